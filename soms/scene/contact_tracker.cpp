#include "soms/scene/contact_tracker.h"

#include "soms/base/error.h"

#include <string>
#include <utility>

namespace soms {

namespace {

/// The two bodies of a contact or an event.
std::pair<std::uint32_t, std::uint32_t> bodies_of(const EnvironmentContact& contact) {
  return {contact.mover, contact.part};
}

std::pair<std::uint32_t, std::uint32_t> bodies_of(const MoverContact& contact) {
  return {contact.a, contact.b};
}

std::pair<std::uint32_t, std::uint32_t> bodies_of(const EnvironmentEvent& event) {
  return {event.mover, event.part};
}

std::pair<std::uint32_t, std::uint32_t> bodies_of(const MoverEvent& event) {
  return {event.a, event.b};
}

/// Pairs of bodies of sorted contacts, each once.
template <typename Event, typename Contact>
std::vector<Event> touching_pairs(const std::vector<Contact>& contacts) {
  std::vector<Event> pairs;
  for (const Contact& contact : contacts) {
    const auto [first, second] = bodies_of(contact);
    if (pairs.empty() || bodies_of(pairs.back()) != std::pair(first, second)) {
      pairs.push_back({first, second, ContactChange::stay});
    }
  }
  return pairs;
}

/// Both lists sorted by bodies, and so are the events.
template <typename Event>
std::vector<Event> changes(const std::vector<Event>& before, const std::vector<Event>& now) {
  std::vector<Event> events;
  events.reserve(before.size() + now.size());
  const auto add = [&events](Event event, ContactChange change) {
    event.change = change;
    events.push_back(event);
  };
  auto old = before.begin();
  for (const Event& event : now) {
    for (; old != before.end() && bodies_of(*old) < bodies_of(event); ++old) {
      add(*old, ContactChange::end);
    }
    const bool stays = old != before.end() && bodies_of(*old) == bodies_of(event);
    add(event, stays ? ContactChange::stay : ContactChange::begin);
    old += stays ? 1 : 0;
  }
  for (; old != before.end(); ++old) {
    add(*old, ContactChange::end);
  }
  return events;
}

}  // namespace

ContactEvents ContactTracker::follow(const StepReport& report) {
  if (report.scope != StepScope::every_pair) {
    throw Error(
        ErrorKind::usage,
        "contact tracker: the report of a step with StepScope::first_contact lacks pairs of "
        "bodies that touch",
        "step with StepScope::every_pair");
  }
  if (has_report_ && report.mover_mover != mover_mover_) {
    throw Error(ErrorKind::usage,
                std::string("contact tracker: this report ") +
                    (mover_mover_ ? "does not compare movers with each other, the one before does"
                                  : "compares movers with each other, the one before does not"),
                "keep StepOptions::mover_mover, or call clear()");
  }
  auto environment = touching_pairs<EnvironmentEvent>(report.environment);
  auto movers = touching_pairs<MoverEvent>(report.movers);
  ContactEvents events{changes(environment_, environment), changes(movers_, movers)};
  environment_ = std::move(environment);
  movers_ = std::move(movers);
  mover_mover_ = report.mover_mover;
  has_report_ = true;
  return events;
}

}  // namespace soms
