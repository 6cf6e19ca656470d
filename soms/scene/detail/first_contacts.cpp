#include "soms/scene/detail/first_contacts.h"

#include "soms/scene/detail/kept_memory.h"

#include <algorithm>

namespace soms::detail {

void FirstContacts::start(std::size_t movers) {
  touching_.assign(movers, 0);
  most_candidates_ = 0;
}

void FirstContacts::begin(std::span<const Candidate> candidates, bool mutual) {
  candidates_ = candidates;
  mutual_ = mutual;
  round_ = 0;
  most_candidates_ = std::max(most_candidates_, candidates.size());
  ends_.assign(touching_.size(), 0);
  for (const Candidate& candidate : candidates) {
    ++ends_[candidate.mover];
    if (mutual) {
      ++ends_[candidate.other];
    }
  }
  next_.clear();
  active_.clear();
  std::size_t end = 0;
  for (std::uint32_t mover = 0; mover < ends_.size(); ++mover) {
    next_.push_back(end);
    end += ends_[mover];
    if (ends_[mover] > 0 && touching_[mover] == 0) {
      active_.push_back(mover);
    }
    ends_[mover] = next_[mover];  // so far; filled below
  }
  // Sorted candidates give sorted lists: those where the mover is the greater come first.
  lists_.resize(end);
  for (std::uint32_t k = 0; k < candidates.size(); ++k) {
    lists_[ends_[candidates[k].mover]++] = k;
    if (mutual) {
      lists_[ends_[candidates[k].other]++] = k;
    }
  }
  rounds_.assign(candidates.size(), 0);
}

std::span<const std::uint32_t> FirstContacts::next_round() {
  ++round_;
  now_.clear();
  std::size_t left = 0;
  for (const std::uint32_t mover : active_) {
    if (touching_[mover] != 0) {
      continue;
    }
    std::size_t& next = next_[mover];
    const auto compared_before = [this](std::uint32_t k) {
      return rounds_[k] != 0 && rounds_[k] != round_;
    };
    while (next < ends_[mover] && compared_before(lists_[next])) {
      ++next;
    }
    if (next == ends_[mover]) {
      continue;
    }
    active_[left++] = mover;
    const std::uint32_t k = lists_[next];
    if (rounds_[k] == 0) {  // else its partner has it compared in this round
      rounds_[k] = round_;
      now_.push_back(k);
    }
  }
  active_.resize(left);
  return now_;
}

void FirstContacts::touch(std::uint32_t k) {
  touching_[candidates_[k].mover] = 1;
  if (mutual_) {
    touching_[candidates_[k].other] = 1;
  }
}

void FirstContacts::give_back() {
  candidates_ = {};
  const std::size_t movers = touching_.size();
  detail::give_back(touching_, movers);
  detail::give_back(ends_, movers);
  detail::give_back(next_, movers);
  detail::give_back(active_, movers);
  detail::give_back(lists_, 2 * most_candidates_);
  detail::give_back(rounds_, most_candidates_);
  detail::give_back(now_, most_candidates_);
}

std::size_t FirstContacts::memory() const {
  return bytes(touching_) + bytes(ends_) + bytes(next_) + bytes(lists_) + bytes(rounds_) +
         bytes(active_) + bytes(now_);
}

}  // namespace soms::detail
