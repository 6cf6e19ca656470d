#include "soms/geometry/detail/parts/part_groups.h"

#include "soms/geometry/detail/parts/closed_unions.h"
#include "soms/geometry/detail/parts/disjoint_sets.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <map>
#include <numeric>
#include <utility>

namespace soms::detail {

namespace {

/// Parts that are nested deeper are compared with those of the whole mesh alone.
constexpr std::size_t kDeepest = 64;

/// Numbers of open parts.
using Numbers = std::vector<std::uint32_t>;

/// Some open parts' edges, and which line each is on.
struct EdgesOnLines {
  std::vector<Segment> segments;
  Numbers owners;
  Numbers lines;
  Numbers order;  ///< of segments, by line
};

EdgesOnLines on_lines(std::span<const OpenPart> parts, const Numbers& numbers) {
  EdgesOnLines edges;
  for (std::uint32_t k = 0; k < numbers.size(); ++k) {
    for (const Segment& segment : parts[numbers[k]].edges) {
      edges.segments.push_back(segment);
      edges.owners.push_back(k);
    }
  }
  edges.lines = lines_of(edges.segments);
  edges.order.resize(edges.segments.size());
  std::iota(edges.order.begin(), edges.order.end(), 0U);
  std::sort(edges.order.begin(), edges.order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return std::pair(edges.lines[a], a) < std::pair(edges.lines[b], b);
  });
  return edges;
}

/// Visits the sets of owners, sorted, that cover a stretch of a line an odd number of times.
template <class Visit>
void for_each_stretch(const EdgesOnLines& edges, std::span<const std::uint32_t> on_one_line,
                      const Visit& visit) {
  const Segment& first = edges.segments[on_one_line.front()];
  const std::size_t axis = leading_axis(first[0], first[1]);
  std::vector<std::pair<double, std::uint32_t>> ends;
  for (const std::uint32_t k : on_one_line) {
    for (const Vec3& end : edges.segments[k]) {
      ends.emplace_back(end[axis] + 0.0, edges.owners[k]);  // -0 is 0
    }
  }
  std::sort(ends.begin(), ends.end());
  Numbers covering;
  for (std::size_t k = 0; k < ends.size(); ++k) {
    const auto [place, owner] = ends[k];
    const auto at = std::lower_bound(covering.begin(), covering.end(), owner);
    if (at != covering.end() && *at == owner) {
      covering.erase(at);
    } else {
      covering.insert(at, owner);
    }
    const bool more_here = k + 1 < ends.size() && ends[k + 1].first == place;
    if (!more_here && !covering.empty()) {
      visit(covering);
    }
  }
}

template <class Visit>
void for_each_stretch(std::span<const OpenPart> parts, const Numbers& numbers, const Visit& visit) {
  const EdgesOnLines edges = on_lines(parts, numbers);
  for (std::size_t begin = 0; begin < edges.order.size();) {
    std::size_t end = begin + 1;
    while (end < edges.order.size() &&
           edges.lines[edges.order[end]] == edges.lines[edges.order[begin]]) {
      ++end;
    }
    for_each_stretch(edges, std::span(edges.order).subspan(begin, end - begin), visit);
    begin = end;
  }
}

bool cover_evenly(std::span<const OpenPart> parts, const Numbers& numbers) {
  std::vector<Segment> segments;
  for (const std::uint32_t k : numbers) {
    segments.insert(segments.end(), parts[k].edges.begin(), parts[k].edges.end());
  }
  return covers_evenly(segments);
}

/// Parts that are not in a group yet, and those that are.
class Grouping {
 public:
  Grouping(const MeshView& mesh, std::span<const OpenPart> parts)
      : mesh_(mesh), parts_(parts), done_(parts.size(), 0), tried_(parts.size(), 1) {}

  std::vector<PartGroup> find() {
    find_in_objects();
    Numbers all(parts_.size());
    std::iota(all.begin(), all.end(), 0U);
    close(all);
    join_open(all);
    std::sort(groups_.begin(), groups_.end(), [](const PartGroup& a, const PartGroup& b) {
      return a.parts.front() < b.parts.front();
    });
    return std::move(groups_);
  }

 private:
  /// The objects around a part, and itself: the outermost first. Empty if they are too many.
  [[nodiscard]] Numbers objects_around(std::uint32_t part) const {
    Numbers path;
    for (; part != Part::kNoParent; part = mesh_.parts[part].parent) {
      if (path.size() == kDeepest) {
        return {};
      }
      path.push_back(part);
    }
    std::reverse(path.begin(), path.end());
    return path;
  }

  void find_in_objects() {
    std::vector<Numbers> paths;
    std::size_t deepest = 0;
    for (const OpenPart& part : parts_) {
      paths.push_back(objects_around(part.part));
      deepest = std::max(deepest, paths.back().size());
    }
    for (std::size_t depth = deepest; depth > 0; --depth) {
      std::map<std::uint32_t, Numbers> held;
      for (std::uint32_t k = 0; k < paths.size(); ++k) {
        if (paths[k].size() >= depth) {
          held[paths[k][depth - 1]].push_back(k);
        }
      }
      for (const auto& [object, numbers] : held) {
        close(numbers);
      }
    }
  }

  /// Makes groups of those of some parts that close each other.
  void close(const Numbers& among) {
    Numbers left;
    std::copy_if(among.begin(), among.end(), std::back_inserter(left),
                 [&](std::uint32_t k) { return done_[k] == 0; });
    // From object to object there are more: as many as were left before are the same.
    if (left.size() < 2 || tried_[left.front()] == left.size()) {
      return;
    }
    ClosedUnions unions(left.size());
    for_each_stretch(parts_, left, [&](const Numbers& stretch) { unions.add(stretch); });
    for (const Numbers& found : unions.solve()) {
      Numbers numbers;
      for (const std::uint32_t k : found) {
        numbers.push_back(left[k]);
      }
      if (cover_evenly(parts_, numbers)) {
        add(numbers, true);
      }
    }
    std::erase_if(left, [&](std::uint32_t k) { return done_[k] != 0; });
    for (const std::uint32_t k : left) {
      tried_[k] = left.size();
    }
  }

  /// Makes groups of those that are left.
  void join_open(const Numbers& all) {
    Numbers left;
    std::copy_if(all.begin(), all.end(), std::back_inserter(left),
                 [&](std::uint32_t k) { return done_[k] == 0; });
    DisjointSets sets(left.size());
    for_each_stretch(parts_, left, [&](const Numbers& stretch) {
      for (const std::uint32_t k : stretch) {
        sets.unite(stretch.front(), k);
      }
    });
    std::map<std::uint32_t, Numbers> groups;
    for (std::uint32_t k = 0; k < left.size(); ++k) {
      groups[sets.find(k)].push_back(left[k]);
    }
    for (const auto& [first, numbers] : groups) {
      add(numbers, false);
    }
  }

  void add(const Numbers& numbers, bool closed) {
    PartGroup group{.closed = closed};
    for (const std::uint32_t k : numbers) {
      done_[k] = 1;
      group.parts.push_back(parts_[k].part);
    }
    groups_.push_back(std::move(group));
  }

  MeshView mesh_;
  std::span<const OpenPart> parts_;
  std::vector<std::uint8_t> done_;
  std::vector<std::size_t> tried_;  ///< of each part, with how many it was left open
  std::vector<PartGroup> groups_;
};

}  // namespace

std::vector<PartGroup> groups_of_open(const MeshView& mesh, std::span<const OpenPart> parts) {
  return Grouping(mesh, parts).find();
}

}  // namespace soms::detail
