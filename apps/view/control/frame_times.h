/// \file
/// Times of the last frames, for the graph and the frames a second.
#pragma once

#include <array>
#include <cstddef>

namespace soms::view {

/// A ring of the last frames' times.
class FrameTimes {
 public:
  static constexpr std::size_t kKept = 120;

  /// A frame that took `ms` of work; `seconds` passed since the frame before. A longer gap than
  /// half a second was a rest, not a slow frame, and starts the frames a second again.
  void add(double ms, double seconds);

  /// Milliseconds from the oldest frame to the newest; zeros where none was yet.
  [[nodiscard]] std::array<float, kKept> graph() const;

  [[nodiscard]] double last() const { return count_ == 0 ? 0 : ms_[(next_ + kKept - 1) % kKept]; }

  [[nodiscard]] double mean() const;
  [[nodiscard]] double greatest() const;

  /// Frames a second since the last rest, over the newest 30 at most; 0 while resting.
  [[nodiscard]] double frames_a_second() const;

 private:
  static constexpr std::size_t kIntervals = 30;

  std::array<float, kKept> ms_{};
  std::size_t next_ = 0;
  std::size_t count_ = 0;
  std::array<double, kIntervals> intervals_{};
  std::size_t next_interval_ = 0;
  std::size_t running_ = 0;
};

}  // namespace soms::view
