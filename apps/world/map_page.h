/// \file
/// The page of a map as SVG: where places lie, the panel beside it, the scale bar.
#pragma once

#include "soms/base/box.h"

#include "apps/draw/look.h"

#include <ostream>
#include <string>
#include <string_view>
#include <vector>

namespace soms::command {

/// Ink and paper of maps.
inline constexpr auto kMapInkHex = look::hex_characters(look::kNearest.light);
inline constexpr const char* kMapInk = kMapInkHex.data();
inline constexpr const char* kMapPaper = "#f3efe6";

/// Where points of an area lie on the page, in pixels, north (+y) up.
struct MapPage {
  Box area;
  double unit = 0;   ///< meters a unit of length; 0: not known
  double scale = 1;  ///< pixels a unit of length
  double width = 0;  ///< of the map, without margin and panel
  double height = 0;
  double left = 0;  ///< margins
  double top = 0;

  [[nodiscard]] double x(double at) const { return left + (at - area.lower.x) * scale; }

  [[nodiscard]] double y(double at) const { return top + (area.upper.y - at) * scale; }

  [[nodiscard]] bool holds(const Vec3& at) const {
    return area.lower.x <= at.x && at.x <= area.upper.x && area.lower.y <= at.y &&
           at.y <= area.upper.y;
  }
};

/// The page for a scene's bounds, with a rim around them; `unit` is that of their numbers.
[[nodiscard]] MapPage make_map_page(const Box& bounds, double unit);

/// A line of text as SVG; `more` are attributes.
[[nodiscard]] std::string map_text(double x, double y, double size, std::string_view words,
                                   std::string_view more = {});

/// Starts the file: its frame and what clips to it. Everything until `close_map` is clipped.
/// Readers of the page without eyes hear the title, then the description.
void open_map(std::ostream& out, const MapPage& page, std::string_view title,
              std::string_view description);

/// Thin lines at round coordinates, upon what was drawn before.
void draw_grid(std::ostream& out, const MapPage& page);

/// Ends what is clipped; draws the coordinates of the grid around the map, and the scale bar and an
/// arrow to the north below it.
void close_map(std::ostream& out, const MapPage& page);

/// A round length not above `length`: 1, 2 or 5 times a power of ten.
[[nodiscard]] double round_length(double length);

/// Round coordinates between two, at least `step` apart, in order, each as text without more digits
/// than the step needs. \pre `step` is a `round_length`.
struct GridLine {
  double at = 0;
  std::string text;
};

[[nodiscard]] std::vector<GridLine> grid_lines(double lower, double upper, double step);

/// Writes the panel beside the map, line by line downwards.
class MapPanel {
 public:
  MapPanel(std::ostream& out, const MapPage& page);

  void title(std::string_view words);  ///< of the map, large
  void head(std::string_view words);   ///< of what follows, with space before
  void line(std::string_view words, double indent = 0);

  /// A line with a swatch, given as SVG around the origin.
  void keyed(std::string_view swatch, std::string_view words);

  /// A line with a square of a color.
  void keyed_color(std::string_view color, std::string_view words);

 private:
  std::ostream& out_;
  double left_;
  double y_;
};

}  // namespace soms::command
