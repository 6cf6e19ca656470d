/// \file
/// Contacts and gaps as marks on the map, and words fit for it.
#pragma once

#include "apps/soms/simulate/simulate_run.h"
#include "apps/world/world.h"

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

/// Where a text stands on the map, in pixels.
struct Label {
  double x = 0;
  double y = 0;
};

/// A place and the numbers of those that lie there: "1", "2, 4", "1-3".
struct NumberedPlace {
  Label at;
  std::string numbers;
};

/// Places numbered from 1 in their order. Those within `apart` pixels of an earlier place stand
/// with it, so that no number covers another.
[[nodiscard]] std::vector<NumberedPlace> numbered_places(const std::vector<Label>& places,
                                                         double apart);

/// Numbers of the labels that are written, `most` of them: each but those that would cover what is
/// `taken` or one before. `width` and `height` are those of the texts.
[[nodiscard]] std::vector<std::size_t> labels_with_room(const std::vector<Label>& labels,
                                                        const std::vector<Label>& taken,
                                                        double width, double height,
                                                        std::size_t most);

}  // namespace soms::command
