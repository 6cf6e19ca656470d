// In the place of the other builders of trees and of their rules: the package builds by `fast`
// alone.
#include "soms/base/error.h"
#include "soms/tree/build/detail/by_morton.h"
#include "soms/tree/build/detail/top_down.h"

namespace soms {

namespace detail {

namespace {

[[noreturn]] void refuse_rule() {
  throw Error(ErrorKind::unsupported, "trees by this rule are not in the package",
              "build by the rule fast");
}

}  // namespace

Subtrees grow_top_down(const MeshView&, const RuleEntry&, const BuildOptions&, const Limits&) {
  refuse_rule();
}

Subtrees grow_by_morton(const MeshView&, const BuildOptions&, const Limits&) {
  refuse_rule();
}

}  // namespace detail

// The table of rules names them; no builder calls them.
namespace rule {

Split object_median(const SplitNode&, std::size_t) {
  return {};
}

Split object_mean(const SplitNode&, std::size_t) {
  return {};
}

Split spatial_median(const SplitNode&, std::size_t) {
  return {};
}

Split soms(const SplitNode&, std::size_t) {
  return {};
}

Split sah(const SplitNode&, std::size_t) {
  return {};
}

Split soms_sah(const SplitNode&, std::size_t) {
  return {};
}

}  // namespace rule
}  // namespace soms
