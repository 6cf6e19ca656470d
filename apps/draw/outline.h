/// \file
/// Outlines of sets of grid cells, as few straight lines as the eye allows.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace soms::command {

/// A corner of the grid: cell (c, r) has the corners (c, r) and (c + 1, r + 1).
struct GridPoint {
  std::int32_t x = 0;
  std::int32_t y = 0;

  [[nodiscard]] bool operator==(const GridPoint&) const = default;
};

using Loop = std::vector<GridPoint>;

/// Closed loops around the cells whose flag is set (row by row), the cells on their left; to be
/// filled by the even-odd rule. The last point is not the first again.
/// \pre `inside` has `columns * rows` flags.
[[nodiscard]] std::vector<Loop> outline(const std::vector<std::uint8_t>& inside,
                                        std::size_t columns, std::size_t rows);

/// The points of a line that keep it within `tolerance` of all its points; the ends stay.
/// \source Ramer 1972; Douglas and Peucker 1973.
[[nodiscard]] Loop simplified_line(const Loop& line, double tolerance);

/// The same for a loop.
[[nodiscard]] Loop simplified_loop(const Loop& loop, double tolerance);

/// Twice the area that a loop surrounds, negative for a hole.
[[nodiscard]] std::int64_t double_area(const Loop& loop);

/// Writes SVG path data of many lines, closed on request: "M3 4h2v5l-1-1zm7 0h1v1z".
class PathWriter {
 public:
  void add(const Loop& line, bool closed);

  [[nodiscard]] const std::string& path() const { return path_; }

 private:
  void move_to(const GridPoint& to);
  void line_to(const GridPoint& to);
  void number(std::int32_t value);

  std::string path_;
  GridPoint at_;         ///< where the last command left off
  char command_ = '\0';  ///< the last one written
  bool blank_ = false;   ///< a number came last
};

}  // namespace soms::command
