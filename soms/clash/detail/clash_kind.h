/// \file
/// Kinds of clashes by relations.
#pragma once

#include "soms/clash/clash.h"
#include "soms/query/solid.h"

namespace soms::detail {

/// The kind of a clash of this relation; of `clear`, `near`.
[[nodiscard]] inline ClashKind kind_of(Relation relation) {
  switch (relation) {
    case Relation::crossing:
      return ClashKind::crossing;
    case Relation::a_in_b:
    case Relation::b_in_a:
      return ClashKind::inside;
    case Relation::same:
      return ClashKind::same;
    case Relation::touching:
      return ClashKind::touching;
    case Relation::clear:
      return ClashKind::near;
    case Relation::undecided:
      break;
  }
  return ClashKind::undecided;
}

}  // namespace soms::detail
