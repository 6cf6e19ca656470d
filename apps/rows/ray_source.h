/// \file
/// Rays and segments of a CSV file, row by row.
#pragma once

#include "soms/query/ray.h"

#include "apps/rows/row_source.h"

#include <optional>
#include <string>
#include <string_view>

namespace soms::command {

/// Rays of a file whose header is ox, oy, oz, dx, dy, dz and perhaps length, in any order.
class RaySource : public RowSource {
 public:
  using Row = Ray;
  static constexpr std::string_view kNoun = "ray";

  /// \errors As `RowSource`.
  RaySource(const std::string& path, const Console& console);

  /// The next ray, or nothing at the end.
  /// \errors As `RowReader::next`; ErrorKind::bad_file for a file without rows, a direction of zero
  ///         and a negative length; out_of_range for an origin beyond 2^300; timed_out.
  [[nodiscard]] std::optional<Ray> next();
};

/// Segments of a file whose header is x0, y0, z0, x1, y1 and z1, in any order.
class SegmentSource : public RowSource {
 public:
  using Row = Ray;
  static constexpr std::string_view kNoun = "segment";

  /// \errors As `RowSource`.
  SegmentSource(const std::string& path, const Console& console);

  /// The next segment, or nothing at the end.
  /// \errors As `RowReader::next`; ErrorKind::bad_file for a file without rows; out_of_range
  ///         beyond 2^300; timed_out.
  [[nodiscard]] std::optional<Ray> next();
};

}  // namespace soms::command
