/// \file
/// A test of `thesis`, run: what each frame found and took, and what it comes to.
#pragma once

#include "soms/base/limits.h"

#include "apps/soms/thesis/thesis_trips.h"
#include "thesis/trips/frames.h"

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

namespace soms::command {

/// What a test comes to. Frames count from 0; times are of the frames in which the roots overlap.
struct ThesisSummary {
  reproduce::Totals sums = {};
  std::optional<std::size_t> first_root = std::nullopt;     ///< roots overlap
  std::optional<std::size_t> first_leaf = std::nullopt;     ///< leaves overlap
  std::optional<std::size_t> first_contact = std::nullopt;  ///< triangles touch
  std::size_t contact_frames = 0;
  std::size_t last_contacts = 0;  ///< pairs of triangles that touch in the last frame
  double mean_ms = 0;             ///< 0 where no roots overlap
  double median_ms = 0;
  double max_ms = 0;

  /// Frames a second by the mean time; 0 where there is none.
  [[nodiscard]] double fps() const { return mean_ms > 0 ? 1000 / mean_ms : 0; }
};

/// "below", "within" or "above" the frames a second that the thesis calls interactive. \pre `fps`
/// is greater than 0.
[[nodiscard]] std::string_view interactive_word(double fps);

/// A test and what it found.
struct ThesisResult {
  ThesisTrip what = {};
  std::vector<reproduce::Frame> frames = {};
  std::vector<double> ms = {};  ///< of each frame: traversal and triangle tests
  ThesisSummary summary = {};
};

/// Runs a test: counts and contacts of each frame, and its median time of so many repetitions after
/// one that warms up.
/// \errors ErrorKind::cancelled.
[[nodiscard]] ThesisResult run_trip(ThesisTrip what, const TraversalOptions& traversal,
                                    int repetitions, const Limits& limits);

}  // namespace soms::command
