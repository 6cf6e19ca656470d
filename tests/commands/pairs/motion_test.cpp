#include "apps/soms/pairs/motion_verify.h"
#include "tests/commands/near.h"
#include "tests/report/reading.h"
#include "tests/support/bodies.h"

#include <cmath>
#include <filesystem>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace soms::test {
namespace {

/// `soms motion` of a cube of edge 2 about the origin past one that stays there.
RunResult motion(std::vector<std::string> words) {
  words.insert(words.begin(), {"motion", box(), box()});
  return soms_run(words);
}

std::vector<Json> answers_of_motion(std::vector<std::string> words) {
  words.emplace_back("--json");
  const RunResult result = motion(std::move(words));
  EXPECT_EQ(result.status, 0) << result.err;
  return json_lines(result.out);
}

TEST(MotionVerb, AnswersInTheSchema) {
  const Json found = answers_of_motion({"--from", "6 0 0", "--by", "-8,0,0"}).at(0);
  EXPECT_EQ(found.at("schema"), "soms.motion/2");
  EXPECT_EQ(found.at("motion"), 0);
  EXPECT_EQ(found.at("verdict"), "contact");
  EXPECT_EQ(found.at("lower"), 0.5);
  EXPECT_EQ(found.at("upper"), 0.5);
  EXPECT_EQ(found.at("triangles").size(), 2U);
  EXPECT_EQ(found.at("point").at(0), 1);
  EXPECT_EQ(found.at("coverage"), "complete");
  EXPECT_TRUE(found.at("cost").contains("node_tests"));
  const Json free = answers_of_motion({"--from", "6 5 0", "--to", "-6 5 0"}).at(0);
  EXPECT_EQ(free.at("verdict"), "free");
  EXPECT_EQ(free.at("lower"), 1);
  EXPECT_TRUE(free.at("upper").is_null());
  EXPECT_FALSE(free.contains("triangles"));
  EXPECT_FALSE(free.contains("point"));
  EXPECT_FALSE(free.contains("normal"));
}

TEST(MotionVerb, SaysPlainlyWhatIsFound) {
  EXPECT_EQ(motion({"--from", "6 5 0", "--to", "-6 5 0"}).out, "free: no contact on the way\n");
  EXPECT_TRUE(motion({"--from", "6 0 0", "--by", "-8,0,0"})
                  .out.starts_with("first contact at t = 0.5: triangle "));
  EXPECT_TRUE(motion({"--to", "9 0 0"}).out.starts_with("in contact at the start: triangle "));
  EXPECT_EQ(motion({"--from", "6 5 0", "--to", "-6 5 0", "--clearance", "2.5"}).out,
            "free: no place within 2.5 on the way\n");
  EXPECT_TRUE(motion({"--from", "6 5 0", "--to", "-6 5 0", "--clearance", "3.5"})
                  .out.starts_with("first place within 3.5 at t = "));
}

TEST(MotionVerb, BothMayMove) {
  const Json met = answers_of_motion({"--from", "6 0 0", "--to", "0 0 0", "--pose-b", "-6 0 0",
                                      "--to-b", "0 0 0"})
                       .at(0);
  EXPECT_EQ(met.at("verdict"), "contact");
  EXPECT_NEAR(met.at("upper"), 5.0 / 6, 1e-9);  // 12 - 12 t = 2
  const Json free = answers_of_motion({"--from", "6 0 0", "--to", "0 0 0", "--pose-b", "0 0 0",
                                       "--to-b", "-6 0 0"})
                        .at(0);
  EXPECT_EQ(free.at("verdict"), "free");
  const RunResult page =
      motion({"--from", "6 0 0", "--to", "0 0 0", "--to-b", "1 0 0", "-o", "p.html"});
  EXPECT_EQ(page.status, 2);
  EXPECT_NE(page.err.find("a page shows one model that moves"), std::string::npos) << page.err;
}

TEST(MotionVerb, IsVerifiedByBruteForce) {
  const std::string right = "verified by brute force: 1 of 1 answer equal\n";
  for (const std::vector<std::string>& words : std::vector<std::vector<std::string>>{
           {"--from", "6 0 0", "--by", "-8,0,0"},
           {"--from", "6 5 0", "--to", "-6 5 0"},
           {"--from", "6 0 0", "--to", "-6 1 0 0 0 0 1"},
           {"--from", "2 0 0", "--by", "3,0,0"},
           {"--from", "2 0 0", "--by", "3,0,0", "--parting"},
           {"--from", "6 5 0", "--to", "-6 5 0", "--clearance", "3.5"},
           {"--from", "6 0 0", "--to", "0 0 0", "--pose-b", "-6 0 0", "--to-b", "0 0 0"}}) {
    std::vector<std::string> all = words;
    all.emplace_back("--verify");
    const RunResult result = motion(all);
    EXPECT_EQ(result.status, 0) << result.err;
    EXPECT_NE(result.out.find(right), std::string::npos) << result.out;
  }
}

TEST(MotionVerb, AnAnswerThatIsWrongIsFound) {
  const Shape cube(box_body({-1, -1, -1}, {1, 1, 1}));
  const RigidMotion to_left = RigidMotion::along(Pose::translation(6, 0, 0), {-8, 0, 0});
  const FirstContact right = first_contact(cube, to_left, Body(cube));
  for (const Vec3& by : {Vec3{0, 0, 0}, Vec3{0, 0.25, 0}}) {  // B rests, or moves
    const command::VerifiedMotion motion{cube, to_left, cube, RigidMotion::along(Pose(), by)};
    const auto is_wrong = [&](const FirstContact& answer) {
      return command::motion_difference(motion, answer, {}, {}).has_value();
    };
    EXPECT_FALSE(is_wrong(right));
    FirstContact late = right;
    late.t = {0.75, 0.75};
    EXPECT_TRUE(is_wrong(late));
    FirstContact early = right;
    early.t = {0.25, 0.25};
    EXPECT_TRUE(is_wrong(early));
    EXPECT_TRUE(is_wrong({.t = {1, std::numeric_limits<double>::infinity()}}));
    EXPECT_TRUE(is_wrong({.verdict = ContactVerdict::started}));
  }
}

TEST(MotionVerb, WhatTouchesMayPartOrGoOn) {
  EXPECT_EQ(motion({"--from", "2 0 0", "--by", "3,0,0", "--parting"}).out,
            "in contact at the start; no other on the way\n");
  const Json next = answers_of_motion({"--from", "2 0 0", "--by", "-9,0,0", "--parting"}).at(0);
  EXPECT_EQ(next.at("verdict"), "started");
  EXPECT_LE(next.at("upper"), 1);
  EXPECT_TRUE(next.contains("triangles"));
  const RunResult refused = motion({"--by", "1,0,0", "--parting", "--clearance", "1"});
  EXPECT_EQ(refused.status, 2);
  EXPECT_NE(refused.err.find("--parting"), std::string::npos);
}

// One word for one thing: other verbs had these names before -o.
TEST(MotionVerb, FilesHaveTheOldNamesOfOtherVerbsToo) {
  const TemporaryFolder folder;
  const std::string page = (folder.path() / "page.html").string();
  EXPECT_EQ(motion({"--from", "6 0 0", "--by", "-8,0,0", "--report", page}).status, 0);
  EXPECT_TRUE(std::filesystem::exists(page));
}

TEST(MotionVerb, APathHasAMotionLessThanPoses) {
  const TemporaryFolder folder;
  const std::string path = file_of(folder, "path.csv", "x,y,z\n9,0,0\n6,0,0\n-2,0,0\n-9,0,0\n");
  const std::vector<Json> answers = answers_of_motion({"--path", path});
  ASSERT_EQ(answers.size(), 3U);
  EXPECT_EQ(answers[0].at("verdict"), "free");
  EXPECT_EQ(answers[1].at("verdict"), "contact");
  EXPECT_NEAR(answers[1].at("upper").get<double>(), 0.5, 1e-9);
  EXPECT_EQ(answers[2].at("verdict"), "started");
  const std::string text = motion({"--path", path}).out;
  EXPECT_NE(text.find("3 motions: 1 free, 2 with contact (the first in motion 1, t = 0.5)\n"),
            std::string::npos)
      << text;
}

TEST(MotionVerb, RowsOfFilesAreMotions) {
  const TemporaryFolder folder;
  const std::string starts = file_of(folder, "starts.csv", "x,y,z\n6,0,0\n6,5,0\n");
  const std::string csv = (folder.path() / "motion.csv").string();
  const std::vector<Json> answers = answers_of_motion({"--from", starts, "--by", "-8,0,0"});
  ASSERT_EQ(answers.size(), 2U);
  EXPECT_EQ(answers[0].at("verdict"), "contact");
  EXPECT_EQ(answers[1].at("verdict"), "free");
  ASSERT_EQ(motion({"--from", starts, "--to", "-6 0 0", "-o", csv}).status, 0);
  EXPECT_EQ(read_text(csv).substr(0, 24), "motion,verdict,lower,upp");
}

/// The page of motions of a cube, with one that is free between two that are not.
std::string page_of_motions(std::vector<std::string> words) {
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "motion.html").string();
  words.insert(words.end(), {"-o", file});
  EXPECT_EQ(motion(std::move(words)).status, 0);
  return read_text(file);
}

