// Recordings of which any number was changed, with checksums that are good: each gives a typed
// error with its place, frames before a fault, or a recording that is the same when it is written
// again.
#include "soms/base/error.h"
#include "soms/scene/replay.h"

#include "tests/scene/recordings.h"
#include "tests/support/recording_mutations.h"
#include "tests/support/support.h"

#include <exception>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

namespace soms {

namespace {

constexpr int kChangedRecordings = 5000;

/// What became of the changed recordings.
struct RecordingOutcomes {
  int inputs = 0;
  int refused = 0;  ///< not even the head is whole
  int cut = 0;      ///< plays up to a fault
  int whole = 0;
};

/// An error that names the file, a byte in it, and what to do.
void expect_placed(const Error& error, std::size_t size) {
  EXPECT_TRUE(error.kind() == ErrorKind::bad_file || error.kind() == ErrorKind::unsupported)
      << error.what();
  const std::string start = "run, byte ";
  ASSERT_EQ(error.place().substr(0, start.size()), start) << error.what();
  EXPECT_LE(std::stoull(error.place().substr(start.size())), size) << error.what();
  EXPECT_FALSE(error.remedy().empty());
}

/// The recording of what was played.
std::string recorded_again(const Replay& replay, const std::vector<RecordedFrame>& frames) {
  std::ostringstream out;
  RecordingWriter writer(out, replay.head());
  for (const RecordedFrame& frame : frames) {
    StepReport report;
    report.environment = frame.environment;
    report.movers = frame.movers;
    report.clearance = replay.head().clearance;
    report.environment_gaps = frame.environment_gaps;
    report.mover_gaps = frame.mover_gaps;
    report.swept = replay.head().swept;
    report.environment_passages = frame.environment_passages;
    report.mover_passages = frame.mover_passages;
    writer.add(frame.poses, report);
  }
  writer.finish(replay.end() ? replay.end()->ending : RecordingEnding::interrupted);
  return out.str();
}

void expect_played(Replay& replay) {
  const std::vector<RecordedFrame> frames = test::frames_of(replay);
  for (std::uint64_t i = replay.frames(); i-- > 0;) {
    EXPECT_EQ(replay.frame(i), frames[i]) << i;
  }
  Replay again = test::replay_of(recorded_again(replay, frames));
  EXPECT_EQ(again.head(), replay.head());
  EXPECT_EQ(test::frames_of(again), frames);
  EXPECT_FALSE(again.fault());
  if (replay.end()) {
    EXPECT_EQ(again.end(), replay.end());
  }
}

void play_changed(const std::string& bytes, RecordingOutcomes& outcomes) {
  ++outcomes.inputs;
  std::optional<Replay> replay;
  try {
    replay.emplace(test::replay_of(bytes));
  } catch (const Error& error) {
    ++outcomes.refused;
    expect_placed(error, bytes.size());
    return;
  } catch (const std::exception& error) {
    FAIL() << "no typed error: " << error.what();
  }
  EXPECT_NE(replay->end().has_value(), replay->fault().has_value());
  if (replay->fault()) {
    ++outcomes.cut;
    expect_placed(*replay->fault(), bytes.size());
  } else {
    ++outcomes.whole;
  }
  expect_played(*replay);
}

void expect_sound_outcomes(const char* tag, const test::Recorded& recorded) {
  std::vector<test::NumberPlaces> places;
  for (const test::RecordedChunk& chunk : test::chunks_of(recorded.bytes)) {
    if (chunk.tag == detail::kFramesTag) {
      places.push_back(test::numbers_of_frames(chunk.content, recorded.head.movers.size(),
                                               recorded.head.clearance > 0, recorded.head.swept));
    } else if (chunk.tag == detail::kHeadTag) {
      places.push_back(test::numbers_of_head(chunk.content));
    } else {
      places.push_back({{0, 1}, {1, 8}, {9, 8}, {17, 8}});
    }
  }
  ASSERT_EQ(test::recording_of(recorded.bytes, test::chunks_of(recorded.bytes)), recorded.bytes);
  RecordingOutcomes outcomes;
  test::for_each_case(tag, kChangedRecordings, [&](Rng& rng) {
    play_changed(test::changed_recording(recorded.bytes, places, rng), outcomes);
  });
  EXPECT_GE(outcomes.inputs, kChangedRecordings);
  EXPECT_EQ(outcomes.inputs, outcomes.refused + outcomes.cut + outcomes.whole);
  EXPECT_GT(outcomes.refused, kChangedRecordings / 50);
  EXPECT_GT(outcomes.cut, kChangedRecordings / 50);
  EXPECT_GT(outcomes.whole, kChangedRecordings / 50);
}

TEST(ChangedRecordings, GiveTypedErrorsOrPlay) {
  expect_sound_outcomes("changed recordings", test::record_drive());
}

TEST(ChangedRecordings, OfGapsGiveTypedErrorsOrPlay) {
  expect_sound_outcomes("changed recordings of gaps", test::record_approach());
}

TEST(ChangedRecordings, OfPassagesGiveTypedErrorsOrPlay) {
  expect_sound_outcomes("changed recordings of passages", test::record_passages());
}

TEST(ChangedRecordings, OfManyBodiesGiveTypedErrorsOrPlay) {
  Rng rng(11);
  expect_sound_outcomes("changed recordings of many bodies",
                        test::record_scene(rng, 3, 6, RecordingEnding::timed_out, 1.5));
}

}  // namespace

}  // namespace soms
