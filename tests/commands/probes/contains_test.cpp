#include "tests/commands/near.h"
#include "tests/support/pipe.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace soms::test {
namespace {

const std::string kPoints = "x,y,z\n0,0,0\n1,0.5,-0.25\n1.5,0,0\n-1,-1,-1\n1e80,0,0\n";

/// Answers about points beside the box [-1, 1]^3. The verb must succeed and have nothing to remark.
std::vector<Json> answers(std::vector<std::string> words, const std::string& points = kPoints) {
  words.insert(words.begin(), {"contains", box(), "--points", "-", "--json"});
  const RunResult result = soms_run(words, points);
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(result.err, "");
  return json_lines(result.out);
}

std::vector<std::string> sides(const std::vector<Json>& answers) {
  std::vector<std::string> sides;
  for (const Json& answer : answers) {
    EXPECT_EQ(answer.at("row"), sides.size());
    sides.push_back(answer.at("side"));
  }
  return sides;
}

const std::vector<std::string> kSides{"inside", "on", "outside", "on", "outside"};

TEST(ContainsVerb, AnswersInTheSchema) {
  const std::vector<Json> lines = answers({});
  EXPECT_EQ(sides(lines), kSides);
  for (const Json& answer : lines) {
    EXPECT_EQ(answer.at("schema"), "soms.contains/2");
    EXPECT_EQ(answer.at("coverage"), "complete");
    EXPECT_TRUE(answer.at("cost").contains("exact_tests"));
    EXPECT_FALSE(answer.contains("verified"));
  }
}

TEST(ContainsVerb, AnswersTheSameByAnyThreadsRuleAndOrderOfColumns) {
  EXPECT_EQ(answers({"--threads", "1"}), answers({"--threads", "2"}));
  for (const char* rule : {"sah", "spatial-median", "quality"}) {
    EXPECT_EQ(sides(answers({"--tree", std::string("rule=") + rule, "--tree", "leaf=1"})), kSides);
  }
  EXPECT_EQ(sides(answers({}, "z,x,y\n-0.25,1,0.5\n\n# a remark\n0,1.5,0\n")),
            (std::vector<std::string>{"on", "outside"}));
}

TEST(ContainsVerb, MovesTheModel) {
  EXPECT_EQ(sides(answers({"--pose", "2 0 0"})),
            (std::vector<std::string>{"outside", "on", "inside", "outside", "outside"}));
  EXPECT_EQ(sides(answers({"--scale", "2"})).at(2), "inside");
  const TemporaryFolder folder;
  const std::string one = file_of(folder, "one.csv", "x,y,z\n2,0,0\n");
  EXPECT_EQ(sides(answers({"--pose", one})).at(2), "inside");
  const std::string two = file_of(folder, "two.csv", "x,y,z\n2,0,0\n3,0,0\n");
  const RunResult many = soms_run({"contains", box(), "--points", "-", "--pose", two}, kPoints);
  EXPECT_EQ(many.status, 2);
  EXPECT_NE(many.err.find("two.csv: has more than one pose; give one pose of the model"),
            std::string::npos)
      << many.err;
}

TEST(ContainsVerb, ListsTheFirstPointsAndTotalsForPeople) {
  const TemporaryFolder folder;
  const std::string points = file_of(folder, "points.csv", kPoints);
  EXPECT_EQ(soms_run({"contains", box(), "--points", points}).out,
            " point  side       at\n"
            "     0  inside     (0, 0, 0)\n"
            "     1  on         (1, 0.5, -0.25)\n"
            "     2  outside    (1.5, 0, 0)\n"
            "     3  on         (-1, -1, -1)\n"
            "     4  outside    (1e+80, 0, 0)\n"
            "5 points: 1 inside, 2 outside, 2 on the surface\n");
  std::string many = "x,y,z\n";
  for (int i = 0; i < 3000; ++i) {
    many += "0,0,0\n";
  }
  const RunResult result = soms_run({"contains", box(), "--points", "-"}, many);
  EXPECT_EQ(std::count(result.out.begin(), result.out.end(), '\n'), 23);
  EXPECT_NE(result.out.find("   and 2,980 points more; --json lists all\n"
                            "3,000 points: 3,000 inside, 0 outside, 0 on the surface\n"),
            std::string::npos)
      << result.out;
}

TEST(ContainsVerb, VerifiesByBruteForce) {
  for (const Json& answer : answers({"--verify"})) {
    EXPECT_EQ(answer.at("verified"), true);
  }
  const RunResult text = soms_run({"contains", box(), "--points", "-", "--verify"}, kPoints);
  EXPECT_EQ(text.status, 0) << text.err;
  EXPECT_NE(text.out.find("verified by brute force: 5 of 5 answers equal\n"), std::string::npos);
}

TEST(ContainsVerb, RefusesAnOpenModelAndNamesItsEdges) {
  const TemporaryFolder folder;
  const std::string sheet = file_of(folder, "sheet.off", triangle_off("0 0 0", "1 0 0", "0 1 0"));
  const RunResult result = soms_run({"contains", sheet, "--points", "-"}, kPoints);
  EXPECT_EQ(result.status, 3);
  EXPECT_EQ(result.out, "");
  EXPECT_NE(result.err.find("sheet.off: not closed: 3 edges belong to an odd number of triangles, "
                            "the first of triangle 0 from (0, 0, 0) to (1, 0, 0)"),
            std::string::npos)
      << result.err;
  EXPECT_NE(result.err.find("; soms info lists these edges"), std::string::npos) << result.err;
}

TEST(ContainsVerb, LeavesOpenPartsOutOnRequest) {
  const TemporaryFolder folder;
  const std::string both = file_of(folder, "both.obj",
                                   "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\no whole\nf 1 3 2\nf 1 2 4\n"
                                   "f 2 3 4\nf 3 1 4\n"
                                   "o sheet\nv 5 0 0\nv 6 0 0\nv 5 1 0\nf 5 6 7\n");
  const std::string points = "x,y,z\n0.125,0.125,0.125\n5,0,0\n";
  EXPECT_EQ(soms_run({"contains", both, "--points", "-"}, points).status, 3);
  const RunResult result =
      soms_run({"contains", both, "--points", "-", "--closed-parts", "--json"}, points);
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_NE(result.err.find("both.obj: 1 triangle of open parts left out"), std::string::npos)
      << result.err;
  const std::vector<Json> lines = json_lines(result.out);
  EXPECT_EQ(sides(lines), (std::vector<std::string>{"inside", "outside"}));
  EXPECT_EQ(lines[0].at("triangles_left_out"), 1);
  EXPECT_FALSE(lines[1].contains("triangles_left_out"));
  const std::string sheet = file_of(folder, "sheet.off", triangle_off("0 0 0", "1 0 0", "0 1 0"));
  const RunResult none = soms_run({"contains", sheet, "--points", "-", "--closed-parts"}, points);
  EXPECT_EQ(none.status, 3);
  EXPECT_NE(none.err.find("no connected part is closed"), std::string::npos) << none.err;
}

/// The box [0, 1]^3 without its upper face.
std::string tub(const TemporaryFolder& folder) {
  return file_of(folder, "tub.off",
                 "OFF\n8 10 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n1 0 1\n1 1 1\n0 1 1\n"
                 "3 0 3 2\n3 0 2 1\n3 0 1 5\n3 0 5 4\n3 1 2 6\n3 1 6 5\n3 2 3 7\n3 2 7 6\n"
                 "3 3 0 4\n3 3 4 7\n");
}

const std::string kPlaces = "x,y,z\n0.5,0.5,0.5\n0.5,0.5,1\n0.5,0.5,1.5\n0.5,0,0.5\n";

TEST(ContainsVerb, SaysOfAnOpenModelThatThereIsWinding) {
  const TemporaryFolder folder;
  const RunResult result = soms_run({"contains", tub(folder), "--points", "-"}, kPlaces);
  EXPECT_EQ(result.status, 3);
  EXPECT_NE(result.err.find("or add --closed-parts, --by part, or --winding, which answers for "
                            "open models, too"),
            std::string::npos)
      << result.err;
}

TEST(ContainsVerb, AnswersForAnOpenModelByWinding) {
  const TemporaryFolder folder;
  const std::string model = tub(folder);
  const RunResult json =
      soms_run({"contains", model, "--points", "-", "--winding", "--json", "--verify"}, kPlaces);
  EXPECT_EQ(json.status, 0) << json.err;
  const std::vector<Json> lines = json_lines(json.out);
  EXPECT_EQ(sides(lines), (std::vector<std::string>{"inside", "undecided", "outside", "on"}));
  EXPECT_EQ(lines[0].at("boundary_edges"), 4);
  EXPECT_FALSE(lines[1].contains("boundary_edges"));
  EXPECT_EQ(lines[0].at("verified"), true);
  for (const Json& line : lines) {
    EXPECT_LE(line.at("lower").get<double>(), line.at("upper").get<double>());
    EXPECT_EQ(line.at("coverage"), "complete");
  }
  EXPECT_NEAR(lines[0].at("lower").get<double>(), 5.0 / 6, 1e-12);
  EXPECT_EQ(
      soms_run({"contains", model, "--points", "-", "--winding", "--width", "0"}, kPlaces).out,
      " point  side       winding       at\n"
      "     0  inside     0.833333333   (0.5, 0.5, 0.5)\n"
      "     1  undecided  0.5           (0.5, 0.5, 1)\n"
      "     2  outside    0.166666667   (0.5, 0.5, 1.5)\n"
      "     3  on         -             (0.5, 0, 0.5)\n"
      "4 points: 1 inside, 1 outside, 1 on the surface, 1 undecided\n");
}

TEST(ContainsVerb, WindingOfAClosedModelIsWhole) {
  const std::vector<Json> lines = answers({"--winding"});
  EXPECT_EQ(sides(lines), kSides);
  EXPECT_EQ(lines[0].at("lower"), 1.0);
  EXPECT_EQ(lines[0].at("upper"), 1.0);
  EXPECT_EQ(lines[2].at("lower"), 0);
  EXPECT_EQ(lines[2].at("upper"), 0);
  EXPECT_EQ(answers({"--winding", "--threads", "1"}), answers({"--winding", "--threads", "2"}));
}

TEST(ContainsVerb, AnswersByPartAndNamesOpenOnes) {
  const TemporaryFolder folder;
  const std::string yard =
      file_of(folder, "yard.obj",
              "v 0 0 0\nv 4 0 0\nv 0 4 0\nv 0 0 4\nv 1 1 5\nv 2 1 5\nv 1 2 5\n"
              "o stone\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\no flag\nf 5 6 7\n");
  const std::string points = "x,y,z\n0.5,0.5,0.5\n1,0,1\n9,9,9\n1,1,5\n";
  const RunResult json =
      soms_run({"contains", yard, "--points", "-", "--by", "part", "--json", "--verify"}, points);
  EXPECT_EQ(json.status, 0) << json.err;
  EXPECT_NE(
      json.err.find("yard.obj: 1 of 2 parts not closed, and no point is inside of them: flag"),
      std::string::npos)
      << json.err;
  const std::vector<Json> lines = json_lines(json.out);
  ASSERT_EQ(lines.size(), 4U);
  ASSERT_EQ(lines[0].at("parts").size(), 1U);
  EXPECT_EQ(lines[0].at("parts")[0].at("name"), "stone");
  EXPECT_EQ(lines[0].at("parts")[0].at("side"), "inside");
  EXPECT_EQ(lines[0].at("open_parts")[0].at("name"), "flag");
  EXPECT_EQ(lines[0].at("open_parts")[0].at("odd_edges"), 3);
  EXPECT_EQ(lines[1].at("parts")[0].at("side"), "on");
  EXPECT_EQ(lines[2].at("parts"), Json::array());
  EXPECT_EQ(lines[3].at("parts")[0].at("name"), "flag");
  EXPECT_EQ(lines[3].at("verified"), true);
  const RunResult text = soms_run({"contains", yard, "--points", "-", "--by", "connected"}, points);
  EXPECT_EQ(text.out,
            " point  at, and parts that hold it\n"
            "     0  (0.5, 0.5, 0.5): inside the part of triangle 0\n"
            "     1  (1, 0, 1): on the surface of the part of triangle 0\n"
            "     2  (9, 9, 9): in no part\n"
            "     3  (1, 1, 5): on the surface of the part of triangle 4\n"
            "4 points: 3 in or on 2 parts, 1 of them closed\n");
}

TEST(ContainsVerb, RefusesQuestionsThatDoNotGoTogether) {
  for (const std::vector<std::string>& words :
       std::vector<std::vector<std::string>>{{"--width", "1e-6"},
                                             {"--winding", "--width", "2"},
                                             {"--winding", "--width", "-1"},
                                             {"--winding", "--closed-parts"},
                                             {"--winding", "--by", "part"},
                                             {"--by", "connected", "--closed-parts"},
                                             {"--by", "triangle"}}) {
    std::vector<std::string> all{"contains", box(), "--points", "-"};
    all.insert(all.end(), words.begin(), words.end());
    EXPECT_EQ(soms_run(all, kPoints).status, 2) << words.back();
  }
}

TEST(ContainsVerb, NamesWhatIsWrongWithPoints) {
  const std::vector<std::pair<const char*, const char*>> cases{
      {"", "standard input: no header"},
      {"x,y\n1,2\n", "begin with x,y,z"},
      {"x,y,z,qw,qx,qy,qz\n0,0,0,1,0,0,0\n", "remove the column \"qw\", or begin with x,y,z"},
      {"x,y,z\n0,0,0\n0,zero,0\n", "standard input, line 3: y is \"zero\", not a number"},
      {"x,y,z\n0,nan,0\n", "line 2: y is \"nan\", not a finite number"},
      {"x,y,z\n0,0,0\n1e200,0,0\n", "standard input: point 1: x exceeds 2^300"}};
  for (const auto& [points, message] : cases) {
    const RunResult result = soms_run({"contains", box(), "--points", "-", "--json"}, points);
    EXPECT_EQ(result.status, 3) << points;
    EXPECT_NE(result.err.find(message), std::string::npos) << result.err;
  }
  const RunResult missing = soms_run({"contains", box(), "--points", "no/such.csv"});
  EXPECT_EQ(missing.status, 3);
  EXPECT_NE(missing.err.find("no/such.csv"), std::string::npos) << missing.err;
}

TEST(ContainsVerb, AnswersTheRowsBeforeAFaultyOne) {
  const RunResult result =
      soms_run({"contains", box(), "--points", "-", "--json"}, "x,y,z\n0,0,0\n3,0,0\n0,x,0\n");
  EXPECT_EQ(result.status, 3);
  EXPECT_EQ(sides(json_lines(result.out)), (std::vector<std::string>{"inside", "outside"}));
}

TEST(ContainsVerb, RefusesWrongUsage) {
  EXPECT_EQ(soms_run({"contains", box()}).status, 2);
  EXPECT_EQ(soms_run({"contains", "-", "--points", "-"}, kPoints).status, 2);
  EXPECT_EQ(soms_run({"contains", box(), "--points", "-", "--clearance", "1"}, kPoints).status, 2);
}

TEST(ContainsVerb, HasNothingInsideOfAnEmptyModel) {
  const std::string empty = data("nasty/empty_mesh.ply").string();
  EXPECT_EQ(soms_run({"contains", empty, "--points", "-"}, kPoints).status, 3);
  const RunResult result =
      soms_run({"contains", empty, "--points", "-", "--allow-empty", "--json"}, kPoints);
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(sides(json_lines(result.out)), std::vector<std::string>(5, "outside"));
}

// A program that gives a point and waits is answered before the next one.
TEST(ContainsVerb, StopsWhenTimeIsUpWithWhatItHas) {
  const TemporaryFolder folder;
  const RunResult result = run_with_time(
      [&](const std::string& seconds) {
        const EndlessPipe points(folder.path() / seconds, "x,y,z", "0,0,0");
        return soms_run(
            {"contains", box(), "--points", points.path(), "--json", "--timeout", seconds});
      },
      [](const RunResult& run) { return !run.out.empty(); });
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_NE(result.err.find("out of time after"), std::string::npos) << result.err;
}

}  // namespace
}  // namespace soms::test