TEST(MotionVerb, APageShowsFirstWhatIsNotFree) {
  const TemporaryFolder folder;
  const std::string starts = file_of(folder, "starts.csv", "x,y,z\n6,5,0\n6,0,0\n1,0,0\n");
  const std::string page = page_of_motions({"--from", starts, "--by", "-8,0,0"});
  EXPECT_NE(page.find("2 of 3 motions are not free. In motion 1 "), std::string::npos);
  EXPECT_NE(page.find(" is free until 0.5 of the way past "), std::string::npos);
  EXPECT_NE(page.find("<dt>motions</dt><dd>3: 2 not free, 1 free</dd>"), std::string::npos);
  EXPECT_NE(page.find("<td><a href=\"#motion=0\">0</a></td><td>free</td>"), std::string::npos);
  const Json scene = scene_of(page);
  const Json& motions = scene.at("motions");
  ASSERT_EQ(motions.size(), 3U);
  EXPECT_EQ(motions[0].at("number"), 1);
  EXPECT_EQ(motions[0].at("upper"), 0.5);
  EXPECT_EQ(motions[0].at("moment"), 0.5);
  EXPECT_EQ(motions[1].at("number"), 2);
  EXPECT_EQ(motions[1].at("words").get<std::string>().substr(0, 24), "in contact at the start;");
  EXPECT_EQ(motions[2].at("number"), 0);
  EXPECT_EQ(motions[2].at("blocked"), false);
  EXPECT_EQ(scene.at("rows"), 2);
  EXPECT_EQ(scene.at("contacts").at("listed"), 2);
}

