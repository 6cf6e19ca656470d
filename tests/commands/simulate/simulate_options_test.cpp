// What options of `simulate` that are left out, wrong or many mean. What it answers is queried in
// simulate_test.cpp.
#include "tests/commands/run.h"

#include <sstream>

namespace soms::test {
namespace {

/// A small city as a file.
class SimulateOptions : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_EQ(soms_run({"generate", "city", "--triangles", "3000", "-o", town()}).status, 0);
  }

  [[nodiscard]] std::string beside(const std::string& name) const {
    return (folder_.path() / name).string();
  }

  [[nodiscard]] std::string town() const { return beside("town.ply"); }

  [[nodiscard]] static RunResult simulate(std::vector<std::string> words) {
    words.insert(words.begin(), "simulate");
    return soms_run(words);
  }

  [[nodiscard]] static int movers(std::vector<std::string> words) {
    words.insert(words.end(), {"--json", "--quiet"});
    return Json::parse(simulate(words).out)["movers"];
  }

  TemporaryFolder folder_;
};

TEST_F(SimulateOptions, HintsAtAMapOnATerminalUnlessItIsToBeQuiet) {
  const auto shown = [&](std::vector<std::string> words) {
    words.insert(words.begin(), {"simulate", town(), "--frames", "1", "--count", "1"});
    return soms_on_terminal(words).out;
  };
  EXPECT_NE(shown({}).find("-o city.svg"), std::string::npos);
  EXPECT_EQ(shown({"--quiet"}).find("-o city.svg"), std::string::npos);
  EXPECT_EQ(shown({"-o", beside("a.svg")}).find("-o city.svg"), std::string::npos);
}

// "Not found" is no proof of "free" when time ran out.
TEST_F(SimulateOptions, FailIfContactIsUndecidedWhenTimeIsUp) {
  write_text(beside("high.csv"), "x,y,z,qw,qx,qy,qz\n0,0,900,1,0,0,0\n");
  const RunResult result = run_with_time(
      [&](const std::string& seconds) {
        return simulate({town(), "--route", beside("high.csv"), "--frames", "100000000",
                         "--fail-if", "contact", "--timeout", seconds, "--json"});
      },
      [](const RunResult& run) { return !run.out.empty(); });
  EXPECT_EQ(result.status, 4) << result.err;
  const Json answer = Json::parse(result.out);
  EXPECT_EQ(answer["coverage"], "cut");
  EXPECT_EQ(answer["contacts"], 0);
}

TEST_F(SimulateOptions, RefusesADescentOfNothing) {
  const RunResult idle =
      simulate({town(), "--frames", "1", "--count", "1", "--tree", "descent=both"});
  EXPECT_EQ(idle.status, 2);
  EXPECT_NE(idle.err.find("--tree descent has no effect: only E-Node has a descent"),
            std::string::npos)
      << idle.err;
}

TEST_F(SimulateOptions, R119OptionsThatChangeNothingAreRefused) {
  write_text(beside("a.csv"), "x,y,z\n0,0,9\n");
  const auto says = [&](std::vector<std::string> words, const std::string& what) {
    words.insert(words.begin(), {town(), "--frames", "1"});
    const RunResult result = simulate(words);
    EXPECT_EQ(result.status, 2) << what;
    EXPECT_NE(result.err.find(what), std::string::npos) << result.err;
  };
  says({"--tree", "empty-side=stop"},
       "--tree empty-side has no effect: the rules fast, quality and quick leave");
  says({"--tree", "rule=soms", "--tree", "root-level=0"},
       "--tree root-level has no effect: levels are not limited; leave it out, or also give --tree "
       "levels=N");
  says({"--tree", "traversal=larger", "--tree", "descent=both"}, "--tree descent has no effect");
  says({"--route", beside("a.csv"), "--route", beside("a.csv"), "--count", "1"},
       "--count 1 leaves 1 of 2 --route without a mover; give --count 2 or more");
  says({"--mover", town(), "--count", "0"}, "--count 0 leaves 1 of 1 --mover without a mover");
  says({"--picture-frame", "0"}, "--picture-frame without -o FILE.png");
  const RunResult embedded = simulate({"--scale", "1", "--frames", "1"});
  EXPECT_EQ(embedded.status, 2);
  EXPECT_NE(embedded.err.find("--scale, --up and --crs need a city from files"), std::string::npos);
}

TEST_F(SimulateOptions, RefusesNamesWhoseExtensionsAreThoseOfOtherFiles) {
  const auto refused = [&](const std::string& option, const std::string& name,
                           const std::string& extension) {
    const RunResult result =
        simulate({town(), "--frames", "1", "--count", "1", option, beside(name)});
    EXPECT_EQ(result.status, 2) << result.err;
    EXPECT_NE(result.err.find("; use " + extension), std::string::npos) << result.err;
  };
  refused("--map", "x.txt", "the extension .svg");
  refused("--report", "x.svg", "one of the extensions .html, .htm");
  refused("--events", "x.json", "the extension .csv");
  refused("--picture", "x.jpg", "the extension .png");
  EXPECT_EQ(files_in(folder_.path()), std::vector<std::string>{"town.ply"});
  EXPECT_EQ(simulate({town(), "--frames", "1", "--count", "1", "--map", beside("X.SVG"), "--events",
                      beside("plain")})
                .status,
            0);
}

