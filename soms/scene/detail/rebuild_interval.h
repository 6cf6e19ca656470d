/// \file
/// For how many calls should larger boxes be made?
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace soms::detail {

/// Chooses for how many calls boxes are made larger: long enough that rebuilding is seldom,
/// short enough that few pairs are kept in vain. Goes up and down a list of lengths and turns
/// around where it got worse. Works on counts, not on times, so that runs are repeatable.
class RebuildInterval {
 public:
  /// A call goes by with what is kept.
  void pass() { ++age_; }

  /// Calls since all was rebuilt.
  [[nodiscard]] std::uint64_t age() const { return age_; }

  /// Calls that boxes are made larger for at present.
  [[nodiscard]] std::uint32_t calls() const { return calls_; }

  /// Work beside looking through the pairs, in entries of a grid.
  void spend(std::uint64_t work) { spent_ += work; }

  /// Calls to make boxes larger for when all is rebuilt; `speed` is how far boxes moved a call.
  [[nodiscard]] std::uint32_t next(double speed);

  /// The boxes became too large for a grid.
  void look_less_far();

  /// All was rebuilt by `work`, in entries of a grid, and `pairs` pairs are kept.
  void start(std::uint64_t work, std::uint64_t pairs);

 private:
  static constexpr std::array<std::uint32_t, 13> kLengths{0,  1,  2,  3,  4,  6, 8,
                                                          12, 16, 24, 32, 48, 64};

  std::size_t at_ = 3;  ///< in kLengths
  bool up_ = true;
  std::uint32_t rest_ = 0;  ///< times to stay at length 0
  std::uint32_t calls_ = 0;
  std::uint64_t age_ = 0;
  std::uint64_t spent_ = 0;
  std::uint64_t pairs_ = 0;
  double speed_ = 0;
  double last_cost_ = 0;
};

}  // namespace soms::detail
