#include "apps/draw/axis.h"
#include "apps/draw/chart.h"
#include "apps/draw/chart_parts.h"
#include "apps/draw/svg.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace soms::reproduce {

namespace {

constexpr double kThickest = 64;
constexpr double kLyingBar = 19;
constexpr double kMostBarNameWidth = 210;

void check(const BarChart& chart) {
  for (const Bars& bars : chart.bars) {
    const auto fits = [&](const std::vector<double>& values) {
      return values.empty() || values.size() == chart.groups.size();
    };
    if (bars.values.size() != chart.groups.size() || !fits(bars.low) || !fits(bars.high) ||
        bars.low.size() != bars.high.size()) {
      refuse(chart.title, "bars \"" + bars.name + "\" and groups differ in number");
    }
    for (const auto* values : {&bars.values, &bars.low, &bars.high}) {
      for (const double value : *values) {
        if (chart.y_scale == Scale::log && std::isfinite(value) && !(value > 0)) {
          refuse(chart.title, "bars \"" + bars.name + "\" have a value not above 0 on a log axis");
        }
      }
    }
  }
}

Axis axis_of(const BarChart& chart) {
  const bool log = chart.y_scale == Scale::log;
  double low = log ? std::numeric_limits<double>::infinity() : 0;
  double high = 0;
  for (const Bars& bars : chart.bars) {
    for (const auto* values : {&bars.values, &bars.low, &bars.high}) {
      for (const double value : *values) {
        if (std::isfinite(value)) {
          low = std::min(low, value);
          high = std::max(high, value);
        }
      }
    }
  }
  if (log && !(low <= high)) {
    low = 1;
    high = 10;
  }
  // The shortest bar of a log axis must still be seen.
  return Axis(
      {log ? low * 0.8 : low, !log && low == high ? 1 : high, chart.y_scale, true, false, 6});
}

std::vector<std::string> names_of(const BarChart& chart) {
  std::vector<std::string> names;
  for (const Bars& bars : chart.bars) {
    names.push_back(bars.name);
  }
  return names;
}

/// Bars stand where all names fit below them and all values above, else they lie.
class BarDrawing {
 public:
  explicit BarDrawing(const BarChart& chart)
      : chart_(chart),
        axis_(axis_of(chart)),
        lying_(!fits_standing()),
        heading_(chart.title, ""),
        legend_(names_of(chart)),
        plot_(make_plot()),
        svg_(kChartWidth, page_height(), chart.title) {}

  std::string draw() {
    heading_.draw(svg_);
    legend_.draw(svg_, heading_.height(), 26,
                 [this](std::size_t k, Spot corner) { fill_bar(k, corner, 20, 13); });
    draw_axis();
    for (std::size_t group = 0; group < chart_.groups.size(); ++group) {
      draw_name(group);
      for (std::size_t series = 0; series < chart_.bars.size(); ++series) {
        draw_bar(group, series);
      }
    }
    const double base = value_at(chart_.y_scale == Scale::log ? axis_.low() : 0);
    svg_.line(lying_ ? Spot{base, plot_.top} : Spot{plot_.left, base},
              lying_ ? Spot{base, plot_.bottom()} : Spot{plot_.right(), base}, kAxisLine);
    return svg_.document();
  }

 private:
  [[nodiscard]] double groups() const {
    return std::max(1.0, static_cast<double>(chart_.groups.size()));
  }

  [[nodiscard]] double series() const {
    return std::max(1.0, static_cast<double>(chart_.bars.size()));
  }

  [[nodiscard]] bool fits_standing() const {
    const double slot = (kChartWidth - 90) / groups();
    const double thickness = std::min((slot - 12) / series(), kThickest);
    for (const Bars& bars : chart_.bars) {
      for (const double value : bars.values) {
        if (std::isfinite(value) && text_width(value_label(value), kValueSize) > thickness) {
          return false;
        }
      }
    }
    return std::all_of(chart_.groups.begin(), chart_.groups.end(), [&](const std::string& name) {
      const std::vector<std::string> lines = wrapped(name, kNameSize, slot - 6);
      return lines.size() <= 3 && std::all_of(lines.begin(), lines.end(), [&](const auto& line) {
               return text_width(line, kNameSize) <= slot - 6;
             });
    });
  }

  [[nodiscard]] std::vector<std::string> name_lines(std::size_t group) const {
    return wrapped(chart_.groups[group], kNameSize,
                   lying_ ? kMostBarNameWidth : plot_.width / groups() - 6);
  }

  [[nodiscard]] Plot make_plot() const {
    Plot plot;
    plot.top = heading_.height() + legend_.height() +
               (lying_                   ? 8
                : chart_.y_label.empty() ? 20
                                         : 42);
    double labels = 0;
    if (lying_) {
      for (const std::string& name : chart_.groups) {
        for (const std::string& line : wrapped(name, kNameSize, kMostBarNameWidth)) {
          labels = std::max(labels, text_width(line, kNameSize));
        }
      }
      plot.height = groups() * (series() * kLyingBar + 16);
    } else {
      for (const Tick& tick : axis_.ticks()) {
        labels = std::max(labels, text_width(tick.label, kNameSize));
      }
      plot.height = kPlotHeight;
    }
    plot.left = kChartMargin + labels + 8;
    plot.width = kChartWidth - plot.left - kChartMargin - (lying_ ? 66 : 8);
    return plot;
  }

  [[nodiscard]] double page_height() const {
    if (lying_) {
      return plot_.bottom() + (chart_.y_label.empty() ? 34 : 56);
    }
    std::size_t lines = 1;
    for (std::size_t group = 0; group < chart_.groups.size(); ++group) {
      lines = std::max(lines, name_lines(group).size());
    }
    return plot_.bottom() + 16 + 1.25 * kNameSize * static_cast<double>(lines);
  }

