// Recordings of steps with a clearance: gaps come back to the last bit, and what no step reports is
// refused.
#include "soms/base/error.h"
#include "soms/scene/detail/recording_format.h"
#include "soms/scene/recording.h"
#include "soms/scene/scene.h"

#include "tests/scene/recordings.h"
#include "tests/support/allocation.h"
#include "tests/support/support.h"

#include <array>
#include <cstdint>
#include <fstream>
#include <functional>
#include <iterator>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

namespace soms {

namespace {

constexpr double kNotANumber = std::numeric_limits<double>::quiet_NaN();
constexpr double kUnbounded = std::numeric_limits<double>::infinity();

std::uint32_t version_of(const std::string& bytes) {
  return detail::get<std::uint32_t>(bytes.data() + 8);
}

/// What is said of a file whose first chunk of frames is another; empty: nothing is wrong with it.
std::string words_of(const std::string& bytes) {
  try {
    Replay replay = test::replay_of(bytes);
    if (!replay.fault()) {
      return {};
    }
    EXPECT_EQ(replay.fault()->kind(), ErrorKind::bad_file);
    EXPECT_EQ(replay.frames(), 0U);
    return replay.fault()->place();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::bad_file);
    return error.place();
  }
}

/// A gap as bytes; of a mover and a part, or of two movers.
struct RawGap {
  std::array<std::uint32_t, 4> ids{0, 0, 0, 0};
  double lower = 0.5;
  double upper = 0.5;
  std::array<double, 6> points{1.5, 0, 0, 1, 0, 0};
};

void put_raw(std::string& bytes, const std::vector<RawGap>& gaps) {
  detail::put(bytes, static_cast<std::uint64_t>(gaps.size()));
  for (const RawGap& gap : gaps) {
    for (const std::uint32_t id : gap.ids) {
      detail::put(bytes, id);
    }
    detail::put(bytes, gap.lower);
    detail::put(bytes, gap.upper);
    for (const double entry : gap.points) {
      detail::put(bytes, entry);
    }
  }
}

/// A recording of three cubes (part 0, movers 0 and 1), of clearance 2, whose one frame has these
/// gaps and no contact.
std::string recording_of(const std::vector<RawGap>& environment,
                         const std::vector<RawGap>& movers) {
  RecordingHead head;
  head.models.resize(1);
  head.models[0].triangles = 12;
  head.environment = {{head.models[0], Pose{}}};
  head.movers = {0, 0};
  head.clearance = 2;
  std::ostringstream out;
  RecordingWriter writer(out, head);
  StepReport report;
  report.clearance = 2;
  writer.add(std::vector<Pose>(2), report);
  writer.finish(RecordingEnding::complete);
  const std::string bytes = out.str();
  return test::forged(bytes, test::second_chunk(bytes), [&](std::string& content) {
    content.resize(content.size() - 16);  // two lists without gaps
    put_raw(content, environment);
    put_raw(content, movers);
  });
}

/// A gap in each list, changed by `change`: what is said of both, which must be the same.
std::string words_of_gap(const std::function<void(RawGap&)>& change) {
  RawGap part;
  RawGap other{.ids = {0, 1, 0, 0}};
  change(part);
  change(other);
  const auto behind_the_byte = [](const std::string& words) {
    return words.empty() ? words : words.substr(words.find(": ") + 2);
  };
  const std::string first = behind_the_byte(words_of(recording_of({part}, {})));
  EXPECT_EQ(behind_the_byte(words_of(recording_of({}, {other}))), first);
  return first;
}

TEST(RecordingGaps, ComeBackToTheLastBit) {
  std::size_t environment = 0;
  std::size_t movers = 0;
  test::for_each_case("recording/gaps", 20, [&](Rng& rng) {
    const test::Recorded recorded = test::record_scene(
        rng, rng.below(6), rng.below(150), RecordingEnding::complete, rng.uniform(0.5, 3));
    ASSERT_EQ(version_of(recorded.bytes), 2U);
    Replay replay = test::replay_of(recorded.bytes);
    ASSERT_TRUE(replay.end()) << replay.fault()->what();
    EXPECT_EQ(replay.head(), recorded.head);
    EXPECT_EQ(test::frames_of(replay), recorded.frames);
    EXPECT_EQ(*replay.end(), recorded.end);
    for (const RecordedFrame& frame : recorded.frames) {
      environment += frame.environment_gaps.size();
      movers += frame.mover_gaps.size();
    }
  });
  EXPECT_GT(environment, 500U);
  EXPECT_GT(movers, 500U);
}

TEST(RecordingGaps, LeaveOfContactsAndPosesWhatIsRecordedWithoutThem) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    Rng rng(seed);
    Rng again(seed);
    const test::Recorded plain = test::record_scene(rng, 4, 70);
    const test::Recorded with = test::record_scene(again, 4, 70, RecordingEnding::complete, 1.5);
    EXPECT_EQ(with.end, plain.end);
    ASSERT_EQ(with.frames.size(), plain.frames.size());
    std::size_t gaps = 0;
    for (std::size_t k = 0; k < plain.frames.size(); ++k) {
      EXPECT_EQ(with.frames[k].poses, plain.frames[k].poses);
      EXPECT_EQ(with.frames[k].environment, plain.frames[k].environment);
      EXPECT_EQ(with.frames[k].movers, plain.frames[k].movers);
      EXPECT_TRUE(plain.frames[k].environment_gaps.empty() && plain.frames[k].mover_gaps.empty());
      gaps += with.frames[k].environment_gaps.size() + with.frames[k].mover_gaps.size();
    }
    EXPECT_GT(gaps, 0U);
  }
}

