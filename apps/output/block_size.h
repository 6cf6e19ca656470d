/// \file
/// How many rows of a file are answered at once.
#pragma once

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdint>

namespace soms::command {

/// How many poses to read and answer at once: as many as took about a tenth of a second in the last
/// block, so that answers come steadily and Ctrl-C loses little. Learned from the past, it bounds
/// no memory: of a block of 4,096 poses after ones that were free, all pairs are held, however
/// many.
class BlockSize {
 public:
  [[nodiscard]] std::size_t value() const { return value_; }

  void learn(std::chrono::steady_clock::duration time, std::uint64_t pairs) {
    if (time > std::chrono::milliseconds(200) || pairs > kMostPairs) {
      value_ = std::max<std::size_t>(1, value_ / 2);
    } else if (time < std::chrono::milliseconds(50) && 4 * pairs < kMostPairs) {
      value_ = std::min<std::size_t>(kMost, 2 * value_);
    }
  }

 private:
  static constexpr std::size_t kMost = 4096;
  static constexpr std::uint64_t kMostPairs = 1'000'000;
  std::size_t value_ = 1;
};

}  // namespace soms::command