  /// Pixel of a value along the bars.
  [[nodiscard]] double value_at(double value) const {
    const double share = axis_.share(value);
    return lying_ ? plot_.left + plot_.width * share : plot_.bottom() - plot_.height * share;
  }

  /// Width of a group's share of the plot, across the bars.
  [[nodiscard]] double slot() const { return (lying_ ? plot_.height : plot_.width) / groups(); }

  [[nodiscard]] double thickness() const {
    return std::min((slot() - 12) / series(), lying_ ? kLyingBar : kThickest);
  }

  /// Middle of a bar across its length.
  [[nodiscard]] double across(std::size_t group, std::size_t series_index) const {
    const double begin = (lying_ ? plot_.top : plot_.left) + slot() * static_cast<double>(group);
    const double rim = (slot() - thickness() * series()) / 2;
    return begin + rim + thickness() * (static_cast<double>(series_index) + 0.5);
  }

  [[nodiscard]] Spot at(double across_bar, double along_bar) const {
    return lying_ ? Spot{along_bar, across_bar} : Spot{across_bar, along_bar};
  }

  void draw_axis() {
    if (lying_) {
      draw_ticks_below(svg_, plot_, axis_);
      draw_label_below(svg_, plot_, chart_.y_label);
      return;
    }
    svg_.text({kChartMargin, plot_.top - 24}, chart_.y_label, {.size = kLabelSize, .faint = true});
    for (const Tick& tick : axis_.ticks()) {
      const double y = value_at(tick.value);
      svg_.line({plot_.left, y}, {plot_.right(), y}, kGridLine);
      svg_.text({plot_.left - 8, y + 5}, tick.label,
                {.size = kNameSize, .anchor = Anchor::end, .faint = true});
    }
  }

  void draw_name(std::size_t group) {
    const std::vector<std::string> lines = name_lines(group);
    if (lying_) {
      const double middle = plot_.top + slot() * (static_cast<double>(group) + 0.5);
      const double first = middle + 5 - 0.625 * kNameSize * static_cast<double>(lines.size() - 1);
      svg_.lines({plot_.left - 8, first}, lines, {.size = kNameSize, .anchor = Anchor::end});
    } else {
      svg_.lines({plot_.left + slot() * (static_cast<double>(group) + 0.5), plot_.bottom() + 20},
                 lines, {.size = kNameSize, .anchor = Anchor::middle});
    }
  }

  /// A box of a series: its color, and a texture that tells it apart without.
  void fill_bar(std::size_t series_index, Spot corner, double width, double height) {
    const std::size_t own = chart_.bars[series_index].color;
    const std::size_t color = (own == kNextColor ? series_index : own) % kSeriesColors;
    const std::size_t texture = series_index % 4;
    const std::string stroke =
        fmt::format("class=\"s{}\" stroke=\"{}\"", color, series_color(color));
    svg_.rect(corner, width, height,
              fmt::format("class=\"f{0} s{0}\" fill=\"{1}\" stroke=\"{1}\" stroke-width=\"1\"{2}",
                          color, series_color(color), texture < 2 ? "" : " fill-opacity=\".35\""));
    if (texture % 2 == 1) {
      std::string d;
      const bool rows = !lying_ && height > width;
      for (int i = 0; 5 + 6 * i < (rows ? height : width); ++i) {
        const double k = 5 + 6 * i;
        d += rows ? fmt::format("M{}h{}", pixels({corner.x, corner.y + height - k}), pixels(width))
                  : fmt::format("M{}v{}", pixels({corner.x + k, corner.y}), pixels(height));
      }
      if (!d.empty()) {
        svg_.path(d, texture == 1 ? "class=\"halo\" stroke=\"#fff\" stroke-width=\"1.5\""
                                  : stroke + " stroke-width=\"1.5\"");
      }
    }
  }

  void draw_bar(std::size_t group, std::size_t series_index) {
    const Bars& bars = chart_.bars[series_index];
    const double value = bars.values[group];
    const double middle = across(group, series_index);
    if (!std::isfinite(value)) {
      return;
    }
    const bool log = chart_.y_scale == Scale::log;
    const double from = value_at(log ? axis_.low() : 0);
    const double to = value_at(value);
    const double half = thickness() / 2 - 1;
    const Spot corner = at(middle - half, std::min(from, to));
    const double length = std::abs(to - from);
    fill_bar(series_index, corner, lying_ ? length : 2 * half, lying_ ? 2 * half : length);
    double tip = to;
    if (!bars.low.empty() && std::isfinite(bars.low[group]) && std::isfinite(bars.high[group])) {
      draw_whisker(svg_, at(middle, value_at(bars.low[group])),
                   at(middle, value_at(bars.high[group])),
                   "class=\"axis\" stroke=\"#333\" stroke-width=\"1.4\"");
      tip = value_at(value < 0 ? bars.low[group] : bars.high[group]);
    }
    const std::string words = value_label(value);
    if (lying_) {
      svg_.text({std::max(tip, from) + 6, middle + 4.5}, words, {.size = kValueSize});
    } else {
      svg_.text({middle, value < 0 ? tip + 15 : tip - 5}, words,
                {.size = kValueSize, .anchor = Anchor::middle, .haloed = true});
    }
  }

  const BarChart& chart_;
  Axis axis_;
  bool lying_;
  Heading heading_;
  Legend legend_;
  Plot plot_;
  Svg svg_;
};

}  // namespace

std::string draw(const BarChart& chart) {
  check(chart);
  return BarDrawing(chart).draw();
}

}  // namespace soms::reproduce
