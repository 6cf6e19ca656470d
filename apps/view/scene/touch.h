/// \file
/// Who is who in a shown scene, and what touches what.
#pragma once

#include "soms/geometry/mesh.h"

#include <compare>
#include <cstdint>

namespace soms::view {

/// What a body is in a scene.
enum class Role : std::uint8_t {
  city,   ///< a part of the environment, which stands still
  mover,  ///< a body that moves
};

/// A body of a scene by its role and its number in that role. Stable: bodies are only added.
struct BodyRef {
  Role role = Role::city;
  std::uint32_t index = 0;

  [[nodiscard]] auto operator<=>(const BodyRef&) const = default;
};

/// Part `index` of the city.
[[nodiscard]] constexpr BodyRef city_part(std::uint32_t index) {
  return {Role::city, index};
}

/// Mover `index`.
[[nodiscard]] constexpr BodyRef mover(std::uint32_t index) {
  return {Role::mover, index};
}

/// Triangle `i` of body `a`, a mover, touches triangle `j` of body `b`, a part of the city or a
/// mover of greater number.
struct Touch {
  BodyRef a;
  BodyRef b;
  TriangleId i = 0;
  TriangleId j = 0;

  [[nodiscard]] auto operator<=>(const Touch&) const = default;
};

/// Two that touch: parts of bodies, or bodies where Part::kNoParent stands for a part.
struct PartPair {
  BodyRef a;
  BodyRef b;
  std::uint32_t part_a = Part::kNoParent;
  std::uint32_t part_b = Part::kNoParent;

  [[nodiscard]] auto operator<=>(const PartPair&) const = default;
};

}  // namespace soms::view