TEST_F(SimulateOptions, OldNamesWriteTheSameWithOneRemark) {
  const auto run = [&](const std::string& option, const std::string& file) {
    return simulate({town(), "--frames", "40", "--count", "9", option, beside(file)});
  };
  for (const auto& [name, extension] :
       {std::pair("--events", ".csv"), std::pair("--map", ".svg")}) {
    const std::string now = "now" + std::string(extension);
    EXPECT_EQ(run("-o", now).err, "");
    EXPECT_EQ(run(name, "before").err, std::string(name) + " is now -o FILE" + extension +
                                           "; the old form ends with the next release\n");
    EXPECT_EQ(read_text(beside("before")), read_text(beside(now))) << name;
  }
  const RunResult page = run("--report", "page.html");
  EXPECT_EQ(page.status, 0);
  EXPECT_EQ(page.err, "--report is now -o FILE.html; the old form ends with the next release\n");
  const std::string help = simulate({"--help"}).out;
  for (const char* const old : {"--events", "--map ", "--report", "--picture "}) {
    EXPECT_EQ(help.find(old), std::string::npos) << help;
  }
}

TEST_F(SimulateOptions, WritesTheObjectOfJson) {
  const RunResult printed =
      simulate({town(), "--frames", "40", "--count", "9", "--json", "-o", beside("answer.json")});
  ASSERT_EQ(printed.status, 0) << printed.err;
  EXPECT_EQ(read_text(beside("answer.json")), printed.out);
  const RunResult table =
      simulate({town(), "--frames", "40", "--count", "9", "-o", beside("beside.json")});
  EXPECT_FALSE(table.out.starts_with("{"));
  EXPECT_TRUE(read_text(beside("beside.json")).starts_with("{\"schema\":\"soms.simulate/1\""));
}

TEST_F(SimulateOptions, ListsOnTheMapWhatTheTableLists) {
  const std::string map = beside("a.svg");
  const RunResult result = simulate({town(), "--count", "60", "--frames", "200", "-o", map});
  ASSERT_EQ(result.status, 0) << result.err;
  ASSERT_NE(result.out.find("most touched"), std::string::npos) << result.out;
  const std::string picture = read_text(map);
  std::istringstream lines(result.out.substr(result.out.find("most touched")));
  std::size_t at = picture.find(">Most touched<");
  ASSERT_NE(at, std::string::npos);
  int listed = 0;
  for (std::string line; std::getline(lines, line) && line.starts_with(listed == 0 ? "most" : " ");
       ++listed) {
    const std::string words = line.substr(14);
    const std::size_t colon = words.find(": ");
    for (const std::string& part : {words.substr(0, colon), words.substr(colon + 2)}) {
      at = picture.find(">" + part + "<", at);
      EXPECT_NE(at, std::string::npos) << part;
    }
  }
  EXPECT_EQ(listed, 5);
}

TEST_F(SimulateOptions, SendsOneMoverAlongEachRoute) {
  const std::string route = beside("route.csv");
  write_text(route, "x,y,z\n10,10,1\n190,10,1\n");
  EXPECT_EQ(movers({town(), "--frames", "2", "--route", route}), 1);
  EXPECT_EQ(movers({town(), "--frames", "2", "--route", route, "--route", route}), 2);
  EXPECT_EQ(movers({town(), "--frames", "2", "--route", route, "--count", "5"}), 5);
}

TEST_F(SimulateOptions, ReadsARouteFromStandardInputButOneThingOnly) {
  const std::vector<std::string> words{"simulate", town(),    "--frames", "2",
                                       "--json",   "--quiet", "--route",  "-"};
  const RunResult piped = soms_run(words, "x,y,z\n10,10,1\n190,10,1\n");
  ASSERT_EQ(piped.status, 0) << piped.err;
  EXPECT_EQ(Json::parse(piped.out)["movers"], 1);
  const RunResult faulty = soms_run(words, "x,y,z\n10,10\n");
  EXPECT_EQ(faulty.status, 3);
  EXPECT_NE(faulty.err.find("soms simulate: standard input, line 2: "), std::string::npos)
      << faulty.err;
  for (const char* const option : {"--mover", "--route"}) {
    const RunResult twice = soms_run({"simulate", "-", option, "-"}, "OFF\n0 0 0\n");
    EXPECT_EQ(twice.status, 2) << twice.err;
    EXPECT_NE(twice.err.find("standard input is given twice"), std::string::npos) << twice.err;
  }
}

TEST_F(SimulateOptions, EndsInTimeWhileMoversAreStillPlaced) {
  const RunResult result =
      simulate({town(), "--count", "1000000", "--timeout", "0.2", "--frames", "1"});
  EXPECT_EQ(result.status, 4);
  EXPECT_NE(result.err.find("out of time while "), std::string::npos) << result.err;
}

}  // namespace
}  // namespace soms::test
