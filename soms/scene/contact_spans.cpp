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

/// All contacts of a report, by their sides, then by triangles.
std::vector<SideContact> sorted_contacts(const StepReport& report, const ContactBodies& bodies) {
  std::vector<SideContact> contacts;
  contacts.reserve(report.environment.size() + report.movers.size());
  const auto side = [&bodies](SceneBodyKind kind, std::uint32_t id, TriangleId triangle) {
    const SceneBody body{kind, id};
    return ContactSide{body, bodies.part ? bodies.part(body, triangle) : Part::kNoParent};
  };
  for (const EnvironmentContact& c : report.environment) {
    contacts.push_back({side(SceneBodyKind::mover, c.mover, c.i),
                        side(SceneBodyKind::environment, c.part, c.j),
                        {c.i, c.j}});
  }
  for (const MoverContact& c : report.movers) {
    contacts.push_back(
        {side(SceneBodyKind::mover, c.a, c.i), side(SceneBodyKind::mover, c.b, c.j), {c.i, c.j}});
  }
  std::sort(contacts.begin(), contacts.end());
  return contacts;
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
    triangles.emplace_back(bodies.triangle(contact.a.body, contact.pair.first),
                           bodies.triangle(contact.b.body, contact.pair.second));
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
