/// \file
/// Stand-ins for the urban scene of the thesis, which is not available: exactly 5,672 triangles
/// each.
#pragma once

#include "soms/base/words.h"
#include "soms/geometry/mesh.h"

namespace soms {

/// The three stand-in scenes.
enum class UrbanScene {
  mixed,  ///< terrain, roads of 4 km, buildings of three kinds, signs: very unlike triangles
  boxes,  ///< four quarters, each one ground quad and 118 boxes
  plain,  ///< 472 boxes and four pads, no large triangle
};

template <>
inline constexpr auto kWords<UrbanScene> = words("UrbanScene", "What a generated scene is made of.",
                                                 "mixed", "boxes", "plain");

/// A stand-in scene, bit for bit the same everywhere: z up, meters, integer or half-integer
/// coordinates.
/// \source  thesis, chapter 3 (an urban scene of 5,672 triangles, 4 km by 4 km).
[[nodiscard]] Mesh generate_urban(UrbanScene scene);

}  // namespace soms
