#include "apps/draw/grouped_bars.h"

#include "apps/draw/chart_parts.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace soms::reproduce {

namespace {

Bars& bars_in_group(BarChart& chart, const std::string& name) {
  const auto found = std::find_if(chart.bars.begin(), chart.bars.end(),
                                  [&](const Bars& bars) { return bars.name == name; });
  if (found != chart.bars.end()) {
    return *found;
  }
  return chart.bars.emplace_back(Bars{.name = name});
}

}  // namespace

BarChart grouped_bars(std::string title, std::string y_label, std::span<const Datum> data) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  BarChart chart{.title = std::move(title), .y_label = std::move(y_label)};
  for (const Datum& datum : data) {
    (void)place_of(chart.groups, datum.group);
    bars_in_group(chart, datum.bar);
  }
  const bool spread = !data.empty() && std::isfinite(data.front().low);
  for (Bars& bars : chart.bars) {
    bars.values.assign(chart.groups.size(), kNone);
    if (spread) {
      bars.low = bars.values;
      bars.high = bars.values;
    }
  }
  for (const Datum& datum : data) {
    const std::size_t group = place_of(chart.groups, datum.group);
    Bars& bars = bars_in_group(chart, datum.bar);
    bars.values[group] = datum.value;
    if (spread) {
      bars.low[group] = datum.low;
      bars.high[group] = datum.high;
    }
  }
  return chart;
}

}  // namespace soms::reproduce
