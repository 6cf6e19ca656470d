// What comes near in a simulation: the log, its judge, and what the command writes.
#include "apps/soms/simulate/simulate_near.h"

#include "apps/soms/simulate/map_marks.h"
#include "apps/soms/simulate/simulate_verify_near.h"
#include "tests/commands/run.h"
#include "tests/report/reading.h"

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace soms::command {
namespace {

EnvironmentGap gap_at(MoverId mover, double distance) {
  return {.mover = mover, .part = 0, .i = 1, .j = 2, .distance = {distance, distance}};
}

TEST(NearLog, KeepsTheLeastGapOfEachStretchOfFrames) {
  NearLog log;
  auto add = [&, frame = 0U](std::vector<EnvironmentGap> gaps) mutable {
    StepReport report;
    report.environment_gaps = std::move(gaps);
    log.add(report, frame++);
  };
  add({gap_at(3, 2)});
  add({gap_at(1, 5), gap_at(3, 1)});
  add({gap_at(1, 5), gap_at(3, 1)});
  add({gap_at(1, 6)});
  add({});
  add({gap_at(3, 0.5)});
  log.finish();
  const std::vector<NearEvent>& events = log.events();
  ASSERT_EQ(events.size(), 3U);
  EXPECT_EQ(events[0].mover, 3U);
  EXPECT_EQ(events[0].begin, 0U);
  EXPECT_EQ(events[0].end, 2U);
  EXPECT_EQ(events[0].nearest, 1U);
  EXPECT_EQ(events[0].distance, (Bracket{1, 1}));
  EXPECT_EQ(events[1].mover, 1U);
  EXPECT_EQ(events[1].begin, 1U);
  EXPECT_EQ(events[1].end, 3U);
  EXPECT_EQ(events[1].nearest, 1U);
  EXPECT_EQ(events[2].begin, 5U);
  EXPECT_EQ(events[2].end, 5U);
  EXPECT_EQ(log.nearest(2), (std::vector<std::size_t>{2, 0}));
  EXPECT_EQ(log.without_touch(), 3U);
}

TEST(NearLog, NamesTheNearestEventOfEachPair) {
  NearLog log;
  auto add = [&, frame = 0U](std::vector<EnvironmentGap> gaps) mutable {
    StepReport report;
    report.environment_gaps = std::move(gaps);
    log.add(report, frame++);
  };
  add({gap_at(1, 5), gap_at(3, 2)});
  add({});
  add({gap_at(1, 4), gap_at(3, 3)});
  log.finish();
  ASSERT_EQ(log.events().size(), 4U);
  EXPECT_EQ(log.nearest_of_pairs(), (std::vector<std::size_t>{1, 2}));
}

TEST(NearLog, CountsTouchingAsDistanceNothing) {
  NearLog log;
  StepReport near;
  near.mover_gaps = {{.a = 1, .b = 2, .distance = {0.25, 0.25}}};
  StepReport touching;
  touching.movers = {{1, 2, 7, 8}, {1, 2, 7, 9}, {1, 3, 0, 0}};
  log.add(near, 0);
  log.add(touching, 1);
  log.add(near, 2);
  log.finish();
  ASSERT_EQ(log.events().size(), 2U);
  const NearEvent& event = log.events()[0];
  EXPECT_TRUE(event.between_movers() && event.touches());
  EXPECT_EQ(event.other, 2U);
  EXPECT_EQ(event.end, 2U);
  EXPECT_EQ(event.nearest, 1U);
  EXPECT_EQ(event.i, 7U);
  EXPECT_EQ(event.j, 8U);
  EXPECT_EQ(log.events()[1].other, 3U);
  EXPECT_EQ(log.between_movers(), 2U);
  EXPECT_EQ(log.without_touch(), 0U);
  EXPECT_TRUE(log.nearest(5).empty());
}

/// Movers 0 and 1 are 0.5 and 2 over the ground and 0.5 from each other, mover 2 touches the
/// ground, mover 3 is far from all.
class GapVerifierTest : public ::testing::Test {
 protected:
  GapVerifierTest() {
    Mesh ground;
    ground.vertices = {{-5, -5, 0}, {5, -5, 0}, {5, 5, 0}, {-5, 5, 0}};
    ground.triangles = {{0, 1, 2}, {0, 2, 3}};
    add_to_city(world_, Body(Shape(ground)), {});
    Mesh sail;
    sail.vertices = {{-0.5, 0, 0}, {0.5, 0, 0}, {0.25, 0, 1}};
    sail.triangles = {{0, 1, 2}};
    const Shape shape(sail);
    world_.models.push_back(make_model(shape, "sail", Kind::model));
    scene_.add_environment(world_.city[0]);
    for (const Vec3& at : {Vec3{0, 0, 0.5}, {0.25, 0, 2}, {-4, -3, 0}, {0, 0, 50}}) {
      world_.routes.emplace_back();
      poses_.push_back(Pose::translation(at.x, at.y, at.z));
      scene_.add_mover(Body(shape, poses_.back()));
    }
    report_ = scene_.step({.clearance = kClearance});
  }

  /// Enough frames that every mover is chosen.
  [[nodiscard]] VerifiedGaps judge(const StepReport& report) const {
    GapVerifier verifier(world_, kClearance, 1);
    VerifiedGaps sum;
    for (int frame = 0; frame < 40; ++frame) {
      sum += verifier.verify(report, poses_, {.threads = 2});
    }
    return sum;
  }

  static constexpr double kClearance = 0.75;
  World world_;
  Scene scene_;
  std::vector<Pose> poses_;
  StepReport report_;
};

TEST_F(GapVerifierTest, ConfirmsATrueReport) {
  ASSERT_EQ(report_.environment_gaps.size(), 1U);
  ASSERT_EQ(report_.mover_gaps.size(), 1U);
  ASSERT_FALSE(report_.environment.empty());
  const VerifiedGaps verified = judge(report_);
  EXPECT_EQ(verified.wrong, 0U);
  EXPECT_GT(verified.near, 40U);
  EXPECT_GT(verified.free, 10U);
}

TEST_F(GapVerifierTest, SeesALostAnAlteredAndAnInventedGap) {
  StepReport lost = report_;
  lost.environment_gaps.clear();
  EXPECT_GT(judge(lost).wrong, 0U);
  lost = report_;
  lost.mover_gaps.clear();
  EXPECT_GT(judge(lost).wrong, 0U);
  StepReport altered = report_;
  altered.environment_gaps[0].distance.upper += 1e-15;
  EXPECT_GT(judge(altered).wrong, 0U);
  altered = report_;
  altered.environment_gaps[0].j = 1 - altered.environment_gaps[0].j;
  EXPECT_GT(judge(altered).wrong, 0U);
  StepReport invented = report_;
  invented.environment_gaps.push_back(gap_at(3, 0.5));
  EXPECT_GT(judge(invented).wrong, 0U);
}

TEST_F(GapVerifierTest, KnowsWhichMoversAreNotTested) {
  world_.filter.ignored = {{0, 1}};
  EXPECT_GT(judge(report_).wrong, 0U);
  StepReport without = report_;
  without.mover_gaps.clear();
  EXPECT_EQ(judge(without).wrong, 0U);
}

/// A wall across x and two flat movers that are led by poses.
class NearRun : public ::testing::Test {
 protected:
  NearRun() {
    test::write_text(at("wall.off"), test::triangle_off("0 -5 -5", "0 5 -5", "0 0 5"));
    test::write_text(at("kite.off"), test::triangle_off("0 0 0", "1 0 0", "1 1 0"));
    std::string first = "x,y,z,qw,qx,qy,qz\n";
    std::string second = first;
    for (const std::string x : {"3", "2", "1", "0.5", "0", "1", "4", "0.25"}) {
      first += x + ",0,0,1,0,0,0\n";
      second += (x == "3" ? "4.5,0,0" : "4.5,0,50") + std::string(",1,0,0,0\n");
    }
    test::write_text(at("first.csv"), first);
    test::write_text(at("second.csv"), second);
  }

  [[nodiscard]] std::string at(const std::string& name) const {
    return (folder_.path() / name).string();
  }

  [[nodiscard]] test::RunResult run(const std::vector<std::string>& more) const {
    std::vector<std::string> words{"simulate",     at("wall.off"),   "--mover",
                                   at("kite.off"), "--route",        at("first.csv"),
                                   "--route",      at("second.csv"), "--quiet"};
    words.insert(words.end(), more.begin(), more.end());
    return test::soms_run(words);
  }

 private:
  test::TemporaryFolder folder_;
};

TEST_F(NearRun, WritesNearEventsBehindContacts) {
  ASSERT_EQ(run({"--clearance", "1", "-o", at("e.csv")}).status, 0);
  const auto rows = test::read_csv(at("e.csv"));
  ASSERT_EQ(rows.size(), 5U);
  const auto joined = [&](std::size_t row, std::size_t fields) {
    EXPECT_EQ(rows[row].size(), 25U);
    std::string text;
    for (std::size_t k = 0; k < fields; ++k) {
      text += (k == 0 ? "" : ",") + rows[row][k];
    }
    return text;
  };
  EXPECT_EQ(joined(0, 25),
            "event,mover,model,touched,part,begin,end,frames,contacts,most_pairs,most_frame,x,y,z,"
            "lower,upper,nearest,mover_triangle,triangle,ax,ay,az,bx,by,bz");
  EXPECT_EQ(joined(1, 11), "contact,0,kite,wall,wall,4,4,1,1,1,4");
  EXPECT_EQ(joined(2, 19), "near,0,kite,mover 1,kite,0,0,1,,,,,,,0.5,0.5,0,0,0");
  EXPECT_EQ(joined(3, 25), "near,0,kite,wall,wall,2,5,4,,,,,,,0,0,4,0,0,,,,,,");
  EXPECT_EQ(joined(4, 19), "near,0,kite,wall,wall,7,7,1,,,,,,,0.25,0.25,7,0,0");
  const auto expect_points = [&](std::size_t row, const std::vector<double>& expected) {
    for (std::size_t k = 0; k < 6; ++k) {
      EXPECT_NEAR(std::stod(rows[row][19 + k]), expected[k], 1e-14) << row << ", " << k;
    }
  };
  expect_points(2, {4, 0, 0, 4.5, 0, 0});
  expect_points(4, {0.25, 0, 0, 0, 0, 0});
  ASSERT_EQ(run({"--contacts", at("plain.csv")}).status, 0);
  EXPECT_EQ(test::read_text(at("plain.csv")),
            "mover,model,touched,part,triangle,begin,end,event\n0,kite,wall,wall,0,4,4,0\n");
}

TEST_F(NearRun, DoubtsNoBoxesWhoseGapIsWithinTheClearance) {
  test::write_text(at("t.off"), test::triangle_off("0 0 0", "1 0 0", "0 1 0"));
  test::write_text(at("p.csv"), "x,y,z\n0,0,3\n");
  const auto status = [&](const char* clearance) {
    return test::soms_run({"simulate", at("t.off"), "--mover", at("t.off"), "--route", at("p.csv"),
                           "--clearance", clearance, "--strict"})
        .status;
  };
  EXPECT_EQ(status("3"), 0);
  EXPECT_EQ(status("2.5"), 3) << "farther apart than either is long, and than the clearance";
}

TEST_F(NearRun, FailsOnRequestWhereSomethingComesNear) {
  const std::vector<std::string> apart{"--no-between-movers", "--frames", "2"};
  const auto status = [&](std::vector<std::string> words) {
    words.insert(words.end(), apart.begin(), apart.end());
    return run(words).status;
  };
  EXPECT_EQ(status({"--clearance", "1", "--fail-if", "near"}), 0) << "3 and 2 from the wall";
  EXPECT_EQ(status({"--clearance", "2", "--fail-if", "near"}), 1);
  EXPECT_EQ(status({"--clearance", "2", "--fail-if", "contact"}), 0);
  EXPECT_EQ(run({"--clearance", "0.125", "--no-between-movers", "--fail-if", "near"}).status, 1)
      << "it touches in frame 4";
  const test::RunResult idle = run({"--fail-if", "near"});
  EXPECT_EQ(idle.status, 2);
  EXPECT_NE(idle.err.find("--fail-if near has no effect without --clearance"), std::string::npos);
}

TEST_F(NearRun, TellsTheNearestToPeopleAndPrograms) {
  const test::RunResult table = run({"--clearance", "1", "--verify"});
  EXPECT_EQ(table.status, 0) << table.err;
  for (const char* const line :
       {"near          3 within 1 m (2 with models of the city, 1 between movers), 2 of them "
        "without a touch\n",
        "nearest       kite 0 and wall: 0.25 m in frame 7\n",
        "              kite 0 and kite 1: 0.5 m in frame 0\n", "by brute force, 0 wrong\n"}) {
    EXPECT_NE(table.out.find(line), std::string::npos) << line << table.out;
  }
  const test::Json json = test::Json::parse(run({"--clearance", "1", "--verify", "--json"}).out);
  EXPECT_EQ(json["clearance"], 1.0);
  EXPECT_EQ(json["near"], 3);
  EXPECT_EQ(json["near_between_movers"], 1);
  EXPECT_EQ(json["near_without_contact"], 2);
  ASSERT_EQ(json["nearest"].size(), 2U);
  test::Json nearest = json["nearest"][0];
  ASSERT_EQ(nearest["points"].size(), 2U);
  EXPECT_NEAR(nearest["points"][0][0].get<double>(), 0.25, 1e-15);
  EXPECT_NEAR(nearest["points"][1][0].get<double>(), 0, 1e-15);
  nearest.erase("points");
  EXPECT_EQ(nearest, test::Json::parse(R"({"mover":0,"model":"kite","city":"wall","part":"wall",
      "begin":7,"end":7,"frame":7,"lower":0.25,"upper":0.25,"triangles":[0,0]})"));
  EXPECT_EQ(json["nearest"][1]["other_mover"], 1);
  EXPECT_EQ(json["verified_gaps"]["wrong"], 0);
  EXPECT_GT(json["verified_gaps"]["near"].get<int>(), 3);
  const test::Json plain = test::Json::parse(run({"--json"}).out);
  EXPECT_FALSE(plain.contains("near") || plain.contains("clearance"));
  EXPECT_EQ(plain["hash"], json["hash"]);
  EXPECT_EQ(plain["contacts"], json["contacts"]);
}

TEST_F(NearRun, ListsTheNearestOnItsPage) {
  ASSERT_EQ(run({"--clearance", "1", "-o", at("p.html")}).status, 0);
  const std::string page = test::read_text(at("p.html"));
  EXPECT_NE(page.find("<summary>Near, within 1 m, without a touch</summary>"), std::string::npos);
  EXPECT_NE(page.find("<tr><td><a href=\"#gap=0\">kite 0</a></td><td>wall</td><td>0.25 m</td>"
                      "<td>7</td><td>7</td><td>7</td><td>(0.25, 0, 0)</td>"),
            std::string::npos);
  const test::Json scene = test::scene_of(page);
  EXPECT_EQ(scene["gaps"]["lengths"], (std::vector<std::string>{"0.25 m", "0.5 m"}));
  EXPECT_EQ(scene["gaps"]["all"], 2);
  const std::vector<std::uint32_t> words = test::words_of(test::element(page, "gaps"));
  ASSERT_EQ(words.size(), 52U);
  const auto bodies = [&](std::size_t gap) {
    return std::pair(scene["bodies"]["names"][words[26 * gap]].get<std::string>(),
                     scene["bodies"]["names"][words[26 * gap + 1]].get<std::string>());
  };
  EXPECT_EQ(bodies(0), std::pair(std::string("kite 0"), std::string("wall")));
  EXPECT_EQ(bodies(1), std::pair(std::string("kite 0"), std::string("kite 1")));
  EXPECT_EQ(words[4], 7U) << "the frame of the least distance";
  ASSERT_EQ(run({"-o", at("plain.html")}).status, 0);
  EXPECT_EQ(test::scene_of(test::read_text(at("plain.html")))["gaps"]["listed"], 0);
}

TEST_F(NearRun, DrawsTheLeastGapOfEachPairOnItsMap) {
  ASSERT_EQ(run({"--clearance", "1", "-o", at("m.svg")}).status, 0);
  const std::string map = test::read_text(at("m.svg"));
  EXPECT_NE(map.find(">0.25 m</text>"), std::string::npos);
  EXPECT_EQ(map.find(">0.5 m</text>"), std::string::npos) << "it lies beyond the map";
  EXPECT_NE(map.find(">2 gaps without a touch</text>"), std::string::npos);
  ASSERT_EQ(run({"-o", at("plain.svg")}).status, 0);
  EXPECT_EQ(test::read_text(at("plain.svg")).find("id=\"gaps\""), std::string::npos);
}

TEST(MapLabels, LeaveOutWhatWouldCoverAnother) {
  const std::vector<Label> labels{{0, 0}, {59, 0}, {60, 0}, {0, 9}, {0, 10}, {500, 500}};
  EXPECT_EQ(labels_with_room(labels, {}, 60, 10, 9), (std::vector<std::size_t>{0, 2, 4, 5}));
  EXPECT_EQ(labels_with_room(labels, {}, 60, 10, 2), (std::vector<std::size_t>{0, 2}));
  EXPECT_EQ(labels_with_room(labels, {{500, 491}, {60, -9}}, 60, 10, 9),
            (std::vector<std::size_t>{0, 4}));
}

TEST_F(NearRun, LeavesOutWhatIsNotTested) {
  const test::Json json =
      test::Json::parse(run({"--clearance", "1", "--no-between-movers", "--json"}).out);
  EXPECT_EQ(json["near_between_movers"], 0);
  EXPECT_EQ(json["near"], 2);
}

TEST_F(NearRun, RefusesAClearanceThatIsNoLength) {
  for (const char* const clearance : {"0", "-1", "inf", "nan", "near"}) {
    const test::RunResult result = run({"--clearance", clearance});
    EXPECT_EQ(result.status, 2) << clearance;
    EXPECT_NE(result.err.find("--clearance"), std::string::npos) << result.err;
  }
}

}  // namespace
}  // namespace soms::command
