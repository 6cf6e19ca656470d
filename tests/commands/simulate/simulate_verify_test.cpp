// The judge itself: brute force must see every answer that was falsified.
#include "apps/soms/simulate/simulate_verify.h"

#include "tests/commands/run.h"

#include <algorithm>
#include <utility>

namespace soms::command {
namespace {

/// A roof over the ground from (-5, -5) to (5, 5) at z.
Mesh roof(double z) {
  Mesh mesh;
  mesh.vertices = {{-5, -5, z}, {5, -5, z}, {5, 5, z}, {-5, 5, z}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

/// Two sails, each in two triangles: across x and across y.
Mesh sails() {
  Mesh mesh;
  mesh.vertices = {{-1, 0, -1}, {1, 0, -1}, {1, 0, 1}, {-1, 0, 1},
                   {0, -1, -1}, {0, 1, -1}, {0, 1, 1}, {0, -1, 1}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}, {4, 5, 6}, {4, 6, 7}};
  return mesh;
}

/// Movers 0 and 1 touch the roof and each other, 2 touches 0 alone, 3 the roof alone, 4 nothing.
class VerifierTest : public ::testing::Test {
 protected:
  VerifierTest() {
    add_to_city(world_, Body(Shape(roof(0))), {});
    const Shape shape(sails());
    world_.models.push_back(make_model(shape, "sails", Kind::model));
    scene_.add_environment(world_.city[0]);
    for (const Vec3& at :
         {Vec3{0, 0, 0}, {0.75, 0.25, 0.5}, {-0.5, -0.25, 1.75}, {-3, -3, 0.5}, {0, 0, 100}}) {
      world_.routes.emplace_back();
      poses_.push_back(Pose::translation(at.x, at.y, at.z));
      scene_.add_mover(Body(shape, poses_.back()));
    }
    report_ = scene_.step();
  }

  [[nodiscard]] Verified judge(const StepReport& report) const {
    Verifier verifier(world_, 1);
    verifier.verify(report, poses_, {.threads = 2});
    return verifier.result();
  }

  World world_;
  Scene scene_;
  std::vector<Pose> poses_;
  StepReport report_;
};

TEST_F(VerifierTest, ConfirmsATrueReport) {
  const auto touches_city = [&](MoverId mover) {
    return std::any_of(report_.environment.begin(), report_.environment.end(),
                       [&](const EnvironmentContact& c) { return c.mover == mover; });
  };
  EXPECT_TRUE(touches_city(0) && touches_city(1) && touches_city(3));
  EXPECT_FALSE(touches_city(2) || touches_city(4));
  const Verified verified = judge(report_);
  EXPECT_EQ(verified.wrong, 0U);
  EXPECT_GE(verified.contacts, 5U);
}

TEST_F(VerifierTest, SeesAllLostContactsWithTheCityOfAMoverThatTouchesMovers) {
  for (const MoverId mover : {MoverId{0}, MoverId{1}}) {
    StepReport report = report_;
    std::erase_if(report.environment,
                  [&](const EnvironmentContact& c) { return c.mover == mover; });
    EXPECT_EQ(judge(report).wrong, 1U) << mover;
  }
}

TEST_F(VerifierTest, SeesALostPairOfMoversThatTouchSomethingElse) {
  StepReport report = report_;
  std::erase_if(report.movers, [](const MoverContact& c) { return c.a == 0 && c.b == 1; });
  ASSERT_LT(report.movers.size(), report_.movers.size());
  EXPECT_EQ(judge(report).wrong, 2U);  // both movers are
}

TEST_F(VerifierTest, TestsOnlyThePairsOfMoversThatTheRunDoes) {
  StepReport report = report_;
  std::erase_if(report.movers, [](const MoverContact& c) { return c.a == 0 && c.b == 1; });
  world_.filter.ignored = {{0, 1}};
  EXPECT_EQ(judge(report).wrong, 0U);
  EXPECT_EQ(judge(report_).wrong, 1U) << "a pair that was to be ignored";
  report.movers.clear();
  world_.filter = {.between = false};
  EXPECT_EQ(judge(report).wrong, 0U);
  EXPECT_GT(judge(report_).wrong, 0U);
}

TEST_F(VerifierTest, SeesASingleLostOrInventedPairOfTriangles) {
  StepReport lost = report_;
  lost.environment.pop_back();
  EXPECT_EQ(judge(lost).wrong, 1U);
  StepReport lost_pair = report_;
  lost_pair.movers.pop_back();
  EXPECT_EQ(judge(lost_pair).wrong, 1U);
  StepReport invented = report_;
  invented.environment.push_back({4, 0, 0, 0});
  EXPECT_EQ(judge(invented).wrong, 1U);
}

}  // namespace
}  // namespace soms::command
