// In the place of soms/io/detail/gltf/gltf_features.cpp and gltf_metadata.cpp: features of glTF are
// the objects of cities, which come in files that the package does not read.
#include "soms/io/detail/gltf/gltf_features.h"

namespace soms::detail {

GltfMetadata::GltfMetadata(const JsonValue&, GltfBuffers& buffers) : buffers_(buffers) {
}

GltfFeatures::GltfFeatures(Source& source, const JsonValue& root, GltfBuffers& buffers,
                           GltfAccessors& accessors, const BatchTable* batches,
                           MeshBuilder& builder)
    : source_(source),
      accessors_(accessors),
      batches_(batches),
      builder_(builder),
      metadata_(root, buffers) {
}

bool GltfFeatures::has(const JsonValue&) const {
  return false;
}

void GltfFeatures::begin(const JsonValue&, std::uint64_t) {
}

void GltfFeatures::enter_feature(std::uint32_t, std::uint32_t, std::uint32_t) {
}

void GltfFeatures::end() {
}

void GltfFeatures::add_notes(std::vector<std::string>&) const {
}

}  // namespace soms::detail
