/// \file
/// The builder behind the rules of planes, from the root down.
#pragma once

#include "soms/tree/build/detail/subtrees.h"
#include "soms/tree/build_options.h"
#include "soms/tree/rule/rules.h"

namespace soms::detail {

/// Divides nodes by `rule`, the upper ones depth by depth, then each subtree by itself.
/// \pre `mesh` has triangles, and `check(options)` passes.
[[nodiscard]] Subtrees grow_top_down(const MeshView& mesh, const RuleEntry& rule,
                                     const BuildOptions& options, const Limits& limits);

}  // namespace soms::detail
