// Robots and other bodies that `simulate` moves by the user's own routes: how long a run is, what
// its notes say, and which movers are tested against each other.
#include "apps/cli/parser.h"
#include "apps/world/world_options.h"
#include "tests/commands/run.h"

#include <cstdlib>

namespace soms::test {
namespace {

const char* const kSail = "OFF\n4 2 0\n-0.1 0 -1\n0.1 0 -1\n0.1 0 1\n-0.1 0 1\n3 0 1 2\n3 0 2 3\n";
const char* const kCrossSail =
    "OFF\n4 2 0\n0 -0.1 -1\n0 0.1 -1\n0 0.1 1\n0 -0.1 1\n3 0 1 2\n3 0 2 3\n";
/// A wall across x at 5.
const char* const kWall = "OFF\n4 2 0\n5 -9 -9\n5 9 -9\n5 9 9\n5 -9 9\n3 0 1 2\n3 0 2 3\n";

/// A wall and three links, of which 0 and 1 cross each other in every frame, and so do 1 and 2.
class SimulateRoutes : public testing::Test {
 protected:
  void SetUp() override {
    write_text(wall(), kWall);
    write_text(at("base.off"), kSail);
    write_text(at("arm.off"), kCrossSail);
    write_text(at("hand.off"), kSail);
    write_text(at("still.csv"), poses(3, 0));
  }

  [[nodiscard]] std::string at(const std::string& name) const {
    return (folder_.path() / name).string();
  }

  [[nodiscard]] std::string wall() const { return at("wall.off"); }

  /// Poses that go along x from 0 in `rows` steps of `step` meters.
  [[nodiscard]] static std::string poses(int rows, double step) {
    std::string text = "x,y,z,qw,qx,qy,qz\n";
    for (int k = 0; k < rows; ++k) {
      text += std::to_string(k * step) + ",0,0,1,0,0,0\n";
    }
    return text;
  }

  [[nodiscard]] static RunResult simulate(std::vector<std::string> words,
                                          const std::vector<std::string>& more = {}) {
    words.insert(words.begin(), "simulate");
    words.insert(words.end(), more.begin(), more.end());
    return soms_run(words);
  }

  /// Base, arm and hand, all three where they cross.
  [[nodiscard]] std::vector<std::string> robot() const {
    return {wall(),         "--mover", at("base.off"),  "--mover", at("arm.off"), "--mover",
            at("hand.off"), "--route", at("still.csv"), "--json",  "--verify"};
  }

  [[nodiscard]] std::vector<std::string> hand_on(const std::string& rows) const {
    write_text(at("hand.csv"), rows);
    return {wall(), "--mover", at("hand.off"), "--route", at("hand.csv"), "--json"};
  }

  TemporaryFolder folder_;
};

// The options that may be repeated took what followed for more values, and the city with it.
TEST(WorldOptions, RepeatableOptionsTakeOneValueAtATime) {
  command::Parser parser("", "soms simulate");
  command::WorldOptions options;
  command::add_world_options(parser, options);
  int repeatable = 0;
  for (const command::Option* const option : parser.options()) {
    if (option->takes() != command::Takes::one_each_time) {
      continue;
    }
    ++repeatable;
    const std::string name = option->name();
    options = {};
    (void)parser.parse({name, "a", "city.obj", name, "b", "town.ply"});
    EXPECT_EQ(option->results(), (std::vector<std::string>{"a", "b"})) << name;
    EXPECT_EQ(options.cities, (std::vector<std::string>{"city.obj", "town.ply"})) << name;
  }
  EXPECT_EQ(repeatable, 4);  // and --only, --ignore
}

TEST_F(SimulateRoutes, TakeOneFileEachWhereverTheCityStands) {
  const std::string hand = at("hand.off");
  const std::string still = at("still.csv");
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{"--mover", hand, wall(), "--route", still},
        {"--route", still, wall(), "--mover", hand},
        {"--route", still, "--mover", hand, wall()},
        {wall(), "--route", still, "--mover", hand},
        {"--mover", hand, "--mover", hand, "--ignore-pair", "0,1", wall(), "--route", still}}) {
    const RunResult result = simulate(words, {"--json"});
    ASSERT_EQ(result.status, 0) << result.err;
    EXPECT_EQ(Json::parse(result.out)["city"], "wall");
  }
}

