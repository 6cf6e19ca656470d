#include "thesis/trips/timing.h"

#include "soms/base/error.h"

#include "tests/support/slow_build.h"

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <functional>
#include <stop_token>
#include <string>
#include <tuple>
#include <vector>

#if defined(__GLIBC__)
#include <unistd.h>
#endif

namespace soms::reproduce {
namespace {

TEST(Timing, SummarizesByOrderStatistics) {
  const Timing timing = summarize({4, 1, 3, 2, 10});
  EXPECT_EQ(timing.median, 3);
  EXPECT_EQ(timing.lower_quartile, 2);
  EXPECT_EQ(timing.upper_quartile, 4);
  EXPECT_EQ(timing.mean, 4);
  EXPECT_EQ(timing.min, 1);
  EXPECT_EQ(timing.max, 10);
  EXPECT_NEAR(timing.deviation, 3.5355339, 1e-6);
  EXPECT_EQ(timing.repetitions, 5);
  EXPECT_EQ(timing.rounds, (std::vector<double>{4, 1, 3, 2, 10}));
}

TEST(Timing, OneSampleHasNoSpread) {
  const Timing timing = summarize({7});
  EXPECT_EQ(timing.median, 7);
  EXPECT_EQ(timing.upper_quartile, 7);
  EXPECT_EQ(timing.deviation, 0);
}

TEST(Timing, WorksAreRunInTurnEveryOtherRoundInReverse) {
  std::string order;
  const std::array<std::function<void()>, 2> works{[&] { order += 'a'; }, [&] { order += 'b'; }};
  const std::vector<Timing> timings = time_in_turn(3, {}, works, 2);
  EXPECT_EQ(order, "abbaabbaab");
  ASSERT_EQ(timings.size(), 2U);
  EXPECT_EQ(timings[0].repetitions, 3);
}

#if defined(__GLIBC__)
TEST(Timing, WorksFindTheMemoryAgainThatTheyFreed) {
  SOMS_SKIP_IN_SLOW_BUILDS();  // sanitizers bring an allocator of their own
  const void* end_while_used = nullptr;
  const auto end_of_heap = [] { return static_cast<const void*>(sbrk(0)); };
  const auto work = [&] {
    // Left to itself glibc maps the first block, and trims the heap from 40 MB on.
    { const std::vector<std::byte> first(std::size_t{20} << 20); }
    const std::array<std::vector<std::byte>, 3> blocks{
        std::vector<std::byte>(std::size_t{15} << 20),
        std::vector<std::byte>(std::size_t{15} << 20),
        std::vector<std::byte>(std::size_t{15} << 20)};
    end_while_used = end_of_heap();
  };
  std::ignore = time_repeatedly(2, {}, work, 1);
  EXPECT_EQ(end_of_heap(), end_while_used);
}
#endif

TEST(Timing, StopRequestEndsIt) {
  std::stop_source source;
  int runs = 0;
  const auto work = [&] {
    if (++runs == 3) {
      source.request_stop();
    }
  };
  EXPECT_THROW(std::ignore = time_repeatedly(100, {.stop = source.get_token()}, work, 0), Error);
  EXPECT_EQ(runs, 3);
}

}  // namespace
}  // namespace soms::reproduce
