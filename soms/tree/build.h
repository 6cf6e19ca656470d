/// \file
/// From a mesh to its tree.
#pragma once

#include "soms/base/limits.h"
#include "soms/geometry/mesh.h"
#include "soms/tree/build_options.h"
#include "soms/tree/rule/split.h"
#include "soms/tree/tree.h"

namespace soms {

class WideTree;

/// Builds the canonical tree of a mesh top down. A function of mesh and options alone: the same
/// bytes for any number of threads. An empty mesh gives an empty tree.
///
/// \pre     `check(mesh)` passes.
/// \errors  ErrorKind::usage for options out of range; cancelled; out_of_memory is std::bad_alloc.
/// \cost    O(n log n) for balanced splits, and about 125 bytes a triangle while it runs
///          with leaves of 8 (31 stay). No recursion.
///          With no level limit and EmptySide::object_median (the defaults) nodes are halved by
///          count where else a chain of one-sided splits would lead below depth 63: at most 63
///          passes, and every node has a TreeId. Other options follow the rule wherever it leads,
///          which may take O(n * depth) time.
/// \source  thesis, chapter 4; Ericson 2005, section 6.2.1.
[[nodiscard]] Tree build(const MeshView& mesh, const BuildOptions& options = {},
                         const Limits& limits = {});

/// The tree by a rule of your own: as `build`, with `rule` in place of that of `options.rule`,
/// which is not looked at. The axis that it is given is that of the inner box unless `axis_from`
/// says otherwise; it sees the outer box, and triangles in ascending order of their numbers. What
/// happens where it leaves a side empty is `empty_side`. Only the tree is made; shapes use named
/// rules.
///
/// \pre     `check(mesh)` passes. `rule` depends on its arguments alone, returns an axis below 3,
///          throws nothing, and may be called by several threads at once.
/// \errors  As `build`; ErrorKind::usage without a rule.
[[nodiscard]] Tree build_by(const MeshView& mesh, RuleFunction rule, BuildOptions options = {},
                            const Limits& limits = {});

/// The layout of the same tree, which is never put together: `WideTree(build(mesh, options), mesh)`
/// byte for byte, sooner and with less memory in between.
[[nodiscard]] WideTree build_wide(const MeshView& mesh, const BuildOptions& options = {},
                                  const Limits& limits = {});

}  // namespace soms
