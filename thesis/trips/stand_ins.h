/// \file
/// Generated bodies in the place of models that are not given.
#pragma once

#include "soms/geometry/mesh.h"

#include <cstdint>

namespace soms::reproduce {

/// A statue of 948 triangles with y up, as high as the bunny and where it stands.
[[nodiscard]] Mesh stand_in_bunny();

/// A statue of 1,416 triangles with y up, as high as Venus and where she stands: a closed surface
/// cannot have 1,417.
[[nodiscard]] Mesh stand_in_venus();

/// The teapot of 2,256 triangles, z up, as its file has it.
[[nodiscard]] Mesh stand_in_small_teapot();

/// The teapot of 6,320 triangles, y up and its spout toward -z, as its file has it.
[[nodiscard]] Mesh stand_in_teapot();

}  // namespace soms::reproduce
