#include "soms/query/detail/engine/limit.h"

#include "soms/base/error.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <cstdint>
#include <optional>
#include <stop_token>

namespace soms::detail {
namespace {

/// More work than a limit lets pass without a look.
constexpr std::uint64_t kMuch = 1 << 20;

TEST(Limit, NeverEndsWithoutADeadline) {
  const Limits limits;
  Limit limit(limits);
  EXPECT_FALSE(limit.spend(kMuch));
  EXPECT_FALSE(limit.late());
}

TEST(Limit, IsLateFromTheStartOnceItsDeadlinePassed) {
  const Limits limits{.deadline = std::chrono::steady_clock::time_point::min()};
  Limit limit(limits);
  EXPECT_TRUE(limit.late());
  EXPECT_TRUE(limit.spend(0));
}

TEST(Limit, DoesNotEndBeforeItsDeadline) {
  const Limits limits{.deadline = std::chrono::steady_clock::time_point::max()};
  Limit limit(limits);
  EXPECT_FALSE(limit.spend(kMuch));
  EXPECT_FALSE(limit.late());
}

TEST(Limit, EndsOnceAnotherPartHasTheAnswerAndIsNotLateThen) {
  std::atomic<bool> done = false;
  const Limits limits;
  Limit limit(limits, &done);
  EXPECT_FALSE(limit.spend(kMuch));
  done = true;
  EXPECT_TRUE(limit.spend(kMuch));
  EXPECT_FALSE(limit.late());
}

TEST(Limit, ThrowsOnceAStopIsRequested) {
  std::stop_source source;
  const Limits limits = {.stop = source.get_token()};
  Limit limit(limits);
  EXPECT_FALSE(limit.spend(kMuch));
  source.request_stop();
  try {
    static_cast<void>(limit.spend(kMuch));
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::cancelled);
  }
}

// Looking at the clock costs more than a test of boxes.
TEST(Limit, LooksOnlyOnceInAWhile) {
  std::atomic<bool> done = true;
  const Limits limits;
  Limit limit(limits, &done);
  EXPECT_FALSE(limit.spend(1));
}

}  // namespace
}  // namespace soms::detail
