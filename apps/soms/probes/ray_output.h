/// \file
/// What rays hit, as text, JSON and CSV.
#pragma once

#include "soms/geometry/mesh.h"
#include "soms/geometry/parts_of.h"
#include "soms/query/ray.h"

#include "apps/model/georeference.h"
#include "apps/output/output.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace soms::command {

class Console;

/// A place where a ray meets the model.
struct Crossing {
  Bracket t;
  CrossingKind kind = CrossingKind::graze;
  std::vector<TriangleId> triangles = {};

  [[nodiscard]] bool operator==(const Crossing&) const = default;
};

/// All places where a ray meets the model.
struct Crossings {
  std::vector<Crossing> places = {};
  Coverage coverage = Coverage::complete;
  Cost cost = {};

  /// Of triangles that are hit.
  [[nodiscard]] std::size_t count() const;
};

/// Those of one ray of a batch.
[[nodiscard]] Crossings crossings_of(const AllHits& hits, std::size_t ray);

/// The answer about a ray, whatever was requested of it.
using RayAnswer = std::variant<ClosestHit, AnyHit, Crossings>;

/// True if something is hit, for all that is known.
[[nodiscard]] bool is_hit(const RayAnswer& answer);
[[nodiscard]] bool is_cut(const RayAnswer& answer);

/// The keys of an answer in JSON, with a comma before.
[[nodiscard]] std::string ray_keys(const RayAnswer& answer);

/// Answers as a table for people: the first twenty.
class RayTable {
 public:
  /// Prints a row; `noun` is what it is called, "ray".
  void add(std::string_view noun, const RayAnswer& answer, const MeshView& mesh, Console& console);

 private:
  std::uint64_t rows_ = 0;
};

/// Answers as a table for spreadsheets and scripts: one row a ray, or one a triangle that is hit
/// where all are requested.
class RayCsv {
 public:
  /// Opens the file, unless `path` is empty. \errors ErrorKind::cannot_write.
  explicit RayCsv(const std::string& path);

  /// Writes the names of the columns of answers like this one; with points, one for what is known
  /// of where they lie on the Earth. The mesh must stay.
  void begin(const MeshView& mesh, const Georeference& georeference, const RayAnswer& like);

  /// \errors ErrorKind::cannot_write; ClosedPipe.
  void add(std::uint64_t ray, const RayAnswer& answer);

  /// Makes the file appear. \errors As `add`.
  void finish();

 private:
  [[nodiscard]] std::string rows_of(std::uint64_t ray, const RayAnswer& answer) const;

  std::optional<OutputFile> file_;
  MeshView mesh_;
  GeoreferenceColumn georeference_;
  PartsOf parts_;
};

}  // namespace soms::command
