// What passes through what between two frames: the log, and what the command writes.
#include "apps/soms/simulate/simulate_passages.h"

#include "soms/scene/replay.h"

#include "apps/soms/simulate/simulate_contacts.h"
#include "tests/commands/run.h"

#include <string>
#include <vector>

namespace soms::command {
namespace {

TEST(PassageLog, KeepsPassagesInOrder) {
  PassageLog log;
  StepReport report;
  report.environment_passages = {{.mover = 3, .part = 1, .i = 7, .j = 8}};
  report.mover_passages = {{.a = 0, .b = 2, .t = {0.5, 0.5}}};
  log.add({}, 0);
  log.add(report, 1);
  ASSERT_EQ(log.events().size(), 2U);
  EXPECT_EQ(log.between_movers(), 1U);
  EXPECT_EQ(log.events()[0].frame, 1U);
  EXPECT_FALSE(log.events()[0].between_movers());
  EXPECT_EQ(log.events()[0].passage, report.environment_passages[0]);
  EXPECT_TRUE(log.events()[1].between_movers());
  EXPECT_EQ(log.events()[1].other, 2U);
  EXPECT_EQ(log.events()[1].passage.t, (Bracket{0.5, 0.5}));
}

/// A wall across x, and a flat mover that is led by poses to this side and that side of it.
class PassageRun : public ::testing::Test {
 protected:
  PassageRun() {
    test::write_text(at("wall.off"), test::triangle_off("0 -5 -5", "0 5 -5", "0 0 5"));
    test::write_text(at("kite.off"), test::triangle_off("-1 0 0", "1 0 0", "1 1 0"));
    test::write_text(at("route.csv"),
                     "x,y,z,qw,qx,qy,qz\n"
                     "-3,0,0,1,0,0,0\n-2,0,0,1,0,0,0\n2,0,0,1,0,0,0\n4,0,0,1,0,0,0\n"
                     "0,0,0,1,0,0,0\n8,0,0,1,0,0,0\n");
  }

  [[nodiscard]] std::string at(const std::string& name) const {
    return (folder_.path() / name).string();
  }

  [[nodiscard]] test::RunResult run(const std::vector<std::string>& more) const {
    std::vector<std::string> words{"simulate", at("wall.off"),  "--mover", at("kite.off"),
                                   "--route",  at("route.csv"), "--quiet"};
    words.insert(words.end(), more.begin(), more.end());
    return test::soms_run(words);
  }

