#include "soms/io/read_mesh.h"
#include "soms/scene/replay.h"

#include "tests/commands/run.h"

#include <algorithm>
#include <array>
#include <csignal>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <set>

namespace soms::test {
namespace {

/// A small town and a car as files.
class Town {
 public:
  Town() {
    EXPECT_EQ(soms_run({"generate", "city", "--triangles", "5000", "-o", path("town.ply")}).status,
              0);
    EXPECT_EQ(soms_run({"generate", "car", "-o", path("car.ply")}).status, 0);
  }

  [[nodiscard]] std::string path(const std::string& name) const {
    return (folder_.path() / name).string();
  }

  /// Simulates cars in the town.
  [[nodiscard]] RunResult simulate(const std::vector<std::string>& words) const {
    std::vector<std::string> all{"simulate", path("town.ply"), "--mover", path("car.ply")};
    all.insert(all.end(), words.begin(), words.end());
    return soms_run(all);
  }

  [[nodiscard]] std::vector<std::string> files() const { return files_in(folder_.path()); }

 private:
  TemporaryFolder folder_;
};

/// A mover, what it touches (0 the city, 1 a mover), and its number.
using Touch = std::array<std::uint32_t, 3>;

std::set<Touch> touches_of(const RecordedFrame& frame) {
  std::set<Touch> touches;
  for (const EnvironmentContact& contact : frame.environment) {
    touches.insert({contact.mover, 0, contact.j});
  }
  for (const MoverContact& contact : frame.movers) {
    touches.insert({contact.a, 1, contact.b});
  }
  return touches;
}

TEST(Record, HoldsWhatTheSimulationReported) {
  const Town town;
  const RunResult result = town.simulate(
      {"--count", "60", "--frames", "150", "--json", "--record", town.path("run.somsrec")});
  ASSERT_EQ(result.status, 0) << result.err;
  const Json said = Json::parse(result.out);
  Replay replay(town.path("run.somsrec"));
  ASSERT_TRUE(replay.end());
  EXPECT_EQ(replay.end()->ending, RecordingEnding::complete);
  EXPECT_EQ(replay.frames(), 150U);
  EXPECT_EQ(replay.head().movers.size(), said["movers"]);
  std::array<char, 17> hash{};
  std::snprintf(hash.data(), hash.size(), "%016llx",
                static_cast<unsigned long long>(replay.end()->hash));
  EXPECT_EQ(said["hash"], hash.data());
  std::uint64_t begun = 0;
  std::uint64_t between = 0;
  std::set<Touch> before;
  for (std::uint64_t i = 0; i < replay.frames(); ++i) {
    const std::set<Touch> now = touches_of(replay.frame(i));
    for (const Touch& touch : now) {
      const bool begins = before.count(touch) == 0;
      begun += begins ? 1U : 0U;
      between += begins && touch[1] == 1 ? 1U : 0U;
    }
    before = now;
  }
  EXPECT_GT(begun, 0U);
  EXPECT_EQ(said["contacts"], begun);
  EXPECT_EQ(said["contacts_between_movers"], between);
}

TEST(Record, HoldsPosesAtWhichTheContactsAreFoundAgain) {
  const Town town;
  ASSERT_EQ(
      town.simulate({"--count", "40", "--frames", "100", "--record", town.path("run.somsrec")})
          .status,
      0);
  Replay replay(town.path("run.somsrec"));
  Scene scene;
  scene.add_environment(Body(read_mesh(town.path("town.ply"))));
  const Shape car(read_mesh(town.path("car.ply")));
  EXPECT_EQ(replay.head().models.at(0).hash, corner_hash(car.mesh()));
  EXPECT_EQ(replay.head().models.at(0).source, town.path("car.ply"));
  for (std::size_t k = 0; k < replay.head().movers.size(); ++k) {
    scene.add_mover(Body(car));
  }
  std::size_t contacts = 0;
  for (std::uint64_t i = 0; i < replay.frames(); ++i) {
    const RecordedFrame& frame = replay.frame(i);
    for (MoverId k = 0; k < frame.poses.size(); ++k) {
      scene.set_pose(k, frame.poses[k]);
    }
    const StepReport report = scene.step();
    ASSERT_EQ(report.environment, frame.environment) << i;
    ASSERT_EQ(report.movers, frame.movers) << i;
    contacts += report.environment.size();
  }
  EXPECT_GT(contacts, 0U);
}

TEST(Record, HoldsTheGapsOfEveryFrameWithAClearance) {
  const Town town;
  const std::vector<std::string> words{"--count", "30", "--frames", "70"};
  const auto record = [&](const std::string& file, std::vector<std::string> more) {
    more.insert(more.end(), words.begin(), words.end());
    more.insert(more.end(), {"--json", "--record", town.path(file)});
    const RunResult result = town.simulate(more);
    EXPECT_EQ(result.status, 0) << result.err;
    return Json::parse(result.out);
  };
  const Json said = record("near.somsrec", {"--clearance", "0.75"});
  const Json without = record("run.somsrec", {});
  Replay near(town.path("near.somsrec"));
  Replay plain(town.path("run.somsrec"));
  EXPECT_EQ(near.head().clearance, 0.75);
  EXPECT_EQ(plain.head().clearance, 0);
  EXPECT_EQ(near.end(), plain.end());  // contacts and their hash
  Scene scene;
  scene.add_environment(Body(read_mesh(town.path("town.ply"))));
  const Shape car(read_mesh(town.path("car.ply")));
  for (std::size_t k = 0; k < near.head().movers.size(); ++k) {
    scene.add_mover(Body(car));
  }
  double least = 1;
  for (std::uint64_t i = 0; i < near.frames(); ++i) {
    const RecordedFrame& frame = near.frame(i);
    for (MoverId k = 0; k < frame.poses.size(); ++k) {
      scene.set_pose(k, frame.poses[k]);
    }
    const StepReport report = scene.step({.clearance = 0.75});
    ASSERT_EQ(report.environment_gaps, frame.environment_gaps) << i;
    ASSERT_EQ(report.mover_gaps, frame.mover_gaps) << i;
    EXPECT_TRUE(plain.frame(i).environment_gaps.empty());
    for (const EnvironmentGap& gap : frame.environment_gaps) {
      least = std::min(least, gap.distance.lower);
    }
    for (const MoverGap& gap : frame.mover_gaps) {
      least = std::min(least, gap.distance.lower);
    }
  }
  ASSERT_LT(least, 0.75);
  EXPECT_LE(least, said["nearest"][0]["lower"]);
}

TEST(Record, IsTheSameFileForAnyNumberOfThreads) {
  const Town town;
  for (const char* threads : {"1", "3"}) {
    const std::string file = town.path(std::string("run") + threads);
    ASSERT_EQ(town.simulate({"--count", "30", "--frames", "70", "--clearance", "0.5", "--threads",
                             threads, "--record", file})
                  .status,
              0);
  }
  EXPECT_EQ(read_text(town.path("run1")), read_text(town.path("run3")));
}

TEST(Record, LeavesAWholeMarkedFileWhenInterrupted) {
  const Town town;
  const TemporaryFolder streams;
  Child child(
      {command().string(), "simulate", town.path("town.ply"), "--mover", town.path("car.ply"),
       "--count", "20", "--frames", "100000000", "--json", "--record", town.path("run.somsrec")},
      streams.path());
  ASSERT_TRUE(child.wait_for_writing(100'000));
  child.send(SIGINT);
  const RunResult result = child.wait();
  EXPECT_EQ(result.status, 130) << result.err;
  Replay replay(town.path("run.somsrec"));
  ASSERT_TRUE(replay.end()) << replay.fault()->what();
  EXPECT_EQ(replay.end()->ending, RecordingEnding::interrupted);
  EXPECT_EQ(replay.head().frames_requested, 100'000'000U);
  EXPECT_EQ(Json::parse(result.out)["frames"], replay.frames());
  EXPECT_EQ(town.files(), (std::vector<std::string>{"car.ply", "run.somsrec", "town.ply"}));
}

TEST(Record, TellsThatTimeWasUp) {
  const Town town;
  const RunResult result = run_with_time(
      [&](const std::string& seconds) {
        return town.simulate({"--count", "5", "--frames", "100000000", "--timeout", seconds,
                              "--record", town.path("run.somsrec")});
      },
      [](const RunResult& run) { return run.status != 4; });
  ASSERT_EQ(result.status, 0) << result.err;
  const Replay replay(town.path("run.somsrec"));
  ASSERT_TRUE(replay.end());
  EXPECT_EQ(replay.end()->ending, RecordingEnding::timed_out);
}

TEST(Record, TellsAtOnceWhatCannotBeRecorded) {
  const Town town;
  const auto status = [&](const std::vector<std::string>& words) {
    return town.simulate(words).status;
  };
  EXPECT_EQ(status({"--record", "-"}), 2);
  EXPECT_EQ(status({"--record", town.path("car.ply")}), 2);
  EXPECT_EQ(status({"--record", town.path("none/run.somsrec")}), 5);
  EXPECT_EQ(status({"--frames", "200", "--record", "/dev/full"}), 5);
  EXPECT_EQ(status({"--frames", "2", "--record", "/dev/null"}), 0);
  const RunResult piped = shell("cat '" + town.path("town.ply") +
                                "' | $soms simulate - --record '" + town.path("run") + "'");
  EXPECT_EQ(piped.status, 2);
  EXPECT_NE(piped.err.find("read again"), std::string::npos) << piped.err;
  EXPECT_EQ(town.files(), (std::vector<std::string>{"car.ply", "town.ply"}));
}

}  // namespace
}  // namespace soms::test
