#include "soms/tree/option_names.h"

#include "soms/base/error.h"

#include <algorithm>
#include <array>
#include <string>

namespace soms {

namespace {

// Each table is in the order of its enumerators.
constexpr std::array<std::string_view, 3> kMidpoints{"thesis", "centroid", "aabb"};
constexpr std::array<std::string_view, 2> kAxes{"outer", "inner"};
constexpr std::array<std::string_view, 4> kEmptySides{"stop", "next_axis", "object_median",
                                                      "chain"};

template <class Enum, std::size_t n>
Enum find(const std::array<std::string_view, n>& table, std::string_view what,
          std::string_view name) {
  std::string snake(name);
  std::replace(snake.begin(), snake.end(), '-', '_');
  const auto at = std::find(table.begin(), table.end(), snake);
  if (at == table.end()) {
    std::string names;
    for (const std::string_view entry : table) {
      names += (names.empty() ? "" : ", ") + std::string(entry);
    }
    throw Error(ErrorKind::usage,
                "no " + std::string(what) + " is named \"" + std::string(name) + "\"",
                "choose one of " + names);
  }
  return static_cast<Enum>(at - table.begin());
}

}  // namespace

std::string_view name(Midpoint value) {
  return kMidpoints[static_cast<std::size_t>(value)];
}

std::string_view name(AxisFrom value) {
  return kAxes[static_cast<std::size_t>(value)];
}

std::string_view name(EmptySide value) {
  return kEmptySides[static_cast<std::size_t>(value)];
}

Midpoint midpoint_named(std::string_view name) {
  return find<Midpoint>(kMidpoints, "midpoint", name);
}

AxisFrom axis_from_named(std::string_view name) {
  return find<AxisFrom>(kAxes, "axis box", name);
}

EmptySide empty_side_named(std::string_view name) {
  return find<EmptySide>(kEmptySides, "empty side", name);
}

}  // namespace soms
