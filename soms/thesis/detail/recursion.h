/// \file
/// How deep traversals by recursion may go.
#pragma once

#include "soms/thesis/pair_traversal.h"

namespace soms::detail {

/// Throws ErrorKind::usage for trees that are together too deep to be traversed by recursion: no
/// traversal nests more calls than the depths of both trees plus one.
void check_recursion(const PosedTree& a, const PosedTree& b);

}  // namespace soms::detail
