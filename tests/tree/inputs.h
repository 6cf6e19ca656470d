/// \file
/// Meshes of any size whose trees are awkward in one way each.
#pragma once

#include "tests/support/support.h"

#include <array>
#include <cstdint>
#include <string>

namespace soms::test {

/// Ways in which the triangles of a mesh lie.
enum class Input {
  random,         ///< small triangles in a cube
  coincident,     ///< copies of one triangle
  coplanar,       ///< on a grid in the plane z = 0, with equal coordinates
  sliver,         ///< long, thin and slanted
  huge_and_tiny,  ///< sizes from 2^-300 to 2^290
  nested,         ///< each around the next, all with the same center
  halving,        ///< at 2^-k: a plane splits off one at each level
  points,         ///< triangles without area, each a single point
};

inline constexpr std::array<Input, 8> kInputs{Input::random,  Input::coincident,    Input::coplanar,
                                              Input::sliver,  Input::huge_and_tiny, Input::nested,
                                              Input::halving, Input::points};

[[nodiscard]] std::string name(Input input);

/// A mesh of `count` triangles; a function of its arguments.
[[nodiscard]] Mesh make_input(Input input, std::size_t count, std::uint64_t seed = 1);

}  // namespace soms::test
