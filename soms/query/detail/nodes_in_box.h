/// \file
/// The part of a body that a box in the world may meet, as nodes of its tree.
#pragma once

#include "soms/base/box.h"
#include "soms/query/answer.h"
#include "soms/query/body.h"

#include <cstdint>
#include <vector>

namespace soms::detail {

/// Ids of nodes and leaves, in place of what `ids` held: each triangle that, moved, has a point in
/// the box is below one of them. The box goes down the tree by itself, as a body at the identity
/// whose vertices are the corners of the box: each point of it is where it was moved to
/// (single_box_descent.h). Where that does not pay, the root stands for all.
/// \pre The pose passed its checks, and the ends of the box are within kMaxCoordinate.
void find_nodes(const Box& box, const Body& body, std::vector<std::uint32_t>& ids, Cost& cost);

}  // namespace soms::detail
