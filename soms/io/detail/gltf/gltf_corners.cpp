#include "soms/io/detail/gltf/gltf_corners.h"

#include "soms/geometry/detail/counts.h"

#include <limits>
#include <string>

namespace soms::detail {

GltfCorners::GltfCorners(const GltfPrimitive& primitive, std::uint64_t count, std::uint32_t first)
    : primitive_(primitive), count_(count), first_(first) {
  if (primitive.indices != nullptr) {
    cursor_.emplace(*primitive.indices);
    // An index of all ones restarts strips elsewhere; glTF forbids it.
    const std::size_t bits = 8 * size_of(primitive.indices->elements.type);
    restart_ = primitive.mode == GltfMode::triangles ? std::numeric_limits<std::uint64_t>::max()
                                                     : (std::uint64_t{1} << bits) - 1;
  }
}

void GltfCorners::fail(std::uint64_t number, std::uint32_t index) const {
  const std::string place = "index " + std::to_string(number) + " is " + std::to_string(index);
  primitive_.json.at("indices").fail(
      index >= count_ ? index_fault(place, "positions", count_)
                      : place + ", which glTF does not allow in strips and fans");
}

}  // namespace soms::detail