 private:
  test::TemporaryFolder folder_;
};

TEST_F(PassageRun, WritesARowForEachPassage) {
  ASSERT_EQ(run({"--swept", "-o", at("e.csv")}).status, 0);
  const auto rows = test::read_csv(at("e.csv"));
  ASSERT_EQ(rows.size(), 5U);
  const auto joined = [&](std::size_t row, std::size_t first, std::size_t count) {
    EXPECT_EQ(rows[row].size(), 19U);
    std::string text;
    for (std::size_t k = first; k < first + count; ++k) {
      text += (k == first ? "" : ",") + rows[row][k];
    }
    return text;
  };
  EXPECT_EQ(joined(0, 14, 5), "verdict,t_lower,t_upper,passing_triangle,passed_triangle");
  EXPECT_EQ(joined(1, 0, 7), "contact,0,kite,wall,wall,4,4");
  EXPECT_EQ(joined(1, 14, 5), ",,,,");
  EXPECT_EQ(joined(2, 0, 11), "passage,0,kite,wall,wall,2,2,1,,,");
  EXPECT_EQ(joined(2, 14, 1), "contact");
  EXPECT_NEAR(std::stod(rows[2][16]), 0.25, 1e-12);
  EXPECT_EQ(joined(3, 0, 7), "passage,0,kite,wall,wall,4,4");
  EXPECT_EQ(joined(4, 0, 7), "passage,0,kite,wall,wall,5,5");
  EXPECT_EQ(joined(4, 14, 5), "started,0,0,0,0");
}

TEST_F(PassageRun, TellsPeopleAndPrograms) {
  const test::RunResult table = run({"--swept"});
  EXPECT_NE(table.out.find("passages      3 on the way from frame to frame (3 with models of the "
                           "city, 0 between movers)\n"),
            std::string::npos)
      << table.out;
  EXPECT_NE(table.out.find("first of them "), std::string::npos) << table.out;
  const test::Json json = test::Json::parse(run({"--swept", "--json"}).out);
  EXPECT_EQ(json["swept"], true);
  EXPECT_EQ(json["passages"], 3);
  EXPECT_EQ(json["passages_between_movers"], 0);
  ASSERT_EQ(json["first_passages"].size(), 3U);
  const test::Json& first = json["first_passages"][0];
  EXPECT_EQ(first["mover"], 0);
  EXPECT_EQ(first["city"], "wall");
  EXPECT_EQ(first["frame"], 2);
  EXPECT_EQ(first["verdict"], "contact");
  const test::Json plain = test::Json::parse(run({"--json"}).out);
  EXPECT_FALSE(plain.contains("swept") || plain.contains("passages"));
  EXPECT_EQ(plain["hash"], json["hash"]);
  EXPECT_EQ(plain["contacts"], json["contacts"]);
}

TEST_F(PassageRun, FailsOnRequestWhereSomethingIsPassed) {
  EXPECT_EQ(run({"--frames", "3", "--fail-if", "contact"}).status, 0);
  EXPECT_EQ(run({"--frames", "3", "--swept", "--fail-if", "contact"}).status, 1);
  EXPECT_EQ(run({"--frames", "2", "--swept", "--fail-if", "contact"}).status, 0);
}

TEST_F(PassageRun, VerifiesThemByBruteForce) {
  const test::RunResult result = run({"--swept", "--verify", "--json"});
  EXPECT_EQ(result.status, 0) << result.err;
  const test::Json json = test::Json::parse(result.out);
  EXPECT_GE(json["verified_passages"]["passages"], 3);
  EXPECT_EQ(json["verified_passages"]["wrong"], 0);
  EXPECT_NE(run({"--swept", "--verify"}).out.find("and between   3 passages and "),
            std::string::npos);
  EXPECT_FALSE(test::Json::parse(run({"--verify", "--json"}).out).contains("verified_passages"));
}

TEST_F(PassageRun, RecordsThem) {
  ASSERT_EQ(run({"--swept", "--record", at("run.somsrec")}).status, 0);
  Replay replay(at("run.somsrec"));
  ASSERT_TRUE(replay.end());
  EXPECT_TRUE(replay.head().swept);
  std::vector<std::size_t> passages;
  for (std::uint64_t k = 0; k < replay.frames(); ++k) {
    passages.push_back(replay.frame(k).environment_passages.size());
  }
  EXPECT_EQ(passages, (std::vector<std::size_t>{0, 0, 1, 0, 1, 1}));
}

// The ones to frame 4 and from it have a contact at an end, which is an event.
TEST_F(PassageRun, ShowsOnAPageThoseThatNoFrameShows) {
  ASSERT_EQ(run({"--swept", "-o", at("p.html")}).status, 0);
  const std::string page = test::read_text(at("p.html"));
  EXPECT_NE(page.find("\"passages\":{\"row\":1,\"after\":[0.25"), std::string::npos);
  EXPECT_NE(page.find("],\"proved\":[1]}"), std::string::npos);
  EXPECT_NE(page.find("\"rows\":2,\"contacts\":{\"listed\":2,\"all\":2"), std::string::npos);
  ASSERT_EQ(run({"-o", at("q.html")}).status, 0);
  EXPECT_EQ(test::read_text(at("q.html")).find("\"passages\""), std::string::npos);
}

TEST_F(PassageRun, DoesNotGoWithAWindow) {
  EXPECT_EQ(run({"--swept", "--view"}).status, 2);
}

TEST_F(PassageRun, StandsBehindNearEvents) {
  ASSERT_EQ(run({"--swept", "--clearance", "1.5", "-o", at("e.csv")}).status, 0);
  for (const auto& row : test::read_csv(at("e.csv"))) {
    EXPECT_EQ(row.size(), 30U);
  }
}

// The note on steps that are longer than the mover has no point where ways are looked at.
TEST_F(PassageRun, NeedsNoShorterSteps) {
  test::write_text(at("points.csv"), "x,y,z\n-30,0,0\n30,0,0\n");
  test::write_text(at("dot.off"), test::triangle_off("0 0 0", "0.01 0 0", "0 0.01 0"));
  const auto status = [&](const std::vector<std::string>& more) {
    std::vector<std::string> words{"simulate", at("wall.off"),   "--mover",  at("dot.off"),
                                   "--route",  at("points.csv"), "--strict", "--quiet"};
    words.insert(words.end(), more.begin(), more.end());
    return test::soms_run(words).status;
  };
  EXPECT_EQ(status({}), 3);
  EXPECT_EQ(status({"--swept"}), 0);
}

}  // namespace
}  // namespace soms::command
