#include "soms/scene/replay.h"

#include "soms/base/hash.h"
#include "soms/scene/detail/recording_format.h"

#include "tests/scene/recordings.h"
#include "tests/support/allocation.h"
#include "tests/support/support.h"

#include <algorithm>
#include <fstream>
#include <string>
#include <vector>

namespace soms {

namespace {

/// What became of bytes that are not as they were written.
struct Verdict {
  bool reported = false;  ///< by an exception or a fault
  ErrorKind kind = ErrorKind::usage;
  std::string words;
  std::vector<RecordedFrame> frames;
};

Verdict judge(const std::string& bytes) {
  Verdict verdict;
  try {
    Replay replay = test::replay_of(bytes);
    verdict.frames = test::frames_of(replay);
    EXPECT_NE(replay.fault().has_value(), replay.end().has_value());
    if (replay.fault()) {
      verdict = {true, replay.fault()->kind(), replay.fault()->what(), std::move(verdict.frames)};
    }
  } catch (const Error& error) {
    verdict = {true, error.kind(), error.what(), {}};
  }
  return verdict;
}

bool is_prefix(const std::vector<RecordedFrame>& frames, const std::vector<RecordedFrame>& all) {
  return frames.size() <= all.size() && std::equal(frames.begin(), frames.end(), all.begin());
}

TEST(Replay, PlaysAnyFrameInAnyOrder) {
  test::for_each_case("replay/random-access", 6, [](Rng& rng) {
    const double clearance = rng.below(2) == 0 ? 0 : 1.5;
    const test::Recorded recorded =
        test::record_scene(rng, 3, 300, RecordingEnding::complete, clearance);
    Replay replay = test::replay_of(recorded.bytes);
    ASSERT_EQ(replay.frames(), 300U);
    for (int k = 0; k < 300; ++k) {
      const std::uint64_t frame = rng.below(300);
      ASSERT_EQ(replay.frame(frame), recorded.frames[frame]) << frame;
      ASSERT_EQ(replay.frame(frame), recorded.frames[frame]) << frame;
      if (frame + 1 < 300) {
        ASSERT_EQ(replay.frame(frame + 1), recorded.frames[frame + 1]) << frame;
      }
    }
  });
}

TEST(Replay, RefusesAFrameThatIsNotThere) {
  Replay replay = test::replay_of(test::record_drive().bytes);
  EXPECT_THROW((void)replay.frame(66), Error);
  EXPECT_EQ(replay.frame(65).poses.size(), 2U);
}

void tells_every_length(const test::Recorded& recorded) {
  std::size_t most = 0;
  for (std::size_t length = 0; length < recorded.bytes.size(); ++length) {
    const Verdict verdict = judge(recorded.bytes.substr(0, length));
    ASSERT_TRUE(verdict.reported) << length;
    ASSERT_EQ(verdict.kind, ErrorKind::bad_file) << verdict.words;
    ASSERT_NE(verdict.words.find(length == 0 ? "byte 0" : "byte " + std::to_string(length)),
              std::string::npos)
        << verdict.words;
    ASSERT_TRUE(is_prefix(verdict.frames, recorded.frames)) << length;
    ASSERT_GE(verdict.frames.size(), most) << length;
    most = verdict.frames.size();
  }
  EXPECT_EQ(most, 66U);  // only the end is missing
}

TEST(Replay, TellsEveryLengthOfACutFileAndPlaysWhatIsWhole) {
  tells_every_length(test::record_drive());
}

TEST(Replay, TellsEveryLengthOfACutFileWithGapsAndPlaysWhatIsWhole) {
  tells_every_length(test::record_approach());
}

void tells_every_altered_byte(const test::Recorded& recorded) {
  for (std::size_t at = 0; at < recorded.bytes.size(); ++at) {
    for (const int change : {0x01, 0x02, 0x04, 0x08, 0x10, 0x20, 0x40, 0x80, 0xff}) {
      std::string bytes = recorded.bytes;
      bytes[at] = static_cast<char>(bytes[at] ^ change);
      const Verdict verdict = judge(bytes);
      ASSERT_TRUE(verdict.reported) << at << " by " << change;
      ASSERT_EQ(verdict.kind, ErrorKind::bad_file) << verdict.words;
      ASSERT_TRUE(is_prefix(verdict.frames, recorded.frames)) << at;
    }
  }
}

TEST(Replay, TellsEveryAlteredByteAndPlaysWhatIsWhole) {
  tells_every_altered_byte(test::record_drive());
}

TEST(Replay, TellsEveryAlteredByteOfAFileWithGapsAndPlaysWhatIsWhole) {
  tells_every_altered_byte(test::record_approach());
}

TEST(Replay, TellsBytesThatWereAddedTakenOrMoved) {
  Rng rng(3);
  const test::Recorded recorded = test::record_scene(rng, 1, 200);
  const std::string& bytes = recorded.bytes;
  EXPECT_TRUE(judge(bytes + 'x').reported);
  EXPECT_TRUE(judge(bytes + bytes).reported);
  const std::size_t first = test::second_chunk(bytes);
  const auto size_of = [&](std::size_t begin) {
    return detail::kChunkHeadSize + 8 +
           static_cast<std::size_t>(detail::get<std::uint64_t>(bytes.data() + begin + 16));
  };
  const std::size_t next = first + size_of(first);
  const std::size_t third = next + size_of(next);
  // A chunk that is missing, one that stands twice, two in the other order.
  const std::string one = bytes.substr(first, next - first);
  const std::string two = bytes.substr(next, third - next);
  EXPECT_EQ(judge(bytes.substr(0, first) + bytes.substr(next)).frames.size(), 0U);
  EXPECT_EQ(judge(bytes.substr(0, next) + one + bytes.substr(next)).frames.size(), 64U);
  EXPECT_EQ(judge(bytes.substr(0, first) + two + one + bytes.substr(third)).frames.size(), 0U);
  EXPECT_EQ(judge(bytes.substr(0, next) + bytes.substr(third)).frames.size(), 64U);
  EXPECT_NE(judge(bytes.substr(0, next) + bytes.substr(third)).words.find("frame 64 is missing"),
            std::string::npos);
}

TEST(Replay, SaysThatAVersionOfTheFutureNeedsANewerProgram) {
  std::string bytes = test::record_drive().bytes;
  std::string head(detail::kRecordingMagic);
  detail::put(head, std::uint32_t{4});
  detail::put(head, static_cast<std::uint32_t>(detail::hash_of(head)));
  bytes.replace(0, head.size(), head);
  const Verdict verdict = judge(bytes);
  EXPECT_EQ(verdict.kind, ErrorKind::unsupported);
  EXPECT_NE(verdict.words.find("a recording of version 4; this soms reads versions 1 to 3"),
            std::string::npos)
      << verdict.words;
}

TEST(Replay, TakesNoMemoryForCountsThatCannotBe) {
  const std::string bytes = test::record_drive().bytes;
  const std::size_t frames = test::second_chunk(bytes);
  const std::string huge(8, '\xff');
  const std::vector<std::string> all = {
      // Length of the title, of frames' contacts, of a chunk.
      test::forged(bytes, 16, [&](std::string& content) { content.replace(0, 4, huge, 0, 4); }),
      test::forged(
          bytes, 16,
          [&](std::string& content) { content.replace(content.size() - 8, 4, huge, 0, 4); }),
      test::forged(bytes, frames,
                   [&](std::string& content) { content.replace(content.size() - 8, 8, huge); }),
      test::forged(bytes, frames, [&](std::string& content) { content.assign(huge + huge); }),
  };
  for (const std::string& one : all) {
    const test::AllocationWatch watch;
    EXPECT_TRUE(judge(one).reported);
    EXPECT_LT(watch.peak(), 1'000'000U);
  }
  std::string long_chunk = bytes.substr(0, frames + 16) + huge.substr(0, 7) + '\x7f';
  detail::put(long_chunk, detail::hash_of(long_chunk.substr(frames)));
  long_chunk += bytes.substr(frames + 32);
  const test::AllocationWatch watch;
  EXPECT_TRUE(judge(long_chunk).reported);
  EXPECT_LT(watch.peak(), 1'000'000U);
}

TEST(Replay, TellsContentThatNoSceneGives) {
  const test::Recorded nothing = test::record_nothing(2);
  const std::size_t end = nothing.bytes.size() - detail::kChunkHeadSize - 25 - 8;
  // An ending that is unknown, contacts that no frame holds, another hash.
  for (const std::size_t at : {0U, 1U, 9U, 17U}) {
    const Verdict verdict = judge(test::forged(nothing.bytes, end, [at](std::string& content) {
      content[at] = static_cast<char>(content[at] + 9);
    }));
    EXPECT_TRUE(verdict.reported);
    EXPECT_EQ(verdict.frames.size(), 2U);
  }
  const std::string bytes = test::record_drive().bytes;
  const std::size_t frames = test::second_chunk(bytes);
  const auto frame_with = [&](const std::string& frame) {
    return judge(test::forged(bytes, frames, [&](std::string& content) { content = frame; })).words;
  };
  std::string not_finite;
  detail::put(not_finite, std::uint16_t{8});
  detail::put(not_finite, std::uint64_t{0x7ff8} << 48);
  EXPECT_NE(frame_with(not_finite).find("an invalid pose"), std::string::npos);
  std::string too_far;
  detail::put(too_far, std::uint16_t{8});
  detail::put(too_far, 0x1p301);
  EXPECT_NE(frame_with(too_far).find("its shift exceeds 2^300"), std::string::npos);
  EXPECT_NE(frame_with("\x01\x10").find("more than twelve"), std::string::npos);
  std::string nobody(4, '\0');
  detail::put(nobody, std::uint64_t{1});
  for (const std::uint32_t number : {2U, 0U, 0U, 0U}) {
    detail::put(nobody, number);
  }
  EXPECT_NE(frame_with(nobody).find("does not exist"), std::string::npos);
}

void ends_well(const char* tag, const test::Recorded& recorded) {
  test::for_each_case(tag, 3000, [&](Rng& rng) {
    std::string bytes = recorded.bytes;
    for (std::uint64_t k = 1 + rng.below(8); k > 0 && !bytes.empty(); --k) {
      const std::size_t at = rng.below(bytes.size());
      switch (rng.below(4)) {
        case 0:
          bytes[at] = static_cast<char>(rng.below(256));
          break;
        case 1:
          bytes.erase(at, 1 + rng.below(20));
          break;
        case 2:
          bytes.insert(at, rng.below(20), static_cast<char>(rng.below(256)));
          break;
        default:
          bytes.resize(at + 1);
      }
    }
    // Half of them with good checksums, so that the content is read.
    const std::size_t begin = test::second_chunk(recorded.bytes);
    if (rng.below(2) == 0) {
      bytes =
          test::forged(recorded.bytes, rng.below(2) == 0 ? 16 : begin, [&](std::string& content) {
            for (int k = 0; k < 3; ++k) {
              content[rng.below(content.size())] = static_cast<char>(rng.below(256));
            }
          });
    }
    (void)judge(bytes);
  });
}

TEST(Replay, EndsWellForAnyBytes) {
  ends_well("replay/mutations", test::record_drive());
}

TEST(Replay, EndsWellForAnyBytesOfAFileWithGaps) {
  ends_well("replay/mutations-of-gaps", test::record_approach());
}

TEST(Replay, OpensFilesAndKnowsThemByTheirFirstBytes) {
  const test::TemporaryFolder folder;
  const auto path = folder.path() / "run.somsrec";
  std::ofstream(path, std::ios::binary) << test::record_drive().bytes;
  std::ofstream(folder.path() / "other.ply") << "ply\n";
  EXPECT_EQ(Replay(path).frames(), 66U);
  EXPECT_TRUE(is_recording(path));
  EXPECT_FALSE(is_recording(folder.path() / "other.ply"));
  EXPECT_FALSE(is_recording(folder.path()));
  EXPECT_FALSE(is_recording(folder.path() / "none"));
  const auto kind_of = [](const std::filesystem::path& file) {
    try {
      const Replay replay(file);
    } catch (const Error& error) {
      return error.kind();
    }
    return ErrorKind::usage;
  };
  EXPECT_EQ(kind_of(folder.path()), ErrorKind::cannot_open);
  EXPECT_EQ(kind_of(folder.path() / "none"), ErrorKind::cannot_open);
  EXPECT_EQ(kind_of(folder.path() / "other.ply"), ErrorKind::bad_file);
}

TEST(Replay, TellsThatTheFileWasChangedSinceItWasOpened) {
  const std::string bytes = test::record_drive().bytes;
  const std::size_t first = test::second_chunk(bytes);
  const std::size_t last =
      first + detail::kChunkHeadSize + 8 +
      static_cast<std::size_t>(detail::get<std::uint64_t>(bytes.data() + first + 16));
  // Another shift of the first mover, with checksums that are good.
  const std::string changed =
      test::forged(bytes, last, [](std::string& content) { content[8] = static_cast<char>(0x31); });
  ASSERT_EQ(changed.size(), bytes.size());
  ASSERT_EQ(test::replay_of(changed).frames(), 66U);
  const test::TemporaryFolder folder;
  const auto path = folder.path() / "run.somsrec";
  std::ofstream(path, std::ios::binary) << bytes;
  Replay replay(path);
  EXPECT_EQ(replay.frame(64).poses[0], Pose::translation(16, 0, 0));
  EXPECT_EQ(replay.frame(0).poses[0], Pose());
  std::ofstream(path, std::ios::binary) << changed;
  for (int again = 0; again < 2; ++again) {
    try {
      static_cast<void>(replay.frame(64));
      ADD_FAILURE() << "plays what was not there";
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::bad_file);
      EXPECT_NE(error.place().find("changed since it was opened"), std::string::npos);
    }
  }
}

TEST(Replay, StopsWhenRequested) {
  const test::Recorded recorded = test::record_drive();
  std::stop_source stop;
  stop.request_stop();
  EXPECT_THROW(Replay(std::make_unique<std::istringstream>(recorded.bytes), "run",
                      {.threads = 1, .stop = stop.get_token(), .progress = {}}),
               Error);
}

}  // namespace

}  // namespace soms
