/// \file
/// For how many calls should larger boxes be made?
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace soms::detail {

/// How boxes move, when all is rebuilt.
struct Outlook {
  double speed = 0;  ///< the way of a usual box in a call
  double last = 0;   ///< its way in the last call
  /// Along each axis, by what part of a usual box a larger box grows for each call ahead.
  std::array<double, 3> growth{};
};

/// Chooses for how many calls boxes are made larger: long enough that rebuilding is seldom, short
/// enough that few pairs are kept in vain. Expects pairs to grow in number as the volume of the
/// larger boxes does, corrected by what came of it the last time. Works on counts, not on times, so
/// that runs are repeatable.
class RebuildInterval {
 public:
  /// A call goes by with what is kept.
  void pass() { ++age_; }

  /// Calls since all was rebuilt.
  [[nodiscard]] std::uint64_t age() const { return age_; }

  /// Calls that boxes are made larger for at present.
  [[nodiscard]] std::uint32_t calls() const { return calls_; }

  /// A call found so many pairs of boxes.
  void find(std::uint64_t pairs) { found_ = pairs; }

  /// Calls to make boxes larger for when all is rebuilt.
  [[nodiscard]] std::uint32_t next(const Outlook& outlook);

  /// The boxes became too large for a grid.
  void look_less_far();

  /// All was rebuilt by `work`, in entries of a grid, and `pairs` pairs are kept.
  void start(std::uint64_t work, std::uint64_t pairs);

 private:
  static constexpr std::array<std::uint32_t, 13> kLengths{0,  1,  2,  3,  4,  6, 8,
                                                          12, 16, 24, 32, 48, 64};

  void learn();

  std::uint32_t most_ = 4;  ///< calls, as far as motions could be foretold
  std::uint32_t rest_ = 0;  ///< times to make no boxes larger
  std::uint32_t calls_ = 0;
  std::uint64_t age_ = 0;
  std::uint64_t work_ = 0;
  std::uint64_t found_ = 0;
  double growth_ = 1;  ///< expected of the pairs that are kept
  double error_ = 1;   ///< how many times as many there are
  double speed_ = 0;
};

}  // namespace soms::detail
