// Files of tests/data/nasty, each against itself moved and turned (their first triangles) and,
// whole, against a sphere, by the default traversal and by its twin.
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

/// The first `most` triangles: what the twin can answer in a test.
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
    const Mesh whole = read_mesh(test::data("nasty/" + row.front()), {.allow_empty = true});
    const Shape shape(head(whole, kMost));
    ++files;
    ASSERT_NO_FATAL_FAILURE(expect_equals_twin(Body(shape), Body(shape)));
    if (whole.triangles.empty()) {
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
    ASSERT_NO_FATAL_FAILURE(expect_equals_twin(Body(ball, at), Body(Shape(whole))));
  }
  EXPECT_EQ(files, 46U);
}

/// Two parallel triangles in tiny corners of larger layouts: their determinants are 513 times the
/// least float, which is above the bounds that cover underflow by less than they lose.
TEST(OverlapNasty, ParallelTrianglesWhoseDeterminantsUnderflowStayApart) {
  Mesh a;
  a.vertices = {{-0x1.882c57435ab2ap-48, -0x1.4b3e2d212dae4p-47, -0x1.c153f908ad4p-57},
                {0x1.902e9f60a08p-51, -0x1.ccea1e875aaeap-47, 0x1.20e695175e3fcp-48},
                {-0x1.434f4decfd7c8p-49, -0x1.8424f1192f219p-48, 0x1.652b37ed4ea7ep-47},
                {0x1.1419e563bdaacp-54, 0x1.03ee860b9e444p-54, -0x1.79630a2ce8d9bp-55}};
  a.triangles = {{0, 1, 2}, {3, 3, 3}};
  Mesh b;
  b.vertices = {{0x1.1fc0a8b2333bfp-50, 0x1.025b3ee7c6958p-49, 0x1.1b358fa67910ap-48},
                {0x1.5be908b6d8ea6p-48, -0x1.3d766d3aa7bbap-47, -0x1.6d8f5d6c2e973p-48},
                {-0x1.905a351a57ea6p-48, 0x1.8650ba2b89998p-47, 0x1.e98a2b34344dap-48},
                {-0x1.b3b8de0167518p-48, -0x1.9a346b8a55c3bp-48, 0x1.29c826076fbbcp-48},
                {0x1.028f5c28f5c29p-21, 0x1.028f5c28f5c29p-21, 0x1.028f5c28f5c29p-21},
                {0x1.1c6a7ef9db22ep-21, 0x1.028f5c28f5c29p-21, 0x1.028f5c28f5c29p-21},
                {0x1.028f5c28f5c29p-21, 0x1.1c6a7ef9db22ep-21, 0x1.028f5c28f5c29p-21},
                {-0x1.d16872b020c4ap-22, -0x1.d16872b020c4ap-22, -0x1.d16872b020c4ap-22},
                {-0x1.9db22d0e56042p-22, -0x1.d16872b020c4ap-22, -0x1.d16872b020c4ap-22},
                {-0x1.d16872b020c4ap-22, -0x1.9db22d0e56042p-22, -0x1.d16872b020c4ap-22}};
  b.triangles = {{0, 1, 2}, {3, 3, 3}, {4, 5, 6}, {7, 8, 9}};
  ShapeOptions options;
  options.build.per_leaf = 2;
  EXPECT_FALSE(overlap(Body(Shape(a, options)), Body(Shape(b, options))).any);
  ASSERT_NO_FATAL_FAILURE(expect_equals_twin(Body(Shape(a, options)), Body(Shape(b, options))));
}

}  // namespace
}  // namespace soms
