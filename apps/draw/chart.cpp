#include "apps/draw/chart.h"

#include "apps/draw/axis.h"
#include "apps/draw/chart_parts.h"
#include "apps/draw/svg.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace soms::reproduce {

namespace {

constexpr double kTickSize = 14;
constexpr double kSwatch = 26;
constexpr double kNameWidth = 170;
constexpr std::size_t kMostMarkers = 40;

/// Least and greatest of numbers; whether all are whole.
struct Range {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();
  bool whole = true;

  void take(double value) {
    if (std::isfinite(value)) {
      low = std::min(low, value);
      high = std::max(high, value);
      whole = whole && value == std::floor(value);
    }
  }

  void take(std::span<const double> values) {
    for (const double value : values) {
      take(value);
    }
  }

  [[nodiscard]] bool empty() const { return !(low <= high); }
};

void check(const LineChart& chart) {
  const auto positive = [](std::span<const double> values) {
    return std::all_of(values.begin(), values.end(),
                       [](double value) { return !std::isfinite(value) || value > 0; });
  };
  for (const Line& line : chart.lines) {
    const std::size_t n = line.x.size();
    const auto fits = [&](std::size_t size) { return size == 0 || size == n; };
    if (line.y.size() != n || !fits(line.low.size()) || !fits(line.high.size()) ||
        line.low.size() != line.high.size()) {
      refuse(chart.title, "lists of line \"" + line.name + "\" differ in length");
    }
    if (!std::all_of(line.x.begin(), line.x.end(), [](double x) { return std::isfinite(x); })) {
      refuse(chart.title, "line \"" + line.name + "\" has an x that is not finite");
    }
    if ((chart.x_scale == Scale::log && !positive(line.x)) ||
        (chart.y_scale == Scale::log &&
         !(positive(line.y) && positive(line.low) && positive(line.high)))) {
      refuse(chart.title, "line \"" + line.name + "\" has a value not above 0 on a log axis");
    }
  }
  for (const Callout& callout : chart.callouts) {
    if ((chart.x_scale == Scale::log && !(callout.x > 0)) ||
        (chart.y_scale == Scale::log && !(callout.y > 0))) {
      refuse(chart.title, "a callout lies at a value not above 0 on a log axis");
    }
  }
}

/// Axis over a range; of one without numbers, from 1 to 10.
Axis axis_over(const Range& range, Scale scale, bool rounded, int most_ticks) {
  const bool none = range.empty();
  return Axis({none ? 1 : range.low, none ? 10 : range.high, scale, rounded,
               !rounded && range.whole, most_ticks});
}

/// Draws one line chart, part by part.
class LineDrawing {
 public:
  explicit LineDrawing(const LineChart& chart)
      : chart_(chart),
        heading_(chart.title, chart.y_label),
        x_(axis_over(x_range(), chart.x_scale, false, x_range().whole ? 15 : 8)),
        y_(axis_over(y_range(), chart.y_scale, true, 6)),
        plot_(make_plot()),
        svg_(kChartWidth, plot_.bottom() + (chart.x_label.empty() ? 34 : 56), chart.title),
        clearings_(plot_) {}

  std::string draw() {
    heading_.draw(svg_);
    draw_grid();
    for (std::size_t k = 0; k < chart_.lines.size(); ++k) {
      draw_spread(k);
    }
    for (std::size_t k = 0; k < chart_.lines.size(); ++k) {
      draw_line(k);
    }
    draw_names();
    for (const Callout& callout : chart_.callouts) {
      draw_callout(svg_, clearings_, spot(callout.x, callout.y), callout.text);
    }
    return svg_.document();
  }

 private:
  [[nodiscard]] Range x_range() const {
    Range range;
    for (const Line& line : chart_.lines) {
      range.take(line.x);
    }
    return range;
  }

  [[nodiscard]] Range y_range() const {
    Range range;
    for (const Line& line : chart_.lines) {
      range.take(line.y);
      range.take(line.low);
      range.take(line.high);
    }
    return range;
  }

