// Lists of clashes over time: older lists, groups of the same name, journals that were damaged, and
// filters at their limits.
#include "tests/commands/run.h"
#include "tests/support/support.h"

#include <array>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace soms::test {
namespace {

/// An OBJ file of boxes, written one by one.
class BoxFile {
 public:
  void add(const std::string& name, const Vec3& lower, const Vec3& upper) {
    text_ += "o " + name + "\n";
    for (unsigned k = 0; k < 8; ++k) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        text_ += (axis == 0 ? "v " : " ") +
                 std::to_string((k >> axis & 1U) != 0 ? upper[axis] : lower[axis]);
      }
      text_ += "\n";
    }
    for (const char* const face : {"1342", "5687", "1265", "3784", "1573", "2486"}) {
      text_ += "f";
      for (int k = 0; k < 4; ++k) {
        text_ += " " + std::to_string(vertices_ + face[k] - '0');
      }
      text_ += "\n";
    }
    vertices_ += 8;
  }

  std::string write(const std::filesystem::path& path) const {
    write_text(path, text_);
    return path.string();
  }

 private:
  std::string text_;
  int vertices_ = 0;
};

Json totals_of_list(const std::vector<std::string>& words) {
  const RunResult result = soms_run(words);
  EXPECT_EQ(result.status, 0) << result.err;
  return json_lines(result.out).back();
}

/// Three boxes in a row that cross each other, and one that is 0.5 off the last.
std::string row_of_boxes(const TemporaryFolder& folder) {
  BoxFile file;
  file.add("p1", {0, 0, 0}, {2, 1, 1});
  file.add("w", {1, 0, 0}, {4, 1, 1});
  file.add("t", {3, 0, 0}, {6, 1, 1});
  file.add("far", {6.5, 0, 0}, {7, 1, 1});
  return file.write(folder.path() / "row.obj");
}

TEST(ClashLists, WhatIsNotLookedAtIsNotResolved) {
  const TemporaryFolder folder;
  const std::string model = row_of_boxes(folder);
  const std::string old = (folder.path() / "old.json").string();
  ASSERT_EQ(soms_run({"clash", model, "--clearance", "1", "-o", old}).status, 0);
  const auto resolved = [&](const std::vector<std::string>& words) {
    std::vector<std::string> all = {"clash", model, "--baseline", old, "--json"};
    all.insert(all.end(), words.begin(), words.end());
    return totals_of_list(all).at("by_status").at("resolved").get<int>();
  };
  EXPECT_EQ(resolved({"--clearance", "1"}), 0);
  EXPECT_EQ(resolved({}), 0);                       // near ones are not looked for
  EXPECT_EQ(resolved({"--clearance", "0.25"}), 0);  // nor those that are farther
  EXPECT_EQ(resolved({"--set", "P=p1", "--set", "T=t", "--between", "T,row"}), 0);
  // What is gone is.
  BoxFile file;
  file.add("p1", {0, 0, 0}, {0.5, 1, 1});
  file.add("w", {1, 0, 0}, {4, 1, 1});
  file.add("t", {3, 0, 0}, {6, 1, 1});
  file.write(model);
  EXPECT_EQ(resolved({}), 1);
  EXPECT_EQ(resolved({"--clearance", "0.5"}), 1);
  EXPECT_EQ(resolved({"--clearance", "1"}), 1 + 1);  // the far box is gone, too, and was within 1
}

TEST(ClashLists, AListThatWasCutIsNoBaseline) {
  const TemporaryFolder folder;
  const std::string model = row_of_boxes(folder);
  const std::filesystem::path old = folder.path() / "old.json";
  ASSERT_EQ(soms_run({"clash", model, "-o", old.string()}).status, 0);
  std::string text = read_text(old);
  const std::string complete = R"("coverage":"complete")";
  const std::size_t at = text.find(complete);
  ASSERT_NE(at, std::string::npos);
  write_text(old, text.replace(at, complete.size(), R"("coverage":"cut")"));
  const RunResult result =
      soms_run({"clash", model, "--baseline", old.string(), "--fail-if", "new"});
  EXPECT_EQ(result.status, 3);
  EXPECT_NE(result.err.find("the list was cut by time or Ctrl-C"), std::string::npos) << result.err;
}

