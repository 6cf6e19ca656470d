/// \file
/// Charts as SVG: lines over numbers, bars over names. Colors that the color-blind tell apart, one
/// fixed look, the same bytes for the same data.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace soms::reproduce {

/// How an axis is divided.
enum class Scale { linear, log };

/// Colors by number, of look::kSeries: by default a line has that of its place.
inline constexpr std::size_t kNextColor = static_cast<std::size_t>(-1);
inline constexpr std::size_t kMovesColor = 0;  ///< blue, as what moves is in every picture
inline constexpr std::size_t kStillColor = 7;  ///< dark sand: sand itself is too pale for a line

/// A line of a chart: points (x[i], y[i]) in ascending x. A y that is not finite breaks the line.
struct Line {
  std::string name;
  std::vector<double> x = {};
  std::vector<double> y = {};
  std::vector<double> low = {};   ///< spread below, as values; empty for none
  std::vector<double> high = {};  ///< spread above
  bool dashed = false;
  std::size_t color = kNextColor;
};

/// A sentence at a point, with a short arrow: what the reader should see.
struct Callout {
  double x = 0;
  double y = 0;
  std::string text;
};

/// Lines over a numeric axis.
struct LineChart {
  std::string title = {};
  std::string x_label = {};
  std::string y_label = {};
  Scale x_scale = Scale::linear;
  Scale y_scale = Scale::linear;
  std::vector<Line> lines = {};
  std::vector<Callout> callouts = {};
  bool markers = true;  ///< a dot at each point
};

/// Bars of one color, one for each group.
struct Bars {
  std::string name;
  std::vector<double> values = {};  ///< as many as the chart's groups; not finite: no bar
  std::vector<double> low = {};
  std::vector<double> high = {};
  std::size_t color = kNextColor;
};

/// Bars side by side in groups.
struct BarChart {
  std::string title = {};
  std::string y_label = {};
  Scale y_scale = Scale::linear;
  std::vector<std::string> groups = {};
  std::vector<Bars> bars = {};
};

/// \errors ErrorKind::usage if lists differ in length or a log axis meets a value not above 0.
[[nodiscard]] std::string draw(const LineChart& chart);
[[nodiscard]] std::string draw(const BarChart& chart);

}  // namespace soms::reproduce
