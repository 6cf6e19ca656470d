#include "apps/draw/interval_chart.h"

#include "apps/draw/axis.h"
#include "apps/draw/chart_parts.h"
#include "apps/draw/svg.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <string_view>

namespace soms::reproduce {

namespace {

constexpr double kGroupHeight = 30;
constexpr double kDotHeight = 15;
constexpr double kRowGap = 9;
constexpr double kMostRowNameWidth = 230;
constexpr double kLogRim = 1.15;
constexpr std::string_view kEnd =
    "class=\"axis\" stroke=\"#6b6f74\" stroke-width=\"1.4\" stroke-dasharray=\"5 4\"";

/// The numbers of a mark that has a dot.
std::vector<double> numbers_of(const IntervalMark& mark) {
  if (!std::isfinite(mark.value)) {
    return {};
  }
  return mark.interval ? std::vector<double>{mark.interval->low, mark.value, mark.interval->high}
                       : std::vector<double>{mark.value};
}

void check(const IntervalChart& chart) {
  const bool log = chart.scale == Scale::log;
  for (const IntervalMark& mark : chart.marks) {
    for (const double number : numbers_of(mark)) {
      if (!std::isfinite(number)) {
        refuse(chart.title, "\"" + mark.label + "\" has an interval without an end");
      }
      if (log && !(number > 0)) {
        refuse(chart.title, "\"" + mark.label + "\" has a value not above 0 on a log axis");
      }
    }
  }
  for (const double end : {chart.above, chart.below}) {
    if (log && std::isfinite(end) && !(end > 0)) {
      refuse(chart.title, "the range demanded has an end not above 0 on a log axis");
    }
  }
}

Axis axis_of(const IntervalChart& chart) {
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  const auto show = [&](double number) {
    if (std::isfinite(number)) {
      low = std::min(low, number);
      high = std::max(high, number);
    }
  };
  for (const IntervalMark& mark : chart.marks) {
    for (const double number : numbers_of(mark)) {
      show(std::min(number, chart.most));
    }
  }
  show(chart.above);
  show(chart.below);
  if (!(low <= high)) {
    low = high = 1;
  }
  if (chart.scale == Scale::log) {
    return Axis({low / kLogRim, high * kLogRim, Scale::log, false, false, 6});
  }
  const double rim = low < high ? 0.05 * (high - low) : 0.1 * std::max(1.0, std::abs(high));
  return Axis({low - rim, high + rim, Scale::linear, false, false, 7});
}

/// A row of dots.
struct Row {
  std::string group;
  std::string label;
  std::vector<const IntervalMark*> marks;
  double middle = 0;
};

class IntervalDrawing {
 public:
  explicit IntervalDrawing(const IntervalChart& chart)
      : chart_(chart),
        axis_(axis_of(chart)),
        heading_(chart.title, ""),
        rows_(make_rows()),
        legend_(series_),
        plot_(make_plot()),
        svg_(kChartWidth, plot_.bottom() + (chart.x_label.empty() ? 34 : 56), chart.title) {}

  std::string draw() {
    heading_.draw(svg_);
    draw_range();
    draw_axis();
    legend_.draw(svg_, heading_.height(), 22, [this](std::size_t k, Spot corner) {
      draw_marker(svg_, k, {corner.x + 8, corner.y + 7});
    });
    for (std::size_t k = 0; k < rows_.size(); ++k) {
      if (begins_group(k)) {
        svg_.text({kChartMargin, rows_[k].middle - row_height() / 2 - 7}, rows_[k].group,
                  {.size = kNameSize, .bold = true});
      }
      draw_row(rows_[k]);
    }
    return svg_.document();
  }

 private:
  [[nodiscard]] double row_height() const {
    return kDotHeight * static_cast<double>(std::max<std::size_t>(1, series_.size())) + kRowGap;
  }

  /// The row at `k` has the heading of a group above it.
  [[nodiscard]] bool begins_group(std::size_t k) const {
    return !rows_[k].group.empty() && (k == 0 || rows_[k].group != rows_[k - 1].group);
  }

  /// Rows by group, then by label; `series_` on the way.
  [[nodiscard]] std::vector<Row> make_rows() {
    std::vector<std::string> groups;
    for (const IntervalMark& mark : chart_.marks) {
      (void)place_of(groups, mark.group);
      (void)place_of(series_, mark.series);
    }
    std::vector<Row> rows;
    for (const std::string& group : groups) {
      std::vector<std::string> labels;
      const std::size_t first = rows.size();
      for (const IntervalMark& mark : chart_.marks) {
        if (mark.group != group) {
          continue;
        }
        const std::size_t row = first + place_of(labels, mark.label);
        if (row == rows.size()) {
          rows.push_back({group, mark.label, {}});
        }
        rows[row].marks.push_back(&mark);
      }
    }
    return rows;
  }

