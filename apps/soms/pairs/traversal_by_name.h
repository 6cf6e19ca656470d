/// \file
/// Overlap by a traversal that `--tree traversal=NAME` names, for `overlap` and `simulate`. It is
/// defined in apps/soms/thesis; builds without the thesis' wing have apps/soms/no_thesis instead.
#pragma once

#include "soms/base/limits.h"
#include "soms/query/body.h"
#include "soms/query/overlap.h"
#include "soms/query/overlap_method.h"

#include <memory>
#include <span>
#include <string>
#include <vector>

namespace soms::command {

class Parser;

/// An answer, and what a named traversal counted for it.
struct CountedAnswer {
  Overlap answer;
  std::string count_keys = {};  ///< of a JSON object, each after a comma; empty: the default
  std::string count_line = {};  ///< the same as a line of text
};

/// The keys `traversal` and `descent` of --tree, and queries by the traversal that they name.
class TraversalByName {
 public:
  TraversalByName() = default;
  TraversalByName(const TraversalByName&) = delete;
  TraversalByName& operator=(const TraversalByName&) = delete;
  virtual ~TraversalByName() = default;

  /// True if another traversal than the default is named. Such ones need canonical trees.
  [[nodiscard]] virtual bool named() const = 0;

  /// The traversal with its options, as text. \pre `named`.
  [[nodiscard]] virtual std::string text() const = 0;

  /// \errors ErrorKind::usage for keys that do not go together.
  virtual void check(const Parser& parser) const = 0;

  /// \pre `named`. \errors As `thesis::overlap`.
  [[nodiscard]] virtual CountedAnswer overlap(const Body& a, const Body& b,
                                              const OverlapOptions& options,
                                              const Limits& limits) const = 0;
  [[nodiscard]] virtual std::vector<CountedAnswer> overlap(const Shape& mover,
                                                           std::span<const Pose> poses,
                                                           const Body& fixed,
                                                           const OverlapOptions& options,
                                                           const Limits& limits) const = 0;

  /// For StepOptions::method. \pre `named`.
  [[nodiscard]] virtual std::unique_ptr<OverlapMethod> method() const = 0;
};

/// Adds the keys to --tree, which `add_tree_list` has added.
[[nodiscard]] std::shared_ptr<const TraversalByName> add_traversal_by_name(Parser& parser);

}  // namespace soms::command
