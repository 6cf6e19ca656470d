#include "tests/commands/near.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace soms::test {
namespace {

std::vector<Json> relations(std::vector<std::string> words) {
  return near_answers("solid", std::move(words));
}

/// The relation of two boxes [-1, 1]^3, the first one moved.
std::string relation_at(const std::string& pose, std::vector<std::string> words = {}) {
  words.insert(words.end(), {"--pose", pose});
  return relations(words).at(0).at("relation");
}

TEST(SolidVerb, AnswersInTheSchema) {
  const Json answer = relations({"--pose", "1 0 0"}).at(0);
  EXPECT_EQ(answer.at("schema"), "soms.solid/2");
  EXPECT_EQ(answer.at("pose"), 0);
  EXPECT_EQ(answer.at("relation"), "crossing");
  EXPECT_EQ(answer.at("surfaces_meet"), true);
  EXPECT_EQ(answer.at("coverage"), "complete");
  EXPECT_TRUE(answer.at("cost").contains("exact_tests"));
  EXPECT_EQ(answer.at("why"), "none");
  EXPECT_FALSE(answer.contains("verified"));
}

TEST(SolidVerb, DecidesExactly) {
  EXPECT_EQ(relation_at("2 0 0"), "touching");
  EXPECT_EQ(relation_at("2.0000000000000004 0 0"), "clear");
  EXPECT_EQ(relation_at("1.9999999999999998 0 0"), "crossing");
  EXPECT_EQ(relation_at("0 0 0"), "same");
  EXPECT_EQ(relation_at("0 0 0", {"--scale", "0.5"}), "a_in_b");
  EXPECT_EQ(relation_at("0 0 0", {"--scale-b", "0.5"}), "b_in_a");
  EXPECT_EQ(relations({"--scale", "0.5"}).at(0).at("surfaces_meet"), false);
  EXPECT_EQ(relations({"--scale", "0.5", "--pose", "0.5 0 0"}).at(0).at("surfaces_meet"), true);
}

TEST(SolidVerb, SaysItInWords) {
  const auto text = [](const std::string& pose) {
    return soms_run({"solid", box(), box(), "--pose", pose}).out;
  };
  EXPECT_EQ(text("2 0 0"), "touching: surfaces meet, and no interior is shared\n");
  EXPECT_EQ(text("3 0 0"), "clear: nothing is shared\n");
  EXPECT_EQ(text("1 0 0"), "crossing: interior is shared, and each has more of its own\n");
  EXPECT_EQ(text("0 0 0"), "same: both fill the same space\n");
  EXPECT_EQ(soms_run({"solid", box(), box(), "--scale", "0.5"}).out,
            "A in B: " + box() + " is inside " + box() + "; the surfaces do not meet\n");
}

TEST(SolidVerb, ListsPosesAndTheirTotals) {
  const TemporaryFolder folder;
  const std::string poses =
      file_of(folder, "poses.csv", "x,y,z\n3,0,0\n2,0,0\n1,0,0\n0,0,0\n1,0,0\n");
  EXPECT_EQ(soms_run({"solid", box(), box(), "--pose", poses}).out,
            "  pose  relation   surfaces meet\n"
            "     0  clear      no\n"
            "     1  touching   yes\n"
            "     2  crossing   yes\n"
            "     3  same       yes\n"
            "     4  crossing   yes\n"
            "5 poses: 1 clear, 1 touching, 2 crossing, 1 same\n");
  EXPECT_EQ(relations({"--pose", poses, "--threads", "1"}),
            relations({"--pose", poses, "--threads", "2"}));
}

TEST(SolidVerb, VerifiesByBruteForce) {
  EXPECT_EQ(relations({"--pose", "0.5 2 0", "--verify"}).at(0).at("verified"), true);
}

TEST(SolidVerb, FailsOnRequestWhereInteriorIsShared) {
  const auto status = [](const std::string& pose, const std::string& scale) {
    return soms_run({"solid", box(), box(), "--pose", pose, "--scale", scale, "--fail-if", "solid"})
        .status;
  };
  EXPECT_EQ(status("3 0 0", "1"), 0);
  EXPECT_EQ(status("2 0 0", "1"), 0);
  EXPECT_EQ(status("1 0 0", "1"), 1);
  EXPECT_EQ(status("0 0 0", "1"), 1);
  EXPECT_EQ(status("0 0 0", "0.5"), 1);
}

TEST(SolidVerb, RefusesAnOpenModelWithTheCountOfItsOddEdges) {
  const TemporaryFolder folder;
  const std::string open = file_of(folder, "open.off", triangle_off("0 0 0", "1 0 0", "0 1 0"));
  const RunResult result = soms_run({"solid", box(), open});
  EXPECT_EQ(result.status, 3);
  EXPECT_NE(result.err.find("not closed: 3 edges belong to an odd number of triangles"),
            std::string::npos)
      << result.err;
  EXPECT_NE(result.err.find("--by part"), std::string::npos) << result.err;
}

/// The pairs of parts of tests/data/clash, as "A - B: relation".
TEST(SolidVerb, NamesThePartsThatAreNotClear) {
  const std::string a = data("clash/special.obj").string();
  const std::string b = data("clash/special_b.obj").string();
  const RunResult result = soms_run({"solid", a, b, "--by", "part", "--json", "--verify"});
  EXPECT_EQ(result.status, 0) << result.err;
  const Json answer = json_lines(result.out).at(0);
  EXPECT_EQ(answer.at("verified"), true);
  std::vector<std::string> found;
  for (const Json& pair : answer.at("parts")) {
    found.push_back(pair.at("a").at("name").get<std::string>() + " - " +
                    pair.at("b").at("name").get<std::string>() + ": " +
                    pair.at("relation").get<std::string>() +
                    (pair.at("surfaces_meet").get<bool>() ? ", meet" : ""));
  }
  EXPECT_EQ(found, (std::vector<std::string>{
                       "Slab - Stands on slab: touching, meet", "Slab - In slab: b_in_a",
                       "Slab - Crosses slab: crossing, meet", "Twin - Twin again: same, meet"}));
  EXPECT_EQ(soms_run({"solid", a, b, "--by", "part", "--fail-if", "solid"}).status, 1);
  EXPECT_EQ(soms_run({"solid", a, b, "--by", "part"}).out,
            "4 pairs of parts are not clear:\n"
            "  Slab and Stands on slab: touching\n"
            "  Slab and In slab: B in A\n"
            "  Slab and Crosses slab: crossing\n"
            "  Twin and Twin again: same\n");
}

TEST(SolidVerb, SaysWhetherTheSurfaceOfAnOpenPartMeets) {
  const TemporaryFolder folder;
  const auto meet = [&](const char* name, const std::string& triangle) {
    const std::string open = file_of(folder, name, triangle);
    const Json row =
        json_lines(soms_run({"solid", box(), open, "--by", "part", "--json"}).out).at(0);
    return row.at("parts").at(0).at("surfaces_meet").get<bool>();
  };
  // Both have boxes that meet the box's; the second one is within it.
  EXPECT_TRUE(meet("through.off", triangle_off("-9 -9 -9", "9 9 9", "9 9 8")));
  EXPECT_FALSE(meet("within.off", triangle_off("0.5 0.5 0.5", "0.625 0.5 0.5", "0.5 0.625 0.5")));
}

TEST(SolidVerb, NamesOpenPartsWithTheCountOfTheirOddEdges) {
  const TwoWalls walls;
  const std::string cube = data("clash/special.obj").string();
  const RunResult result = soms_run({"solid", walls.a, cube, "--by", "part"});
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(result.out,
            "1 pair of parts is not clear:\n  near and Slab: undecided, A is open at 3 edges\n");
  const Json pair = json_lines(soms_run({"solid", walls.a, cube, "--by", "part", "--json"}).out)
                        .at(0)
                        .at("parts")
                        .at(0);
  EXPECT_EQ(pair.at("relation"), "undecided");
  EXPECT_EQ(pair.at("why"), "open");
  EXPECT_EQ(pair.at("odd_edges"), Json({3, 0}));
}

TEST(SolidVerb, OverlapOffersItWhereOneBoxHoldsTheOther) {
  const auto text = [](const std::string& pose) {
    return soms_run({"overlap", box(), box(), "--scale", "0.5", "--pose", pose}).out;
  };
  EXPECT_NE(text("0 0 0").find("soms solid"), std::string::npos) << text("0 0 0");
  EXPECT_EQ(text("2 0 0").find("soms solid"), std::string::npos) << text("2 0 0");
}

}  // namespace
}  // namespace soms::test
