/// \file
/// Plots that report pages share.
#pragma once

#include "apps/report/page.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace soms::command {

/// Values one after the other, and the mean and the largest of each few where there are many.
struct Binned {
  std::size_t width = 1;       ///< values that share a point
  std::vector<double> x = {};  ///< number of the first of them
  std::vector<double> mean = {};
  std::vector<double> most = {};
};

/// `value(k)` for k below `count`, at some hundred points at most.
[[nodiscard]] Binned binned(std::uint64_t count, const std::function<double(std::uint64_t)>& value);

/// Bars for the eight names with the highest counts, highest first, in a color of charts; empty for
/// none, and for one, which compares nothing. The chart's caption says what is counted.
[[nodiscard]] std::vector<report::Plot> bars_of(std::vector<std::pair<std::string, double>> counts,
                                                const std::string& title, const std::string& label,
                                                const std::string& caption, std::size_t color);

/// A drawing for a page.
[[nodiscard]] report::Plot plot(std::string svg, std::string caption);

}  // namespace soms::command
