/// \file
/// Nearest points of a model as text, JSON and CSV.
#pragma once

#include "soms/geometry/mesh.h"
#include "soms/geometry/parts_of.h"
#include "soms/query/closest.h"
#include "soms/query/contains.h"

#include "apps/model/georeference.h"
#include "apps/output/output.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace soms::command {

class Console;

/// A triangle in the list of a point.
struct ListedTriangle {
  TriangleId triangle = 0;
  Bracket distance;
};

/// The answer about a point: where the model is nearest, or which triangles are near.
struct PointAnswer {
  Closest closest;  ///< without a list: all of it; with one: coverage and cost alone
  std::optional<std::vector<ListedTriangle>> hits = std::nullopt;
  std::optional<Side> side = std::nullopt;

  /// Of the distance and the side together.
  [[nodiscard]] Coverage coverage() const {
    return side == Side::undecided ? Coverage::cut : closest.coverage;
  }

  [[nodiscard]] bool cut() const { return coverage() == Coverage::cut; }
};

/// The keys of an answer in JSON, with a comma before.
[[nodiscard]] std::string point_keys(const PointAnswer& answer);

/// An answer as a sentence about the only point. `at_most` is the limit of the question.
[[nodiscard]] std::string point_text(const PointAnswer& answer, const MeshView& mesh,
                                     double at_most);

/// Answers of many points as a table for people: the first twenty, and how many there are more.
class PointTable {
 public:
  void add(std::uint64_t point, const PointAnswer& answer, const MeshView& mesh, double at_most,
           Console& console);

  /// Says how many rows were left out.
  void finish(Console& console) const;

 private:
  std::uint64_t rows_ = 0;
};

/// Answers as a table for spreadsheets and scripts: one row a point, or one a triangle of a list.
class PointCsv {
 public:
  /// Opens the file, unless `path` is empty. \errors ErrorKind::cannot_write.
  explicit PointCsv(const std::string& path);

  /// Writes the names of the columns, the last ones for the sides and for what is known of where
  /// the points lie on the Earth. The mesh must stay.
  void begin(const MeshView& mesh, const Georeference& georeference, bool lists, bool sides);

  /// \errors ErrorKind::cannot_write; ClosedPipe.
  void add(std::uint64_t point, const PointAnswer& answer);

  /// Makes the file appear. \errors As `add`.
  void finish();

 private:
  std::optional<OutputFile> file_;
  MeshView mesh_;
  GeoreferenceColumn georeference_;
  PartsOf parts_;
};

}  // namespace soms::command
