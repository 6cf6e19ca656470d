#include "soms/query/detail/ray/crossings.h"

#include "soms/query/detail/moved_triangle.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <span>
#include <utility>

namespace soms::detail {

namespace {

/// A triangle among those whose times floats cannot part.
struct Candidate {
  TriangleId id;
  Triangle triangle;
  ExactRay exact;
};

/// Corners of a feature that holds the point: what connected triangles have in common.
struct SharedFeature {
  std::array<Vec3, 3> corner;  // the least first; those not used repeat the last one
  std::size_t owner;
};

bool before(const Vec3& a, const Vec3& b) {
  return a.x != b.x ? a.x < b.x : a.y != b.y ? a.y < b.y : a.z < b.z;
}

bool before(const SharedFeature& a, const SharedFeature& b) {
  return std::lexicographical_compare(a.corner.begin(), a.corner.end(), b.corner.begin(),
                                      b.corner.end(),
                                      [](const Vec3& p, const Vec3& q) { return before(p, q); });
}

SharedFeature shared(const Triangle& t, Feature feature, std::size_t owner) {
  SharedFeature shared{{}, owner};
  std::size_t count = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    if ((feature >> i & 1) == 0) {
      continue;
    }
    std::size_t at = count++;
    for (; at > 0 && before(corner(t, i), shared.corner[at - 1]); --at) {
      shared.corner[at] = shared.corner[at - 1];
    }
    shared.corner[at] = corner(t, i);
  }
  for (std::size_t i = count; i < 3; ++i) {
    shared.corner[i] = shared.corner[count - 1];
  }
  return shared;
}

std::size_t root_of(std::vector<std::size_t>& parent, std::size_t i) {
  while (parent[i] != i) {
    parent[i] = parent[parent[i]];
    i = parent[i];
  }
  return i;
}

/// The least place of each candidate's crossing.
std::vector<std::size_t> connected(std::span<const Candidate> at_one_time) {
  std::vector<SharedFeature> features;
  for (std::size_t i = 0; i < at_one_time.size(); ++i) {
    for (const Feature f : at_one_time[i].exact.features()) {
      if (f != 0) {
        features.push_back(shared(at_one_time[i].triangle, f, i));
      }
    }
  }
  std::sort(features.begin(), features.end(),
            [](const SharedFeature& a, const SharedFeature& b) { return before(a, b); });
  std::vector<std::size_t> parent(at_one_time.size());
  std::iota(parent.begin(), parent.end(), std::size_t{0});
  for (std::size_t k = 1; k < features.size(); ++k) {
    if (features[k].corner == features[k - 1].corner) {
      const std::size_t a = root_of(parent, features[k - 1].owner);
      const std::size_t b = root_of(parent, features[k].owner);
      parent[std::max(a, b)] = std::min(a, b);
    }
  }
  for (std::size_t i = 0; i < parent.size(); ++i) {
    parent[i] = root_of(parent, i);
  }
  return parent;
}

CrossingKind kind_of(int fronts, int backs) {
  return (fronts + backs) % 2 == 0 ? CrossingKind::graze
         : fronts > backs          ? CrossingKind::enter
                                   : CrossingKind::leave;
}

/// Crossings of triangles met at one time, by their least triangles.
void form(std::span<const Candidate> at_one_time, RayRow& row) {
  const std::vector<std::size_t> crossing = connected(at_one_time);
  const Bracket t = bracket(at_one_time[0].exact.time());
  for (std::size_t i = 0; i < crossing.size(); ++i) {
    if (crossing[i] != i) {
      continue;
    }
    FoundCrossing found{.t = t};
    int fronts = 0;
    int backs = 0;
    for (std::size_t k = i; k < crossing.size(); ++k) {
      if (crossing[k] != i) {
        continue;
      }
      row.triangles.push_back(at_one_time[k].id);
      ++found.triangles;
      if (at_one_time[k].exact.crossed_beside()) {
        ++(at_one_time[k].exact.side() > 0 ? fronts : backs);
      }
    }
    found.kind = kind_of(fronts, backs);
    row.crossings.push_back(found);
  }
}

/// Triangles whose times only whole numbers can part.
void form_exactly(const Body& body, const RayLine& line, std::span<const FoundHit> found,
                  RayRow& row, Cost& cost) {
  std::vector<Candidate> candidates;
  candidates.reserve(found.size());
  for (const FoundHit& hit : found) {
    const Triangle triangle = moved_triangle(body, hit.id);
    candidates.push_back({hit.id, triangle, ExactRay(line, triangle)});
    cost.exact_tests += hit.inside ? 1U : 0U;  // others were counted when they were found
  }
  std::sort(candidates.begin(), candidates.end(), [](const Candidate& a, const Candidate& b) {
    const auto order = compare(a.exact.time(), b.exact.time());
    return order != 0 ? order < 0 : a.id < b.id;
  });
  for (std::size_t begin = 0; begin < candidates.size();) {
    std::size_t end = begin + 1;
    while (end < candidates.size() &&
           compare(candidates[begin].exact.time(), candidates[end].exact.time()) == 0) {
      ++end;
    }
    form(std::span(candidates).subspan(begin, end - begin), row);
    begin = end;
  }
}

}  // namespace

void form_crossings(const Body& body, const RayLine& line, const ScaledDirection& direction,
                    std::vector<FoundHit>& found, RayRow& row, Cost& cost) {
  std::sort(found.begin(), found.end(), [](const FoundHit& a, const FoundHit& b) {
    return a.bounds.lower < b.bounds.lower || (a.bounds.lower == b.bounds.lower && a.id < b.id);
  });
  for (std::size_t begin = 0; begin < found.size();) {
    std::size_t end = begin + 1;
    double upper = found[begin].bounds.upper;
    while (end < found.size() && !(found[end].bounds.lower > upper)) {
      upper = std::max(upper, found[end++].bounds.upper);
    }
    const FoundHit& first = found[begin];
    std::optional<PlaneHit> hit;
    if (end == begin + 1 && first.inside) {
      hit = plane_hit(line, direction, moved_triangle(body, first.id));
    }
    if (hit) {
      row.crossings.push_back(
          {hit->t, first.bounds.side > 0 ? CrossingKind::enter : CrossingKind::leave, 1});
      row.triangles.push_back(first.id);
    } else {
      form_exactly(body, line, std::span(found).subspan(begin, end - begin), row, cost);
    }
    begin = end;
  }
}

}  // namespace soms::detail
