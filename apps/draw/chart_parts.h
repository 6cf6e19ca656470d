/// \file
/// What line charts and bar charts draw alike: title, labels beside lines, callouts, whiskers.
#pragma once

#include "apps/draw/axis.h"
#include "apps/draw/chart.h"
#include "apps/draw/svg.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace soms::reproduce {

inline constexpr double kChartWidth = 720;
inline constexpr double kChartMargin = 14;
inline constexpr double kTitleSize = 18;
inline constexpr double kLabelSize = 14.5;
inline constexpr double kNameSize = 14;
inline constexpr double kValueSize = 13;
inline constexpr double kPlotHeight = 320;
inline constexpr double kLegendRow = 24;
inline constexpr std::string_view kGridLine =
    "class=\"grid\" stroke=\"#e3e3e0\" stroke-width=\"1\"";
inline constexpr std::string_view kAxisLine =
    "class=\"axis\" stroke=\"#6b6f74\" stroke-width=\"1.2\"";

/// The part of the page where data are drawn.
struct Plot {
  double left = 0;
  double top = 0;
  double width = 0;
  double height = 0;

  [[nodiscard]] double right() const { return left + width; }

  [[nodiscard]] double bottom() const { return top + height; }
};

/// The title, then what the vertical axis means; where the plot may begin.
struct Heading {
  std::vector<std::string> title;
  std::string label;

  Heading(std::string_view title_words, std::string_view label_words);
  [[nodiscard]] double height() const;
  void draw(Svg& svg) const;
};

/// Tops of boxes of these heights, near the wished centers, in the order given by the wishes, apart
/// from each other and, as far as they fit, between `top` and `bottom`.
[[nodiscard]] std::vector<double> spread(const std::vector<double>& wishes,
                                         const std::vector<double>& heights, double top,
                                         double bottom);

/// Shape that tells series `series` from others without its color, around `at`.
void draw_marker(Svg& svg, std::size_t series, Spot at);

/// A whisker between two ends, with feet across it.
void draw_whisker(Svg& svg, Spot from, Spot to, std::string_view attributes);

/// Places for words on a plot: knows what is covered already.
class Clearings {
 public:
  explicit Clearings(const Plot& plot);

  void cover(Spot from, Spot to);
  void cover(Spot corner, double width, double height);

  /// Corner of the clearest place for a box of this size, as near to `at` as may be.
  [[nodiscard]] Spot find(Spot at, double width, double height) const;

 private:
  [[nodiscard]] int covered(Spot corner, double width, double height) const;

  Plot plot_;
  int columns_;
  int rows_;
  std::vector<std::uint8_t> cells_;
};

/// Writes a callout where it covers least, with an arrow to `at`.
void draw_callout(Svg& svg, Clearings& clearings, Spot at, std::string_view words);

/// Says what is wrong with a chart's data. \errors ErrorKind::usage, always.
[[noreturn]] void refuse(const std::string& chart, const std::string& what);

/// The index of `name` in `names`, where it is put at the end if it is not there.
[[nodiscard]] std::size_t place_of(std::vector<std::string>& names, const std::string& name);

/// The names of series below a heading, in as many rows as they need; none where there is nothing
/// to tell apart.
class Legend {
 public:
  explicit Legend(std::vector<std::string> names);

  [[nodiscard]] double height() const;

  /// `swatch(k, corner)` draws what stands for series k; its name follows `indent` to the right.
  template <typename Swatch>
  void draw(Svg& svg, double top, double indent, const Swatch& swatch) const {
    for (std::size_t k = 0; k < corners_.size(); ++k) {
      const Spot corner{corners_[k].x, top + corners_[k].y};
      swatch(k, corner);
      svg.text({corner.x + indent, corner.y + 12}, names_[k], {.size = kNameSize});
    }
  }

 private:
  std::vector<std::string> names_;
  std::vector<Spot> corners_;  ///< of those that are drawn, below the top
};

/// The axis below a plot: its lines with their numbers, and what they count.
void draw_ticks_below(Svg& svg, const Plot& plot, const Axis& axis);
void draw_label_below(Svg& svg, const Plot& plot, std::string_view label);

}  // namespace soms::reproduce
