#include "tests/commands/run.h"

#include <map>
#include <sstream>

namespace soms::test {
namespace {

using Row = std::vector<std::string>;

constexpr std::size_t kPair = 1;
constexpr std::size_t kMeshA = 2;
constexpr std::size_t kMeshB = 3;
constexpr std::size_t kPoseA = 5;
constexpr std::size_t kPoseB = 17;
constexpr std::size_t kOverlap = 29;
constexpr std::size_t kCount = 30;
constexpr std::size_t kHash = 31;

/// Files of meshes that lie in tests/data.
std::map<std::string, std::string> mesh_files() {
  std::map<std::string, std::string> files;
  for (const Row& row : read_csv(test::data("truth/meshes.csv"))) {
    const auto path = test::data("truth/" + row.at(1));
    if (std::filesystem::exists(path)) {
      files[row.at(0)] = path.string();
    }
  }
  return files;
}

/// Cases of each pair of meshes, in order.
std::map<int, std::vector<Row>> cases_by_pair() {
  std::map<int, std::vector<Row>> groups;
  const auto rows = read_csv(test::data("truth/cases.csv"));
  for (std::size_t k = 1; k < rows.size(); ++k) {
    groups[std::stoi(rows[k].at(kPair))].push_back(rows[k]);
  }
  return groups;
}

std::string pose_file(const std::vector<Row>& cases, std::size_t first) {
  std::string text = "r00,r01,r02,tx,r10,r11,r12,ty,r20,r21,r22,tz\n";
  for (const Row& row : cases) {
    for (std::size_t i = 0; i < 12; ++i) {
      text += (i == 0 ? "" : ",") + row.at(first + i);
    }
    text += "\n";
  }
  return text;
}

// Every case of the truth set whose meshes are kept with the tests, through the command: both
// bodies posed by files, answers compared by count and hash.
TEST(OverlapTruth, CountsAndHashesAgreeWithTheTruthSet) {
  const TemporaryFolder folder;
  const auto files = mesh_files();
  const std::string poses_a = (folder.path() / "a.csv").string();
  const std::string poses_b = (folder.path() / "b.csv").string();
  std::size_t decided = 0;
  for (const auto& [pair, cases] : cases_by_pair()) {
    const auto a = files.find(cases.front().at(kMeshA));
    const auto b = files.find(cases.front().at(kMeshB));
    if (a == files.end() || b == files.end()) {
      continue;
    }
    write_text(poses_a, pose_file(cases, kPoseA));
    write_text(poses_b, pose_file(cases, kPoseB));
    const RunResult result = soms_run({"overlap", a->second, b->second, "--pose", poses_a,
                                       "--pose-b", poses_b, "--json", "--no-pairs"});
    ASSERT_EQ(result.status, 0) << "pair " << pair << ": " << result.err;
    const std::vector<Json> answers = json_lines(result.out);
    ASSERT_EQ(answers.size(), cases.size());
    for (std::size_t k = 0; k < cases.size(); ++k) {
      const Row& row = cases[k];
      ASSERT_EQ(answers[k].at("pose"), k);
      ASSERT_EQ(answers[k].at("any"), row.at(kOverlap) == "1") << "case " << row.at(0);
      ASSERT_EQ(answers[k].at("count"), std::stoull(row.at(kCount))) << "case " << row.at(0);
      ASSERT_EQ(answers[k].at("hash"), row.at(kHash)) << "case " << row.at(0);
      ++decided;
    }
  }
  EXPECT_GE(decided, 3000U);
}

}  // namespace
}  // namespace soms::test
