// Who touches what, from when to when: what the table of events says, by what --contacts says.
#include "tests/commands/run.h"
#include "tests/support/support.h"

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <tuple>
#include <vector>

namespace soms {

namespace {

TEST(SimulateEvents, AreStretchesOfTheContactsOfAMoverAndAPart) {
  const test::TemporaryFolder folder;
  const auto at = [&](const char* name) { return (folder.path() / name).string(); };
  const std::string contacts = at("contacts.csv");
  const std::string events = at("events.csv");
  ASSERT_EQ(
      test::soms_run({"generate", "city", "--triangles", "3000", "-o", at("town.ply")}).status, 0);
  const test::RunResult run =
      test::soms_run({"simulate", at("town.ply"), "--frames", "600", "--count", "80", "--contacts",
                      contacts, "-o", events, "--json"});
  ASSERT_EQ(run.status, 0) << run.err;
  const test::Json object = test::Json::parse(run.out);
  const auto rows = test::read_csv(contacts);
  using Who = std::tuple<std::string, std::string, std::string>;
  std::map<Who, std::set<std::uint64_t>> frames;
  for (std::size_t k = 1; k < rows.size(); ++k) {
    for (std::uint64_t frame = std::stoul(rows[k][5]); frame <= std::stoul(rows[k][6]); ++frame) {
      frames[{rows[k][0], rows[k][2], rows[k][3]}].insert(frame);
    }
  }
  std::multiset<std::tuple<Who, std::uint64_t, std::uint64_t>> expected;
  for (const auto& [who, touching] : frames) {
    for (auto frame = touching.begin(); frame != touching.end();) {
      const std::uint64_t begin = *frame;
      std::uint64_t end = begin;
      for (++frame; frame != touching.end() && *frame == end + 1; ++frame) {
        end = *frame;
      }
      expected.emplace(who, begin, end);
    }
  }
  const auto listed = test::read_csv(events);
  ASSERT_EQ(listed[0], (std::vector<std::string>{"event", "mover", "model", "touched", "part",
                                                 "begin", "end", "frames", "contacts", "most_pairs",
                                                 "most_frame", "x", "y", "z"}));
  std::multiset<std::tuple<Who, std::uint64_t, std::uint64_t>> found;
  std::uint64_t all = 0;
  for (std::size_t k = 1; k < listed.size(); ++k) {
    const auto& row = listed[k];
    ASSERT_EQ(row.size(), 14U);
    EXPECT_EQ(row[0], "contact");
    const std::uint64_t begin = std::stoul(row[5]);
    const std::uint64_t end = std::stoul(row[6]);
    found.emplace(Who{row[1], row[3], row[4]}, begin, end);
    EXPECT_EQ(std::stoul(row[7]), end - begin + 1);
    EXPECT_GE(std::stoul(row[9]), 1U);
    EXPECT_LE(begin, std::stoul(row[10]));
    EXPECT_LE(std::stoul(row[10]), end);
    all += std::stoul(row[8]);
  }
  EXPECT_EQ(found, expected);
  EXPECT_GT(found.size(), frames.size()) << "no two touch twice";
  EXPECT_EQ(object["events"], found.size());
  EXPECT_EQ(object["contacts"], all);
  for (std::size_t k = 1; k < rows.size(); ++k) {  // each contact names its event
    const auto& event = listed.at(1 + std::stoul(rows[k][7]));
    EXPECT_EQ(Who(event[1], event[3], event[4]), Who(rows[k][0], rows[k][2], rows[k][3]));
    EXPECT_LE(std::stoul(event[5]), std::stoul(rows[k][5]));
    EXPECT_GE(std::stoul(event[6]), std::stoul(rows[k][6]));
  }
}

}  // namespace

}  // namespace soms