  [[nodiscard]] bool named() const {
    return std::any_of(chart_.lines.begin(), chart_.lines.end(),
                       [](const Line& line) { return !line.name.empty(); });
  }

  [[nodiscard]] static std::vector<std::string> name_of(const Line& line) {
    return wrapped(line.name, kTickSize, kNameWidth);
  }

  [[nodiscard]] static double height_of(const Line& line) {
    return 1.25 * kTickSize * static_cast<double>(name_of(line).size()) + 5;
  }

  [[nodiscard]] Plot make_plot() const {
    double left = 0;
    for (const Tick& tick : y_.ticks()) {
      left = std::max(left, text_width(tick.label, kTickSize));
    }
    double right = 0;
    double names = 0;
    for (const Line& line : chart_.lines) {
      for (const std::string& word : name_of(line)) {
        right = std::max(right, text_width(word, kTickSize));
      }
      names += height_of(line);
    }
    Plot plot{kChartMargin + left + 8, heading_.height(), 0, std::max(kPlotHeight, names)};
    plot.width = kChartWidth - plot.left - kChartMargin - (named() ? right + kSwatch + 24 : 8);
    return plot;
  }

  [[nodiscard]] Spot spot(double x, double y) const {
    return {plot_.left + plot_.width * x_.share(x), plot_.bottom() - plot_.height * y_.share(y)};
  }

  void draw_grid() {
    for (const Tick& tick : y_.ticks()) {
      const double y = spot(x_.low(), tick.value).y;
      svg_.line({plot_.left, y}, {plot_.right(), y}, kGridLine);
      svg_.text({plot_.left - 8, y + 5}, tick.label,
                {.size = kTickSize, .anchor = Anchor::end, .faint = true});
    }
    double clear_from = 0;
    for (const Tick& tick : x_.ticks()) {
      const double x = spot(tick.value, y_.low()).x;
      svg_.line({x, plot_.bottom()}, {x, plot_.bottom() + 5}, kAxisLine);
      const double half = text_width(tick.label, kTickSize) / 2;
      if (x - half < clear_from) {
        continue;
      }
      clear_from = x + half + 6;
      svg_.text({x, plot_.bottom() + 21}, tick.label,
                {.size = kTickSize, .anchor = Anchor::middle, .faint = true});
    }
    svg_.line({plot_.left, plot_.bottom()}, {plot_.right(), plot_.bottom()}, kAxisLine);
    if (!chart_.x_label.empty()) {
      svg_.text({plot_.left + plot_.width / 2, plot_.bottom() + 44}, chart_.x_label,
                {.size = kLabelSize, .anchor = Anchor::middle, .faint = true});
    }
    if (y_range().empty()) {
      svg_.text({plot_.left + plot_.width / 2, plot_.top + plot_.height / 2}, "no data",
                {.size = kLabelSize, .anchor = Anchor::middle, .faint = true});
    }
  }

  /// Calls `use(begin, end)` for each run of points whose `values` are finite.
  template <typename Use>
  static void for_runs(const std::vector<double>& values, const Use& use) {
    for (std::size_t begin = 0; begin < values.size();) {
      std::size_t end = begin;
      while (end < values.size() && std::isfinite(values[end])) {
        ++end;
      }
      if (end > begin) {
        use(begin, end);
      }
      begin = end + 1;
    }
  }

  void draw_spread(std::size_t series) {
    const Line& line = chart_.lines[series];
    std::vector<double> both;
    for (std::size_t k = 0; k < line.low.size(); ++k) {
      both.push_back(line.low[k] + line.high[k]);
    }
    const std::size_t color = color_of(series);
    for_runs(both, [&](std::size_t begin, std::size_t end) {
      if (end - begin == 1) {
        draw_whisker(svg_, spot(line.x[begin], line.low[begin]),
                     spot(line.x[begin], line.high[begin]), stroke(color, 1.6));
        return;
      }
      PathData band;
      for (std::size_t k = begin; k < end; ++k) {
        band.next(spot(line.x[k], line.high[k]));
      }
      for (std::size_t k = end; k-- > begin;) {
        band.line(spot(line.x[k], line.low[k]));
      }
      svg_.path(band.close().data(), fmt::format("class=\"f{}\" fill=\"{}\" fill-opacity=\".18\"",
                                                 color, series_color(color)));
    });
  }

