/// \file
/// Features of glTF meshes, by the numbers at their vertices: batch ids of 3D Tiles 1.0, feature
/// ids of EXT_mesh_features.
#pragma once

#include "soms/io/detail/gltf/gltf_accessor.h"
#include "soms/io/detail/gltf/gltf_metadata.h"
#include "soms/io/detail/mesh_builder.h"
#include "soms/io/detail/tiles/batch_table.h"

#include <cstdint>
#include <limits>
#include <string>
#include <unordered_map>
#include <vector>

namespace soms::detail {

/// No feature.
inline constexpr std::uint32_t kNoFeature = std::numeric_limits<std::uint32_t>::max();

/// The features of a primitive's positions.
struct GltfFeatureIds {
  const GltfPropertyTable* table = nullptr;  ///< null: batches of the tile
  std::vector<std::uint32_t> of;             ///< of each position; kNoFeature where it has none
};

/// Makes features parts, while a mesh is built in the order of the file.
class GltfFeatures {
 public:
  /// `batches`: of the tile around the document; null where there is none.
  GltfFeatures(Source& source, const JsonValue& root, GltfBuffers& buffers,
               GltfAccessors& accessors, const BatchTable* batches, MeshBuilder& builder);

  /// True if `begin` would find features.
  [[nodiscard]] bool has(const JsonValue& primitive) const;

  /// Triangles from here on are of this primitive, which has so many positions.
  /// \errors ErrorKind::bad_file: ids beyond the table, fewer or more than positions.
  void begin(const JsonValue& primitive, std::uint64_t positions);

  /// The next triangle has these positions. \errors ErrorKind::bad_file, out_of_memory.
  void enter(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    if (active_) {
      enter_feature(a, b, c);
    }
  }

  /// The primitive ends.
  void end();

  /// Adds what of the features is not read.
  void add_notes(std::vector<std::string>& notes) const;

 private:
  /// Where a primitive says which feature its positions are of.
  struct Place {
    JsonValue accessor;
    std::optional<JsonValue> table;   ///< none: batches
    std::uint64_t none = kNoFeature;  ///< the number of no feature
  };

  [[nodiscard]] std::optional<Place> batch_place(const JsonValue& primitive) const;
  [[nodiscard]] std::optional<Place> feature_place(const JsonValue& primitive) const;
  [[nodiscard]] std::optional<Place> place_of(const JsonValue& primitive) const;
  void read(const Place& place, std::uint64_t positions);
  void count_unread(const JsonValue& primitive);
  void enter_feature(std::uint32_t a, std::uint32_t b, std::uint32_t c);
  void open(std::uint32_t feature);

  Source& source_;
  GltfAccessors& accessors_;
  const BatchTable* batches_;
  MeshBuilder& builder_;
  GltfMetadata metadata_;
  bool active_ = false;
  GltfFeatureIds ids_;
  std::uint32_t opened_ = kNoFeature;
  /// The first run of each feature, by table.
  std::unordered_map<const GltfPropertyTable*, std::unordered_map<std::uint32_t, std::uint32_t>>
      first_runs_;
  std::optional<JsonValue> primitive_;
  LeftOut mixed_;
  LeftOut without_ids_;
  LeftOut unread_sets_;
};

}  // namespace soms::detail
