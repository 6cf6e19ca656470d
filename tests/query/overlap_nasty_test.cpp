// Files of tests/data/nasty, each against itself moved and turned and against a sphere, by the
// default traversal and by its twin.
#include "soms/base/error.h"
#include "soms/generate/shapes.h"
#include "soms/io/read_mesh.h"
#include "soms/query/overlap.h"
#include "soms/query/reference/overlap.h"

#include "tests/query/overlap_inputs.h"
#include "tests/support/support.h"

#include <algorithm>
#include <string>
#include <vector>

namespace soms {
namespace {

/// The first `most` triangles: what the twin can be asked about in a test.
Mesh head(Mesh mesh, std::size_t most) {
  mesh.triangles.resize(std::min(mesh.triangles.size(), most));
  mesh.faces.clear();
  mesh.parts.clear();
  return mesh;
}

double size_of(const Box& box) {
  const Vec3 extent = box.extent();
  return std::max({extent.x, extent.y, extent.z});
}

void expect_equals_twin(const Body& a, const Body& b) {
  const Overlap answer = overlap(a, b);
  const Overlap twin = reference::overlap(a.shape.mesh(), a.pose, b.shape.mesh(), b.pose);
  ASSERT_EQ(answer.any, twin.any);
  ASSERT_EQ(answer.pairs, twin.pairs);
  ASSERT_EQ(overlap(b, a, {.mode = OverlapMode::any}).any, twin.any);
}

TEST(OverlapNasty, EqualsItsTwinOnEveryFile) {
  constexpr std::size_t kMost = 600;
  std::size_t files = 0;
  const Mesh sphere = generate_sphere(180);
  for (const auto& row : test::read_csv(test::data("nasty/EXPECTED.csv"))) {
    if (row.front().find(".ply") == std::string::npos) {
      continue;
    }
    SCOPED_TRACE(row.front());
    if (row.front() == "sphere_huge_1e200.ply") {
      EXPECT_THROW(static_cast<void>(read_mesh(test::data("nasty/" + row.front()))), Error);
      continue;
    }
    const Mesh mesh =
        head(read_mesh(test::data("nasty/" + row.front()), {.allow_empty = true}), kMost);
    const Shape shape(mesh);
    ++files;
    ASSERT_NO_FATAL_FAILURE(expect_equals_twin(Body(shape), Body(shape)));
    if (mesh.triangles.empty()) {
      continue;
    }
    const Box box = shape.bounds();
    Rng rng(files);
    for (int turn = 0; turn < 3; ++turn) {
      const Pose pose = test::moving(test::awkward_rotation(rng), test::point_in(rng, box),
                                     test::point_in(rng, box));
      ASSERT_NO_FATAL_FAILURE(expect_equals_twin(Body(shape, pose), Body(shape)));
    }
    const double size = std::max(size_of(box), 0x1p-1000);
    const Shape ball(test::placed(sphere, 0.3 * size, {}));
    const Pose at = test::moving(test::awkward_rotation(rng), {}, test::point_in(rng, box));
    ASSERT_NO_FATAL_FAILURE(expect_equals_twin(Body(ball, at), Body(shape)));
  }
  EXPECT_EQ(files, 46U);
}

}  // namespace
}  // namespace soms
