#include "apps/view/scene/load.h"

#include "soms/base/error.h"
#include "soms/io/write_mesh.h"

#include "apps/view/scene/view_scene.h"
#include "tests/support/bodies.h"
#include "tests/support/support.h"

#include <gtest/gtest.h>

namespace soms::view {
namespace {

TEST(Load, MakesTheMotionsOfASimulation) {
  command::Shared shared;
  shared.quiet = true;
  command::Console console(shared);
  test::TemporaryFolder folder;
  const std::string city = (folder.path() / "city.ply").string();
  write_mesh(city, test::box_body({0, 0, 0}, {50, 50, 10}, 4), MeshFormat::ply);
  command::WorldOptions options;
  options.cities = {city};
  options.count = 5;
  const command::World world = command::load_world(options, console);
  ViewScene scene(content_of(world));
  EXPECT_EQ(scene.title(), "city");
  ASSERT_EQ(scene.movers(), world.ways.size());
  ASSERT_GT(scene.movers(), 0U);
  EXPECT_TRUE(scene.contacts().empty());  // movers start free
  scene.go_to(30);
  for (std::uint32_t k = 0; k < scene.movers(); ++k) {
    EXPECT_EQ(scene.body(mover(k)).pose, world.ways[k].at(30));
    EXPECT_EQ(scene.body(mover(k)).shape.shared_mesh(),
              world.models[world.ways[k].model].shape.shared_mesh());
  }
}

TEST(Load, ReadsADroppedFile) {
  test::TemporaryFolder folder;
  const auto path = folder.path() / "block.stl";
  write_mesh(path, test::box_body({0, 0, 0}, {1, 2, 3}), MeshFormat::stl);
  const Body body = read_body(path);
  EXPECT_EQ(body.name, "block");
  EXPECT_EQ(body.shape.bounds().upper, (Vec3{1, 2, 3}));
  EXPECT_THROW((void)read_body(folder.path() / "none.ply"), Error);
}

}  // namespace
}  // namespace soms::view
