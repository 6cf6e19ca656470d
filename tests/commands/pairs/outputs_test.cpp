// -o FILE of verbs that answer row by row: the extension says what is written; and its old names.
#include "tests/commands/run.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace soms::test {
namespace {

using Words = std::vector<std::string>;

class Outputs : public testing::Test {
 protected:
  void SetUp() override {
    write_text(at("poses.csv"), "x,y,z\n0.5,0,0\n3.5,0,0\n9,0,0\n");
    write_text(at("points.csv"), "x,y,z\n0,0,0\n3,0.25,0\n");
    write_text(at("rays.csv"), "ox,oy,oz,dx,dy,dz\n-9,0.25,0.5,1,0,0\n9,9,9,1,0,0\n");
  }

  [[nodiscard]] std::string at(const std::string& name) const {
    return (folder_.path() / name).string();
  }

  [[nodiscard]] static std::string box() { return data("truth/meshes/box2.ply").string(); }

  /// Command lines of each verb, without outputs.
  [[nodiscard]] std::vector<Words> questions() const {
    std::vector<Words> questions;
    for (const Words& words : std::vector<Words>{{"overlap"},
                                                 {"overlap", "--by", "part"},
                                                 {"overlap", "--clearance", "1"},
                                                 {"distance"},
                                                 {"within", "--clearance", "1"},
                                                 {"solid"},
                                                 {"solid", "--by", "part"}}) {
      questions.push_back(words);
      questions.back().insert(questions.back().end(), {box(), box(), "--pose", at("poses.csv")});
    }
    for (const Words& words : std::vector<Words>{{"closest"},
                                                 {"closest", "--nearest", "2"},
                                                 {"closest", "--signed"},
                                                 {"contains"},
                                                 {"contains", "--winding"},
                                                 {"contains", "--by", "part"}}) {
      questions.push_back(words);
      questions.back().insert(questions.back().end(), {box(), "--points", at("points.csv")});
    }
    for (const Words& words : std::vector<Words>{{"ray"}, {"ray", "--any"}, {"ray", "--all"}}) {
      questions.push_back(words);
      questions.back().insert(questions.back().end(), {box(), "--rays", at("rays.csv")});
    }
    return questions;
  }

  [[nodiscard]] static RunResult run(Words words, const Words& more) {
    words.insert(words.end(), more.begin(), more.end());
    return soms_run(words);
  }

 private:
  TemporaryFolder folder_;
};

std::string without_costs(std::string text) {
  for (std::size_t begin = text.find("\"cost\""); begin != std::string::npos;
       begin = text.find("\"cost\"", begin)) {
    text.erase(begin, text.find('}', begin) + 1 - begin);
  }
  return text;
}

TEST_F(Outputs, LinesAreTheRowsOfJsonBesideTheText) {
  for (const Words& question : questions()) {
    const RunResult rows = run(question, {"--json"});
    const RunResult text = soms_run(question);
    const RunResult both = run(question, {"-o", at("a.jsonl")});
    EXPECT_EQ(both.status, 0) << both.err;
    EXPECT_EQ(both.out, text.out);
    EXPECT_EQ(without_costs(read_text(at("a.jsonl"))), without_costs(rows.out));
  }
}

TEST_F(Outputs, AJsonFileIsOneDocumentOfTheRows) {
  for (const Words& question : questions()) {
    const RunResult rows = run(question, {"--json", "-o", at("a.json")});
    ASSERT_EQ(rows.status, 0) << rows.err;
    const Json document = Json::parse(read_text(at("a.json")));
    ASSERT_EQ(document.size(), 1U);
    const std::vector<Json> lines = json_lines(rows.out);
    EXPECT_EQ(document.at("rows"), Json(lines)) << question.front();
  }
}

TEST_F(Outputs, ADocumentOfNoRowsIsAList) {
  write_text(at("none.csv"), "x,y,z\n");
  ASSERT_EQ(soms_run({"distance", box(), box(), "--pose", at("none.csv"), "-o", at("a.json"), "-o",
                      at("a.jsonl")})
                .status,
            0);
  EXPECT_EQ(read_text(at("a.json")), "{\"rows\":[]}\n");
  EXPECT_EQ(read_text(at("a.jsonl")), "");
}

TEST_F(Outputs, OldNamesWriteTheSameWithOneRemark) {
  const std::map<std::string, std::string> old{
      {"--csv", ".csv"}, {"--binary", ".npz"}, {"--report", ".html"}};
  for (const Words& question : questions()) {
    const std::string help = soms_run({question.front(), "--help"}).out;
    for (const auto& [name, extension] : old) {
      if (help.find(extension) == std::string::npos) {
        EXPECT_NE(run(question, {name, at("x")}).status, 0);
        continue;
      }
      EXPECT_EQ(help.find(name), std::string::npos) << help;
      const RunResult now = run(question, {"-o", at("now" + extension), "--threads", "1"});
      const RunResult before = run(question, {name, at("old"), "--threads", "1"});
      EXPECT_EQ(before.out, now.out);
      EXPECT_EQ(before.status, now.status);
      if (now.status != 0) {
        continue;  // arrays of several rows a point
      }
      EXPECT_EQ(before.err, name + " is now -o FILE" + extension +
                                "; the old form ends with the next release\n");
      EXPECT_EQ(read_text(at("old")), read_text(at("now" + extension))) << question.front();
      EXPECT_EQ(run(question, {name, at("old"), "--quiet"}).err, "");
    }
  }
}

TEST_F(Outputs, ManPagesAndCompletionKnowNoOldNames) {
  EXPECT_EQ(soms_run({"man", "distance"}).out.find("binary"), std::string::npos);
  EXPECT_NE(soms_run({"man", "distance"}).out.find("\\-\\-output"), std::string::npos);
  EXPECT_EQ(soms_run({"completion", "bash"}).out.find("--binary"), std::string::npos);
}

TEST_F(Outputs, OtherExtensionsAreRefusedWithAListOfThose) {
  const auto refused = [&](const Words& question, const std::string& file,
                           const std::string& message) {
    const RunResult result = run(question, {"-o", file});
    EXPECT_EQ(result.status, 2) << file;
    EXPECT_EQ(result.out, "");
    EXPECT_NE(result.err.find(message), std::string::npos) << result.err;
  };
  const Words distance{"distance", box(), box()};
  for (const char* const file : {"a.txt", "a", "a.csv.gz", "/dev/stdout"}) {
    refused(distance, file,
            std::string("-o ") + file +
                "; use one of the extensions .csv, .npz, .json, .jsonl, .html, .htm");
  }
  refused(distance, "", "-o \"\"; use one of the extensions");
  refused(distance, "-", "the answer is already written to standard output; give the name");
  refused({"solid", box(), box()}, "a.html", "use one of the extensions .csv, .npz, .json, .jsonl");
  const RunResult two = run(distance, {"-o", at("a.csv"), "-o", at("b.csv")});
  EXPECT_EQ(two.status, 2);
  EXPECT_NE(two.err.find("a.csv is given, too; give one file of each kind"), std::string::npos)
      << two.err;
  const RunResult read = run(distance, {"--pose", at("poses.csv"), "-o", at("poses.csv")});
  EXPECT_EQ(read.status, 2);
  EXPECT_NE(read.err.find("--pose names the same file"), std::string::npos) << read.err;
  EXPECT_NE(read_text(at("poses.csv")).find("0.5,0,0"), std::string::npos);
}

}  // namespace
}  // namespace soms::test
