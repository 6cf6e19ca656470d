/// \file
/// Names of parts and clashes that survive renumbering: by them a list is compared with an older
/// one.
///
/// \code
/// const soms::Mesh car = soms::generate_mover(soms::MoverKind::car);
/// const std::vector<soms::PartBody> parts = soms::part_bodies(car);
/// std::vector<soms::MeshPart> named;
/// for (const soms::PartBody& part : parts) {
///   named.push_back({car, &part});
/// }
/// const std::vector<std::uint64_t> keys = soms::part_keys(named);
/// std::cout << std::boolalpha << keys.size() << " keys; the same in either order: "
///           << (soms::clash_key(keys[0], keys[1]) == soms::clash_key(keys[1], keys[0])) << '\n';
/// \endcode
/// It prints:
/// \verbatim
/// 12 keys; the same in either order: true
/// \endverbatim
#pragma once

#include "soms/clash/part_bodies.h"
#include "soms/geometry/mesh.h"

#include <cstdint>
#include <span>
#include <vector>

namespace soms {

/// A part and the mesh that it is a part of.
struct MeshPart {
  MeshView mesh;
  const PartBody* part = nullptr;
};

/// A key for each part of a model, or of the models of several files. It is made of the part's id,
/// or of the path of names where the file gives no id. Where other parts have the same, the corners
/// of its triangles count, too, if the file has them. So keys stay where parts and triangles come
/// in another order, and where a part that is named alone moves or changes its shape. Parts that
/// are alike in all of this differ by their order.
/// \pre   `part` is set.
/// \cost  O(n log n) for n triangles.
[[nodiscard]] std::vector<std::uint64_t> part_keys(std::span<const MeshPart> parts);

/// A key for the clash of two parts, the same in either order.
[[nodiscard]] std::uint64_t clash_key(std::uint64_t a, std::uint64_t b);

}  // namespace soms
