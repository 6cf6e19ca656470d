#include "apps/soms/simulate_rows.h"

#include "soms/base/common_box.h"

#include "apps/report/placing.h"
#include "apps/support/part_names.h"

#include <algorithm>
#include <array>
#include <map>

namespace soms::command {

namespace {

Box mover_box(const World& world, MoverId mover, std::uint64_t frame) {
  const MoverRoute& way = world.routes[mover];
  return report::moved(world.models[way.model].shape.bounds(), way.at(frame));
}

/// Where the boxes of two bodies meet that touch.
Box meeting_box(const Box& a, const Box& b) {
  const Box common = common_box(a, b);
  return common.empty() ? a : common;  // apart by the rounding of a box
}

/// Gathers contacts one after the other.
class Gathering {
 public:
  explicit Gathering(const World& world) : world_(world) {
    for (const Body& body : world.city) {
      parts_of_.emplace_back(body.shape.mesh());
    }
  }

  void add(const Contact& contact) {
    const bool between = contact.part == Contact::kMover;
    const std::uint32_t body = between ? body_of(world_, contact.other) : contact.part;
    const std::uint32_t part = between ? Part::kNoParent : parts_of_[contact.part](contact.other);
    const auto [at, added] =
        numbers_.try_emplace({contact.mover, body, part}, gathered_.rows.size());
    if (added) {
      gathered_.rows.push_back(
          {.a = body_of(world_, contact.mover),
           .b = body,
           .part_b = number_of(body, part),
           .begin = contact.begin,
           .first = {report::kNoTriangle, between ? report::kNoTriangle : contact.other}});
      counted_.push_back(contact.begin);
    }
    gathered_.row_of.push_back(at->second);
    extend(at->second, contact);
  }

  ContactRows take() { return std::move(gathered_); }

 private:
  void extend(std::size_t number, const Contact& contact) {
    report::SceneRow& row = gathered_.rows[number];
    ++row.count;
    row.end = std::max(row.end, contact.end);
    // Frames of contacts that last side by side count once.
    const std::uint64_t first = std::max(contact.begin, counted_[number]);
    if (contact.end >= first) {
      row.steps += contact.end - first + 1;
      counted_[number] = contact.end + 1;
    }
    const bool between = contact.part == Contact::kMover;
    const Box other =
        between
            ? mover_box(world_, contact.other, contact.begin)
            : report::moved(bounds(world_.city[contact.part].shape.mesh().triangle(contact.other)),
                            world_.city[contact.part].pose);
    row.box.grow(meeting_box(mover_box(world_, contact.mover, contact.begin), other));
  }

  std::uint32_t number_of(std::uint32_t body, std::uint32_t part) {
    if (part == Part::kNoParent) {
      return report::kNoPart;
    }
    const auto [at, added] =
        part_numbers_.try_emplace({body, part}, static_cast<std::uint32_t>(gathered_.parts.size()));
    if (added) {
      const Mesh& mesh = world_.city[body].shape.mesh();
      gathered_.parts.push_back(
          {part_label(mesh, part), part_path_label(mesh, part, report::kLongestText)});
    }
    return at->second;
  }

  const World& world_;
  ContactRows gathered_;
  std::vector<PartsOf> parts_of_;                                ///< of bodies of the city
  std::map<std::array<std::uint32_t, 3>, std::size_t> numbers_;  ///< of rows
  std::map<std::array<std::uint32_t, 2>, std::uint32_t> part_numbers_;
  std::vector<std::uint64_t> counted_;  ///< frames before this one are counted, of each row
};

}  // namespace

std::uint32_t body_of(const World& world, MoverId mover) {
  return static_cast<std::uint32_t>(world.city.size()) + mover;
}

ContactRows rows_of(const World& world, const std::vector<Contact>& contacts) {
  Gathering gathering(world);
  for (const Contact& contact : contacts) {
    gathering.add(contact);
  }
  return gathering.take();
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