TEST_F(SimulateRoutes, RunToTheLastRowOfTheLongestPoses) {
  // The wall is reached in row 700, behind the 600 frames of a run without routes.
  std::string rows = poses(700, 0) + "5,0,0,1,0,0,0\n";
  const RunResult whole = simulate(hand_on(rows));
  ASSERT_EQ(whole.status, 0) << whole.err;
  EXPECT_EQ(whole.err, "");
  EXPECT_EQ(Json::parse(whole.out)["frames"], 701);
  EXPECT_GT(Json::parse(whole.out)["contacts"], 0);
  EXPECT_EQ(Json::parse(simulate(hand_on(poses(3, 0))).out)["frames"], 3);
  const std::vector<std::string> words = hand_on(poses(3, 0));
  const RunResult table = simulate({words.begin(), words.end() - 1});
  EXPECT_NE(table.out.find("one for each row of the longest route"), std::string::npos)
      << table.out;
}

TEST_F(SimulateRoutes, OfPointsKeepTheUsualFramesBesidePoses) {
  const std::vector<std::string> words = hand_on("x,y,z\n-1,0,0\n-9,0,0\n");
  EXPECT_EQ(Json::parse(simulate(words).out)["frames"], 600);
  EXPECT_EQ(Json::parse(simulate(words, {"--route", at("still.csv")}).out)["frames"], 600);
}

TEST_F(SimulateRoutes, NoteRowsThatNoFrameComesTo) {
  const std::vector<std::string> words = hand_on(poses(9, 0));
  const std::string note = "--frames 4 ends before the poses do: the longest --route has 9 rows";
  const RunResult cut = simulate(words, {"--frames", "4"});
  EXPECT_EQ(cut.status, 0);
  EXPECT_NE(cut.err.find(note), std::string::npos) << cut.err;
  EXPECT_EQ(Json::parse(cut.out)["notes"][0], note);
  const RunResult refused = simulate(words, {"--frames", "4", "--strict"});
  EXPECT_EQ(refused.status, 3);
  EXPECT_NE(refused.err.find("give --frames 9, or leave it out"), std::string::npos) << refused.err;
  EXPECT_EQ(simulate(words, {"--frames", "9", "--strict"}).err, "");
}

TEST_F(SimulateRoutes, NeedAFrame) {
  const RunResult result = simulate(robot(), {"--frames", "0"});
  EXPECT_EQ(result.status, 2);
  EXPECT_NE(result.err.find("--frames 0"), std::string::npos) << result.err;
}

TEST_F(SimulateRoutes, OfPointsNoteStepsLongerThanTheMover) {
  const std::string along = "x,y,z\n-1,0,0\n-9,0,0\n";
  const RunResult small = simulate(hand_on(along), {"--route", at("hand.csv")});
  EXPECT_EQ(small.status, 0);
  const std::string note =
      "2 movers go in steps of 0.231 m, longer than the model (hand: 0.2 m): they can pass thin "
      "walls between two frames";
  EXPECT_NE(small.err.find(note), std::string::npos) << small.err;
  EXPECT_EQ(Json::parse(small.out)["notes"][0], note);
  EXPECT_EQ(simulate(hand_on(along), {"--strict"}).status, 3);
  EXPECT_EQ(simulate(hand_on(along), {"--mover-scale", "2", "--strict"}).err, "");
}

