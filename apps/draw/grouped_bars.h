/// \file
/// Bars side by side from numbers that know their group and their bar.
#pragma once

#include "apps/draw/chart.h"

#include <limits>
#include <span>
#include <string>

namespace soms::reproduce {

/// A number of a chart of bars.
struct Datum {
  std::string group;  ///< the model, say
  std::string bar;    ///< the rule, say
  double value = 0;
  /// Spread, both or neither.
  double low = std::numeric_limits<double>::quiet_NaN();
  double high = std::numeric_limits<double>::quiet_NaN();
};

/// A chart of the data: groups and bars in order of first appearance; a pair that is not in the
/// data, or whose value is not finite, has no bar. Spread is drawn if the first datum has it.
[[nodiscard]] BarChart grouped_bars(std::string title, std::string y_label,
                                    std::span<const Datum> data);

}  // namespace soms::reproduce
