#include "soms/query/detail/self/duplicates.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <tuple>

namespace soms::detail {

namespace {

/// Pairs listed between two looks at the stop.
constexpr std::size_t kLook = std::size_t{1} << 16;

struct NamedTriangle {
  CornerNames corners;  ///< in order, each once, then the first again
  TriangleId id;
};

NamedTriangle named(const SelfFrame& frame, TriangleId id) {
  CornerNames corners = frame.corners_of(id);
  std::sort(corners.begin(), corners.end());
  std::fill(std::unique(corners.begin(), corners.end()), corners.end(), corners[0]);
  return {corners, id};
}

}  // namespace

bool list_duplicates(const SelfFrame& frame, std::uint64_t limit, const Limits& limits,
                     std::vector<TrianglePair>& pairs) {
  const std::size_t count = frame.mesh().triangles.size();
  if (limits.late()) {
    return false;
  }
  std::vector<NamedTriangle> all(count);
  for (std::size_t i = 0; i < count; ++i) {
    all[i] = named(frame, static_cast<TriangleId>(i));
  }
  check_stop(limits);
  std::sort(all.begin(), all.end(), [](const NamedTriangle& a, const NamedTriangle& b) {
    return std::tie(a.corners, a.id) < std::tie(b.corners, b.id);
  });
  check_stop(limits);
  bool complete = true;
  for (std::size_t i = 0; i < count && complete; ++i) {
    for (std::size_t k = i + 1; k < count && all[k].corners == all[i].corners; ++k) {
      if (pairs.size() >= limit || limits.late()) {
        complete = false;
        break;
      }
      pairs.push_back({all[i].id, all[k].id});
      if (pairs.size() % kLook == 0) {
        check_stop(limits);
      }
    }
  }
  std::sort(pairs.begin(), pairs.end());
  return complete;
}

}  // namespace soms::detail
