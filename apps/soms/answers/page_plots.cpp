#include "apps/soms/answers/page_plots.h"

#include "apps/draw/chart.h"
#include "apps/report/script_text.h"

#include <algorithm>

namespace soms::command {

namespace {

constexpr std::uint64_t kMostPoints = 800;
constexpr std::size_t kLongestName = 28;

}  // namespace

Binned binned(std::uint64_t count, const std::function<double(std::uint64_t)>& value) {
  Binned bins;
  bins.width =
      static_cast<std::size_t>(std::max<std::uint64_t>(1, (count + kMostPoints - 1) / kMostPoints));
  for (std::uint64_t begin = 0; begin < count; begin += bins.width) {
    const std::uint64_t end = std::min<std::uint64_t>(count, begin + bins.width);
    double sum = 0;
    double most = value(begin);
    for (std::uint64_t k = begin; k < end; ++k) {
      sum += value(k);
      most = std::max(most, value(k));
    }
    bins.x.push_back(static_cast<double>(begin));
    bins.mean.push_back(sum / static_cast<double>(end - begin));
    bins.most.push_back(most);
  }
  return bins;
}

std::vector<report::Plot> bars_of(std::vector<std::pair<std::string, double>> counts,
                                  const std::string& title, const std::string& label,
                                  const std::string& caption, std::size_t color) {
  constexpr std::size_t kMost = 8;
  if (counts.size() < 2) {
    return {};
  }
  std::sort(counts.begin(), counts.end(), [](const auto& a, const auto& b) {
    return a.second != b.second ? a.second > b.second : a.first < b.first;
  });
  counts.resize(std::min(kMost, counts.size()));
  reproduce::BarChart chart{.title = title, .y_label = label};
  reproduce::Bars bars{.name = label, .color = color};
  for (const auto& [name, count] : counts) {
    chart.groups.push_back(report::shortened(name, kLongestName));
    bars.values.push_back(count);
  }
  chart.bars.push_back(std::move(bars));
  return {plot(reproduce::draw(chart), caption)};
}

report::Plot plot(std::string svg, std::string caption) {
  return {.svg = std::move(svg), .caption = std::move(caption)};
}

}  // namespace soms::command
