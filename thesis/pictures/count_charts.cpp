#include "thesis/pictures/count_charts.h"

#include "apps/draw/grouped_bars.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace soms::reproduce {

namespace {

double percent(std::uint64_t part, std::size_t whole) {
  return whole == 0 ? 0 : 100 * static_cast<double>(part) / static_cast<double>(whole);
}

Line& line_of(LineChart& chart, const Contender& contender) {
  const auto found = std::find_if(chart.lines.begin(), chart.lines.end(),
                                  [&](const Line& line) { return line.name == contender.title; });
  if (found != chart.lines.end()) {
    return *found;
  }
  return chart.lines.emplace_back(Line{.name = contender.title, .dashed = !contender.of_thesis});
}

}  // namespace

double one_percent(const Counted& counted) {
  return percent(counted.counts.one, counted.model->mesh->triangles.size());
}

double lt5_percent(const Counted& counted) {
  return percent(counted.counts.lt5, counted.counts.leaves);
}

double lt5(const Counted& counted) {
  return static_cast<double>(counted.counts.lt5);
}

double balanced_level(const Counted& counted) {
  return static_cast<double>(counted.counts.balanced_level);
}

double undividable(const Counted& counted) {
  return static_cast<double>(counted.counts.undividable);
}

std::string bars_of(std::string title, std::string y_label, std::span<const Counted> counts,
                    CountValue value, Scale scale) {
  std::vector<Datum> data;
  for (const Counted& one : counts) {
    data.push_back({label_of(*one.model), one.contender.title, value(one)});
  }
  BarChart chart = grouped_bars(std::move(title), std::move(y_label), data);
  chart.y_scale = scale;
  return draw(chart);
}

std::string lines_by_level(std::string title, std::string y_label, const Model& model,
                           std::span<const Counted> counts, CountValue value) {
  LineChart chart{
      .title = std::move(title), .x_label = "greatest level", .y_label = std::move(y_label)};
  for (const Counted& one : counts) {
    const int level = one.contender.options.level;
    if (one.model == &model && level > 0 && has_usual_options(one.contender)) {
      Line& line = line_of(chart, one.contender);
      line.x.push_back(level);
      line.y.push_back(value(one));
    }
  }
  return draw(chart);
}

std::vector<Counted> with_usual_options(std::span<const Counted> counts) {
  std::vector<Counted> result;
  std::copy_if(counts.begin(), counts.end(), std::back_inserter(result),
               [](const Counted& one) { return has_usual_options(one.contender); });
  return result;
}

}  // namespace soms::reproduce
