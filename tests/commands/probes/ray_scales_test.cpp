// Rays and winding numbers at sizes where products of lengths underflow, and what --verify says of
// them.
#include "apps/soms/probes/winding_verify.h"
#include "tests/commands/run.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

namespace soms::test {
namespace {

std::string scales_data(const std::string& file) {
  return test::data("rays/" + file).string();
}

/// The only answer of a run that brute force agrees with.
Json verified_answer(std::vector<std::string> words) {
  words.insert(words.end(), {"--verify", "--json"});
  const RunResult result = soms_run(std::move(words));
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(result.err, "");
  const std::vector<Json> lines = json_lines(result.out);
  EXPECT_EQ(lines.size(), 1U);
  EXPECT_EQ(lines.at(0).at("verified"), true);
  return lines.at(0);
}

TEST(RayScalesVerb, NamesTheFirstTriangleOfTheUsualSize) {
  const Json answer = verified_answer(
      {"ray", scales_data("ray-usual-size.ply"), "--rays", scales_data("ray-usual-size.csv")});
  EXPECT_EQ(answer.at("triangle"), 0);
}

TEST(RayScalesVerb, NamesTheFirstTriangleOfTheLeastSize) {
  const Json answer = verified_answer(
      {"ray", scales_data("ray-first.ply"), "--rays", scales_data("ray-first.csv")});
  EXPECT_EQ(answer.at("triangle"), 0);
}

TEST(RayScalesVerb, InventsNoHit) {
  const Json answer = verified_answer({"ray", scales_data("ray-invented.ply"), "--rays",
                                       scales_data("ray-invented.csv"), "--pose",
                                       scales_data("ray-invented-pose.csv"), "--any"});
  EXPECT_EQ(answer.at("hit"), false);
}

TEST(RayScalesVerb, FindsAWindingNumberForTrianglesInOnePlace) {
  const Json answer = verified_answer({"contains", scales_data("winding-nan.ply"), "--points",
                                       scales_data("winding-nan.csv"), "--pose",
                                       scales_data("winding-nan-pose.csv"), "--winding"});
  EXPECT_EQ(answer.at("side"), "outside");
  EXPECT_GE(answer.at("lower"), -1e-9);
  EXPECT_LE(answer.at("upper"), 1e-9);
}

TEST(RayScalesVerb, R123AWindingNumberThatIsNoneIsADifference) {
  using command::agrees;
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  const Bracket truth{0.25, 0.5};
  EXPECT_TRUE(agrees({0.25, 0.5}, truth));
  EXPECT_TRUE(agrees({0.5, 0.75}, truth));
  EXPECT_TRUE(agrees({0, 0.25}, truth));
  EXPECT_TRUE(agrees({0, 1}, truth));
  EXPECT_FALSE(agrees({0.625, 0.75}, truth));
  EXPECT_FALSE(agrees({0, 0.125}, truth));
  EXPECT_FALSE(agrees({kNone, kNone}, truth));
  EXPECT_FALSE(agrees({kNone, 0.5}, truth));
  EXPECT_FALSE(agrees({0.25, kNone}, truth));
  EXPECT_FALSE(agrees({0.25, 0.5}, {kNone, kNone}));
  EXPECT_FALSE(agrees({0.25, 0.5}, {0.25, kNone}));
  EXPECT_FALSE(agrees({0.25, 0.5}, {kNone, 0.5}));
  EXPECT_FALSE(agrees({0.75, 0.25}, truth));
}

}  // namespace
}  // namespace soms::test
