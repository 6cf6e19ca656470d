/// \file
/// The georeference of an answer's coordinates, for each form of output. It is recorded, never
/// applied: coordinates stay those of the file.
#pragma once

#include "soms/geometry/mesh.h"

#include "apps/output/json.h"

#include <span>
#include <string>
#include <string_view>

namespace soms::command {

/// That of the first mesh that has one: the coordinates of an answer are those of its models, and a
/// warning says where these differ.
[[nodiscard]] Georeference georeference_of(std::span<const MeshView> meshes);

/// `{"crs":"EPSG:25833","vertical_datum":null,"map_conversion":{"eastings":...}}`; null where
/// nothing is stated.
[[nodiscard]] Json georeference_json(const Georeference& georeference);

/// Adds the member "georeference" where one is stated.
void add_georeference(Json& json, const Georeference& georeference);

/// A last column of a CSV file, where a georeference is stated.
class GeoreferenceColumn {
 public:
  /// Without a column.
  GeoreferenceColumn() = default;

  explicit GeoreferenceColumn(const Georeference& georeference);

  /// ",georeference", or nothing.
  [[nodiscard]] std::string_view head() const { return head_; }

  /// The field of each row with its comma, or nothing.
  [[nodiscard]] std::string_view field() const { return field_; }

 private:
  std::string_view head_;
  std::string field_;
};

}  // namespace soms::command
