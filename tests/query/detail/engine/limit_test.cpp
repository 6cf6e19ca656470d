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
  const Parallel parallel;
  Limit limit(std::nullopt, parallel);
  EXPECT_FALSE(limit.spend(kMuch));
  EXPECT_FALSE(limit.late());
}

TEST(Limit, IsLateFromTheStartOnceItsDeadlinePassed) {
  const Parallel parallel;
  Limit limit(std::chrono::steady_clock::time_point::min(), parallel);
  EXPECT_TRUE(limit.late());
  EXPECT_TRUE(limit.spend(0));
}

TEST(Limit, DoesNotEndBeforeItsDeadline) {
  const Parallel parallel;
  Limit limit(std::chrono::steady_clock::time_point::max(), parallel);
  EXPECT_FALSE(limit.spend(kMuch));
  EXPECT_FALSE(limit.late());
}

TEST(Limit, EndsOnceAnotherPartHasTheAnswerAndIsNotLateThen) {
  std::atomic<bool> done = false;
  const Parallel parallel;
  Limit limit(std::nullopt, parallel, &done);
  EXPECT_FALSE(limit.spend(kMuch));
  done = true;
  EXPECT_TRUE(limit.spend(kMuch));
  EXPECT_FALSE(limit.late());
}

TEST(Limit, ThrowsOnceAStopIsRequested) {
  std::stop_source source;
  const Parallel parallel = {.stop = source.get_token()};
  Limit limit(std::nullopt, parallel);
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
  const Parallel parallel;
  Limit limit(std::nullopt, parallel, &done);
  EXPECT_FALSE(limit.spend(1));
}

}  // namespace
}  // namespace soms::detail
