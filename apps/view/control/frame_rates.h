/// \file
/// Milliseconds of frames in which something moved, with drawing and without.
#pragma once

#include "soms/base/pose.h"

#include "apps/view/control/subject.h"
#include "apps/view/control/view_state.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace soms::view {

/// Means over the newest frames in which something moved.
struct Rates {
  std::size_t frames = 0;   ///< that were measured; 0: none was
  double collision_ms = 0;  ///< of the traversal chosen alone
  double whole_ms = 0;      ///< of all that a frame takes, drawing and panels too
  bool moving = false;      ///< the newest frame is among them; else they are from before
};

/// Keeps the newest frames. Another test, tree or traversal starts over.
/// \source thesis, section 1.4: milliseconds, frame and FPS of each test, drawing on and off.
class FrameRates {
 public:
  static constexpr std::size_t kKept = 60;

  /// A frame that was finished. One in which neither time nor the object moved is not measured, nor
  /// the first one after a choice, which builds trees.
  void add(const ViewState& state, const Facts& facts, double whole_ms);

  [[nodiscard]] Rates rates() const;

 private:
  struct Sample {
    double collision_ms = 0;
    double whole_ms = 0;
  };

  std::optional<Choice> choice_;
  std::uint64_t frame_ = 0;
  std::optional<Pose> object_;
  std::array<Sample, kKept> samples_{};
  std::size_t next_ = 0;
  std::size_t count_ = 0;
  bool moving_ = false;
};

/// A row of the panel: what was measured, its milliseconds and its frames a second.
struct RateRow {
  std::string what;
  std::string ms;
  std::string fps;
};

/// Collision alone, and with drawing. Before anything moved the first is that of the frame shown,
/// and the second is not known.
[[nodiscard]] std::vector<RateRow> rate_rows(const Rates& rates, const Facts& facts);

/// What the rows are: "mean of the last 49 frames", or that these are of the time before a rest.
[[nodiscard]] std::string rate_line(const Rates& rates);

}  // namespace soms::view