TEST_F(SimulateRoutes, IgnoreThePairsThatAreNamed) {
  const auto between = [&](const std::vector<std::string>& more) {
    const RunResult result = simulate(robot(), more);
    EXPECT_EQ(result.status, 0) << result.err;
    const Json answer = Json::parse(result.out);
    EXPECT_EQ(answer["verified"]["wrong"], 0);
    return std::pair(answer["contacts_between_movers"].get<int>(),
                     answer["ignored_pairs"].get<int>());
  };
  // 0 and 1, 1 and 2, and the sails 0 and 2, which lie in one plane.
  EXPECT_EQ(between({}), std::pair(3, 0));
  EXPECT_EQ(between({"--ignore-pair", "0,1"}), std::pair(2, 1));
  EXPECT_EQ(between({"--ignore-pair", "1,0", "--ignore-pair", "0,1"}), std::pair(2, 1));
  EXPECT_EQ(between({"--ignore-pair", "base,arm", "--ignore-pair", "hand.off,1"}), std::pair(1, 2));
  EXPECT_EQ(between({"--ignore-pair", at("base.off") + ",arm", "--ignore-pair", "0,2",
                     "--ignore-pair", "1,2"}),
            std::pair(0, 3));
}

TEST_F(SimulateRoutes, IgnoreAllPairsOfTheModelsThatAreNamed) {
  std::vector<std::string> words = robot();
  words.insert(words.end(), {"--count", "6", "--ignore-pair", "base,arm"});
  EXPECT_EQ(Json::parse(simulate(words).out)["ignored_pairs"], 4);
  EXPECT_EQ(
      Json::parse(
          simulate(robot(), {"--count", "6", "--ignore-pair", "arm,arm"}).out)["ignored_pairs"],
      1);
}

TEST_F(SimulateRoutes, TestMoversAgainstTheCityAlone) {
  std::vector<std::string> words = robot();
  words.erase(words.end() - 2, words.end());
  write_text(at("still.csv"), "x,y,z,qw,qx,qy,qz\n5,0,0,1,0,0,0\n");
  const Json alone = Json::parse(simulate(robot(), {"--no-between-movers"}).out);
  EXPECT_EQ(alone["contacts_between_movers"], 0);
  EXPECT_EQ(alone["between_movers"], false);
  EXPECT_GT(alone["contacts"], 0);
  EXPECT_EQ(alone["verified"]["wrong"], 0);
  EXPECT_EQ(Json::parse(simulate(robot()).out)["between_movers"], true);
  EXPECT_NE(simulate(words, {"--no-between-movers"})
                .out.find("not tested    movers against each other (--no-between-movers)"),
            std::string::npos);
  EXPECT_NE(simulate(words, {"--ignore-pair", "0,1"})
                .out.find("not tested    1 pair of movers (--ignore-pair)"),
            std::string::npos);
}

TEST_F(SimulateRoutes, RefuseAPairOfMoversThatIsNone) {
  const auto says = [&](const std::vector<std::string>& more, const std::string& what) {
    const RunResult result = simulate(robot(), more);
    EXPECT_EQ(result.status, 2) << what;
    EXPECT_NE(result.err.find(what), std::string::npos) << result.err;
  };
  says({"--ignore-pair", "0"}, "--ignore-pair 0; give two movers, A,B");
  says({"--ignore-pair", "0,1,2"}, "--ignore-pair 0,1,2; give two movers, A,B");
  says({"--ignore-pair", ",1"}, "--ignore-pair ,1; give two movers, A,B");
  says({"--ignore-pair", "0,3"}, "there is no mover 3; give numbers from 0 to 2");
  says({"--ignore-pair", "elbow,0"}, "--ignore-pair elbow,0: there is no mover elbow");
  says({"--ignore-pair", "1,arm"}, "these are the same mover");
  says({"--ignore-pair", "0,1", "--no-between-movers"},
       "--ignore-pair has no effect with --no-between-movers");
  for (const std::vector<std::string>& more :
       {std::vector<std::string>{"--ignore-pair", "0,1"}, {"--no-between-movers"}}) {
    const RunResult window = simulate({wall(), "--view"}, more);
    EXPECT_EQ(window.status, 2);
    EXPECT_NE(window.err.find("--view cannot be combined"), std::string::npos) << window.err;
  }
}

}  // namespace
}  // namespace soms::test
