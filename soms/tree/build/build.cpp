#include "soms/tree/build.h"

#include "soms/base/arithmetic.h"
#include "soms/base/error.h"
#include "soms/tree/build/detail/by_morton.h"
#include "soms/tree/build/detail/by_reference.h"
#include "soms/tree/build/detail/top_down.h"
#include "soms/tree/layout/detail/wide_tree.h"

#include <utility>

namespace soms {

namespace {

using detail::Subtrees;
using detail::within;

Subtrees grow(const MeshView& mesh, const RuleEntry& rule, const BuildOptions& options,
              const Limits& limits) {
  if (rule.rule == Rule::quick) {
    return detail::grow_by_morton(mesh, options, limits);
  }
  return rule.own_builder ? detail::grow_by_reference(mesh, options, limits)
                          : detail::grow_top_down(mesh, rule, options, limits);
}

Tree build_checked(const MeshView& mesh, const RuleEntry& rule, const BuildOptions& options,
                   const Limits& limits) {
  const PlainArithmetic plain;
  check(limits);
  if (mesh.triangles.empty()) {
    return {};
  }
  Subtrees subtrees = grow(mesh, rule, options, within(limits, 0, 0.9));
  Tree tree = detail::join(std::move(subtrees), mesh, within(limits, 0.9, 1));
  if (limits.progress) {
    limits.progress(1);
  }
  return tree;
}

}  // namespace

Tree build(const MeshView& mesh, const BuildOptions& options, const Limits& limits) {
  check(options);
  return build_checked(mesh, entry(options.rule), options, limits);
}

Tree build_by(const MeshView& mesh, RuleFunction rule, BuildOptions options, const Limits& limits) {
  if (rule == nullptr) {
    throw Error(ErrorKind::usage, "build_by: no rule", "give a function");
  }
  options.rule = Rule::soms;  // which uses every option, as a rule of one's own does
  check(options);
  return build_checked(mesh, {.split = rule, .needs_outer = true, .needs_order = true}, options,
                       limits);
}

WideTree build_wide(const MeshView& mesh, const BuildOptions& options, const Limits& limits) {
  const PlainArithmetic plain;
  check(options);
  check(limits);
  if (mesh.triangles.empty()) {
    return {};
  }
  Subtrees subtrees = grow(mesh, entry(options.rule), options, within(limits, 0, 0.6));
  return {detail::parts_of(subtrees), mesh, within(limits, 0.6, 1)};
}

}  // namespace soms
