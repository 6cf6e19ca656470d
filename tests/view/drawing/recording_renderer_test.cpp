#include "apps/view/drawing/recording_renderer.h"

#include "soms/base/error.h"

#include "tests/support/support.h"

namespace soms::view {
namespace {

TEST(RecordingRenderer, RemembersWhatItWasRequested) {
  Mesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.triangles = {{0, 1, 2}};
  DrawList list;
  list.meshes.push_back({7, 0, std::make_shared<const Mesh>(mesh), nullptr});
  list.instances.resize(3);
  RecordingRenderer renderer;
  EXPECT_THROW((void)renderer.read_pixels(), Error);
  EXPECT_THROW(renderer.draw(list, {}, {0, 10}), Error);
  renderer.draw(list, {}, {8, 4});
  EXPECT_EQ(renderer.statistics().triangles, 3U);
  EXPECT_EQ(renderer.statistics().instances, 3U);
  EXPECT_EQ(renderer.statistics().uploads, 1U);
  renderer.draw(list, {}, {8, 4});
  EXPECT_EQ(renderer.statistics().uploads, 0U) << "a mesh is brought once";
  list.meshes[0].version = 1;
  renderer.draw(list, {}, {8, 4});
  EXPECT_EQ(renderer.statistics().uploads, 1U) << "and again when it changed";
  EXPECT_EQ(renderer.drawn(), 3U);
  EXPECT_EQ(renderer.read_pixels().size, (Size{8, 4}));
  renderer.present();
  EXPECT_EQ(renderer.presented(), 1U);
}

}  // namespace
}  // namespace soms::view
