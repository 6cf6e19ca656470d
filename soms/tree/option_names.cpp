#include "soms/tree/option_names.h"

#include "soms/base/error.h"

#include <algorithm>
#include <array>
#include <string>

namespace soms {

namespace {

template <class Enum>
Enum find(std::string_view what, std::string_view name) {
  constexpr auto& table = kWords<Enum>.names;
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

Midpoint midpoint_named(std::string_view name) {
  return find<Midpoint>("midpoint", name);
}

AxisFrom axis_from_named(std::string_view name) {
  return find<AxisFrom>("axis box", name);
}

EmptySide empty_side_named(std::string_view name) {
  return find<EmptySide>("empty side", name);
}

}  // namespace soms
