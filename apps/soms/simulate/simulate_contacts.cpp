#include "apps/soms/simulate/simulate_contacts.h"

#include <algorithm>
#include <tuple>

namespace soms::command {

// The report's lists are sorted, by bodies first: only triangles of the city are put in order,
// those that one mover touches of one body.
void ContactLog::add(const StepReport& report, std::uint64_t frame) {
  now_.clear();
  const auto push = [&](const Contact& contact) {
    if (now_.empty() || !now_.back().same_touch(contact)) {
      now_.push_back(contact);
    }
  };
  auto mover = report.movers.begin();
  const auto add_movers = [&](std::uint64_t below) {
    for (; mover != report.movers.end() && mover->a < below; ++mover) {
      push({mover->a, Contact::kMover, mover->b, frame, frame});
    }
  };
  const auto& environment = report.environment;
  for (auto begin = environment.begin(); begin != environment.end();) {
    triangles_.clear();
    auto end = begin;
    for (; end != environment.end() && end->mover == begin->mover && end->part == begin->part;
         ++end) {
      triangles_.push_back(end->j);
    }
    std::sort(triangles_.begin(), triangles_.end());
    add_movers(begin->mover);
    for (const TriangleId triangle : triangles_) {
      push({begin->mover, begin->part, triangle, frame, frame});
    }
    begin = end;
  }
  add_movers(std::uint64_t{1} << 32);  // all that are left
  follow(now_, frame);
}

/// Merges the touches of this frame with those of the frame before: both are sorted.
void ContactLog::follow(std::vector<Contact>& now, std::uint64_t frame) {
  auto before = lasting_.begin();
  for (Contact& contact : now) {
    while (before != lasting_.end() && before->touches_less(contact)) {
      contacts_.push_back(*before++);
    }
    if (before != lasting_.end() && before->same_touch(contact)) {
      contact.begin = before++->begin;
    } else {
      begin(contact);
    }
    contact.end = frame;
    if (contact.part != Contact::kMover) {
      ++touched_[(std::uint64_t{contact.part} << 32) | contact.other].frames;
    }
  }
  contacts_.insert(contacts_.end(), before, lasting_.end());
  lasting_.swap(now);
}

void ContactLog::begin(const Contact& contact) {
  if (contact.part == Contact::kMover) {
    ++between_movers_;
    return;
  }
  Touched& touched = touched_[(std::uint64_t{contact.part} << 32) | contact.other];
  if (touched.contacts++ == 0) {
    touched.part = contact.part;
    touched.triangle = contact.other;
    touched.mover = contact.mover;
    touched.begin = contact.begin;
  }
}

void ContactLog::finish() {
  contacts_.insert(contacts_.end(), lasting_.begin(), lasting_.end());
  lasting_.clear();
  std::sort(contacts_.begin(), contacts_.end(), [](const Contact& a, const Contact& b) {
    return a.begin != b.begin ? a.begin < b.begin : a.touches_less(b);
  });
}

std::uint64_t ContactLog::movers() const {
  std::vector<MoverId> movers;
  for (const Contact& contact : contacts_) {
    movers.push_back(contact.mover);
    if (contact.part == Contact::kMover) {
      movers.push_back(contact.other);
    }
  }
  std::sort(movers.begin(), movers.end());
  return static_cast<std::uint64_t>(std::unique(movers.begin(), movers.end()) - movers.begin());
}

std::vector<Touched> ContactLog::most_touched(std::size_t n) const {
  std::vector<Touched> all;
  all.reserve(touched_.size());
  for (const auto& [key, touched] : touched_) {
    all.push_back(touched);
  }
  const std::size_t most = std::min(n, all.size());
  std::partial_sort(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(most), all.end(),
                    [](const Touched& a, const Touched& b) {
                      return std::tie(b.frames, a.part, a.triangle) <
                             std::tie(a.frames, b.part, b.triangle);
                    });
  all.resize(most);
  return all;
}

}  // namespace soms::command
