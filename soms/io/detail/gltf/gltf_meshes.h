/// \file
/// Meshes of glTF before they are placed: what their primitives draw on.
#pragma once

#include "soms/io/detail/gltf/gltf_accessor.h"
#include "soms/io/detail/left_out.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <unordered_map>
#include <vector>

namespace soms::detail {

/// How corners become triangles, by the numbers that glTF gives the ways.
enum class GltfMode : std::uint8_t { triangles = 4, strip = 5, fan = 6 };

/// Triangles of a mesh.
struct GltfPrimitive {
  JsonValue json;
  std::size_t positions = 0;              ///< number of the accessor in its mesh
  const GltfAccessor* indices = nullptr;  ///< none: corners are the positions in order
  GltfMode mode = GltfMode::triangles;
  std::uint64_t triangles = 0;
};

/// A mesh: positions that its primitives share are there once.
struct GltfMesh {
  std::vector<const GltfAccessor*> positions;
  std::vector<GltfPrimitive> primitives;
  std::uint64_t vertices = 0;
  std::uint64_t triangles = 0;
};

/// Meshes of a document, each understood when it is first needed.
class GltfMeshes {
 public:
  GltfMeshes(Source& source, GltfAccessors& accessors) : source_(source), accessors_(accessors) {}

  /// The mesh that a number of the document names; valid as long as this.
  /// \errors ErrorKind::bad_file, unsupported, and those of GltfAccessors.
  [[nodiscard]] const GltfMesh& mesh(const JsonValue& reference);

  /// Meshes that were requested.
  [[nodiscard]] std::size_t count() const { return loaded_.size(); }

  /// True if this mesh of the document was requested.
  [[nodiscard]] bool has(std::uint64_t number) const { return loaded_.count(number) > 0; }

  /// What was passed over in them.
  void add_notes(std::vector<std::string>& notes) const;

 private:
  void add_primitive(GltfMesh& mesh, const JsonValue& json);

  Source& source_;
  GltfAccessors& accessors_;
  std::unordered_map<std::uint64_t, GltfMesh> loaded_;
  std::unordered_map<const GltfAccessor*, std::size_t> numbers_;  ///< of one mesh's positions
  LeftOut points_and_lines_;
  LeftOut without_positions_;
  LeftOut morphed_;
};

}  // namespace soms::detail