TEST(ClashLists, GroupsOfOneNameStayApart) {
  const TemporaryFolder folder;
  BoxFile walls;
  walls.add("wall", {0, 0, 0}, {10, 1, 3});
  walls.add("wall", {0, 5, 0}, {10, 6, 3});
  walls.add("post", {20, 0, 0}, {21, 1, 3});
  BoxFile pipes;
  pipes.add("x", {1, -1, 1}, {2, 2, 2});
  pipes.add("y", {4, -1, 1}, {5, 9, 2});
  pipes.add("z", {20.5, -1, 1}, {22, 9, 2});
  const Json totals =
      totals_of_list({"clash", walls.write(folder.path() / "walls.obj"), "--against",
                      pipes.write(folder.path() / "pipes.obj"), "--group-by", "a", "--json"});
  std::map<std::string, int> groups;
  for (const Json& group : totals.at("by_group")) {
    groups[group.at("group")] = group.at("pairs").get<int>();
  }
  ASSERT_EQ(groups.size(), 3U);
  EXPECT_EQ(groups.at("post"), 1);
  std::multiset<int> counts;
  for (const auto& [name, count] : groups) {
    counts.insert(count);
    EXPECT_TRUE(name == "post" || name.find("walls.obj, part ") != std::string::npos) << name;
  }
  EXPECT_EQ(counts, (std::multiset<int>{1, 1, 2}));
}

TEST(ClashLists, TheToleranceIsADepthThatNobodyMinds) {
  const TemporaryFolder folder;
  BoxFile file;
  file.add("a", {0, 0, 0}, {2, 2, 2});
  file.add("b", {1.75, 0.125, 0.125}, {4, 1.5, 1.5});
  const std::string model = file.write(folder.path() / "two.obj");
  EXPECT_EQ(totals_of_list({"clash", model, "--tolerance", "0.25", "--json"}).at("pairs"), 0);
  EXPECT_EQ(totals_of_list({"clash", model, "--tolerance", "0.2499", "--json"}).at("pairs"), 1);
  BoxFile hair;
  hair.add("a", {-100000, -100000, -1}, {100000, 100000, 0});
  hair.add("b", {-5, -5, -0.000001}, {5, 5, 3});
  const std::string thin = hair.write(folder.path() / "hair.obj");
  EXPECT_EQ(totals_of_list({"clash", thin, "--tolerance", "0", "--json"}).at("pairs"), 1);
}

// Wherever a byte is damaged, the answer is that of the run, or the journal is refused.
TEST(ClashLists, ADamagedJournalIsNotBelieved) {
  const TemporaryFolder folder;
  const std::string model = row_of_boxes(folder);
  const std::filesystem::path journal = folder.path() / "row.journal";
  const auto run = [&] {
    return soms_run(
        {"clash", model, "--clearance", "1", "--json", "--quiet", "--journal", journal.string()});
  };
  const auto rows = [](const RunResult& result) {
    std::vector<Json> lines = json_lines(result.out);
    lines.pop_back();
    return lines;
  };
  const std::vector<Json> right = rows(run());
  ASSERT_EQ(right.size(), 4U);
  const std::string whole = read_text(journal);
  int refused = 0;
  for (std::size_t at = 0; at < whole.size(); at += 7) {
    std::string text = whole;
    text[at] = static_cast<char>(text[at] ^ 1);
    write_text(journal, text);
    const RunResult again = run();
    refused += again.status == 0 ? 0 : 1;
    if (again.status == 0) {
      EXPECT_EQ(rows(again), right) << at;
    }
  }
  EXPECT_LT(refused, 40);  // the first line alone says whose journal it is
}

TEST(ClashLists, OptionsOfTheSecondSetNeedOne) {
  const TemporaryFolder folder;
  const std::string model = row_of_boxes(folder);
  for (const std::vector<std::string>& words : {std::vector<std::string>{"--scale-b", "2"},
                                                {"--up-b", "y"},
                                                {"--lod-b", "1"},
                                                {"--surfaces-b"}}) {
    std::vector<std::string> all = {"clash", model};
    all.insert(all.end(), words.begin(), words.end());
    const RunResult result = soms_run(all);
    EXPECT_EQ(result.status, 2) << words.front();
    EXPECT_NE(result.err.find("no effect without --against"), std::string::npos) << result.err;
  }
}

TEST(ClashLists, PairsToIgnoreMayHaveBlanksAndAByteOrderMark) {
  const TemporaryFolder folder;
  const std::string model = row_of_boxes(folder);
  const std::filesystem::path pairs = folder.path() / "pairs.csv";
  write_text(pairs, "\xef\xbb\xbfp1 , w\r\n\"w\" , \"t\"\n");
  EXPECT_EQ(
      totals_of_list({"clash", model, "--ignore-pairs", pairs.string(), "--json"}).at("pairs"), 0);
}

}  // namespace
}  // namespace soms::test
