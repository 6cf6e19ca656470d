#include "soms/tree/build.h"

#include "soms/base/arithmetic.h"
#include "soms/base/error.h"
#include "soms/tree/build/detail/by_morton.h"
#include "soms/tree/build/detail/by_reference.h"
#include "soms/tree/build/detail/top_down.h"
#include "soms/tree/layout/wide_tree.h"

#include <utility>

namespace soms {

namespace {

using detail::Subtrees;
using detail::within;

Subtrees grow(const MeshView& mesh, const RuleEntry& rule, const BuildOptions& options,
              const Parallel& parallel) {
  if (rule.rule == Rule::quick) {
    return detail::grow_by_morton(mesh, options, parallel);
  }
  return rule.own_builder ? detail::grow_by_reference(mesh, options, parallel)
                          : detail::grow_top_down(mesh, rule, options, parallel);
}

Tree build_checked(const MeshView& mesh, const RuleEntry& rule, const BuildOptions& options,
                   const Parallel& parallel) {
  const PlainArithmetic plain;
  check_stop(parallel);
  if (mesh.triangles.empty()) {
    return {};
  }
  Subtrees subtrees = grow(mesh, rule, options, within(parallel, 0, 0.9));
  Tree tree = detail::join(std::move(subtrees), mesh, within(parallel, 0.9, 1));
  if (parallel.progress) {
    parallel.progress(1);
  }
  return tree;
}

}  // namespace

Tree build(const MeshView& mesh, const BuildOptions& options, const Parallel& parallel) {
  check(options);
  return build_checked(mesh, entry(options.rule), options, parallel);
}

Tree build_by(const MeshView& mesh, RuleFunction rule, BuildOptions options,
              const Parallel& parallel) {
  if (rule == nullptr) {
    throw Error(ErrorKind::usage, "build_by: no rule", "give a function");
  }
  options.rule = Rule::soms;  // which uses every option, as a rule of one's own does
  check(options);
  return build_checked(mesh, {.split = rule, .needs_outer = true, .needs_order = true}, options,
                       parallel);
}

WideTree build_wide(const MeshView& mesh, const BuildOptions& options, const Parallel& parallel) {
  const PlainArithmetic plain;
  check(options);
  check_stop(parallel);
  if (mesh.triangles.empty()) {
    return {};
  }
  Subtrees subtrees = grow(mesh, entry(options.rule), options, within(parallel, 0, 0.6));
  return {detail::parts_of(subtrees), mesh, within(parallel, 0.6, 1)};
}

}  // namespace soms
