/// \file
/// Contacts as marks on the map, and words fit for it.
#pragma once

#include "apps/soms/simulate_run.h"
#include "apps/support/world.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace soms::command {

/// Contacts that began near each other.
struct Mark {
  double x = 0;  ///< mean place of the movers
  double y = 0;
  std::uint64_t contacts = 0;
};

/// Contacts gathered by squares of side `cell` meters: most contacts first.
[[nodiscard]] std::vector<Mark> find_marks(const World& world, const Outcome& outcome, double cell);

/// Radius of a mark in pixels: its area grows with the contacts, up to a limit.
[[nodiscard]] double mark_radius(std::uint64_t contacts);

/// A round length not above `meters`: 1, 2 or 5 times a power of ten.
[[nodiscard]] double round_length(double meters);

}  // namespace soms::command