// The seeds of the fuzzer were written before there were gaps.
TEST(RecordingGaps, ChangeNoByteOfARecordingWithoutClearance) {
  const auto seed = [](const char* name) {
    std::ifstream in(test::data("") / ".." / "fuzz" / "seeds" / "recording" / name,
                     std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(in), {});
  };
  Rng rng(1);
  EXPECT_EQ(test::record_drive().bytes, seed("drive.somsrec"));
  EXPECT_EQ(test::record_nothing(3).bytes, seed("empty.somsrec"));
  EXPECT_EQ(test::record_scene(rng, 3, 8).bytes, seed("scene.somsrec"));
  EXPECT_EQ(version_of(test::record_drive().bytes), 1U);
}

TEST(RecordingGaps, AreRefusedWithAnotherClearanceThanThatOfTheHead) {
  const auto refuses = [](double head_clearance, double step_clearance) {
    RecordingHead head;
    head.clearance = head_clearance;
    std::ostringstream out;
    RecordingWriter writer(out, head);
    StepReport report;
    report.clearance = step_clearance;
    try {
      writer.add({}, report);
    } catch (const Error& error) {
      EXPECT_EQ(writer.so_far().frames, 0U);
      return error.kind() == ErrorKind::usage;
    }
    return false;
  };
  EXPECT_FALSE(refuses(0, 0));
  EXPECT_FALSE(refuses(0.25, 0.25));
  EXPECT_TRUE(refuses(0, 0.25));
  EXPECT_TRUE(refuses(0.25, 0));
  EXPECT_TRUE(refuses(0.25, 0.5));
}

TEST(RecordingGaps, NeedAClearanceThatIsALength) {
  for (const double clearance : {-1.0, kNotANumber, kUnbounded}) {
    RecordingHead head;
    head.clearance = clearance;
    std::ostringstream out;
    EXPECT_THROW(RecordingWriter(out, head), Error) << clearance;
    EXPECT_TRUE(out.str().empty());
  }
}

TEST(RecordingGaps, AreReadAsTheyWereForged) {
  EXPECT_EQ(words_of(recording_of({RawGap{}}, {RawGap{.ids = {0, 1, 0, 0}}})), "");
  EXPECT_EQ(words_of_gap([](RawGap& gap) { gap.upper = 2; }), "");
  EXPECT_EQ(words_of_gap([](RawGap& gap) {
              gap.lower = 0;
              gap.upper = std::numeric_limits<double>::denorm_min();
            }),
            "");
  Replay replay = test::replay_of(recording_of({RawGap{.ids = {1, 0, 2, 3}, .lower = 0.25}}, {}));
  EXPECT_EQ(replay.frame(0).environment_gaps,
            (std::vector<EnvironmentGap>{{1, 0, 2, 3, {0.25, 0.5}, {1.5, 0, 0}, {1, 0, 0}}}));
}

