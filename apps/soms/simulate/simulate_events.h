/// \file
/// The contacts of a simulation as events: a mover and a part of the city, or another mover, from
/// when to when.
#pragma once

#include "soms/scene/contact_spans.h"

#include "apps/soms/simulate/simulate_contacts.h"
#include "apps/soms/simulate/simulate_run.h"
#include "apps/world/world.h"

#include <cstddef>
#include <cstdint>
#include <ostream>
#include <span>
#include <vector>

namespace soms::command {

/// Bodies of a run for `ContactSpans`: the city is divided into its parts, movers are whole. Both
/// must stay.
[[nodiscard]] ContactBodies event_bodies(const World& world, const Scene& scene);

/// How many events are of two movers.
[[nodiscard]] std::uint64_t between_movers(const std::vector<ContactSpan>& events);

/// The event of each contact.
/// \pre   Both are of the same frames, none left out.
/// \cost  O(n log m) for n contacts and m events.
[[nodiscard]] std::vector<std::size_t> events_of_contacts(const World& world,
                                                          std::span<const Contact> contacts,
                                                          const std::vector<ContactSpan>& events);

/// CSV, a row an event: columns of docs/simulate.md. `event_of` is that of `events_of_contacts`,
/// here and below. With a clearance there are the columns `kNearColumns`, too, and behind the
/// contacts a row for each time that two bodies are near. Swept steps add `kPassageColumns` and a
/// row for each passage.
void write_events(std::ostream& out, const World& world, const Outcome& outcome,
                  std::span<const std::size_t> event_of, const SimulateOptions& options);

/// CSV, a row a contact, in the order of `ContactLog`: mover, model, touched, part, triangle,
/// begin, end, event. Frames count from 0; `end` is the last frame of touch; `event` is the row of
/// `write_events`, from 0.
void write_contacts(std::ostream& out, const World& world, const Outcome& outcome,
                    std::span<const std::size_t> event_of);

}  // namespace soms::command
