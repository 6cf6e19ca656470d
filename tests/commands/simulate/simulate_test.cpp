#include "tests/commands/run.h"
#include "tests/support/slow_build.h"
#include "tests/support/support.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <csignal>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace soms {

namespace {

using nlohmann::json;

test::RunResult simulate(std::vector<std::string> words) {
  words.insert(words.begin(), {test::command().string(), "simulate"});
  return test::run_program(words);
}

/// A ground of 200 m with nine houses on it, or only the box of one house, as an OFF file.
class Town {
 public:
  explicit Town(const std::string& name = "town.off", int houses = 9) {
    std::ofstream out(folder_.path() / name);
    out << "OFF\n"
        << 4 + 8 * houses << ' ' << 2 + 12 * houses << " 0\n"
        << "0 0 0\n200 0 0\n200 200 0\n0 200 0\n";
    for (int k = 0; k < houses; ++k) {
      const int x = 20 + 60 * (k % 3);
      const int y = 20 + 60 * (k / 3);
      for (int corner = 0; corner < 8; ++corner) {
        out << x + ((corner & 1) != 0 ? 40 : 0) << ' ' << y + ((corner & 2) != 0 ? 40 : 0) << ' '
            << ((corner & 4) != 0 ? 8 + k : 0) << '\n';
      }
    }
    out << "3 0 1 2\n3 0 2 3\n";
    for (int k = 0; k < houses; ++k) {
      const int b = 4 + 8 * k;
      const int faces[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                               {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
      for (const auto& f : faces) {
        out << "3 " << b + f[0] << ' ' << b + f[1] << ' ' << b + f[2] << "\n3 " << b + f[0] << ' '
            << b + f[2] << ' ' << b + f[3] << '\n';
      }
    }
    path_ = (folder_.path() / name).string();
  }

  [[nodiscard]] const std::string& path() const { return path_; }

  /// A path in the town's folder.
  [[nodiscard]] std::string beside(const std::string& name) const {
    return (folder_.path() / name).string();
  }

  /// Writes a file into the town's folder.
  [[nodiscard]] std::string write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_.path() / name) << text;
    return beside(name);
  }

  /// Files in the folder: what a failed run must not add to.
  [[nodiscard]] std::size_t files() const {
    const std::filesystem::directory_iterator all(folder_.path());
    return static_cast<std::size_t>(std::distance(begin(all), end(all)));
  }

