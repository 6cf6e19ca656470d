#include "tests/commands/run.h"

#include <gtest/gtest.h>

#include <fstream>
#include <string>
#include <vector>

namespace soms::test {
namespace {

const std::string kNote = "lines that start with an unknown keyword, not read: 1, ";

/// A triangle, and a line that is none by a slip of the hand.
std::string lossy(const TemporaryFolder& folder) {
  const std::string path = (folder.path() / "lossy.obj").string();
  std::ofstream(path) << "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nF 3 2 1\n";
  return path;
}

TEST(Notes, R115OfALossyFileReachWhoAsksForOverlap) {
  const TemporaryFolder folder;
  const std::string model = lossy(folder);
  const std::string page = (folder.path() / "page.html").string();
  const RunResult result = soms_run({"overlap", model, model, "--json", "-o", page});
  EXPECT_EQ(result.status, 0);
  EXPECT_NE(result.err.find(model + ": " + kNote), std::string::npos) << result.err;
  const Json row = json_lines(result.out).at(0);
  ASSERT_EQ(row.at("notes").size(), 1U);  // two bodies of one file
  EXPECT_NE(row.at("notes").at(0).get<std::string>().find(kNote), std::string::npos);
  EXPECT_NE(read_text(page).find(kNote), std::string::npos);
  EXPECT_EQ(soms_run({"overlap", model, model, "--strict"}).status, 3);
}

TEST(Notes, R115OfALossyFileReachWhoSimulates) {
  const TemporaryFolder folder;
  const std::string model = lossy(folder);
  const std::string page = (folder.path() / "page.html").string();
  const RunResult result =
      soms_run({"simulate", model, "--count", "1", "--frames", "2", "--json", "-o", page});
  EXPECT_NE(result.err.find(model + ": " + kNote), std::string::npos) << result.err;
  EXPECT_EQ(json_lines(result.out).at(0).at("notes").size(), 1U);
  EXPECT_NE(read_text(page).find(kNote), std::string::npos);
}

TEST(Notes, OfALossyFileAreInTheJsonOfConvert) {
  const TemporaryFolder folder;
  const std::string copy = (folder.path() / "copy.ply").string();
  const RunResult result = soms_run({"convert", lossy(folder), copy, "--json"});
  const Json notes = json_lines(result.out).at(0).at("notes");
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_NE(notes.at(0).get<std::string>().find(kNote), std::string::npos);
}

std::string write(const TemporaryFolder& folder, const char* name, const std::string& text) {
  const std::string path = (folder.path() / name).string();
  std::ofstream(path) << text;
  return path;
}

TEST(Notes, R117AnAxisThatTheFileContradictsIsReported) {
  const TemporaryFolder folder;
  const std::string model = (folder.path() / "ball.glb").string();
  ASSERT_EQ(soms_run({"generate", "sphere", "--triangles", "20", "-o", model}).status, 0);
  const std::string note = "the file declares that z is up";
  const RunResult result = soms_run({"overlap", model, model, "--up-b", "y", "--json"});
  EXPECT_NE(result.err.find(note), std::string::npos) << result.err;
  EXPECT_NE(json_lines(result.out).at(0).at("notes").dump().find(note), std::string::npos);
  EXPECT_EQ(soms_run({"overlap", model, model, "--up-b", "y", "--strict"}).status, 3);
  EXPECT_EQ(soms_run({"overlap", model, model, "--up-b", "z", "--strict"}).err, "");
}

TEST(Notes, OfPosesThatEndEarlierThanOthersReachWhoSimulates) {
  const TemporaryFolder folder;
  const std::string model = lossy(folder);
  const std::string head = "x,y,z,qw,qx,qy,qz\n";
  const std::string row = "0,0,0,1,0,0,0\n";
  const std::string two = write(folder, "two.csv", head + row + row);
  const std::string three = write(folder, "three.csv", head + row + row + row);
  const std::string note = "have 2 to 3 rows";
  const std::vector<std::string> run{"simulate", model,      "--mover", model,   "--route",
                                     two,        "--frames", "2",       "--json"};
  EXPECT_EQ(soms_run(run).err.find(note), std::string::npos);
  std::vector<std::string> uneven = run;
  uneven.insert(uneven.end(), {"--route", three});
  const RunResult result = soms_run(uneven);
  EXPECT_EQ(result.status, 0);
  EXPECT_NE(result.err.find(note), std::string::npos) << result.err;
  EXPECT_NE(json_lines(result.out).at(0).at("notes").dump().find(note), std::string::npos);
}

TEST(Notes, AreLeftOutWhereThereAreNone) {
  const TemporaryFolder folder;
  const std::string model = (folder.path() / "whole.obj").string();
  std::ofstream(model) << "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
  const RunResult result = soms_run({"overlap", model, model, "--json"});
  EXPECT_EQ(result.err, "");
  EXPECT_FALSE(json_lines(result.out).at(0).contains("notes"));
}

}  // namespace
}  // namespace soms::test
