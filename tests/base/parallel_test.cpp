#include "soms/base/parallel.h"

#include "soms/base/error.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <numeric>
#include <stdexcept>
#include <utility>
#include <vector>

namespace soms {
namespace {

constexpr int kThreadCounts[] = {1, 2, 8, 0};

Limits threads(int n) {
  Limits limits;
  limits.threads = n;
  return limits;
}

TEST(Limits, ChunksCoverTheRangeOnceWithFixedBounds) {
  for (const int n : kThreadCounts) {
    for (const std::size_t count : {0U, 1U, 6U, 7U, 8U, 1000U}) {
      std::vector<std::atomic<int>> visits(count);
      std::vector<std::pair<std::size_t, std::size_t>> bounds((count + 6) / 7);
      for_each_chunk(count, 7, threads(n), [&](std::size_t begin, std::size_t end) {
        bounds[begin / 7] = {begin, end};
        for (std::size_t i = begin; i < end; ++i) {
          ++visits[i];
        }
      });
      for (std::size_t i = 0; i < count; ++i) {
        EXPECT_EQ(visits[i], 1);
      }
      for (std::size_t c = 0; c < bounds.size(); ++c) {
        EXPECT_EQ(bounds[c].first, 7 * c);
        EXPECT_EQ(bounds[c].second, std::min(count, 7 * c + 7));
      }
    }
  }
}

TEST(Limits, AChunkOfZeroItemsCountsAsOne) {
  std::atomic<int> chunks = 0;
  for_each_chunk(5, 0, threads(2), [&](std::size_t begin, std::size_t end) {
    EXPECT_EQ(end, begin + 1);
    ++chunks;
  });
  EXPECT_EQ(chunks, 5);
}

// Sums of doubles depend on order: joined in chunk order they are the same bits.
TEST(Limits, ResultsJoinedInChunkOrderAreTheSameBits) {
  const auto sum = [](int n) {
    std::vector<double> parts(101);
    for_each_chunk(10007, 100, threads(n), [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        parts[begin / 100] += 1.0 / static_cast<double>(i + 1);
      }
    });
    return std::accumulate(parts.begin(), parts.end(), 0.0);
  };
  for (const int n : kThreadCounts) {
    EXPECT_EQ(sum(n), sum(1));
  }
}

TEST(Limits, RethrowsTheExceptionOfABody) {
  for (const int n : kThreadCounts) {
    EXPECT_THROW(for_each_chunk(100, 1, threads(n),
                                [](std::size_t begin, std::size_t) {
                                  if (begin == 37) {
                                    throw std::invalid_argument("thirty-seven");
                                  }
                                }),
                 std::invalid_argument);
  }
}

TEST(Limits, StopsBetweenChunksOnRequest) {
  for (const int n : kThreadCounts) {
    std::stop_source source;
    Limits limits = threads(n);
    limits.stop = source.get_token();
    std::atomic<int> chunks = 0;
    try {
      for_each_chunk(10000, 1, limits, [&](std::size_t, std::size_t) {
        ++chunks;
        source.request_stop();
      });
      ADD_FAILURE() << "not cancelled";
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::cancelled);
    }
    EXPECT_LE(chunks, 64);
    EXPECT_THROW(check_stop(limits), Error);
  }
}

TEST(Limits, ReportsProgressUpToOne) {
  for (const int n : kThreadCounts) {
    Limits limits = threads(n);
    std::vector<double> shares;
    limits.progress = [&](double share) { shares.push_back(share); };
    for_each_chunk(10, 3, limits, [](std::size_t, std::size_t) {});
    EXPECT_EQ(shares, (std::vector<double>{0.25, 0.5, 0.75, 1}));
  }
}

TEST(Limits, NestsAndIsCalledFromManyPlaces) {
  std::atomic<int> items = 0;
  for_each_chunk(8, 1, threads(4), [&](std::size_t, std::size_t) {
    for_each_chunk(100, 10, threads(2), [&](std::size_t begin, std::size_t end) {
      items += static_cast<int>(end - begin);
    });
  });
  EXPECT_EQ(items, 800);
}

TEST(Limits, NeverPrints) {
  ::testing::internal::CaptureStderr();
  for_each_chunk(100, 1, threads(64), [](std::size_t, std::size_t) {});
  EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
}

}  // namespace
}  // namespace soms
