#include "soms/scene/reference/contact_spans.h"

#include "soms/base/arithmetic.h"
#include "soms/scene/detail/contact_place.h"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>
#include <utility>

namespace soms::reference {

namespace {

using Sides = std::pair<ContactSide, ContactSide>;
/// The pairs of triangles of all sides that touch in a step.
using StepContacts = std::map<Sides, std::set<TrianglePair>>;

StepContacts contacts_of(const ContactStep& step) {
  StepContacts contacts;
  const auto add = [&](const SceneBody& a, const SceneBody& b, TriangleId i, TriangleId j) {
    Sides sides{{a, Part::kNoParent}, {b, Part::kNoParent}};
    if (step.bodies.part) {
      sides.first.part = step.bodies.part(a, i);
      sides.second.part = step.bodies.part(b, j);
    }
    contacts[sides].insert({i, j});
  };
  for (const EnvironmentContact& c : step.report.environment) {
    add({SceneBodyKind::mover, c.mover}, {SceneBodyKind::environment, c.part}, c.i, c.j);
  }
  for (const MoverContact& c : step.report.movers) {
    add({SceneBodyKind::mover, c.a}, {SceneBodyKind::mover, c.b}, c.i, c.j);
  }
  return contacts;
}

void set_most(ContactSpan& span, const ContactStep& step, const std::set<TrianglePair>& pairs) {
  std::vector<std::pair<Triangle, Triangle>> triangles;
  for (const auto& [i, j] : pairs) {
    triangles.emplace_back(step.bodies.triangle(span.a.body, i),
                           step.bodies.triangle(span.b.body, j));
  }
  const detail::ContactPlace place = detail::contact_place(triangles);
  span.most_pairs = pairs.size();
  span.most_step = step.step;
  span.pair = *std::next(pairs.begin(), static_cast<std::ptrdiff_t>(place.pair));
  span.place = place.point;
  span.box = place.box;
}

}  // namespace

std::vector<ContactSpan> contact_spans(std::span<const ContactStep> steps) {
  const PlainArithmetic plain;
  std::vector<StepContacts> contacts;
  std::set<Sides> all;
  for (const ContactStep& step : steps) {
    contacts.push_back(contacts_of(step));
    for (const auto& [sides, pairs] : contacts.back()) {
      all.insert(sides);
    }
  }
  std::vector<ContactSpan> spans;
  for (const Sides& sides : all) {
    bool touching = false;
    for (std::size_t k = 0; k < steps.size(); ++k) {
      const auto found = contacts[k].find(sides);
      if (found == contacts[k].end()) {
        const bool two_movers = sides.second.body.kind == SceneBodyKind::mover;
        if (touching && (!two_movers || steps[k].report.mover_mover)) {
          spans.back().lasts = false;
          touching = false;
        }
        continue;
      }
      if (!touching) {
        spans.push_back({.a = sides.first, .b = sides.second, .begin = steps[k].step});
        touching = true;
      }
      ContactSpan& span = spans.back();
      span.end = steps[k].step;
      ++span.steps;
      if (found->second.size() > span.most_pairs) {
        set_most(span, steps[k], found->second);
      }
    }
  }
  std::sort(spans.begin(), spans.end(), [](const ContactSpan& s, const ContactSpan& t) {
    return std::tie(s.begin, s.a, s.b) < std::tie(t.begin, t.a, t.b);
  });
  return spans;
}

}  // namespace soms::reference
