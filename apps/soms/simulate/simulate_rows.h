/// \file
/// The contacts of a simulation, gathered by event: the rows of its page.
#pragma once

#include "apps/report/scene.h"
#include "apps/soms/simulate/simulate_contacts.h"
#include "apps/soms/simulate/simulate_run.h"
#include "apps/world/world.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace soms::command {

/// Rows of a page and the row of each contact.
struct ContactRows {
  std::vector<report::SceneRow> rows;    ///< events
  std::vector<report::ScenePart> parts;  ///< of the city
  std::vector<std::size_t> row_of;       ///< of each contact
};

/// Bodies of a page's scene: those of the city, then the movers.
[[nodiscard]] std::uint32_t body_of(const World& world, MoverId mover);

/// A row for each event, in order of begin, with all its contacts, whose events are `event_of`
/// (`events_of_contacts`). Rows hold no pairs.
[[nodiscard]] ContactRows rows_of(const World& world, const Outcome& outcome,
                                  std::vector<std::size_t> event_of);

/// Numbers, ascending, of at most `most` contacts: each row has a fair share, its
/// first and its longest.
[[nodiscard]] std::vector<std::size_t> fair_sample(const ContactRows& rows,
                                                   const std::vector<Contact>& contacts,
                                                   std::size_t most);

}  // namespace soms::command
