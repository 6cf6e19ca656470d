/// \file
/// What can be decided of two parts of which one or both are open.
#pragma once

#include "soms/base/vector.h"
#include "soms/clash/part_bodies.h"

namespace soms::detail {

/// True if an edge of one triangle goes through the plane of the other strictly inside it, and the
/// triangle of the edge has area: the two surfaces go on to both sides of each other. Where
/// triangles share no more than corners, points of edges or area in one plane, it is false.
/// Symmetric. Exact.
[[nodiscard]] bool pass_through(const Triangle& s, const Triangle& t);

/// Whether a whole component of `inner` may be inside `outer`, whose surface is open and does not
/// meet that of `inner`: it lies in the box of `outer`, beyond which an open surface is taken to
/// enclose nothing.
[[nodiscard]] bool may_be_inside(const PartBody& inner, const PartBody& outer);

}  // namespace soms::detail