TEST(RecordingGaps, RefuseAHeadWithoutALengthForClearance) {
  const std::string bytes = test::record_approach().bytes;
  const auto with = [&](double clearance) {
    return words_of(test::forged(bytes, 16, [&](std::string& content) {
      content.resize(content.size() - 8);
      detail::put(content, clearance);
    }));
  };
  EXPECT_EQ(with(2), "");
  for (const double clearance : {0.0, -1.0, kNotANumber, kUnbounded}) {
    EXPECT_NE(with(clearance).find("a clearance that is not positive"), std::string::npos);
  }
  const std::string without = words_of(
      test::forged(bytes, 16, [](std::string& content) { content.resize(content.size() - 8); }));
  EXPECT_NE(without.find("the chunk is too short"), std::string::npos) << without;
}

TEST(RecordingGaps, RefuseAVersionOfOtherContent) {
  const auto as_version = [](std::string bytes, std::uint32_t version) {
    std::string head(detail::kRecordingMagic);
    detail::put(head, version);
    detail::put(head, static_cast<std::uint32_t>(detail::hash_of(head)));
    return words_of(bytes.replace(0, head.size(), head));
  };
  const std::string one = as_version(test::record_approach().bytes, 1);
  EXPECT_NE(one.find("too long for its content"), std::string::npos) << one;
  const std::string two = as_version(test::record_drive().bytes, 2);
  EXPECT_NE(two.find("too short for its content"), std::string::npos) << two;
}

TEST(RecordingGaps, RefuseMoreThanThereAreBytes) {
  const std::string good = recording_of({}, {});
  for (const std::size_t from_end : {16U, 8U}) {
    for (const std::uint64_t count : {std::uint64_t{1}, ~std::uint64_t{0}}) {
      const std::string bytes =
          test::forged(good, test::second_chunk(good), [&](std::string& content) {
            std::string number;
            detail::put(number, count);
            content.replace(content.size() - from_end, 8, number);
          });
      const test::AllocationWatch watch;
      EXPECT_NE(words_of(bytes).find(std::to_string(count) + " entries in"), std::string::npos);
      EXPECT_LT(watch.peak(), 1'000'000U);
    }
  }
}

TEST(RecordingGaps, RefuseBodiesAndTrianglesThatDoNotExist) {
  const auto words = [](std::array<std::uint32_t, 4> part, std::array<std::uint32_t, 4> other) {
    const std::string first = words_of(recording_of({RawGap{.ids = part}}, {}));
    const std::string second = words_of(recording_of({}, {RawGap{.ids = other}}));
    EXPECT_EQ(first.empty(), second.empty());
    EXPECT_EQ(first.find("does not exist") == std::string::npos,
              second.find("does not exist") == std::string::npos);
    return first;
  };
  EXPECT_EQ(words({1, 0, 11, 11}, {0, 1, 11, 11}), "");
  const std::string fault = "a gap refers to a mover or part that does not exist";
  EXPECT_NE(words({2, 0, 0, 0}, {1, 1, 0, 0}).find(fault), std::string::npos);
  EXPECT_NE(words({0, 1, 0, 0}, {0, 2, 0, 0}).find(fault), std::string::npos);
  EXPECT_NE(words({0, 0, 12, 0}, {0, 1, 12, 0}).find(fault), std::string::npos);
  EXPECT_NE(words({0, 0, 0, 12}, {0, 1, 0, 12}).find(fault), std::string::npos);
  EXPECT_NE(words({~0U, ~0U, ~0U, ~0U}, {1, 0, 0, 0}).find(fault), std::string::npos);
}

