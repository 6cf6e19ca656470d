#include "tests/commands/run.h"
#include "tests/support/pipe.h"

#include <algorithm>
#include <regex>
#include <utility>

namespace soms::test {
namespace {

constexpr const char* kEmptyHash = "cbf29ce484222325";

/// Answers to `words` after two boxes; each a JSON object.
std::vector<Json> ask(std::vector<std::string> words) {
  words.insert(words.begin(), {"overlap", box(), box(), "--json"});
  const RunResult result = soms_run(words);
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(result.err, "");
  return json_lines(result.out);
}

TEST(OverlapVerb, AnswersInTheSchema) {
  const Json answer = ask({"--pose", "1.5 0.25 0.25"}).at(0);
  EXPECT_EQ(answer.at("schema"), "soms.overlap/2");
  EXPECT_EQ(answer.at("pose"), 0);
  EXPECT_EQ(answer.at("any"), true);
  EXPECT_EQ(answer.at("coverage"), "complete");
  EXPECT_EQ(answer.at("hash").get<std::string>().size(), 16U);
  EXPECT_EQ(answer.at("count"), answer.at("pairs").size());
  EXPECT_GT(answer.at("cost").at("triangle_tests").get<int>(), 0);
  EXPECT_TRUE(answer.at("cost").contains("node_tests"));
  EXPECT_TRUE(answer.at("cost").contains("exact_tests"));
  const auto pairs = answer.at("pairs").get<std::vector<std::pair<unsigned, unsigned>>>();
  EXPECT_TRUE(std::is_sorted(pairs.begin(), pairs.end()));
}

TEST(OverlapVerb, FindsTouchingAndNothingBeyond) {
  EXPECT_EQ(ask({"--pose", "2 0 0"}).at(0).at("any"), true);
  const Json apart = ask({"--pose", "2.0000000000000004 0 0"}).at(0);
  EXPECT_EQ(apart.at("any"), false);
  EXPECT_EQ(apart.at("count"), 0);
  EXPECT_EQ(apart.at("hash"), kEmptyHash);
  EXPECT_EQ(apart.at("pairs"), Json::array());
}

TEST(OverlapVerb, AnyAndFirstStopEarly) {
  const Json all = ask({"--pose", "1 1 1"}).at(0);
  const Json first = ask({"--pose", "1 1 1", "--first"}).at(0);
  EXPECT_EQ(first.at("coverage"), "first");
  EXPECT_EQ(first.at("pairs"), Json::array({all.at("pairs").at(0)}));
  const Json any = ask({"--pose", "1 1 1", "--any"}).at(0);
  EXPECT_EQ(any.at("coverage"), "first");
  EXPECT_FALSE(any.contains("count"));
  ASSERT_EQ(any.at("pairs").size(), 1U);
  const auto& pairs = all.at("pairs");
  EXPECT_NE(std::find(pairs.begin(), pairs.end(), any.at("pairs").at(0)), pairs.end());
}

TEST(OverlapVerb, LimitCutsAndSaysSo) {
  const Json all = ask({}).at(0);
  ASSERT_GT(all.at("count").get<int>(), 3);
  const Json cut = ask({"--limit", "3"}).at(0);
  EXPECT_EQ(cut.at("coverage"), "cut");
  EXPECT_EQ(cut.at("count"), 3);
  EXPECT_EQ(ask({"--limit", "1000000"}).at(0).at("coverage"), "complete");
  EXPECT_EQ(soms_run({"overlap", box(), box(), "--limit", "3", "--any"}).status, 2);
  EXPECT_EQ(soms_run({"overlap", box(), box(), "--first", "--any"}).status, 2);
}

TEST(OverlapVerb, LeavesPairsOutWhenRequested) {
  const Json answer = ask({"--no-pairs"}).at(0);
  EXPECT_FALSE(answer.contains("pairs"));
  EXPECT_EQ(answer.at("hash"), ask({}).at(0).at("hash"));
  EXPECT_EQ(answer.at("count"), ask({}).at(0).at("count"));
}

TEST(OverlapVerb, SwapsColumnsWhenBodiesAreSwapped) {
  const std::string torus = test::data("truth/meshes/torus.ply").string();
  const auto pairs = [&](const std::string& a, const std::string& b, const char* option) {
    const RunResult result = soms_run({"overlap", a, b, option, "0.25 0.125 0", "--json"});
    return json_lines(result.out)
        .at(0)
        .at("pairs")
        .get<std::vector<std::pair<unsigned, unsigned>>>();
  };
  const auto there = pairs(torus, box(), "--pose");
  auto back = pairs(box(), torus, "--pose-b");
  for (auto& pair : back) {
    std::swap(pair.first, pair.second);
  }
  std::sort(back.begin(), back.end());
  EXPECT_FALSE(there.empty());
  EXPECT_EQ(there, back);
}

TEST(OverlapVerb, GivesTheSameLinesForAnyThreadsRuleAndTraversal) {
  const TemporaryFolder folder;
  std::string rows = "x,y,z\n";
  for (int i = 0; i < 300; ++i) {
    rows += std::to_string(0.0078125 * i) + ",0.5,0.25\n";
  }
  const std::string poses = (folder.path() / "poses.csv").string();
  write_text(poses, rows);
  const auto hashes = [&](std::vector<std::string> words) {
    words.insert(words.end(), {"--pose", poses, "--no-pairs"});
    std::vector<std::string> found;
    for (const Json& answer : ask(words)) {
      found.push_back(answer.at("hash"));
    }
    return found;
  };
  const auto expected = hashes({});
  ASSERT_EQ(expected.size(), 300U);
  EXPECT_NE(expected.front(), kEmptyHash);
  EXPECT_EQ(expected.back(), kEmptyHash);
  EXPECT_EQ(soms_run({"overlap", box(), box(), "--json", "--pose", poses, "--threads", "1"}).out,
            soms_run({"overlap", box(), box(), "--json", "--pose", poses, "--threads", "3"}).out);
  for (const char* rule : {"object-median", "object-mean", "spatial-median", "soms", "sah",
                           "soms-sah", "fast", "quality", "quick"}) {
    EXPECT_EQ(hashes({"--tree", std::string("rule=") + rule, "--tree", "leaf=1"}), expected)
        << rule;
  }
  for (const char* traversal : {"a-first", "b-first", "alternate", "larger", "simultaneous",
                                "ericson", "larsson", "e-node", "e-node-front", "default"}) {
    EXPECT_EQ(hashes({"--tree", std::string("traversal=") + traversal}), expected) << traversal;
  }
  for (const char* descent : {"both", "larger", "cross", "fewest"}) {
    EXPECT_EQ(hashes({"--tree", "traversal=e-node", "--tree", std::string("descent=") + descent}),
              expected)
        << descent;
  }
  const RunResult idle = soms_run({"overlap", box(), box(), "--tree", "descent=cross"});
  EXPECT_EQ(idle.status, 2);
  EXPECT_NE(idle.err.find("--tree descent has no effect: only E-Node has a descent; leave it "
                          "out, or also give --tree traversal=e-node or e-node-front"),
            std::string::npos)
      << idle.err;
}

TEST(OverlapVerb, CountsTheTrianglePairsOfANamedTraversal) {
  // One node a tree: its leaf holds all 12 triangles, so 12 x 12 pairs are looked at.
  const Json cost =
      ask({"--tree", "traversal=larger", "--tree", "levels=1", "--pose", "1.5 0.25 0.25"})
          .at(0)
          .at("cost");
  EXPECT_EQ(cost.at("node_tests"), 1);
  EXPECT_EQ(cost.at("entered"), 1);
  EXPECT_EQ(cost.at("leaf_pairs"), 1);
  EXPECT_EQ(cost.at("triangle_pairs"), 144);
  EXPECT_EQ(cost.at("first_tests"), 1);
  EXPECT_EQ(cost.at("max_stack"), 1);
  EXPECT_LT(cost.at("triangle_tests"), 144);
  EXPECT_FALSE(ask({}).at(0).at("cost").contains("triangle_pairs"));
  const RunResult text = soms_run({"overlap", box(), box(), "--tree", "traversal=larger", "--tree",
                                   "levels=1", "--pose", "1.5 0.25 0.25"});
  EXPECT_NE(
      text.out.find("  traversal larger: 1 box test, 1 pair entered, 1 leaf pair, 144 "
                    "triangle pairs, " +
                    std::to_string(cost.at("triangle_tests").get<int>()) + " of them decided\n"),
      std::string::npos)
      << text.out;
}

TEST(OverlapVerb, CountsANamedTraversalPoseByPose) {
  const TemporaryFolder folder;
  const std::string poses = (folder.path() / "poses.csv").string();
  write_text(poses, "x,y,z\n1.5,0.25,0.25\n9,0,0\n");
  const std::vector<Json> answers =
      ask({"--tree", "traversal=simultaneous", "--tree", "levels=1", "--pose", poses});
  ASSERT_EQ(answers.size(), 2U);
  EXPECT_EQ(answers[0].at("cost").at("triangle_pairs"), 144);
  EXPECT_EQ(answers[1].at("cost").at("triangle_pairs"), 0);
  EXPECT_EQ(answers[1].at("cost").at("node_tests"), 1);
}

TEST(OverlapVerb, VerifiesByBruteForce) {
  const Json answer = ask({"--verify", "--pose", "0.5 0 0"}).at(0);
  EXPECT_EQ(answer.at("verified"), true);
  for (const char* option : {"--any", "--first", "--limit=2", "--all"}) {
    EXPECT_EQ(soms_run({"overlap", box(), box(), "--verify", option}).status, 0) << option;
  }
  EXPECT_NE(soms_run({"overlap", box(), box(), "--verify"}).out.find("1 of 1 answer equal"),
            std::string::npos);
}

TEST(OverlapVerb, FailsOnRequestWhenThereIsOverlap) {
  EXPECT_EQ(soms_run({"overlap", box(), box(), "--fail-if", "overlap"}).status, 1);
  EXPECT_EQ(soms_run({"overlap", box(), box(), "--pose", "9 0 0", "--fail-if", "overlap"}).status,
            0);
  EXPECT_EQ(soms_run({"overlap", box(), box(), "--fail-if", "rain"}).status, 2);
}

TEST(OverlapVerb, ListsAFewPairsWithTheirPartsForPeople) {
  const std::string two = test::data("formats/two_objects.3ds").string();
  const RunResult result = soms_run({"overlap", two, two});
  EXPECT_EQ(result.status, 0) << result.err;
  const Json report = json_lines(soms_run({"info", two, "--json", "--no-trees"}).out).at(0);
  const std::string part = report.at("parts").at(0).at("name");
  EXPECT_NE(result.out.find("pairs of triangles overlap"), std::string::npos) << result.out;
  EXPECT_NE(result.out.find("0 (" + part + ") and 0 (" + part + ")"), std::string::npos)
      << result.out;
  EXPECT_NE(result.out.find("more; --json lists all"), std::string::npos);
  EXPECT_LE(std::count(result.out.begin(), result.out.end(), '\n'), 23);
  // A box within the box touches nothing of it; one beside it cannot be within.
  EXPECT_NE(soms_run({"overlap", box(), box(), "--scale", "0.5"}).out.find("surfaces only"),
            std::string::npos);
  EXPECT_EQ(soms_run({"overlap", box(), box(), "--pose", "4 0 0"}).out,
            "no triangles overlap: the boxes of the models are 2 apart\n");
}

TEST(OverlapVerb, SaysALineAPoseAndATotalForPeople) {
  const TemporaryFolder folder;
  const std::string poses = (folder.path() / "poses.csv").string();
  write_text(poses, "x,y,z\n0.5,0,0\n7,0,0\n");
  const RunResult result = soms_run({"overlap", box(), box(), "--pose", poses});
  EXPECT_TRUE(
      std::regex_search(result.out, std::regex("pose 0: \\d+ pairs of triangles overlap\n")))
      << result.out;
  EXPECT_NE(result.out.find("pose 1: no overlap\n2 poses: 1 with overlap, 1 without\n"),
            std::string::npos)
      << result.out;
}

TEST(OverlapVerb, HelpSaysSurfacesOnly) {
  EXPECT_NE(soms_run({"overlap", "--help"}).out.find("Only surfaces"), std::string::npos);
}

TEST(OverlapVerb, ScalesAndTurnsEachModel) {
  // [-1, 1]^3 scaled by 2 touches the other at distance 3, not at 3.5.
  EXPECT_EQ(ask({"--scale", "2", "--pose", "3 0 0"}).at(0).at("any"), true);
  EXPECT_EQ(ask({"--scale-b", "2", "--pose", "3 0 0"}).at(0).at("any"), true);
  EXPECT_EQ(ask({"--pose", "3 0 0"}).at(0).at("any"), false);
  EXPECT_EQ(ask({"--up", "y", "--up-b", "y"}).at(0).at("any"), true);
}

TEST(OverlapVerb, RefusesModelsThatAreNone) {
  const std::vector<std::pair<std::string, std::string>> cases{
      {"bad/no_such_file.ply", "no_such_file.ply"},
      {"bad/directory.ply", "directory.ply"},
      {"bad/ply_wrong_magic.ply", "ply_wrong_magic.ply"},
      {"nasty/empty_mesh.ply", "empty_mesh.ply"},
      {"bad/3ds_nan.3ds", "3ds_nan.3ds"}};
  for (const auto& [file, named] : cases) {
    for (const bool second : {false, true}) {
      const std::string bad = test::data(file).string();
      const RunResult result = second ? soms_run({"overlap", box(), bad, "--json"})
                                      : soms_run({"overlap", bad, box(), "--json"});
      EXPECT_EQ(result.status, 3) << file;
      EXPECT_TRUE(result.err.starts_with("soms overlap: ")) << result.err;
      EXPECT_NE(result.err.find(named), std::string::npos) << result.err;
      EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
      EXPECT_EQ(result.out, "");
    }
  }
}

TEST(OverlapVerb, AnEmptyModelOverlapsNothingWhenAccepted) {
  const std::string empty = test::data("nasty/empty_mesh.ply").string();
  const RunResult result = soms_run({"overlap", empty, box(), "--allow-empty", "--json"});
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(json_lines(result.out).at(0).at("any"), false);
}

TEST(OverlapVerb, RefusesCoordinatesThatMovingTakesOutOfRange) {
  const RunResult result = soms_run({"overlap", box(), box(), "--pose", "1e300 0 0"});
  EXPECT_EQ(result.status, 3) << result.out;
  EXPECT_NE(result.err.find("2^300"), std::string::npos) << result.err;
}

TEST(OverlapVerb, AnswersAreCutWhenTimeIsUp) {
  const TemporaryFolder folder;
  const std::string page = (folder.path() / "page.html").string();
  const std::string poses = (folder.path() / "poses.csv").string();
  std::string rows = "x,y,z\n";
  for (int i = 0; i < 2'000'000; ++i) {
    rows += "0.5,0,0\n";
  }
  write_text(poses, rows);
  const RunResult result = run_with_time(
      [&](const std::string& seconds) {
        return soms_run({"overlap", box(), box(), "--pose", poses, "--no-pairs", "--json", "-o",
                         page, "--timeout", seconds});
      },
      [](const RunResult& run) { return run.status != 4; });
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_NE(result.err.find("out of time after"), std::string::npos) << result.err;
  const std::vector<Json> answers = json_lines(result.out);
  ASSERT_FALSE(answers.empty());
  EXPECT_LT(answers.size(), 2'000'000U);
  EXPECT_EQ(answers.back().at("coverage"), "cut");
  EXPECT_EQ(answers.back().at("timed_out"), true);
  EXPECT_FALSE(answers.front().contains("timed_out"));
  const std::string html = read_text(page);
  EXPECT_NE(html.find("<dd>out of time after "), std::string::npos);
  EXPECT_NE(html.find("\"complete\":false"), std::string::npos);
  for (std::size_t k = 0; k + 1 < answers.size(); ++k) {
    ASSERT_EQ(answers[k].at("coverage"), "complete");
  }
}

TEST(OverlapVerb, KeepsWhatWasVerifiedWhenTimeIsUp) {
  const TemporaryFolder folder;
  const RunResult result = run_with_time(
      [&](const std::string& seconds) {
        const EndlessPipe poses(folder.path() / seconds, "x,y,z", "0.5,0,0");
        return soms_run({"overlap", box(), box(), "--pose", poses.path(), "--no-pairs", "--verify",
                         "--timeout", seconds});
      },
      [](const RunResult& run) { return run.status != 4; });
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_NE(result.err.find("out of time after"), std::string::npos) << result.err;
  EXPECT_NE(result.out.find("verified by brute force: "), std::string::npos);
}

// The rows are answered by then, as free, but brute force has not come to the last.
TEST(OverlapVerb, IsNotFreeWhereRowsWereNotVerifiedInTime) {
  const TemporaryFolder folder;
  const RunResult result = run_with_time(
      [&](const std::string& seconds) {
        const EndlessPipe poses(folder.path() / seconds, "x,y,z", "9,0,0");
        return soms_run({"overlap", box(), box(), "--pose", poses.path(), "--verify", "--fail-if",
                         "overlap", "--timeout", seconds});
      },
      [](const RunResult& run) { return !run.out.empty(); });
  EXPECT_EQ(result.status, 4) << result.err;
  EXPECT_NE(result.err.find("out of time after"), std::string::npos) << result.err;
  EXPECT_EQ(result.out.find("undecided"), std::string::npos);
}

TEST(OverlapVerb, HasNoAnswerWhenTimeIsUpBeforeTheFirst) {
  const RunResult result = soms_run({"overlap", box(), box(), "--timeout", "0"});
  EXPECT_EQ(result.status, 4) << result.err;
  EXPECT_NE(result.err.find("out of time while reading"), std::string::npos) << result.err;
}

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)

TEST(OverlapVerb, AnswersOrSaysThatMemoryIsShort) {
  const TemporaryFolder folder;
  const std::string city = (folder.path() / "city.ply").string();
  const std::string poses = (folder.path() / "poses.csv").string();
  ASSERT_EQ(soms_run({"generate", "city", "--triangles", "5672", "-o", city}).status, 0);
  write_text(poses, "x,y,z\n10,0,-3\n0,0,0\n");
  for (const char* most : {"15M", "20M", "40M", "1G"}) {
    const RunResult result =
        soms_run({"overlap", city, box(), "--pose", poses, "--max-memory", most});
    EXPECT_TRUE(result.status == 0 || result.status == 4)
        << most << ": status " << result.status << ", " << result.err;
  }
}

TEST(OverlapVerb, NeedsNoMoreMemoryForManyPosesThanForFew) {
  const TemporaryFolder folder;
  const auto resident = [&](int rows) {
    std::string text = "x,y,z,qw,qx,qy,qz\n";
    for (int i = 0; i < rows; ++i) {
      text += "0.5,0.25,0.125,1,0,0,0\n";
    }
    const std::string poses = (folder.path() / "poses.csv").string();
    write_text(poses, text);
    Child child(
        {command().string(), "overlap", box(), box(), "--pose", poses, "--json", "--threads", "2"},
        folder.path());
    EXPECT_EQ(child.wait().status, 0);
    return child.max_resident();
  };
  const long few = resident(2'000);
  const long many = resident(200'000);
  EXPECT_LT(many, few + 16L * 1024) << few << " KiB for 2,000 rows, " << many << " for 200,000";
}

TEST(OverlapVerb, StopsAtAMemoryLimit) {
  const RunResult result = soms_run({"generate", "knot", "--triangles", "50000000", "-o",
                                     "/dev/null", "--format", "ply", "--max-memory", "200MB"});
  EXPECT_EQ(result.status, 4) << result.err;
  EXPECT_NE(result.err.find("memory"), std::string::npos) << result.err;
}

#endif

}  // namespace
}  // namespace soms::test