  [[nodiscard]] Plot make_plot() {
    Plot plot;
    plot.top = heading_.height() + 8 + legend_.height();
    double labels = 0;
    double y = plot.top;
    for (std::size_t k = 0; k < rows_.size(); ++k) {
      y += begins_group(k) ? kGroupHeight : 0;
      rows_[k].middle = y + row_height() / 2;
      y += row_height();
      for (const std::string& line : wrapped(rows_[k].label, kNameSize, kMostRowNameWidth)) {
        labels = std::max(labels, text_width(line, kNameSize));
      }
    }
    plot.height = std::max(y - plot.top, 20.0);
    plot.left = kChartMargin + labels + 10;
    plot.width = kChartWidth - plot.left - kChartMargin - (series_.size() == 1 ? 62 : 8);
    return plot;
  }

  [[nodiscard]] double x_of(double value) const {
    return plot_.left + plot_.width * axis_.share(value);
  }

  /// An arrow stands for it at this edge: 1 the right one, -1 the left one, 0 none.
  [[nodiscard]] int beyond(double value) const {
    return value > chart_.most || value == std::numeric_limits<double>::infinity() ? 1
           : value == -std::numeric_limits<double>::infinity()                     ? -1
                                                                                   : 0;
  }

  void draw_range() {
    const bool from_below = std::isfinite(chart_.above);
    const bool to_above = std::isfinite(chart_.below);
    if (!from_below && !to_above) {
      return;
    }
    const double left = from_below ? x_of(chart_.above) : plot_.left;
    const double right = to_above ? x_of(chart_.below) : plot_.right();
    svg_.rect({left, plot_.top}, std::max(0.0, right - left), plot_.height,
              fmt::format("class=\"f2\" fill=\"{}\" fill-opacity=\".12\"", series_color(2)));
  }

  void draw_axis() {
    draw_ticks_below(svg_, plot_, axis_);
    for (const double end : {chart_.above, chart_.below}) {
      if (std::isfinite(end)) {
        svg_.line({x_of(end), plot_.top}, {x_of(end), plot_.bottom()}, kEnd);
      }
    }
    draw_label_below(svg_, plot_, chart_.x_label);
  }

  void draw_row(const Row& row) {
    const std::vector<std::string> lines = wrapped(row.label, kNameSize, kMostRowNameWidth);
    const double first = row.middle + 5 - 0.625 * kNameSize * static_cast<double>(lines.size() - 1);
    svg_.lines({plot_.left - 10, first}, lines, {.size = kNameSize, .anchor = Anchor::end});
    for (const IntervalMark* mark : row.marks) {
      const std::size_t series = place_of(series_, mark->series);
      const double offset =
          static_cast<double>(series) - static_cast<double>(series_.size() - 1) / 2;
      draw_mark(*mark, series, row.middle + kDotHeight * offset);
    }
  }

  void draw_mark(const IntervalMark& mark, std::size_t series, double y) {
    if (std::isnan(mark.value)) {
      return;
    }
    const int edge = beyond(mark.value);
    if (mark.interval && std::isfinite(mark.value)) {
      const std::size_t color = series % kSeriesColors;
      draw_whisker(svg_, {x_of(std::min(mark.interval->low, chart_.most)), y},
                   {x_of(std::min(mark.interval->high, chart_.most)), y},
                   fmt::format("class=\"s{}\" stroke=\"{}\" stroke-width=\"1.6\"", color,
                               series_color(color)));
    }
    if (edge != 0) {
      draw_arrow(mark.value, edge, series, y);
    } else {
      draw_marker(svg_, series, {x_of(mark.value), y});
    }
    if (series_.size() == 1 && edge == 0) {
      svg_.text({plot_.right() + 8, y + 4.5}, value_label(mark.value), {.size = kValueSize});
    }
  }

  /// Points out of the plot at its edge, with the number inside.
  void draw_arrow(double value, int edge, std::size_t series, double y) {
    const double tip = edge > 0 ? plot_.right() : plot_.left;
    const std::size_t color = series % kSeriesColors;
    PathData arrow;
    arrow.move({tip, y}).line({tip - 9 * edge, y - 5}).line({tip - 9 * edge, y + 5}).close();
    svg_.path(arrow.data(), fmt::format("class=\"f{}\" fill=\"{}\"", color, series_color(color)));
    svg_.text(
        {tip - 14 * edge, y + 4.5},
        std::isfinite(value) ? value_label(value) : (edge > 0 ? "\u221e" : "-\u221e"),
        {.size = kValueSize, .anchor = edge > 0 ? Anchor::end : Anchor::start, .haloed = true});
  }

  const IntervalChart& chart_;
  Axis axis_;
  Heading heading_;
  std::vector<std::string> series_;
  std::vector<Row> rows_;
  Legend legend_;
  Plot plot_;
  Svg svg_;
};

}  // namespace

std::string draw(const IntervalChart& chart) {
  check(chart);
  return IntervalDrawing(chart).draw();
}

}  // namespace soms::reproduce
