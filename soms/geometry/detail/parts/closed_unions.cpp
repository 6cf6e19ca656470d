#include "soms/geometry/detail/parts/closed_unions.h"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

namespace soms::detail {

namespace {

/// Most surfaces of a stretch that is kept: so many meet nowhere but in files made to be slow.
constexpr std::size_t kMostOfAStretch = 64;

/// Most classes that are untied together: one bit each.
constexpr std::size_t kMostClasses = 64;

/// Each round settles what the one before made plain.
constexpr int kMostRounds = 64;

}  // namespace

std::uint32_t ClosedUnions::united(std::uint32_t a, std::uint32_t b) {
  a = classes_.find(a);
  b = classes_.find(b);
  classes_.unite(a, b);
  const std::uint32_t both = classes_.find(a);
  open_[both] = open_[a] | open_[b];
  return both;
}

void ClosedUnions::add(std::span<const std::uint32_t> stretch) {
  if (stretch.size() == 1) {
    open_[classes_.find(stretch[0])] = 1;
  } else if (stretch.size() == 2) {
    static_cast<void>(united(stretch[0], stretch[1]));
  } else if (stretch.size() <= kMostOfAStretch) {
    stretches_.emplace_back(stretch.begin(), stretch.end());
  }
}

/// Leaves the classes that are there an odd number of times, without those that stay open.
void ClosedUnions::reduce(std::vector<std::uint32_t>& stretch) {
  for (std::uint32_t& surface : stretch) {
    surface = classes_.find(surface);
  }
  std::sort(stretch.begin(), stretch.end());
  std::size_t kept = 0;
  for (std::size_t begin = 0; begin < stretch.size();) {
    std::size_t end = begin + 1;
    while (end < stretch.size() && stretch[end] == stretch[begin]) {
      ++end;
    }
    if ((end - begin) % 2 != 0 && open_[stretch[begin]] == 0) {
      stretch[kept++] = stretch[begin];
    }
    begin = end;
  }
  stretch.resize(kept);
}

/// A stretch of one class opens it, and of two joins them, which may leave fewer in others.
void ClosedUnions::settle() {
  bool changed = true;
  for (int round = 0; changed && round < kMostRounds; ++round) {
    changed = false;
    std::erase_if(stretches_, [&](std::vector<std::uint32_t>& stretch) {
      reduce(stretch);
      if (stretch.size() == 1 || stretch.size() == 2) {
        add(stretch);
        changed = true;
      }
      return stretch.size() < 3;
    });
  }
  for (std::vector<std::uint32_t>& stretch : stretches_) {
    reduce(stretch);
  }
}

/// Solves what is left over two elements: by elimination, for classes that hang together.
void ClosedUnions::untie() {
  DisjointSets knots(open_.size());
  for (const auto& stretch : stretches_) {
    for (const std::uint32_t member : stretch) {
      knots.unite(stretch.front(), member);
    }
  }
  std::map<std::uint32_t, std::vector<std::uint32_t>> classes;
  std::map<std::uint32_t, std::vector<const std::vector<std::uint32_t>*>> stretches;
  for (const auto& stretch : stretches_) {
    if (!stretch.empty()) {
      const std::uint32_t knot = knots.find(stretch.front());
      stretches[knot].push_back(&stretch);
      classes[knot].insert(classes[knot].end(), stretch.begin(), stretch.end());
    }
  }
  for (auto& [knot, members] : classes) {
    std::sort(members.begin(), members.end());
    members.erase(std::unique(members.begin(), members.end()), members.end());
    if (members.size() <= kMostClasses) {
      untie(members, stretches[knot]);
    } else {
      for (const std::uint32_t member : members) {
        open_[member] = 1;
      }
    }
  }
}

void ClosedUnions::untie(std::span<const std::uint32_t> classes,
                         std::span<const std::vector<std::uint32_t>* const> stretches) {
  const auto bit = [&](std::uint32_t member) {
    return std::uint64_t{1} << (std::lower_bound(classes.begin(), classes.end(), member) -
                                classes.begin());
  };
  // Row k, if there is one, is the only one with bit k.
  std::array<std::uint64_t, kMostClasses> rows{};
  for (const auto* const stretch : stretches) {
    std::uint64_t row = 0;
    for (const std::uint32_t member : *stretch) {
      row ^= bit(member);
    }
    for (std::size_t k = 0; k < classes.size(); ++k) {
      row ^= (row >> k & 1) != 0 ? rows[k] : 0;
    }
    if (row == 0) {
      continue;
    }
    std::size_t lowest = 0;
    while ((row >> lowest & 1) == 0) {
      ++lowest;
    }
    for (std::uint64_t& other : rows) {
      other ^= (other >> lowest & 1) != 0 ? row : 0;
    }
    rows[lowest] = row;
  }
  std::vector<std::uint64_t> closed;  // from each class without a row, the least union with it
  for (std::size_t k = 0; k < classes.size(); ++k) {
    if (rows[k] == 0) {
      std::uint64_t members = std::uint64_t{1} << k;
      for (std::size_t j = 0; j < classes.size(); ++j) {
        members |= (rows[j] >> k & 1) << j;
      }
      closed.push_back(members);
    }
  }
  std::uint64_t in_one = 0;
  for (const std::uint64_t members : closed) {
    const auto meets = [&](std::uint64_t other) { return (other & members) != 0; };
    if (std::count_if(closed.begin(), closed.end(), meets) != 1) {
      continue;
    }
    in_one |= members;
    std::uint32_t first = 0;
    bool any = false;
    for (std::size_t k = 0; k < classes.size(); ++k) {
      if ((members >> k & 1) != 0) {
        first = any ? united(first, classes[k]) : classes[k];
        any = true;
      }
    }
  }
  for (std::size_t k = 0; k < classes.size(); ++k) {
    if ((in_one >> k & 1) == 0) {
      open_[classes_.find(classes[k])] = 1;
    }
  }
}

std::vector<std::vector<std::uint32_t>> ClosedUnions::solve() {
  settle();
  untie();
  std::map<std::uint32_t, std::vector<std::uint32_t>> unions;
  for (std::uint32_t k = 0; k < open_.size(); ++k) {
    const std::uint32_t first = classes_.find(k);
    if (open_[first] == 0) {
      unions[first].push_back(k);
    }
  }
  std::vector<std::vector<std::uint32_t>> found;
  found.reserve(unions.size());
  for (auto& [first, members] : unions) {
    found.push_back(std::move(members));
  }
  return found;
}

}  // namespace soms::detail