 private:
  test::TemporaryFolder folder_;
  std::string path_;
};

std::string read_text(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  std::stringstream text;
  text << in.rdbuf();
  return text.str();
}

/// Answer of a run that must succeed.
json answer(std::vector<std::string> words) {
  words.insert(words.end(), {"--json", "--quiet"});
  const test::RunResult result = simulate(words);
  EXPECT_EQ(result.status, 0) << result.err;
  return json::parse(result.out);
}

TEST(Simulate, RefusesToOverwriteItsOwnFiles) {
  const Town town;
  const std::string before = read_text(town.path());
  const std::string same = town.beside("./m.svg");
  const auto refused = [&](std::vector<std::string> words, const std::string& text) {
    words.insert(words.end(), {"--frames", "1", "--count", "1"});
    const test::RunResult result = simulate(words);
    EXPECT_EQ(result.status, 2) << result.err;
    EXPECT_NE(result.err.find(text), std::string::npos) << result.err;
  };
  refused({town.path(), "--map", town.beside("m.svg"), "--events", same},
          "m.svg: -o names the same file");
  refused({town.path(), "--map", town.path()}, "town.off: CITY names the same file");
  refused({town.path(), "--mover", "a.ply", "--events", "./a.ply"}, "--mover names");
  refused({town.path(), "--route", "r.csv", "--events", "r.csv"}, "--route names");
  refused({town.path(), "--map", "-"},
          "the answer is already written to standard output; give the name of a file");
  refused({town.path(), "--events", "/dev/stdout", "--json"},
          "the answer is already written to standard output");
  EXPECT_EQ(read_text(town.path()), before);
  EXPECT_EQ(town.files(), 1U);
  EXPECT_EQ(simulate({town.path(), "--frames", "1", "--count", "1", "--map", "/dev/null",
                      "--events", "/dev/null"})
                .status,
            0);
}

TEST(Simulate, RunsTheEmbeddedCityWithAThousandMoversAndIsConfirmedByBruteForce) {
  const json object = answer({"--frames", "12", "--verify"});
  EXPECT_EQ(object["schema"], "soms.simulate/1");
  EXPECT_EQ(object["triangles"], 1'000'000);
  EXPECT_EQ(object["movers"], 1000);
  EXPECT_EQ(object["frames"], 12);
  EXPECT_EQ(object["coverage"], "complete");
  EXPECT_EQ(object["verified"]["wrong"], 0);
  EXPECT_GT(object["verified"]["free"], 12);
  EXPECT_GE(object["queries"], 12 * 1000);
}

TEST(Simulate, PrintsATableForPeople) {
  const Town town;
  const test::RunResult result = simulate({town.path(), "--frames", "30", "--count", "40"});
  EXPECT_EQ(result.status, 0) << result.err;
  for (const char* word : {"town, 110 triangles", "built in", "movers", "frames a second",
                           "queries a second", "contacts"}) {
    EXPECT_NE(result.out.find(word), std::string::npos) << word << " in\n" << result.out;
  }
  EXPECT_EQ(result.out.find("see it"), std::string::npos) << "a hint in a pipe";
}

TEST(Simulate, CountsMoversOfAFileByItsName) {
  const Town town;
  const std::string mover = town.write("car.off", "OFF\n3 1 0\n-1 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  const std::string route = town.write("r.csv", "x,y,z\n5,5,1\n5,195,1\n");
  const std::string map = town.beside("map.svg");
  const test::RunResult result = simulate({town.path(), "--mover", mover, "--route", route,
                                           "--count", "2", "--frames", "1", "-o", map});
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_NE(result.out.find("  2 (2 of car, 1 triangle)\n"), std::string::npos) << result.out;
  EXPECT_NE(read_text(map).find(">2 of car<"), std::string::npos);
}

TEST(Simulate, TellsInJsonWhatScriptsRelyOn) {
  const Town town;
  const json object = answer({town.path(), "--frames", "60", "--count", "60", "--verify"});
  EXPECT_EQ(object["triangles"], 110);
  EXPECT_EQ(object["frames"], 60);
  for (const char* const key : {"median", "worst"}) {
    EXPECT_TRUE(object["fps"][key].is_number()) << object["fps"];
  }
  EXPECT_GT(object["fps"]["median"], 0);
  EXPECT_GT(object["fps"]["worst"], 0);
  EXPECT_GE(object["fps"]["median"], object["fps"]["worst"]);
  EXPECT_GE(object["build_ms"], 0);
  EXPECT_EQ(object["hash"].get<std::string>().size(), 16U);
  EXPECT_GT(object["contacts"], 0);
  EXPECT_GT(object["verified"]["contacts"], 0);
  EXPECT_EQ(object["verified"]["wrong"], 0);
}

TEST(Simulate, AnswersTheSameForAnyNumberOfThreadsAndOtherwiseForAnotherSeed) {
  const Town town;
  const auto hash = [&](const std::string& threads, const std::string& seed) {
    return answer({town.path(), "--frames", "60", "--count", "80", "--threads", threads, "--seed",
                   seed})["hash"];
  };
  EXPECT_EQ(hash("1", "1"), hash("2", "1"));
  EXPECT_NE(hash("1", "1"), hash("1", "2"));
}

TEST(Simulate, StartsEveryMoverFree) {
  const Town town;
  const std::string events = town.beside("events.csv");
  const json object =
      answer({town.path(), "--frames", "1", "--count", "300", "--contacts", events});
  EXPECT_EQ(object["contacts"], 0);
  EXPECT_GT(object["movers"], 100);
}

TEST(Simulate, WritesBeginAndEndOfEveryContact) {
  const Town town;
  const std::string contacts = town.beside("contacts.csv");
  const json object =
      answer({town.path(), "--frames", "120", "--count", "40", "--contacts", contacts});
  const auto rows = test::read_csv(contacts);
  ASSERT_EQ(rows.size(), object["contacts"].get<std::size_t>() + 1);
  EXPECT_EQ(rows[0], (std::vector<std::string>{"mover", "model", "touched", "part", "triangle",
                                               "begin", "end", "event"}));
  for (std::size_t k = 1; k < rows.size(); ++k) {
    ASSERT_EQ(rows[k].size(), 8U);
    EXPECT_LE(std::stoul(rows[k][5]), std::stoul(rows[k][6]));
    EXPECT_LT(std::stoul(rows[k][6]), 120U);
    EXPECT_EQ(rows[k][2].starts_with("mover "), rows[k][4].empty());
  }
}

TEST(Simulate, DrawsAMapThatIsWholeAndSmall) {
  const Town town("a & <b>.off");
  const std::string map = town.beside("map.svg");
  static_cast<void>(answer({town.path(), "--frames", "60", "--count", "40", "-o", map}));
  const std::string text = read_text(map);
  EXPECT_TRUE(text.starts_with("<svg "));
  EXPECT_TRUE(text.ends_with("</svg>\n"));
  EXPECT_LT(text.size(), 300'000U);
  EXPECT_NE(text.find("a &amp; &lt;b&gt;"), std::string::npos);
  EXPECT_EQ(text.find("nan"), std::string::npos);
  EXPECT_EQ(text.find("inf"), std::string::npos);
}

// In tenths of a pixel the second place is beyond 2^31.
TEST(Simulate, DrawsTracksThatLeaveTheMapByFar) {
  const Town town;
  const std::string route =
      town.write("far.csv", "x,y,z,qw,qx,qy,qz\n5,5,1,1,0,0,0\n100000000,5,1,1,0,0,0\n");
  const std::string mover = town.write("mover.off", "OFF\n3 1 0\n-1 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  const std::string map = town.beside("map.svg");
  static_cast<void>(
      answer({town.path(), "--mover", mover, "--route", route, "--frames", "2", "-o", map}));
  EXPECT_NE(read_text(map).find("h99999"), std::string::npos) << "no line to the right";
}

TEST(Simulate, FollowsARouteOfPosesRowByRow) {
  const Town town;
  // Into the wall of the house at x = 20, and back out.
  const std::string route = town.write(
      "poses.csv", "x,y,z,qw,qx,qy,qz\n10,30,5,1,0,0,0\n20,30,5,1,0,0,0\n10,30,5,1,0,0,0\n");
  const std::string events = town.beside("events.csv");
  const std::string mover = town.write("mover.off", "OFF\n3 1 0\n-1 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  const json object = answer({town.path(), "--mover", mover, "--route", route, "--frames", "3",
                              "--contacts", events, "--verify"});
  EXPECT_EQ(object["movers"], 1);
  const auto rows = test::read_csv(events);
  ASSERT_GE(rows.size(), 2U);
  for (std::size_t k = 1; k < rows.size(); ++k) {
    EXPECT_EQ(rows[k][5], "1");
    EXPECT_EQ(rows[k][6], "1");
  }
  EXPECT_EQ(object["verified"]["wrong"], 0);
}

TEST(Simulate, FollowsARouteOfPointsAtConstantSpeed) {
  const Town town;
  const std::string route = town.write("points.csv", "x,y,z\n5,5,1\n5,195,1\n195,195,1\n");
  const json object = answer({town.path(), "--route", route, "--count", "12", "--frames", "60"});
  EXPECT_EQ(object["movers"], 12);
}

/// Contacts in three frames of a mover that follows these rows, of a file or through a pipe.
std::size_t contacts_on(const Town& town, const std::string& rows, bool piped = false) {
  const std::string route = town.write("route.csv", rows);
  const std::string mover = town.write("mover.off", "OFF\n3 1 0\n-1 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  const std::string events = town.beside("events.csv");
  const test::RunResult result =
      test::run_program({"sh", "-c",
                         "cat '" + route + "' | '" + test::command().string() + "' simulate '" +
                             town.path() + "' --frames 3 --mover '" + mover + "' --contacts '" +
                             events + "' --route '" + (piped ? "/dev/stdin" : route) + "'"});
  EXPECT_EQ(result.status, 0) << result.err;
  return test::read_csv(events).size() - 1;
}

TEST(Simulate, TellsPointsOfARouteFromPosesByTheHeaderAlone) {
  const Town town;
  const std::string poses =
      "x,y,z,qw,qx,qy,qz\n10,30,5,1,0,0,0\n20,30,5,1,0,0,0\n10,30,5,1,0,0,0\n";
  const std::string points = "x,y,z\n10,30,5\n20,30,5\n10,30,5\n";
  const std::size_t jumping = contacts_on(town, poses);
  ASSERT_GT(jumping, 0U);
  // At its speed a mover needs more than three frames to the wall.
  EXPECT_EQ(contacts_on(town, points), 0U);
  EXPECT_EQ(contacts_on(town, points, true), 0U);
  EXPECT_EQ(contacts_on(town, poses, true), jumping);
  EXPECT_EQ(contacts_on(town, "   \n" + points), 0U);
  EXPECT_EQ(contacts_on(town, "  # a, b, c\n" + poses), jumping);
}

TEST(Simulate, FailsOnContactOnlyWhenRequested) {
  const Town town;
  const std::vector<std::string> words{town.path(), "--frames", "120", "--count", "40"};
  EXPECT_EQ(simulate(words).status, 0);
  for (const char* condition : {"overlap", "contact"}) {
    std::vector<std::string> requested = words;
    requested.insert(requested.end(), {"--fail-if", condition});
    EXPECT_EQ(simulate(requested).status, 1);
  }
  EXPECT_EQ(simulate({town.path(), "--count", "0", "--fail-if", "contact"}).status, 0);
}

TEST(Simulate, RunsWithoutMovers) {
  const Town town;
  const std::string map = town.beside("map.svg");
  EXPECT_EQ(answer({town.path(), "--count", "0", "--frames", "5", "-o", map})["movers"], 0);
  EXPECT_TRUE(read_text(map).ends_with("</svg>\n"));
}

TEST(Simulate, FindsRoomForAMoverLargerThanTheCity) {
  const Town town;
  const std::string tower =
      town.write("tower.off",
                 "OFF\n4 4 0\n0 0 0\n900 0 0\n0 900 0\n0 0 900\n3 0 1 2\n3 0 1 3\n3 0 2 3\n"
                 "3 1 2 3\n");
  const json object = answer({town.path(), "--mover", tower, "--count", "2", "--frames", "3"});
  EXPECT_GE(object["movers"], 1);
}

TEST(Simulate, LeavesOutMoversWithoutRoomAndSaysSo) {
  const Town town;
  const test::RunResult result = simulate({town.path(), "--count", "4000", "--frames", "1"});
  EXPECT_EQ(result.status, 0);
  EXPECT_NE(result.err.find("found no free place"), std::string::npos) << result.err;
  EXPECT_NE(result.out.find("4,000 requested"), std::string::npos) << result.out;
}

TEST(Simulate, RefusesWordsThatMakeNoSense) {
  const Town town;
  const std::vector<std::vector<std::string>> wrong{{"--count", "-1"},
                                                    {"--count", "2147483648"},
                                                    {"--count", "many"},
                                                    {"--frames", "1e9"},
                                                    {"--up", "w"},
                                                    {"--scale", "0"},
                                                    {"--scale", "nan"},
                                                    {"--fail-if", "never"},
                                                    {"--mover-scale", "-2"},
                                                    {"--threads", "-3"},
                                                    {"--colour"},
                                                    {"--map"}};
  for (std::vector<std::string> words : wrong) {
    words.insert(words.begin(), town.path());
    const test::RunResult result = simulate(words);
    EXPECT_EQ(result.status, 2) << words[1];
    EXPECT_NE(result.err.find(words[1]), std::string::npos) << result.err;
    EXPECT_TRUE(result.out.empty());
  }
  EXPECT_EQ(simulate({"--scale", "2"}).status, 2);  // the embedded city has its size
}

TEST(Simulate, NamesBadInputAndLeavesNoFile) {
  const Town town;
  const std::string empty = town.write("empty.off", "OFF\n0 0 0\n");
  const std::string none = town.write("none.csv", "x,y,z\n");
  const std::string nan = town.write("nan.csv", "x,y,z\n1,nan,3\n");
  const std::string gone = town.beside("gone.ply");
  const std::size_t files = town.files();
  const std::string map = town.beside("map.svg");
  const std::vector<std::vector<std::string>> bad{{gone},
                                                  {empty},
                                                  {town.path(), "--mover", gone},
                                                  {town.path(), "--mover", empty},
                                                  {town.path(), "--route", none},
                                                  {town.path(), "--route", nan},
                                                  {town.path(), "--route", gone}};
  for (std::vector<std::string> words : bad) {
    const std::string name = words.back();
    words.insert(words.end(), {"-o", map, "-o", town.beside("e.csv")});
    const test::RunResult result = simulate(words);
    EXPECT_EQ(result.status, 3) << name << ": " << result.err;
    EXPECT_NE(result.err.find(name), std::string::npos) << result.err;
    EXPECT_EQ(town.files(), files) << name;
  }
}

TEST(Simulate, TellsBeforeTheWorkThatItCannotWrite) {
  const Town town;
  const std::string folder = std::filesystem::path(town.path()).parent_path().string();
  for (const char* option : {"--map", "--events"}) {
    for (const std::string& place : {folder + "/no/such/file", folder}) {
      const test::RunResult result = simulate({town.path(), option, place});
      EXPECT_EQ(result.status, 5) << result.err;
      EXPECT_NE(result.err.find(place), std::string::npos) << result.err;
    }
  }
  EXPECT_EQ(simulate({town.path(), "--frames", "2", "--map", "/dev/full"}).status, 5);
}

TEST(Simulate, EndsCleanlyWhenInterruptedAndMarksItsAnswer) {
  const Town town;
  const std::string events = town.beside("events.csv");
  const test::TemporaryFolder streams;
  test::Child child({test::command().string(), "simulate", town.path(), "--count", "20", "--frames",
                     "100000000", "--json", "-o", events, "--record", town.beside("record")},
                    streams.path());
  ASSERT_TRUE(child.wait_for_writing(10'000));  // the recording, so frames have been made
  child.send(SIGINT);
  const test::RunResult result = child.wait();
  EXPECT_EQ(result.status, 130) << result.err;
  const json object = json::parse(result.out);
  EXPECT_EQ(object["interrupted"], true);
  EXPECT_EQ(object["coverage"], "cut");
  EXPECT_GT(object["frames"], 0);
  EXPECT_EQ(test::read_csv(events).size(), object["events"].get<std::size_t>() + 1);
}

TEST(Simulate, AnswersWhatItHasWhenTimeIsUp) {
  const Town town;
  // Where time is up before the movers stand it is status 4.
  const test::RunResult result = test::run_with_time(
      [&](const std::string& seconds) {
        return simulate(
            {town.path(), "--frames", "100000000", "--timeout", seconds, "--json", "--quiet"});
      },
      [](const test::RunResult& run) { return run.status != 4; });
  ASSERT_EQ(result.status, 0) << result.err;
  const json object = json::parse(result.out);
  EXPECT_EQ(object["coverage"], "cut");
  EXPECT_EQ(object["interrupted"], false);
  EXPECT_LT(object["frames"], 100000000);
}

// Heights beyond the range of floats once kept the search for the ground from ending.
TEST(Simulate, EndsInACityOfAnySize) {
  const Town town;
  const json object = answer({town.path(), "--scale", "1e60", "--count", "2", "--frames", "2"});
  EXPECT_EQ(object["frames"], 2);
}

TEST(Simulate, AnswersTheSameForEveryTreeAndTraversal) {
  const Town town;
  const auto hash_with = [&](std::vector<std::string> words) {
    words.insert(words.begin(), {town.path(), "--count", "30", "--frames", "40"});
    const json object = answer(words);
    EXPECT_GT(object["contacts"], 0);
    return object["hash"].get<std::string>() + " " + std::to_string(object["contacts"].get<int>());
  };
  const std::string plain = hash_with({});
  for (const char* rule : {"object-median", "object-mean", "spatial-median", "soms", "sah",
                           "soms-sah", "quality", "quick"}) {
    EXPECT_EQ(hash_with({"--tree", std::string("rule=") + rule}), plain) << rule;
  }
  for (const char* traversal : {"a-first", "b-first", "alternate", "larger", "simultaneous",
                                "ericson", "larsson", "e-node", "e-node-front"}) {
    EXPECT_EQ(hash_with({"--tree", std::string("traversal=") + traversal}), plain) << traversal;
  }
  EXPECT_EQ(hash_with({"--tree", "traversal=e-node", "--tree", "descent=cross"}), plain);
  EXPECT_EQ(hash_with({"--tree", "rule=soms", "--tree", "midpoint=thesis", "--tree",
                       "empty-side=stop", "--tree", "leaf=1", "--tree", "levels=15"}),
            plain);
}

TEST(Simulate, NamesTheCityWhoseTriangleIsTouched) {
  const Town town;
  const json result = answer({town.path(), "--count", "30", "--frames", "40"});
  ASSERT_FALSE(result["most_touched"].empty());
  for (const json& touched : result["most_touched"]) {
    EXPECT_EQ(touched["city"], "town");
  }
}

TEST(Simulate, SaysWhatUnitAndAxisAFileStates) {
  const Town town;
  const std::string model = test::data("formats/z_up_cm.dae").string();
  const test::RunResult small =
      simulate({town.path(), "--mover", model, "--count", "1", "--frames", "1"});
  EXPECT_NE(small.err.find("the unit is 0.01 m; assuming meters (--mover-scale 0.01 converts it)"),
            std::string::npos)
      << small.err;
  EXPECT_EQ(small.err.find("across, taken"), std::string::npos) << small.err;
  const test::RunResult scaled = simulate(
      {town.path(), "--mover", model, "--mover-scale", "0.01", "--count", "1", "--frames", "1"});
  EXPECT_EQ(scaled.err.find("the unit"), std::string::npos) << scaled.err;
  const std::string turned = test::data("formats/x_up.dae").string();
  EXPECT_NE(simulate({turned, "--count", "1", "--frames", "1"})
                .err.find("the up axis is x; rotated to z"),
            std::string::npos);
}

TEST(Simulate, ConfirmsRealCitiesByBruteForce) {
  SOMS_NEEDS_OUTSIDE_DATA("13 cities of others with a car and a van");
  constexpr std::array kCities{"amsterdam",
                               "berlin_sample",
                               "delft",
                               "denhaag_01",
                               "euromast",
                               "lyon",
                               "new_york_mid",
                               "new_york_north",
                               "new_york_south",
                               "rotterdam",
                               "rotterdam_delfshaven",
                               "zurich_subset",
                               "zurich_far_origin"};
  constexpr std::size_t kStep = test::kSlowBuild ? 5 : 1;
  std::uint64_t contacts = 0;
  for (std::size_t k = kStep / 2; k < kCities.size(); k += kStep) {
    const std::string name = kCities[k];
    const auto city = *test::outside_data("cities/" + name + ".ply");
    SCOPED_TRACE(name);
    const json object =
        answer({city.string(), "--mover", test::outside_data("3ds/car_disim.3ds")->string(),
                "--mover", test::outside_data("3ds/van_disim.3ds")->string(), "--count", "30",
                "--frames", "12", "--verify"});
    EXPECT_EQ(object["verified"]["wrong"], 0);
    EXPECT_GT(object["movers"], 0);
    contacts += object["contacts"].get<std::uint64_t>();
  }
  EXPECT_GT(contacts, 0U);
}

}  // namespace

}  // namespace soms
