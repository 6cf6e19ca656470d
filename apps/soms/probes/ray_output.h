/// \file
/// What rays hit, as text and JSON.
#pragma once

#include "soms/geometry/mesh.h"
#include "soms/query/ray.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace soms::command {

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

/// The keys of crossings in JSON, with a comma before.
[[nodiscard]] std::string crossings_keys(const Crossings& hits);

/// Titles of the table of answers for people, of which `noun` is what a row is called, "ray".
[[nodiscard]] std::string closest_hit_head(std::string_view noun);
[[nodiscard]] std::string any_hit_head(std::string_view noun);
[[nodiscard]] std::string crossings_head(std::string_view noun);

/// Rows of that table, with so many digits.
[[nodiscard]] std::string text_of(std::uint64_t ray, const ClosestHit& hit, const MeshView& mesh,
                                  int digits);
[[nodiscard]] std::string text_of(std::uint64_t ray, const AnyHit& hit);
[[nodiscard]] std::string text_of(std::uint64_t ray, const Crossings& hits, int digits);

}  // namespace soms::command
