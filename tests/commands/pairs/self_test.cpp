#include "tests/commands/run.h"

#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace soms::test {
namespace {

/// Two triangles that cross, a third with the corners of the first, and one with a corner of it.
constexpr const char* kFolded =
    "o first\nv 0 0 0\nv 2 0 0\nv 1 2 0\nf 1 2 3\n"
    "o second\nv 1 1 -1\nv 1 1 1\nv 3 1 0\nf 4 5 6\n"
    "o third\nf 3 2 1\n"
    "o fourth\nv 5 0 0\nv 5 1 0\nf 2 7 8\n";

class SelfVerb : public testing::Test {
 protected:
  void SetUp() override { std::ofstream(file()) << kFolded; }

  [[nodiscard]] std::string file() const { return (folder_.path() / "folded.obj").string(); }

  [[nodiscard]] std::string beside(const char* name) const {
    return (folder_.path() / name).string();
  }

 private:
  TemporaryFolder folder_;
};

std::string text_of(const std::string& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

TEST_F(SelfVerb, ListsWhatCrossesAndWhatIsDouble) {
  const RunResult result = soms_run({"self", file(), "--json", "-o", beside("rows.csv")});
  ASSERT_EQ(result.status, 0) << result.err;
  const Json answer = json_lines(result.out).at(0);
  EXPECT_EQ(answer.at("schema"), "soms.self/1");
  EXPECT_EQ(answer.at("any"), true);
  ASSERT_EQ(answer.at("pairs").size(), 2U);
  EXPECT_EQ(answer.at("pairs").at(0).at("triangles"), Json::parse("[0,1]"));
  EXPECT_EQ(answer.at("pairs").at(0).at("parts"), Json::parse(R"(["first","second"])"));
  EXPECT_EQ(answer.at("pairs").at(1).at("triangles"), Json::parse("[1,2]"));
  EXPECT_EQ(answer.at("duplicates").at(0).at("triangles"), Json::parse("[0,2]"));
  const std::string rows = text_of(beside("rows.csv"));
  EXPECT_NE(rows.find("\noverlap,0,0,first,1,1,second,1"), std::string::npos) << rows;
  EXPECT_NE(rows.find("\nduplicate,0,0,first,2,2,third,"), std::string::npos) << rows;
}

TEST_F(SelfVerb, SaysItInWords) {
  const RunResult result = soms_run({"self", file(), "--verify"});
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(result.out.find("2 pairs of triangles cross or touch beyond the corners"), 0U)
      << result.out;
  EXPECT_NE(result.out.find("1 pair of triangles has the same corners"), std::string::npos);
  EXPECT_NE(result.err.find("brute force finds the same"), std::string::npos) << result.err;
}

TEST_F(SelfVerb, FailsIfRequested) {
  EXPECT_EQ(soms_run({"self", file(), "--fail-if", "overlap"}).status, 1);
  EXPECT_EQ(soms_run({"self", file(), "--fail-if", "overlap", "--ignore", "second"}).status, 0);
  EXPECT_EQ(soms_run({"self", file(), "--any", "--fail-if", "overlap"}).status, 1);
  EXPECT_EQ(soms_run({"self", file(), "--by", "corner"}).status, 2);
  EXPECT_EQ(soms_run({"self", beside("none.obj")}).status, 3);
}

// Numbers are those of the file where parts are left out.
TEST_F(SelfVerb, KeepsTheNumbersOfTheFile) {
  const RunResult result = soms_run({"self", file(), "--json", "--ignore", "first"});
  ASSERT_EQ(result.status, 0) << result.err;
  const Json answer = json_lines(result.out).at(0);
  ASSERT_EQ(answer.at("pairs").size(), 1U);
  EXPECT_EQ(answer.at("pairs").at(0).at("triangles"), Json::parse("[1,2]"));
  EXPECT_EQ(answer.at("pairs").at(0).at("parts"), Json::parse(R"(["second","third"])"));
}

}  // namespace
}  // namespace soms::test
