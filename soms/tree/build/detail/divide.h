/// \file
/// One step of a build: a node's primitives, divided or left together.
#pragma once

#include "soms/tree/build_options.h"
#include "soms/tree/rule/rules.h"

#include <array>
#include <cstdint>
#include <span>

namespace soms::detail {

/// What became of a node.
struct Division {
  bool divided = false;          ///< it has two children
  bool undividable = false;      ///< the rule left one side empty
  std::uint32_t left_count = 0;  ///< primitives of the left child
};

/// Divides nodes as the options say.
class Divider {
 public:
  explicit Divider(const BuildOptions& options);

  [[nodiscard]] Primitive primitive(const Mesh& mesh, TriangleId i) const;

  /// Brings the left child's primitives to the front, both sides in ascending order of numbers.
  /// `scratch` is as long as `run`.
  [[nodiscard]] Division divide(std::span<Primitive> run, std::span<Primitive> scratch,
                                std::uint32_t depth) const;

 private:
  [[nodiscard]] bool is_leaf(std::size_t count, std::uint32_t depth) const;
  [[nodiscard]] bool too_deep(std::size_t count, std::uint32_t depth) const;
  [[nodiscard]] std::array<std::size_t, 3> axes(const SplitNode& node) const;

  BuildOptions options_;
  RuleFunction rule_;
  AxisFrom axis_from_;
  std::uint32_t last_depth_;  ///< nodes of this depth are never divided
};

}  // namespace soms::detail
