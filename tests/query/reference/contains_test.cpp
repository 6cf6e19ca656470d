#include "soms/query/reference/contains.h"

#include "soms/base/error.h"

#include "tests/support/truth/question_truth.h"

#include <gtest/gtest.h>

#include <vector>

namespace soms {
namespace {

TEST(ContainsByBruteForce, TellsSidesOfNestedBoxes) {
  const Mesh* mesh = test::question_mesh("nestsame");
  ASSERT_NE(mesh, nullptr);
  const Body body(*mesh);
  const Box box = body.shape.bounds();
  const std::vector<Vec3> points{box.lower, box.upper + Vec3{1, 0, 0}, mesh->vertices[0]};
  EXPECT_EQ(reference::contains_by_brute_force(body, points)[1], Side::outside);
  EXPECT_EQ(reference::contains_by_brute_force(body, points)[2], Side::on);
  EXPECT_EQ(reference::contains_by_brute_force(Body{}, Vec3{}), Side::outside);
}

TEST(ContainsByBruteForce, RefusesPoses) {
  Pose skewed;
  skewed.m[1] = 0.5;
  try {
    static_cast<void>(
        reference::contains_by_brute_force(Body(*test::question_mesh("wall"), skewed), Vec3{}));
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::not_rigid);
  }
}

}  // namespace
}  // namespace soms
