#include "soms/geometry/part_runs.h"

#include <algorithm>
#include <limits>
#include <set>
#include <utility>

namespace soms {

std::vector<PartRun> part_runs(const MeshView& mesh) {
  struct Event {
    std::size_t triangle = 0;
    std::uint32_t part = 0;
    bool begins = false;
  };

  std::vector<Event> events;
  for (std::uint32_t p = 0; p < mesh.parts.size(); ++p) {
    const Part& part = mesh.parts[p];
    if (part.count > 0) {
      events.push_back({part.first, p, true});
      events.push_back({std::size_t{part.first} + part.count, p, false});
    }
  }
  std::stable_sort(events.begin(), events.end(),
                   [](const Event& a, const Event& b) { return a.triangle < b.triangle; });
  // The innermost part is the one with the fewest triangles, the later one where two are equal.
  const auto rank = [&](std::uint32_t p) {
    return std::pair(mesh.parts[p].count, std::numeric_limits<std::uint32_t>::max() - p);
  };
  std::set<std::pair<std::uint32_t, std::uint32_t>> open;
  std::vector<PartRun> runs;
  if (!mesh.triangles.empty()) {
    runs.push_back({0, Part::kNoParent});
  }
  for (std::size_t i = 0; i < events.size();) {
    const std::size_t triangle = events[i].triangle;
    for (; i < events.size() && events[i].triangle == triangle; ++i) {
      if (events[i].begins) {
        open.insert(rank(events[i].part));
      } else {
        open.erase(rank(events[i].part));
      }
    }
    const std::uint32_t part =
        open.empty() ? Part::kNoParent
                     : std::numeric_limits<std::uint32_t>::max() - open.begin()->second;
    if (triangle == 0) {
      runs.clear();
    }
    if (triangle < mesh.triangles.size()) {
      runs.push_back({triangle, part});
    }
  }
  return runs;
}

}  // namespace soms