TEST(MotionVerb, APageOfOneMotionSaysWhatItIs) {
  EXPECT_NE(
      page_of_motions({"--from", "6 5 0", "--by", "-8,0,0"}).find(" is free all the way past "),
      std::string::npos);
  const std::string near =
      page_of_motions({"--from", "6 0 0", "--by", "-8,0,0", "--clearance", "1"});
  EXPECT_NE(near.find("and within 1 "), std::string::npos);
  EXPECT_NE(near.find(" of A is near triangle "), std::string::npos);
}

TEST(MotionVerb, FailsUnlessAllIsFree) {
  EXPECT_EQ(motion({"--from", "6 0 0", "--by", "-8,0,0", "--fail-if", "contact"}).status, 1);
  EXPECT_EQ(motion({"--to", "9 0 0", "--fail-if", "contact"}).status, 1);
  EXPECT_EQ(motion({"--from", "6 5 0", "--by", "-8,0,0", "--fail-if", "contact"}).status, 0);
}

TEST(MotionVerb, RefusesWhatIsNoQuestion) {
  const std::vector<std::pair<std::vector<std::string>, std::string>> cases{
      {{"--from", "6 0 0"}, "neither --to, --by nor --path is given"},
      {{"--to", "1 0 0", "--by", "1,0,0"}, "--to, --by and --path exclude each other"},
      {{"--path", "p.csv", "--from", "1 0 0"}, "--path and --from exclude each other"},
      {{"--by", "1,0,0", "--pivot", "0,0,0"}, "--pivot has no effect with --by"},
      {{"--by", "1,0"}, "--by 1,0"},
      {{"--to", "1 0"}, "--to"},
      {{"--to", "1 0 0", "--clearance", "-1"}, "--clearance -1; give a length of 0 or more"},
      {{"--to", "1 0 0", "--fail-if", "overlap"}, "--fail-if"}};
  for (const auto& [words, message] : cases) {
    const RunResult result = motion(words);
    EXPECT_EQ(result.status, 2) << message;
    EXPECT_NE(result.err.find(message), std::string::npos) << result.err;
    EXPECT_EQ(result.out, "");
  }
}

}  // namespace
}  // namespace soms::test
