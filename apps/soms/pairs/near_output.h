/// \file
/// How near two surfaces are, as text, JSON and CSV: what `distance` and `within` print alike.
#pragma once

#include "soms/base/vector.h"
#include "soms/geometry/parts_of.h"
#include "soms/query/answer.h"

#include "apps/model/georeference.h"
#include "apps/output/output.h"
#include "apps/soms/answers/answer_fields.h"
#include "apps/soms/pairs/pair_report.h"
#include "apps/world/part_names.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace soms::command {

class Console;

/// The triangles that an answer names, and the points on them that are near.
struct NearPair {
  std::optional<TrianglePair> triangles;
  Vec3 point_a;
  Vec3 point_b;
};

/// ": triangle 3 (wall) of a.ply at (0, 0, 1) and triangle 5 of b.ply at (0, 0, 2)"; nothing where
/// no pair is named.
[[nodiscard]] std::string near_text(const PairReport& report, const NearPair& pair);

/// Answers of many poses as a table for people: the first twenty, and how many there are more.
class NearTable {
 public:
  /// Prints a row; `value` stands under `title`.
  void add(const PairReport& report, std::uint64_t pose, std::string_view title,
           std::string_view value, const NearPair& pair, Console& console);

  /// Says how many rows were left out.
  void finish(Console& console) const;

 private:
  std::uint64_t rows_ = 0;
};

/// Answers as a table for spreadsheets and scripts, one row a pose.
class NearCsv {
 public:
  /// Opens the file, unless `path` is empty. \errors ErrorKind::cannot_write.
  explicit NearCsv(const std::string& path);

  /// Writes the names of the columns of answers T. The meshes of `report` must stay.
  template <Described T>
  void begin(const PairReport& report) {
    begin(report, field_head<T>());
  }

  /// \errors ErrorKind::cannot_write; ClosedPipe.
  template <Described T>
  void add(std::uint64_t pose, const T& answer) {
    if (file_) {
      put(pose, field_cells(answer, [this](int side, std::optional<TriangleId> triangle) {
            return side == 0 ? triangle_csv_fields(report_->a, parts_a_, triangle)
                             : triangle_csv_fields(report_->b, parts_b_, triangle);
          }));
    }
  }

  /// Makes the file appear. \errors As `add`.
  void finish();

 private:
  void begin(const PairReport& report, std::string_view head);
  void put(std::uint64_t pose, std::string_view cells);

  std::optional<OutputFile> file_;
  const PairReport* report_ = nullptr;
  GeoreferenceColumn georeference_;
  PartsOf parts_a_;
  PartsOf parts_b_;
};

}  // namespace soms::command
