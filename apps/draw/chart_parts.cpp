#include "apps/draw/chart_parts.h"

#include "soms/base/error.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

namespace soms::reproduce {

namespace {

constexpr double kCell = 5;
constexpr double kCalloutSize = 14;
constexpr double kCalloutWidth = 210;

/// Paths of markers around the origin, all of about the same area.
constexpr std::array<std::string_view, kSeriesColors> kMarkers{
    "m-4,0a4,4 0 1 0 8,0a4,4 0 1 0 -8,0z",
    "m-3.6,-3.6h7.2v7.2h-7.2z",
    "m0,-4.8l4.6,8h-9.2z",
    "m0,-5l5,5l-5,5l-5,-5z",
    "m0,4.8l4.6,-8h-9.2z",
    "m-1.4,-4.4h2.8v3h3v2.8h-3v3h-2.8v-3h-3v-2.8h3z",
    "m-5,-2.2h10v4.4h-10z",
    "m-2.2,-5h4.4v10h-4.4z"};

/// Distance from `at` to a box; 0 inside.
double distance(Spot at, Spot corner, double width, double height) {
  const double dx = std::max({corner.x - at.x, at.x - corner.x - width, 0.0});
  const double dy = std::max({corner.y - at.y, at.y - corner.y - height, 0.0});
  return std::hypot(dx, dy);
}

std::size_t cell_of(int row, int column, int columns) {
  return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
         static_cast<std::size_t>(column);
}

}  // namespace

Heading::Heading(std::string_view title_words, std::string_view label_words)
    : title(wrapped(title_words, kTitleSize, kChartWidth - 2 * kChartMargin, true)),
      label(label_words) {
}

double Heading::height() const {
  const double titles =
      title.front().empty() ? 0 : 1.25 * kTitleSize * static_cast<double>(title.size());
  return kChartMargin + titles + (label.empty() ? 8 : 30);
}

void Heading::draw(Svg& svg) const {
  svg.lines({kChartMargin, kChartMargin + 0.9 * kTitleSize}, title,
            {.size = kTitleSize, .bold = true});
  svg.text({kChartMargin, height() - 10}, label, {.size = kLabelSize, .faint = true});
}

void refuse(const std::string& chart, const std::string& what) {
  throw Error(ErrorKind::usage, "chart \"" + chart + "\": " + what, "correct the chart's data");
}

std::size_t place_of(std::vector<std::string>& names, const std::string& name) {
  const auto found = std::find(names.begin(), names.end(), name);
  const auto place = static_cast<std::size_t>(found - names.begin());
  if (found == names.end()) {
    names.push_back(name);
  }
  return place;
}

Legend::Legend(std::vector<std::string> names) : names_(std::move(names)) {
  if (names_.empty() || (names_.size() == 1 && names_[0].empty())) {
    return;
  }
  Spot next{kChartMargin, 0};
  for (const std::string& name : names_) {
    const double width = text_width(name, kNameSize) + 42;
    if (next.x > kChartMargin && next.x + width > kChartWidth - kChartMargin) {
      next = {kChartMargin, next.y + kLegendRow};
    }
    corners_.push_back(next);
    next.x += width;
  }
}

double Legend::height() const {
  return corners_.empty() ? 0 : corners_.back().y + kLegendRow;
}

void draw_ticks_below(Svg& svg, const Plot& plot, const Axis& axis) {
  for (const Tick& tick : axis.ticks()) {
    const double x = plot.left + plot.width * axis.share(tick.value);
    svg.line({x, plot.top}, {x, plot.bottom()}, kGridLine);
    svg.text({x, plot.bottom() + 19}, tick.label,
             {.size = kNameSize, .anchor = Anchor::middle, .faint = true});
  }
}

void draw_label_below(Svg& svg, const Plot& plot, std::string_view label) {
  if (!label.empty()) {
    svg.text({plot.left + plot.width / 2, plot.bottom() + 43}, label,
             {.size = kLabelSize, .anchor = Anchor::middle, .faint = true});
  }
}

std::vector<double> spread(const std::vector<double>& wishes, const std::vector<double>& heights,
                           double top, double bottom) {
  std::vector<std::size_t> order(wishes.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return wishes[a] < wishes[b]; });
  std::vector<double> tops(wishes.size());
  double next = top;
  for (const std::size_t k : order) {
    tops[k] = std::max(next, wishes[k] - heights[k] / 2);
    next = tops[k] + heights[k];
  }
  double limit = bottom;
  for (auto k = order.rbegin(); k != order.rend(); ++k) {
    tops[*k] = std::min(tops[*k], limit - heights[*k]);
    limit = tops[*k];
  }
  return tops;
}

void draw_marker(Svg& svg, std::size_t series, Spot at) {
  const std::size_t k = series % kSeriesColors;
  svg.path(fmt::format("M{}{}", pixels(at), kMarkers[k]),
           fmt::format("class=\"f{}\" fill=\"{}\"", k, series_color(k)));
}

