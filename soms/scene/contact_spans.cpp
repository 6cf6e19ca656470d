#include "soms/scene/contact_spans.h"

#include "soms/base/arithmetic.h"
#include "soms/base/error.h"
#include "soms/query/detail/moved_triangle.h"
#include "soms/scene/detail/contact_place.h"
#include "soms/scene/scene.h"

#include <algorithm>
#include <span>
#include <string>
#include <tuple>
#include <utility>

namespace soms {

namespace {

/// A pair of triangles of two sides.
struct SideContact {
  ContactSide a;
  ContactSide b;
  TrianglePair pair;

  // By hand, as older standard libraries have no <=> of pairs.
  [[nodiscard]] bool operator<(const SideContact& other) const {
    return std::tie(a, b, pair) < std::tie(other.a, other.b, other.pair);
  }
};

/// The two sides, for comparing.
auto sides_of(const auto& contact) {
  return std::tie(contact.a, contact.b);
}

/// The two bodies of a contact.
template <class Contact>
using BodiesOf = std::pair<SceneBody, SceneBody> (*)(const Contact&);

/// Contacts of a report's list, by their sides, then by triangles. A step's lists are sorted by
/// bodies already, so only what one mover touches is put in order, and mostly that is, too.
template <class Contact>
std::vector<SideContact> sorted_contacts(const std::vector<Contact>& list,
                                         const ContactBodies& bodies, BodiesOf<Contact> bodies_of) {
  if (!std::is_sorted(list.begin(), list.end())) {
    std::vector<Contact> sorted = list;
    std::sort(sorted.begin(), sorted.end());
    return sorted_contacts(sorted, bodies, bodies_of);
  }
  std::vector<SideContact> contacts;
  contacts.reserve(list.size());
  const auto side = [&bodies](const SceneBody& body, TriangleId triangle) {
    return ContactSide{body, bodies.part ? bodies.part(body, triangle) : Part::kNoParent};
  };
  for (const Contact& c : list) {
    const auto [a, b] = bodies_of(c);
    contacts.push_back({side(a, c.i), side(b, c.j), {c.i, c.j}});
  }
  for (auto begin = contacts.begin(); begin != contacts.end();) {
    const auto end = std::find_if(begin, contacts.end(), [&begin](const SideContact& contact) {
      return contact.a.body != begin->a.body;
    });
    if (!std::is_sorted(begin, end)) {
      std::sort(begin, end);
    }
    begin = end;
  }
  return contacts;
}

/// All contacts of a report.
std::vector<SideContact> sorted_contacts(const StepReport& report, const ContactBodies& bodies) {
  std::vector<SideContact> with_city =
      sorted_contacts<EnvironmentContact>(report.environment, bodies, [](const auto& c) {
        return std::pair(SceneBody{SceneBodyKind::mover, c.mover},
                         SceneBody{SceneBodyKind::environment, c.part});
      });
  if (report.movers.empty()) {
    return with_city;
  }
  const std::vector<SideContact> between_movers = sorted_contacts<
      MoverContact>(report.movers, bodies, [](const auto& c) {
    return std::pair(SceneBody{SceneBodyKind::mover, c.a}, SceneBody{SceneBodyKind::mover, c.b});
  });
  std::vector<SideContact> all(with_city.size() + between_movers.size());
  std::merge(with_city.begin(), with_city.end(), between_movers.begin(), between_movers.end(),
             all.begin());
  return all;
}

/// The span after one more step with these contacts, all of them of its two sides.
ContactSpan longer(ContactSpan span, std::uint64_t step, std::span<const SideContact> contacts,
                   const ContactBodies& bodies) {
  span.end = step;
  ++span.steps;
  if (contacts.size() <= span.most_pairs) {
    return span;
  }
  std::vector<std::pair<Triangle, Triangle>> triangles;
  triangles.reserve(contacts.size());
  for (const SideContact& contact : contacts) {
    triangles.emplace_back(bodies.triangle(contact.a.body, contact.pair.a),
                           bodies.triangle(contact.b.body, contact.pair.b));
  }
  const detail::ContactPlace place = detail::contact_place(triangles);
  span.most_pairs = contacts.size();
  span.most_step = step;
  span.pair = contacts[place.pair].pair;
  span.place = place.point;
  span.box = place.box;
  return span;
}

bool was_compared(const ContactSpan& span, const StepReport& report) {
  return span.b.body.kind == SceneBodyKind::environment || report.mover_mover;
}

void check(std::optional<std::uint64_t> before, std::uint64_t step, const StepReport& report) {
  if (report.coverage != Coverage::complete) {
    throw Error(ErrorKind::usage,
                "contact spans: the report of step " + std::to_string(step) +
                    " is not complete, it may lack parts that touch",
                "step with StepScope::every_pair and OverlapMode::all");
  }
  if (before && step <= *before) {
    throw Error(ErrorKind::usage,
                "contact spans: step " + std::to_string(step) + " does not come after step " +
                    std::to_string(*before),
                "number the steps in ascending order");
  }
}

}  // namespace

ContactBodies contact_bodies(const Scene& scene) {
  return {.triangle = [&scene](const SceneBody& body, TriangleId triangle) {
    return detail::moved_triangle(
        body.kind == SceneBodyKind::mover ? scene.mover(body.id) : scene.environment(body.id),
        triangle);
  }};
}

void ContactSpans::follow(std::uint64_t step, const StepReport& report,
                          const ContactBodies& bodies) {
  const PlainArithmetic plain;
  check(step_, step, report);
  const std::vector<SideContact> contacts = sorted_contacts(report, bodies);
  // Kept aside until all is known, so that an error changes nothing.
  std::vector<std::pair<std::size_t, ContactSpan>> changed;
  std::vector<std::size_t> lasting;
  std::size_t count = spans_.size();
  auto old = lasting_.begin();
  const auto go_on_without_touch = [&] {
    ContactSpan span = spans_[*old];
    if (was_compared(span, report)) {
      span.lasts = false;
      changed.emplace_back(*old, span);
    } else {
      lasting.push_back(*old);
    }
    ++old;
  };
  for (auto begin = contacts.begin(); begin != contacts.end();) {
    const auto end = std::find_if(begin, contacts.end(), [&begin](const SideContact& contact) {
      return sides_of(contact) != sides_of(*begin);
    });
    while (old != lasting_.end() && sides_of(spans_[*old]) < sides_of(*begin)) {
      go_on_without_touch();
    }
    const bool goes_on = old != lasting_.end() && sides_of(spans_[*old]) == sides_of(*begin);
    const std::size_t index = goes_on ? *old++ : count++;
    const ContactSpan span =
        goes_on ? spans_[index] : ContactSpan{.a = begin->a, .b = begin->b, .begin = step};
    const std::span<const SideContact> touching(&*begin, static_cast<std::size_t>(end - begin));
    changed.emplace_back(index, longer(span, step, touching, bodies));
    lasting.push_back(index);
    begin = end;
  }
  while (old != lasting_.end()) {
    go_on_without_touch();
  }
  spans_.resize(count);
  for (const auto& [index, span] : changed) {
    spans_[index] = span;
  }
  lasting_ = std::move(lasting);
  step_ = step;
}

}  // namespace soms
