/// \file
/// Numbers with their intervals beside what a claim demands of them: dots with whiskers, one row
/// for each label, labels in groups.
#pragma once

#include "apps/draw/chart.h"
#include "apps/draw/interval.h"

#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace soms::reproduce {

/// A number of the chart.
struct IntervalMark {
  std::string group = {};   ///< heading above its row: the kind of trip, say; may be empty
  std::string label;        ///< of its row: the trip, say
  std::string series = {};  ///< which of the dots in the row: the opponent, say; may be empty
  double value = 0;         ///< not a number: no dot
  std::optional<Interval> interval = std::nullopt;  ///< a whisker; nothing for a count
};

/// Dots over one horizontal axis. Groups, rows and series stand in order of first appearance.
struct IntervalChart {
  std::string title = {};
  std::string x_label = {};
  Scale scale = Scale::linear;
  /// The open range that is demanded is shaded, and its finite ends are lines: "below 1" has an end
  /// at 1. Without an end nothing is shaded.
  double above = -std::numeric_limits<double>::infinity();
  double below = std::numeric_limits<double>::infinity();
  /// The greatest value with a dot of its own, so that a few far away do not press the others
  /// together. A greater one, or an infinite one, is an arrow at the edge with its number; whiskers
  /// end there.
  double most = std::numeric_limits<double>::infinity();
  std::vector<IntervalMark> marks = {};
};

/// As SVG; the same bytes for the same data. Values stand at the right if there is one series.
/// \errors ErrorKind::usage for an end of an interval that is not finite, or on a log axis for a
///         value or a finite end that is not above 0.
[[nodiscard]] std::string draw(const IntervalChart& chart);

}  // namespace soms::reproduce