void draw_whisker(Svg& svg, Spot from, Spot to, std::string_view attributes) {
  const double length = std::hypot(to.x - from.x, to.y - from.y);
  if (!(length > 0)) {
    return;
  }
  const Spot foot{4 * (to.y - from.y) / length, -4 * (to.x - from.x) / length};
  PathData path;
  path.move(from).line(to);
  for (const Spot end : {from, to}) {
    path.move({end.x - foot.x, end.y - foot.y}).line({end.x + foot.x, end.y + foot.y});
  }
  svg.path(path.data(), fmt::format("fill=\"none\" {}", attributes));
}

Clearings::Clearings(const Plot& plot)
    : plot_(plot),
      columns_(static_cast<int>(plot.width / kCell) + 1),
      rows_(static_cast<int>(plot.height / kCell) + 1),
      cells_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), 0) {
}

void Clearings::cover(Spot from, Spot to) {
  const int steps = static_cast<int>(std::hypot(to.x - from.x, to.y - from.y) / kCell) + 1;
  for (int k = 0; k <= steps; ++k) {
    const double t = static_cast<double>(k) / steps;
    const Spot at{from.x + t * (to.x - from.x), from.y + t * (to.y - from.y)};
    cover({at.x - kCell, at.y - kCell}, 2 * kCell, 2 * kCell);
  }
}

void Clearings::cover(Spot corner, double width, double height) {
  const auto cell = [](double at, double begin, int count) {
    return std::clamp(static_cast<int>(std::floor((at - begin) / kCell)), 0, count - 1);
  };
  const int right = cell(corner.x + width, plot_.left, columns_);
  const int bottom = cell(corner.y + height, plot_.top, rows_);
  for (int row = cell(corner.y, plot_.top, rows_); row <= bottom; ++row) {
    for (int column = cell(corner.x, plot_.left, columns_); column <= right; ++column) {
      cells_[cell_of(row, column, columns_)] = 1;
    }
  }
}

int Clearings::covered(Spot corner, double width, double height) const {
  const int left = static_cast<int>((corner.x - plot_.left) / kCell);
  const int top = static_cast<int>((corner.y - plot_.top) / kCell);
  const int right = std::min(columns_, left + static_cast<int>(width / kCell) + 1);
  const int bottom = std::min(rows_, top + static_cast<int>(height / kCell) + 1);
  int count = 0;
  for (int row = top; row < bottom; ++row) {
    for (int column = left; column < right; ++column) {
      count += cells_[cell_of(row, column, columns_)];
    }
  }
  return count;
}

Spot Clearings::find(Spot at, double width, double height) const {
  Spot best{plot_.left, plot_.top};
  double least = 1e300;
  for (double y = plot_.top; y + height <= plot_.bottom(); y += kCell) {
    for (double x = plot_.left + kCell; x + width <= plot_.right(); x += kCell) {
      const double away = distance(at, {x, y}, width, height);
      // So near that no arrow fits between is as bad as far away.
      const double cost = (away < 16 ? 200 : away) + 60.0 * covered({x, y}, width, height);
      if (cost < least) {
        least = cost;
        best = {x, y};
      }
    }
  }
  return best;
}

void draw_callout(Svg& svg, Clearings& clearings, Spot at, std::string_view words) {
  const std::vector<std::string> lines = wrapped(words, kCalloutSize, kCalloutWidth);
  double width = 0;
  for (const std::string& line : lines) {
    width = std::max(width, text_width(line, kCalloutSize));
  }
  const double height = 1.25 * kCalloutSize * static_cast<double>(lines.size());
  const Spot corner = clearings.find(at, width, height);
  clearings.cover(corner, width, height);
  const Spot from{std::clamp(at.x, corner.x, corner.x + width),
                  std::clamp(at.y, corner.y, corner.y + height)};
  const double length = std::hypot(at.x - from.x, at.y - from.y);
  if (length > 12) {
    const Spot along{(at.x - from.x) / length, (at.y - from.y) / length};
    const Spot tip{at.x - 6 * along.x, at.y - 6 * along.y};
    const Spot back{tip.x - 7 * along.x, tip.y - 7 * along.y};
    const Spot side{3.5 * along.y, -3.5 * along.x};
    PathData arrow;
    arrow.move(from).line(tip).move({back.x + side.x, back.y + side.y}).line(tip);
    arrow.line({back.x - side.x, back.y - side.y});
    svg.path(arrow.data(), "class=\"axis\" fill=\"none\" stroke=\"#6b6f74\" stroke-width=\"1.4\"");
  }
  svg.lines({corner.x, corner.y + 0.95 * kCalloutSize}, lines,
            {.size = kCalloutSize, .haloed = true});
}

}  // namespace soms::reproduce
