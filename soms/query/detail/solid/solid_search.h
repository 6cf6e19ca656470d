/// \file
/// The relation of two closed bodies at one pose each: first what is quick to find.
#pragma once

#include "soms/base/limits.h"
#include "soms/query/answer.h"
#include "soms/query/solid.h"

#include <optional>

namespace soms::detail {

/// What `overlap` with mode `any` says of two bodies.
struct FirstContact {
  std::optional<TrianglePair> pair = std::nullopt;
  bool cut = false;  ///< a deadline ended it
  Cost cost = {};
};

/// One query of two bodies, neither of them empty.
/// \errors ErrorKind::cancelled.
[[nodiscard]] Solid solid_relation(const ClosedBody& a, const ClosedBody& b,
                                   const FirstContact& contact, const Limits& limits);

}  // namespace soms::detail
