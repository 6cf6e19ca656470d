#include "apps/soms/simulate/simulate_rows.h"

#include "apps/world/part_names.h"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

namespace soms::command {

namespace {

/// The parts of the city that rows name, each once.
class NamedParts {
 public:
  NamedParts(const World& world, std::vector<report::ScenePart>& parts)
      : world_(world), parts_(parts) {}

  std::uint32_t number_of(const ContactSide& side) {
    if (side.part == Part::kNoParent) {
      return report::kNoPart;
    }
    const auto [at, added] =
        numbers_.try_emplace({side.body.id, side.part}, static_cast<std::uint32_t>(parts_.size()));
    if (added) {
      const MeshView& mesh = world_.city[side.body.id].shape.mesh();
      parts_.push_back(
          {part_label(mesh, side.part), part_path_label(mesh, side.part, report::kLongestText)});
    }
    return at->second;
  }

 private:
  const World& world_;
  std::vector<report::ScenePart>& parts_;
  std::map<std::array<std::uint32_t, 2>, std::uint32_t> numbers_;
};

}  // namespace

std::uint32_t body_of(const World& world, MoverId mover) {
  return static_cast<std::uint32_t>(world.city.size()) + mover;
}

ContactRows rows_of(const World& world, const Outcome& outcome, std::vector<std::size_t> event_of) {
  const std::vector<ContactSpan>& events = outcome.events.spans();
  ContactRows gathered;
  NamedParts parts(world, gathered.parts);
  for (const ContactSpan& event : events) {
    const bool between = event.b.body.kind == SceneBodyKind::mover;
    gathered.rows.push_back({.a = body_of(world, event.a.body.id),
                             .b = between ? body_of(world, event.b.body.id) : event.b.body.id,
                             .part_b = parts.number_of(event.b),
                             .steps = event.steps,
                             .begin = event.begin,
                             .end = event.end,
                             .first = event.pair,
                             .box = event.box,
                             .most_pairs = event.most_pairs,
                             .most_step = event.most_step,
                             .place = event.place});
  }
  gathered.row_of = std::move(event_of);
  for (const std::size_t row : gathered.row_of) {
    ++gathered.rows[row].count;
  }
  return gathered;
}

std::vector<std::size_t> fair_sample(const ContactRows& rows, const std::vector<Contact>& contacts,
                                     std::size_t most) {
  std::vector<std::vector<std::size_t>> members(rows.rows.size());
  std::vector<std::uint64_t> counts(rows.rows.size(), 0);
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    members[rows.row_of[k]].push_back(k);
    ++counts[rows.row_of[k]];
  }
  const std::vector<std::uint64_t> shares = report::fair_shares(counts, most);
  std::vector<std::size_t> chosen;
  for (std::size_t r = 0; r < members.size(); ++r) {
    if (shares[r] == 0) {
      continue;
    }
    // The first however short it is: the page shows it where the row is chosen.
    chosen.push_back(members[r].front());
    std::vector<report::Span> spans;
    for (std::size_t k = 1; k < members[r].size(); ++k) {
      spans.push_back({contacts[members[r][k]].begin, contacts[members[r][k]].end});
    }
    for (const std::size_t k : report::longest(spans, static_cast<std::size_t>(shares[r]) - 1)) {
      chosen.push_back(members[r][k + 1]);
    }
  }
  std::sort(chosen.begin(), chosen.end());
  return chosen;
}

}  // namespace soms::command
