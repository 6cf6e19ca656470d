/// \file
/// The geometries of CityJSON objects: which one is read, and its surfaces as triangles.
#pragma once

#include "soms/io/detail/json_document.h"
#include "soms/io/detail/left_out.h"
#include "soms/io/detail/mesh_builder.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace soms::detail {

/// From the whole numbers of a file to coordinates.
struct CityTransform {
  std::array<double, 3> scale = {1, 1, 1};
  std::array<double, 3> translate = {0, 0, 0};
};

/// The `transform` of a document; none if it has none.
/// \errors ErrorKind::bad_file.
[[nodiscard]] CityTransform city_transform(const JsonValue& root);

/// What was left out of geometries.
struct CityLeftOut {
  LeftOut others;     ///< geometries of another level than the one that is read, or of the same
  LeftOut without;    ///< objects with geometries, but none of the level that is requested
  LeftOut not_areas;  ///< points and lines
  std::set<std::string> levels = {};  ///< all that occurred, as the file states them
};

/// Adds the geometries of one document to a mesh.
class CityGeometries {
 public:
  /// Adds the document's vertices to the mesh.
  /// \errors ErrorKind::bad_file, not_finite, out_of_range, out_of_memory.
  CityGeometries(Source& source, const JsonValue& root, const CityTransform& transform,
                 MeshBuilder& builder, CityLeftOut& left_out);

  /// Adds the surfaces of one geometry of an object, if it has any: of the level of detail that is
  /// requested, else of the most detailed one.
  /// \errors As `read_mesh`.
  void add(const JsonValue& object);

 private:
  struct Kind {
    std::string_view name;
    std::size_t depth = 0;  ///< lists around a surface, which is a list of rings
    int rank = 0;           ///< of equally detailed ones the greatest is read
  };

  [[nodiscard]] static const Kind* kind_of(const JsonValue& geometry);
  [[nodiscard]] JsonValue template_of(const JsonValue& instance) const;
  [[nodiscard]] std::optional<double> detail_of(const JsonValue& geometry) const;
  void add_geometry(const JsonValue& geometry);
  void add_instance(const JsonValue& instance);
  void add_boundaries(const JsonValue& geometry);
  void add_by_semantics(const JsonValue& boundaries, std::size_t depth, const JsonValue& semantics);
  void add_surfaces(const JsonValue& list, std::size_t depth);
  void add_surface(const JsonValue& rings);
  [[nodiscard]] std::uint32_t vertex_of(const JsonValue& index);
  void add_vertex(const Vec3& v, const JsonValue& place);

  Source& source_;
  JsonValue root_;
  MeshBuilder& builder_;
  CityLeftOut& left_out_;
  std::uint32_t first_ = 0;  ///< vertex of the mesh that is the document's vertex 0
  std::uint64_t count_ = 0;  ///< vertices of the document
  struct Instance;
  Instance* instance_ = nullptr;  ///< that is being added
  std::vector<std::uint32_t> corners_;
  std::vector<std::size_t> ends_;
  std::uint64_t surfaces_ = 0;
};

}  // namespace soms::detail
