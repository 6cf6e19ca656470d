#include "apps/soms/simulate/simulate_events.h"

#include "soms/base/text.h"

#include "apps/model/georeference.h"
#include "apps/soms/simulate/simulate_near_report.h"
#include "apps/soms/simulate/simulate_passage_report.h"
#include "apps/soms/simulate/simulate_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <string>
#include <string_view>
#include <tuple>

namespace soms::command {

namespace {

bool is_between_movers(const ContactSpan& event) {
  return event.b.body.kind == SceneBodyKind::mover;
}

/// Mover, body of the city or kMover, number of its part or of the other mover.
using WhoTouches = std::tuple<MoverId, std::uint32_t, std::uint32_t>;

WhoTouches who_touches(const ContactSpan& event) {
  return is_between_movers(event) ? WhoTouches{event.a.body.id, Contact::kMover, event.b.body.id}
                                  : WhoTouches{event.a.body.id, event.b.body.id, event.b.part};
}

std::string model_field(const World& world, MoverId mover) {
  return csv_field(model_name(world, mover));
}

}  // namespace

ContactBodies event_bodies(const World& world, const Scene& scene) {
  ContactBodies bodies = contact_bodies(scene);
  bodies.part = [parts = std::make_shared<CityParts>(world)](const SceneBody& body,
                                                             TriangleId triangle) {
    return body.kind == SceneBodyKind::mover ? Part::kNoParent : parts->number(body.id, triangle);
  };
  return bodies;
}

std::uint64_t between_movers(const std::vector<ContactSpan>& events) {
  return static_cast<std::uint64_t>(std::count_if(events.begin(), events.end(), is_between_movers));
}

std::vector<std::size_t> events_of_contacts(const World& world, std::span<const Contact> contacts,
                                            const std::vector<ContactSpan>& events) {
  std::vector<std::tuple<WhoTouches, std::uint64_t, std::size_t>> begins;
  begins.reserve(events.size());
  for (std::size_t k = 0; k < events.size(); ++k) {
    begins.emplace_back(who_touches(events[k]), events[k].begin, k);
  }
  std::sort(begins.begin(), begins.end());
  const CityParts parts(world);
  std::vector<std::size_t> numbers;
  numbers.reserve(contacts.size());
  for (const Contact& contact : contacts) {
    const WhoTouches who{contact.mover, contact.part,
                         contact.part == Contact::kMover
                             ? contact.other
                             : parts.number(contact.part, contact.other)};
    // The last of these two that begins no later: a contact lies within one event.
    const auto after = std::upper_bound(begins.begin(), begins.end(),
                                        std::tuple(who, contact.begin, events.size()));
    numbers.push_back(std::get<2>(*std::prev(after)));
  }
  return numbers;
}

void write_events(std::ostream& out, const World& world, const Outcome& outcome,
                  std::span<const std::size_t> event_of, const SimulateOptions& options) {
  const std::vector<ContactSpan>& events = outcome.events.spans();
  std::vector<std::uint64_t> counts(events.size(), 0);
  for (const std::size_t k : event_of) {
    ++counts[k];
  }
  const CityParts parts(world);
  const bool with_near = options.clearance > 0;
  const std::string_view of_near = with_near ? kNearFieldsOfContact : "";
  const std::string_view of_passage = options.swept ? kPassageFieldsOfOthers : "";
  const GeoreferenceColumn georeference(world.georeference);
  out << "event,mover,model,touched,part,begin,end,frames,contacts,most_pairs,most_frame,x,y,z"
      << (with_near ? kNearColumns : "") << (options.swept ? kPassageColumns : "")
      << georeference.head() << '\n';
  for (std::size_t k = 0; k < events.size(); ++k) {
    const ContactSpan& event = events[k];
    out << "contact," << event.a.body.id << ',' << model_field(world, event.a.body.id) << ',';
    if (is_between_movers(event)) {
      out << "mover " << event.b.body.id << ',' << model_field(world, event.b.body.id);
    } else {
      out << csv_field(world.city[event.b.body.id].name) << ','
          << csv_field(parts.part_name(event.b.body.id, event.b.part));
    }
    out << fmt::format(",{},{},{},{},{},{},{},{},{}", event.begin, event.end, event.steps,
                       counts[k], event.most_pairs, event.most_step, event.place.x, event.place.y,
                       event.place.z)
        << of_near << of_passage << georeference.field() << '\n';
  }
  if (with_near) {
    write_near_events(out, world, outcome, of_passage);
  }
  if (options.swept) {
    write_passages(out, world, outcome, of_near);
  }
}

void write_contacts(std::ostream& out, const World& world, const Outcome& outcome,
                    std::span<const std::size_t> event_of) {
  const std::vector<Contact>& contacts = outcome.contacts.contacts();
  const CityParts parts(world);
  out << "mover,model,touched,part,triangle,begin,end,event\n";
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    const Contact& contact = contacts[k];
    out << contact.mover << ',' << model_field(world, contact.mover) << ',';
    if (contact.part == Contact::kMover) {
      out << "mover " << contact.other << ',' << model_field(world, contact.other) << ",,";
    } else {
      out << csv_field(world.city[contact.part].name) << ','
          << csv_field(parts.name(contact.part, contact.other)) << ','
          << world.numbers[contact.part](contact.other) << ',';
    }
    out << contact.begin << ',' << contact.end << ',' << event_of[k] << '\n';
  }
}

}  // namespace soms::command
