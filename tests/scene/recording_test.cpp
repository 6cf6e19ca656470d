#include "soms/scene/recording.h"

#include "soms/base/error.h"

#include "tests/scene/random_bodies.h"
#include "tests/scene/recordings.h"
#include "tests/support/allocation.h"
#include "tests/support/support.h"

#include <cmath>
#include <limits>
#include <new>
#include <sstream>
#include <streambuf>
#include <string>
#include <vector>

namespace soms {

namespace {

/// Swallows bytes and counts them.
class Counter : public std::streambuf {
 public:
  std::uint64_t bytes = 0;

 protected:
  std::streamsize xsputn(const char*, std::streamsize count) override {
    bytes += static_cast<std::uint64_t>(count);
    return count;
  }

  int_type overflow(int_type c) override {
    ++bytes;
    return c;
  }
};

/// Takes no byte after the first `room`.
class FullDisk : public std::streambuf {
 public:
  explicit FullDisk(std::streamsize room) : room_(room) {}

 protected:
  std::streamsize xsputn(const char*, std::streamsize count) override {
    room_ -= count;
    return room_ < 0 ? 0 : count;
  }

 private:
  std::streamsize room_;
};

RecordingHead head_of_one_mover() {
  RecordingHead head;
  head.models.resize(1);
  head.models[0].triangles = 10;
  head.movers = {0};
  return head;
}

TEST(Recording, GivesBackEveryBitOfHeadPosesAndContacts) {
  std::size_t contacts = 0;
  test::for_each_case("recording/round-trip", 20, [&](Rng& rng) {
    const test::Recorded recorded =
        test::record_scene(rng, rng.below(6), rng.below(200), RecordingEnding::interrupted);
    Replay replay = test::replay_of(recorded.bytes);
    ASSERT_FALSE(replay.fault()) << replay.fault()->what();
    EXPECT_EQ(replay.head(), recorded.head);
    EXPECT_EQ(test::frames_of(replay), recorded.frames);
    ASSERT_TRUE(replay.end());
    EXPECT_EQ(*replay.end(), recorded.end);
    EXPECT_EQ(replay.end()->ending, RecordingEnding::interrupted);
    contacts += recorded.end.environment_contacts + recorded.end.mover_contacts;
  });
  EXPECT_GT(contacts, 1000U);
}

TEST(Recording, KeepsTheSignOfZeroInAPose) {
  RecordingHead head = head_of_one_mover();
  std::ostringstream out;
  RecordingWriter writer(out, head);
  Pose pose;
  pose.m[3] = -0.0;
  writer.add(std::vector<Pose>{pose}, {});
  pose.m[3] = 0.0;
  writer.add(std::vector<Pose>{pose}, {});
  writer.finish(RecordingEnding::complete);
  Replay replay = test::replay_of(out.str());
  EXPECT_TRUE(std::signbit(replay.frame(0).poses[0].m[3]));
  EXPECT_FALSE(std::signbit(replay.frame(1).poses[0].m[3]));
}

TEST(Recording, TellsTheHashOfAllReports) {
  Rng rng(7);
  const test::Recorded recorded = test::record_scene(rng, 5, 100);
  Fnv1a hash;
  std::uint64_t environment = 0;
  for (const RecordedFrame& frame : recorded.frames) {
    StepReport report;
    report.environment = frame.environment;
    report.movers = frame.movers;
    hash.add(report.hash());
    environment += frame.environment.size();
  }
  EXPECT_EQ(recorded.end.hash, hash.value());
  EXPECT_EQ(recorded.end.environment_contacts, environment);
  EXPECT_EQ(recorded.end.frames, 100U);
}

TEST(Recording, TakesNoMoreMemoryForAHundredThousandFrames) {
  Counter counter;
  std::ostream out(&counter);
  const test::AllocationWatch watch;
  RecordingWriter writer(out, head_of_one_mover());
  std::vector<Pose> poses(1);
  for (int frame = 0; frame < 100'000; ++frame) {
    poses[0] = Pose::translation(frame, 0, 0);
    writer.add(poses, {});
  }
  writer.finish(RecordingEnding::complete);
  EXPECT_LT(watch.peak(), 64'000U);
  // A shift in x alone: 2 + 8 bytes, 16 for two counts of contacts, and a 64th of a chunk's frame.
  EXPECT_LT(counter.bytes, 2'800'000U);
}

TEST(Recording, PlaysAHundredThousandFramesInBoundedMemory) {
  std::ostringstream out;
  RecordingWriter writer(out, head_of_one_mover());
  std::vector<Pose> poses(1);
  for (int frame = 0; frame < 100'000; ++frame) {
    poses[0] = Pose::translation(frame, 0, 0);
    writer.add(poses, {});
  }
  writer.finish(RecordingEnding::complete);
  auto in = std::make_unique<std::istringstream>(out.str());
  const test::AllocationWatch watch;
  Replay replay(std::move(in), "long");
  for (const std::uint64_t frame : {99'999U, 0U, 64U, 63U, 50'000U, 50'001U, 49'999U}) {
    EXPECT_EQ(replay.frame(frame).poses[0], Pose::translation(static_cast<double>(frame), 0, 0));
  }
  EXPECT_LT(watch.peak(), 300'000U);
}

TEST(Recording, RefusesWhatNoRecordingCanHold) {
  const auto refuses = [](const RecordingHead& head) {
    std::ostringstream out;
    try {
      const RecordingWriter writer(out, head);
    } catch (const Error& error) {
      return error.kind() == ErrorKind::usage && out.str().empty();
    }
    return false;
  };
  RecordingHead head = head_of_one_mover();
  EXPECT_FALSE(refuses(head));
  head.movers = {1};
  EXPECT_TRUE(refuses(head));
  head = head_of_one_mover();
  head.frames_a_second = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(refuses(head));
  head = head_of_one_mover();
  head.models[0].scale = 0;
  EXPECT_TRUE(refuses(head));
  head = head_of_one_mover();
  head.models[0].city_size = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(refuses(head));
  head = head_of_one_mover();
  head.models[0].triangles = kMaxPrimitives + 1;
  EXPECT_TRUE(refuses(head));
  head = head_of_one_mover();
  head.environment.resize(1);
  EXPECT_FALSE(refuses(head));
  head.environment[0].pose.m[5] = -1;
  EXPECT_TRUE(refuses(head));
  std::ostringstream out;
  RecordingWriter writer(out, head_of_one_mover());
  EXPECT_THROW(writer.add({}, {}), Error);
}

TEST(Recording, RefusesPosesThatNoReplayPlays) {
  std::ostringstream out;
  RecordingWriter writer(out, head_of_one_mover());
  Pose scaled;
  scaled.m[0] = 1.001;
  const auto kind_of = [&](const Pose& pose) {
    try {
      writer.add(std::vector<Pose>{pose}, {});
    } catch (const Error& error) {
      EXPECT_TRUE(error.place().starts_with("recording: frame 0, mover 0: ")) << error.what();
      return error.kind();
    }
    return ErrorKind::usage;
  };
  EXPECT_EQ(kind_of(scaled), ErrorKind::not_rigid);
  EXPECT_EQ(kind_of(Pose::translation(0, std::nan(""), 0)), ErrorKind::not_finite);
  EXPECT_EQ(kind_of(Pose::translation(0, 0, -0x1p301)), ErrorKind::out_of_range);
  writer.add(std::vector<Pose>{Pose::translation(0, 0, 0x1p300)}, {});
  writer.finish(RecordingEnding::complete);
  EXPECT_EQ(test::replay_of(out.str()).frames(), 1U);
}

// A recording holds one mesh for each mover, and all contacts: what it cannot hold is refused, and
// the frames before play.
TEST(Recording, RefusesShapesThatWereSetBetweenItsFramesAndPartialReports) {
  std::ostringstream out;
  RecordingWriter writer(out, head_of_one_mover());
  const std::vector<Pose> poses(1);
  const auto refuses = [&](const StepReport& report) {
    try {
      writer.add(poses, report);
    } catch (const Error& error) {
      return error.kind() == ErrorKind::usage;
    }
    return false;
  };
  Scene scene;
  const Shape shape(test::box_mesh({{0, 0, 0}, {1, 1, 1}}));
  const MoverId mover = scene.add_mover(Body(shape));
  scene.set_shape(mover, shape);  // before the first frame
  EXPECT_FALSE(refuses(scene.step()));
  EXPECT_FALSE(refuses(scene.step()));
  EXPECT_TRUE(refuses(scene.step({.scope = StepScope::first_contact})));
  scene.set_shape(mover, shape);
  EXPECT_TRUE(refuses(scene.step()));
  EXPECT_EQ(writer.so_far().frames, 2U);
  writer.finish(RecordingEnding::interrupted);
  Replay replay = test::replay_of(out.str());
  EXPECT_EQ(replay.frames(), 2U);
  EXPECT_FALSE(replay.fault());
}

TEST(Recording, KeepsItsFramesWhereMemoryRanShort) {
  StepReport report;
  for (TriangleId k = 0; k < 100; ++k) {
    report.environment.push_back({1, 0, 0, k});
  }
  std::size_t failures = 0;
  for (std::uint64_t lasting = 0, failed = 1; failed != 0; ++lasting) {
    failed = 0;
    RecordingHead head;
    head.models.resize(1);
    head.models[0].triangles = 100;
    head.environment = {{head.models[0], Pose{}}};
    head.movers = {0, 0};
    std::ostringstream out;
    RecordingWriter writer(out, head);
    for (int frame = 0; frame < 3; ++frame) {
      const std::vector<Pose> poses{Pose::translation(frame, 0, 0), Pose::translation(0, frame, 0)};
      const test::AllocationFault fault(frame == 1 ? lasting : 1000);
      try {
        writer.add(poses, report);
      } catch (const std::bad_alloc&) {
        failed = 1;
        ++failures;
      }
    }
    writer.finish(RecordingEnding::complete);
    ASSERT_EQ(writer.so_far().frames, failed != 0 ? 2U : 3U);
    Replay replay = test::replay_of(out.str());
    ASSERT_TRUE(replay.end());
    const std::vector<RecordedFrame> frames = test::frames_of(replay);
    ASSERT_EQ(frames.size(), writer.so_far().frames);
    EXPECT_EQ(frames.back().poses[1], Pose::translation(0, 2, 0));
  }
  EXPECT_GT(failures, 0U);
}

TEST(Recording, TellsAFullDisk) {
  FullDisk disk(1000);
  std::ostream out(&disk);
  RecordingWriter writer(out, head_of_one_mover());
  try {
    for (int frame = 0; frame < 1000; ++frame) {
      writer.add(std::vector<Pose>(1), {});
    }
    FAIL() << "nothing was reported";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::cannot_write);
  }
}

}  // namespace

}  // namespace soms
