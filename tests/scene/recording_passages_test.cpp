// Recordings of swept steps: passages come back to the last bit, and what no step reports is
// refused.
#include "soms/base/error.h"
#include "soms/scene/detail/recording_format.h"
#include "soms/scene/recording.h"
#include "soms/scene/scene.h"

#include "tests/scene/recordings.h"
#include "tests/support/support.h"

#include <cmath>
#include <functional>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

namespace soms {

namespace {

constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();

std::uint32_t version_in(const std::string& bytes) {
  return detail::get<std::uint32_t>(bytes.data() + 8);
}

/// What is said of a recording of two frames, two movers and a part, with these passages on the way
/// to each; no way leads to the first.
std::string words_of_passages(const std::vector<EnvironmentPassage>& environment,
                              const std::vector<MoverPassage>& movers) {
  RecordingHead head;
  head.models.resize(1);
  head.models[0].triangles = 12;
  head.environment = {{head.models[0], Pose{}}};
  head.movers = {0, 0};
  head.swept = true;
  std::ostringstream out;
  RecordingWriter writer(out, head);
  StepReport report;
  report.swept = true;
  report.environment_passages = environment;
  report.mover_passages = movers;
  writer.add(std::vector<Pose>(2), report);
  writer.add(std::vector<Pose>(2), report);
  writer.finish(RecordingEnding::complete);
  Replay replay = test::replay_of(out.str());
  if (!replay.fault()) {
    EXPECT_EQ(replay.frame(1).environment_passages, environment);
    EXPECT_EQ(replay.frame(1).mover_passages, movers);
    EXPECT_TRUE(replay.frame(0).environment_passages.empty());
    EXPECT_TRUE(replay.frame(0).mover_passages.empty());
    return {};
  }
  const std::string words = replay.fault()->place();
  return words.substr(words.find(": ") + 2);
}

TEST(RecordingPassages, ComeBackToTheLastBit) {
  std::size_t environment = 0;
  std::size_t movers = 0;
  test::for_each_case("recording/passages", 20, [&](Rng& rng) {
    const double clearance = rng.below(2) == 0 ? 0 : 1;
    const test::Recorded recorded = test::record_scene(rng, rng.below(6), rng.below(90),
                                                       RecordingEnding::complete, clearance, true);
    ASSERT_EQ(version_in(recorded.bytes), 3U);
    Replay replay = test::replay_of(recorded.bytes);
    ASSERT_TRUE(replay.end()) << replay.fault()->what();
    EXPECT_EQ(replay.head(), recorded.head);
    EXPECT_EQ(test::frames_of(replay), recorded.frames);
    for (const RecordedFrame& frame : recorded.frames) {
      environment += frame.environment_passages.size();
      movers += frame.mover_passages.size();
    }
  });
  EXPECT_GT(environment, 200U);
  EXPECT_GT(movers, 200U);
}

TEST(RecordingPassages, LeaveContactsGapsAndHashAsTheyAre) {
  Rng rng(3);
  Rng again(3);
  const test::Recorded plain = test::record_scene(rng, 4, 70, RecordingEnding::complete, 1.5);
  const test::Recorded with =
      test::record_scene(again, 4, 70, RecordingEnding::complete, 1.5, true);
  EXPECT_EQ(with.end, plain.end);
  EXPECT_EQ(version_in(plain.bytes), 2U);
  for (std::size_t k = 0; k < plain.frames.size(); ++k) {
    EXPECT_EQ(with.frames[k].environment, plain.frames[k].environment);
    EXPECT_EQ(with.frames[k].mover_gaps, plain.frames[k].mover_gaps);
    EXPECT_TRUE(plain.frames[k].environment_passages.empty());
  }
}

TEST(RecordingPassages, NeedReportsOfSweptSteps) {
  RecordingHead head;
  head.swept = true;
  std::ostringstream out;
  RecordingWriter writer(out, head);
  try {
    writer.add({}, StepReport{});
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::usage);
    EXPECT_NE(error.place().find("not swept"), std::string::npos);
  }
  StepReport swept;
  swept.swept = true;
  writer.add({}, swept);
  EXPECT_EQ(writer.so_far().frames, 1U);
}

TEST(RecordingPassages, AreLeftOutByAHeadThatDoesNotSaySo) {
  std::ostringstream out;
  std::ostringstream plain;
  StepReport swept;
  swept.swept = true;
  for (const auto& [stream, report] : {std::pair(&out, swept), std::pair(&plain, StepReport{})}) {
    RecordingWriter writer(*stream, RecordingHead{});
    writer.add({}, report);
    writer.finish(RecordingEnding::complete);
  }
  EXPECT_EQ(out.str(), plain.str());
}

TEST(RecordingPassages, RefuseWhatNoStepReports) {
  const EnvironmentPassage good{0, 0, 1, 2, ContactVerdict::contact, {0.25, 0.5}, {1, 2, 3}};
  const auto words = [&](const std::function<void(EnvironmentPassage&)>& change) {
    EnvironmentPassage part = good;
    change(part);
    const MoverPassage other{part.mover,   part.part + 1, part.i,    part.j,
                             part.verdict, part.t,        part.point};
    const std::string first = words_of_passages({part}, {});
    EXPECT_EQ(words_of_passages({}, {other}), first);
    return first;
  };
  EXPECT_EQ(words([](EnvironmentPassage& /*same*/) {}), "");
  EXPECT_EQ(words([](EnvironmentPassage& p) {
              p.verdict = ContactVerdict::grazing;
              p.t = {1, HUGE_VAL};
            }),
            "");
  const std::string missing = "a passage refers to a mover or part that does not exist";
  EXPECT_EQ(words([](EnvironmentPassage& p) { p.i = 12; }), missing);
  EXPECT_EQ(words([](EnvironmentPassage& p) { p.part = 1; }), missing);
  EXPECT_EQ(words([](EnvironmentPassage& p) { p.verdict = ContactVerdict::free; }),
            "a passage that is free");
  const std::string never = "the time of a passage is none on the way";
  for (const Bracket t : {Bracket{-0.5, 0.5}, Bracket{0.5, 0.25}, Bracket{0.5, 1.5},
                          Bracket{kNoNumber, 1}, Bracket{0, kNoNumber}, Bracket{1.5, HUGE_VAL}}) {
    EXPECT_EQ(words([&](EnvironmentPassage& p) { p.t = t; }), never) << t.lower << ", " << t.upper;
  }
  EXPECT_EQ(words([](EnvironmentPassage& p) { p.point.y = HUGE_VAL; }),
            "a point of a passage is not finite");
  EXPECT_EQ(words_of_passages({good, good}, {}), "the passages are not sorted");
}

TEST(RecordingPassages, OfAFrameAreThoseOfTheWayToIt) {
  Rng rng(17);
  const test::Recorded recorded =
      test::record_scene(rng, 4, 70, RecordingEnding::complete, 0, true);
  Replay replay = test::replay_of(recorded.bytes);
  std::size_t passages = 0;
  for (const std::uint64_t k : {69U, 1U, 64U, 63U, 30U}) {
    Scene scene;  // of two steps only: nothing older plays a part
    for (std::size_t m = 0; m < recorded.shapes.size(); ++m) {
      scene.add_environment(Body(recorded.shapes[m], recorded.head.environment[m].pose));
    }
    for (const std::uint32_t model : recorded.head.movers) {
      scene.add_mover(Body(recorded.shapes[model]));
    }
    StepReport report;
    for (const std::uint64_t frame : {k - 1, k}) {
      const std::vector<Pose> poses = replay.frame(frame).poses;
      for (MoverId id = 0; id < poses.size(); ++id) {
        scene.set_pose(id, poses[id]);
      }
      report = scene.step({.swept = true});
    }
    EXPECT_EQ(replay.frame(k).environment_passages, report.environment_passages) << k;
    EXPECT_EQ(replay.frame(k).mover_passages, report.mover_passages) << k;
    passages += report.environment_passages.size() + report.mover_passages.size();
  }
  EXPECT_GT(passages, 0U);
}

}  // namespace

}  // namespace soms
