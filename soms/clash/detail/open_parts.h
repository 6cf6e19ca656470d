/// \file
/// What can be decided of two parts of which one or both are open.
#pragma once

#include "soms/base/vector.h"
#include "soms/clash/part_bodies.h"
#include "soms/query/overlap.h"

#include <functional>
#include <span>
#include <utility>

namespace soms::detail {

/// Calls its argument for triangles of one body, all that may matter, until it is false.
using TriangleLoop = std::function<bool(const std::function<bool(const Triangle&)>&)>;

/// True if an edge of `s`, which has area, goes through the plane of `t` strictly inside it, so
/// that the two surfaces go on to both sides of each other, and both triangles bound something
/// there for sure: in the point in which the edge goes through `t`, no other triangle of the body
/// of `t` lies, and beside the edge, none of the body of `s` covers `s`. Two triangles in one
/// place, or two faces that are glued together, bound nothing. `beside_s` has all triangles of the
/// body of `s`, but `s`, that overlap `t`, and `beside_t` those of the other body, but `t`, that
/// overlap `s`; more do no harm. Exact without others; with them it may be false where it is true:
/// of signs that double precision does not tell.
[[nodiscard]] bool edge_crosses(const Triangle& s, const Triangle& t, const TriangleLoop& beside_s,
                                const TriangleLoop& beside_t);

/// True if for one of the pairs of triangles that overlap, in one order or the other,
/// `edge_crosses`: all pairs of two bodies, sorted, and where poses move their triangles.
[[nodiscard]] bool surfaces_cross(std::span<const TrianglePair> pairs,
                                  std::span<const std::pair<Triangle, Triangle>> triangles);

/// Whether a whole component of `inner` may be inside `outer`: it lies in its box.
[[nodiscard]] bool fits_into(const PartBody& inner, const PartBody& outer);

/// What a part stands for that leads (PartBody::leads): its open group as one body, or itself.
[[nodiscard]] inline const PartBody& body_led_by(const PartBody& part) {
  return part.together.body ? *part.together.body : part;
}

/// True if both parts lead bodies, and at least one of these is an open group that the other is not
/// of: the two bodies are compared, too, not only the two parts.
[[nodiscard]] bool lead_bodies(const PartBody& a, const PartBody& b);

}  // namespace soms::detail
