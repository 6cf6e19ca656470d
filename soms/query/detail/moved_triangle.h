/// \file
/// A triangle where its body's pose has moved it.
#pragma once

#include "soms/query/body.h"

namespace soms::detail {

[[nodiscard]] inline Triangle moved_triangle(const Body& body, TriangleId id) {
  const Triangle t = body.shape.mesh().triangle(id);
  return {body.pose.apply(t.a), body.pose.apply(t.b), body.pose.apply(t.c)};
}

}  // namespace soms::detail
