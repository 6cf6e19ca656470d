#include "tests/commands/run.h"

#include <gtest/gtest.h>

#include <fstream>
#include <string>

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
  const RunResult result = soms_run({"overlap", model, model, "--json", "--report", page});
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
      soms_run({"simulate", model, "--count", "1", "--frames", "2", "--json", "--report", page});
  EXPECT_NE(result.err.find(model + ": " + kNote), std::string::npos) << result.err;
  EXPECT_EQ(json_lines(result.out).at(0).at("notes").size(), 1U);
  EXPECT_NE(read_text(page).find(kNote), std::string::npos);
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