  [[nodiscard]] static std::string stroke(std::size_t color, double width) {
    return fmt::format("class=\"s{}\" stroke=\"{}\" stroke-width=\"{}\" stroke-linejoin=\"round\"",
                       color % kSeriesColors, series_color(color), pixels(width));
  }

  [[nodiscard]] std::size_t color_of(std::size_t series) const {
    const std::size_t own = chart_.lines[series].color;
    return (own == kNextColor ? series : own) % kSeriesColors;
  }

  [[nodiscard]] std::string stroke_of(const Line& line, std::size_t series) const {
    return stroke(color_of(series), 2.4) + (line.dashed ? " stroke-dasharray=\"7 5\"" : "");
  }

  /// Points between markers; 0 for no markers. Lines with many points still get a few, so that
  /// color is not all that tells them apart.
  [[nodiscard]] std::size_t marker_stride(const Line& line) const {
    if (chart_.markers && line.x.size() <= kMostMarkers) {
      return 1;
    }
    return chart_.lines.size() == 1 && !chart_.markers ? 0 : line.x.size() / 7 + 1;
  }

  void draw_line(std::size_t series) {
    const Line& line = chart_.lines[series];
    const std::size_t stride = marker_stride(line);
    std::vector<Spot> markers;
    for_runs(line.y, [&](std::size_t begin, std::size_t end) {
      PathData path;
      for (std::size_t k = begin; k < end; ++k) {
        const Spot at = spot(line.x[k], line.y[k]);
        path.next(at);
        clearings_.cover(k == begin ? at : spot(line.x[k - 1], line.y[k - 1]), at);
        const bool alone = end - begin == 1;
        if (alone || (stride > 0 && (k + series) % stride == 0)) {
          markers.push_back(at);
        }
      }
      svg_.path(path.data(), fmt::format("fill=\"none\" {}", stroke_of(line, series)));
    });
    for (const Spot at : markers) {
      draw_marker(svg_, color_of(series), at);
    }
  }

  /// Each line's name beside its end.
  void draw_names() {
    if (!named()) {
      return;
    }
    std::vector<double> wishes;
    std::vector<double> heights;
    std::vector<Spot> ends;
    for (const Line& line : chart_.lines) {
      Spot end{plot_.left, plot_.bottom()};
      for_runs(line.y, [&](std::size_t, std::size_t past) {
        end = spot(line.x[past - 1], line.y[past - 1]);
      });
      ends.push_back(end);
      wishes.push_back(end.y);
      heights.push_back(height_of(line));
    }
    const std::vector<double> tops = spread(wishes, heights, plot_.top - 8, plot_.bottom() + 8);
    for (std::size_t k = 0; k < chart_.lines.size(); ++k) {
      const Line& line = chart_.lines[k];
      const double left = plot_.right() + 16;
      const double middle = tops[k] + heights[k] / 2;
      if (ends[k].x > plot_.right() - 2) {
        svg_.line({ends[k].x + 5, ends[k].y}, {left, middle},
                  stroke(color_of(k), 1) + " stroke-opacity=\".6\"");
      }
      svg_.line({left, middle}, {left + kSwatch, middle}, stroke_of(line, k));
      if (marker_stride(line) > 0) {
        draw_marker(svg_, color_of(k), {left + kSwatch / 2, middle});
      }
      svg_.lines({left + kSwatch + 6, tops[k] + 1.25 * kTickSize - 1}, name_of(line),
                 {.size = kTickSize});
    }
  }

  const LineChart& chart_;
  Heading heading_;
  Axis x_;
  Axis y_;
  Plot plot_;
  Svg svg_;
  Clearings clearings_;
};

}  // namespace

std::string draw(const LineChart& chart) {
  check(chart);
  return LineDrawing(chart).draw();
}

}  // namespace soms::reproduce
