#include "soms/query/detail/solid/edge_sums.h"

#include <algorithm>
#include <tuple>

namespace soms::detail {

namespace {

auto in_order(const Vec3& p) {
  return std::tie(p.x, p.y, p.z);
}

bool is_less(const PlanarEdge& a, const PlanarEdge& b) {
  return a.from == b.from ? in_order(a.to) < in_order(b.to) : in_order(a.from) < in_order(b.from);
}

}  // namespace

void EdgeSums::add(const Vec3& p, const Vec3& q, std::size_t body, CutKind kind) {
  if (p == q) {
    return;
  }
  const bool turned = in_order(q) < in_order(p);
  const unsigned bit = 1U << (2 * static_cast<unsigned>(kind) + static_cast<unsigned>(body));
  entries_.push_back({{turned ? q : p, turned ? p : q}, bit});
}

std::vector<PlanarEdge> EdgeSums::odd() {
  std::sort(entries_.begin(), entries_.end(),
            [](const Entry& a, const Entry& b) { return is_less(a.edge, b.edge); });
  std::vector<PlanarEdge> odd;
  for (auto first = entries_.begin(); first != entries_.end();) {
    unsigned kinds = 0;
    auto last = first;
    for (; last != entries_.end() && !is_less(first->edge, last->edge); ++last) {
      kinds ^= last->kinds;
    }
    if (kinds != 0) {
      odd.push_back(first->edge);
    }
    first = last;
  }
  return odd;
}

}  // namespace soms::detail