TEST(RecordingGaps, RefuseADistanceThatIsNoneWithinTheClearance) {
  struct Ends {
    double lower;
    double upper;
  };

  for (const Ends ends :
       {Ends{-0.5, 0.5}, Ends{0.5, 0.25}, Ends{0, 0}, Ends{0.5, 2.5}, Ends{0.5, kUnbounded},
        Ends{kNotANumber, 0.5}, Ends{0.5, kNotANumber}, Ends{-kUnbounded, 0.5}}) {
    EXPECT_EQ(words_of_gap([&](RawGap& gap) {
                gap.lower = ends.lower;
                gap.upper = ends.upper;
              }),
              "the distance of a gap is no distance within the clearance")
        << ends.lower << ", " << ends.upper;
  }
}

TEST(RecordingGaps, RefusePointsThatAreNotFinite) {
  for (std::size_t entry = 0; entry < 6; ++entry) {
    for (const double value : {kNotANumber, kUnbounded, -kUnbounded}) {
      EXPECT_EQ(words_of_gap([&](RawGap& gap) { gap.points[entry] = value; }),
                "a point of a gap is not finite")
          << entry << ": " << value;
    }
  }
}

TEST(RecordingGaps, RefuseAnyOrderButTheirOwnAndAPairTwice) {
  const RawGap zero;
  const RawGap one{.ids = {1, 0, 0, 0}};
  EXPECT_EQ(words_of(recording_of({zero, one}, {})), "");
  EXPECT_NE(words_of(recording_of({one, zero}, {})).find("the gaps are not sorted"),
            std::string::npos);
  // Two bodies have one gap, of whichever triangles.
  const RawGap another{.ids = {0, 0, 1, 1}};
  EXPECT_NE(words_of(recording_of({zero, another}, {})).find("the gaps are not sorted"),
            std::string::npos);
  const RawGap movers{.ids = {0, 1, 0, 0}};
  EXPECT_NE(words_of(recording_of({}, {movers, movers})).find("the gaps are not sorted"),
            std::string::npos);
}

TEST(RecordingGaps, RefuseAGapOfBodiesThatTouch) {
  for (const bool of_movers : {false, true}) {
    std::string content(4, '\0');  // both poses as before
    const RawGap gap{.ids = {0, of_movers ? 1U : 0U, 0, 0}};
    for (const bool list_of_movers : {false, true}) {
      detail::put(content, std::uint64_t{list_of_movers == of_movers});
      if (list_of_movers == of_movers) {
        for (const std::uint32_t id : {0U, of_movers ? 1U : 0U, 3U, 4U}) {
          detail::put(content, id);
        }
      }
    }
    put_raw(content, of_movers ? std::vector<RawGap>{} : std::vector{gap});
    put_raw(content, of_movers ? std::vector{gap} : std::vector<RawGap>{});
    const std::string good = recording_of({}, {});
    const std::string words = words_of(test::forged(
        good, test::second_chunk(good), [&](std::string& changed) { changed = content; }));
    EXPECT_NE(words.find("a gap between bodies that touch"), std::string::npos) << words;
  }
}

TEST(RecordingGaps, OfAFrameAreThoseOfTheStepAtItsPoses) {
  Rng rng(11);
  const test::Recorded recorded = test::record_scene(rng, 5, 130, RecordingEnding::complete, 2);
  Scene scene;
  for (std::size_t k = 0; k < recorded.shapes.size(); ++k) {
    scene.add_environment(Body(recorded.shapes[k], recorded.head.environment[k].pose));
  }
  for (const std::uint32_t model : recorded.head.movers) {
    scene.add_mover(Body(recorded.shapes[model]));
  }
  Replay replay = test::replay_of(recorded.bytes);
  std::size_t gaps = 0;
  for (const std::uint64_t k : {129U, 0U, 64U, 63U, 100U, 5U}) {
    const RecordedFrame& frame = replay.frame(k);
    for (MoverId id = 0; id < frame.poses.size(); ++id) {
      scene.set_pose(id, frame.poses[id]);
    }
    const StepReport report = scene.step({.clearance = replay.head().clearance});
    EXPECT_EQ(frame.environment_gaps, report.environment_gaps) << k;
    EXPECT_EQ(frame.mover_gaps, report.mover_gaps) << k;
    gaps += report.environment_gaps.size() + report.mover_gaps.size();
  }
  EXPECT_GT(gaps, 0U);
}

}  // namespace

}  // namespace soms
