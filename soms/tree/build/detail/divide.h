/// \file
/// One step of a build: a node's primitives, divided or left together.
#pragma once

#include "soms/tree/build_options.h"
#include "soms/tree/rule/rules.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace soms::detail {

/// What became of a node.
struct Division {
  bool divided = false;          ///< it has two children
  bool undividable = false;      ///< the rule left one side empty
  std::uint32_t left_count = 0;  ///< primitives of the left child
  Box left_inner;                ///< bounds of the midpoints of each side
  Box right_inner;
};

/// Turns a mesh into primitives, and divides nodes as the options say.
class Divider {
 public:
  /// `options.rule` is not looked at.
  Divider(const MeshView& mesh, const RuleEntry& rule, const BuildOptions& options);

  /// Writes primitives `begin` to `end`, and what the rule needs to know of them besides.
  /// Returns the bounds of their midpoints. Chunks may run at once.
  Box prepare(std::size_t begin, std::size_t end, std::span<Primitive> primitives);

  /// Brings the left child's primitives to the front; in ascending order of numbers on both sides
  /// if the rule needs it. `inner` bounds the midpoints of `run`.
  [[nodiscard]] Division divide(std::span<Primitive> run, const Box& inner,
                                std::uint32_t depth) const;

 private:
  [[nodiscard]] bool is_leaf(std::size_t count, std::uint32_t depth) const;
  [[nodiscard]] bool too_deep(std::size_t count, std::uint32_t depth) const;
  [[nodiscard]] std::array<std::size_t, 3> axes(const SplitNode& node) const;
  [[nodiscard]] Division partition(std::span<Primitive> run, const Split& split) const;

  MeshView mesh_;
  BuildOptions options_;
  RuleEntry rule_;
  AxisFrom axis_from_;
  std::uint32_t last_depth_;  ///< nodes of this depth are never divided
  double unit_ = 1;
  std::vector<Box> bounds_;  ///< of each triangle, where outer boxes are needed, else empty
};

}  // namespace soms::detail
