/// \file
/// Points of a CSV file, row by row.
#pragma once

#include "soms/base/vector.h"

#include "apps/rows/row_source.h"

#include <optional>
#include <string>
#include <string_view>

namespace soms::command {

/// Points of a file whose header is x, y and z, in any order.
class PointSource : public RowSource {
 public:
  using Row = Vec3;
  static constexpr std::string_view kNoun = "point";

  /// \errors As `RowSource`.
  PointSource(const std::string& path, const Console& console);

  /// The next point, or nothing at the end.
  /// \errors As `RowReader::next`; ErrorKind::bad_file for a file without rows; out_of_range
  ///         beyond 2^300; timed_out.
  [[nodiscard]] std::optional<Vec3> next();
};

}  // namespace soms::command
