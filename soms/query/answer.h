/// \file
/// What every answer carries: how much of the question it covers, and what it cost.
#pragma once

#include "soms/base/words.h"
#include "soms/describe/fields.h"
#include "soms/geometry/mesh.h"

#include <compare>
#include <cstdint>
#include <tuple>
#include <vector>

namespace soms {

/// A triangle of each of two bodies. Pairs are ordered by `a`, then by `b`.
struct TrianglePair {
  TriangleId a = 0;  ///< of the first body
  TriangleId b = 0;  ///< of the second

  [[nodiscard]] auto operator<=>(const TrianglePair&) const = default;
};

template <>
struct Fields<TrianglePair> {
  static constexpr const char* kName = "TrianglePair";
  static constexpr const char* kMeaning = "A triangle of each of two bodies.";
  static constexpr auto kList = std::tuple(field("a", &TrianglePair::a, "Of the first body."),
                                           field("b", &TrianglePair::b, "Of the second."));
};

/// How much of the question an answer covers.
enum class Coverage {
  complete,  ///< everything was decided
  first,     ///< stopped at the first hit, as requested
  cut,       ///< a limit or a deadline ended it; there may be more
};

template <>
inline constexpr auto kWords<Coverage> =
    words("Coverage",
          "How much of the question an answer covers: everything, up to the first hit as "
          "requested, or what a limit or a deadline left.",
          "complete", "first", "cut");

/// Work done: deterministic counts for a given tree, layout and traversal, the same on every
/// machine and, for complete answers, for any number of threads.
struct Cost {
  std::uint64_t node_tests = 0;      ///< boxes, or pairs of boxes, tested
  std::uint64_t triangle_tests = 0;  ///< triangles, or pairs of them, tested
  std::uint64_t exact_tests = 0;     ///< of these, those that needed exact arithmetic

  [[nodiscard]] bool operator==(const Cost&) const = default;

  Cost& operator+=(const Cost& other) {
    node_tests += other.node_tests;
    triangle_tests += other.triangle_tests;
    exact_tests += other.exact_tests;
    return *this;
  }
};

template <>
struct Fields<Cost> {
  static constexpr const char* kName = "Cost";
  static constexpr const char* kMeaning = "Work done, the same on every machine.";
  static constexpr auto kList = std::tuple(
      field("node_tests", &Cost::node_tests, "Boxes, or pairs of boxes, tested."),
      field("triangle_tests", &Cost::triangle_tests, "Triangles, or pairs of them, tested."),
      field("exact_tests", &Cost::exact_tests, "Of these, those that needed exact arithmetic."));
};

/// The field `coverage` of an answer, and the column of a batch.
template <class T, class Column>
[[nodiscard]] constexpr auto coverage_field(Coverage T::*place, Column column) {
  return field("coverage", place, column, "How much of the question is decided.");
}

/// The field `cost` of an answer, and the column `costs` of a batch.
template <class T, class Batch>
[[nodiscard]] constexpr auto cost_field(Cost T::*place, std::vector<Cost> Batch::*column) {
  return field("cost", place, column, "costs", "Work done.");
}

}  // namespace soms
