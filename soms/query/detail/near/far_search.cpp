#include "soms/query/detail/near/far_search.h"

#include "soms/query/detail/leaf_pairs.h"
#include "soms/query/detail/near/direction.h"
#include "soms/query/detail/near/far_support.h"

#include <algorithm>
#include <limits>

namespace soms::detail {

namespace {

/// The least of `sign` times the places of a triangle's points along `n`.
double least_along(const Vec3& n, double sign, const Triangle& t) {
  return std::min({sign * dot(n, t.a), sign * dot(n, t.b), sign * dot(n, t.c)});
}

Vec3 middle(const Triangle& t) {
  return (t.a * (1.0 / 3) + t.b * (1.0 / 3)) + t.c * (1.0 / 3);
}

}  // namespace

template <class Source>
FarSearch<Source>::FarSearch(const PairFrame& frame, NearGoal& goal)
    : frame_(frame),
      goal_(goal),
      x_{&frame.x(), Source(*frame.x().shape), 1},
      y_{&frame.y(), Source(*frame.y().shape), -1},
      direction_(direction(place_of(frame.x(), {}) - place_of(frame.y(), {}))),
      slack_(kFarRounding * (moved_extent(*frame.x().pose, frame.x().layout().bounds()) +
                             moved_extent(*frame.y().pose, frame.y().layout().bounds())) +
             kFarUnderflow) {
}

template <class Source>
void FarSearch<Source>::open(Side& side, std::uint32_t node, double most) {
  const WideNode& here = side.source.node(node);
  const double scale = side.body->layout().scale();
  const double place = side.sign * dot(direction_, place_of(*side.body, here.origin));
  const double margin = slack_ + (kFarBoxes * here.l1_radius + 0x1p-100) / scale;
  const auto least = supports(here, seen(*side.body->pose, direction_, axes_of(here)),
                              static_cast<float>(side.sign));
  cost_.node_tests += here.count;
  for (std::size_t k = 0; k < here.count; ++k) {
    const double reach = place + static_cast<double>(least[k]) / scale - margin;
    if (reach > most) {
      continue;
    }
    if ((here.leaves >> k & 1U) != 0) {
      leaves_.push_back(here.child[k]);
    } else {
      nodes_.push_back({reach, here.child[k]});
      std::push_heap(nodes_.begin(), nodes_.end(),
                     [](const Reach& a, const Reach& b) { return b < a; });
    }
  }
}

template <class Source>
template <class Take>
void FarSearch<Source>::look_at_leaf(Side& side, std::uint32_t token, const Take& take) {
  for (;; token = side.source.next(token)) {
    const TriangleBlock& block = side.source.block(token);
    const bool last = block.following == 0;
    cost_.triangle_tests += block.count;
    for (std::size_t k = 0; k < block.count; ++k) {
      const TriangleId id = block.id[k];
      take(Reach{least_along(direction_, side.sign, moved(*side.body, id)), id});
    }
    if (last) {
      return;
    }
  }
}

template <class Source>
bool FarSearch<Source>::find_least(Side& side, Limit& limit, Reach& least) {
  least = {std::numeric_limits<double>::infinity(), 0};
  std::size_t looks = 0;
  nodes_.assign(1, {-std::numeric_limits<double>::infinity(), 0});
  while (!nodes_.empty()) {
    const Reach next = nodes_.front();
    std::pop_heap(nodes_.begin(), nodes_.end(),
                  [](const Reach& a, const Reach& b) { return b < a; });
    nodes_.pop_back();
    if (next.least > least.least) {
      return true;
    }
    leaves_.clear();
    open(side, next.id, least.least);
    for (const std::uint32_t token : leaves_) {
      look_at_leaf(side, token, [&](const Reach& here) {
        least = std::min(least, here);
        ++looks;
      });
    }
    if (looks > kLooks || limit.spend(4 + 8 * leaves_.size())) {
      return false;
    }
  }
  return true;
}

template <class Source>
bool FarSearch<Source>::collect(Side& side, double most, Limit& limit, std::vector<Reach>& found) {
  found.clear();
  nodes_.assign(1, {-std::numeric_limits<double>::infinity(), 0});
  while (!nodes_.empty()) {
    const std::uint32_t node = nodes_.back().id;
    nodes_.pop_back();
    leaves_.clear();
    open(side, node, most);
    for (const std::uint32_t token : leaves_) {
      look_at_leaf(side, token, [&](const Reach& here) {
        if (!(here.least > most)) {
          found.push_back(here);
        }
      });
      if (found.size() > kTriangles) {
        return false;
      }
    }
    if (limit.spend(4 + 8 * leaves_.size())) {
      return false;
    }
  }
  std::sort(found.begin(), found.end());
  return true;
}

template <class Source>
double FarSearch<Source>::lower_bound(const TrianglePair& ids) const {
  const Triangle x = moved(*x_.body, ids.a);
  const Triangle y = moved(*y_.body, ids.b);
  const Vec3 n = direction(middle(x) - middle(y));
  return least_along(n, 1, x) + least_along(n, -1, y) - slack_;
}

template <class Source>
bool FarSearch<Source>::pair_up(const std::vector<Reach>& of_x, const std::vector<Reach>& of_y) {
  candidates_.clear();
  std::size_t pairs = 0;
  for (const Reach& x : of_x) {
    for (const Reach& y : of_y) {
      if (x.least + y.least > most()) {
        break;
      }
      if (++pairs > kPairs) {
        return false;
      }
      ++cost_.triangle_tests;
      const TrianglePair ids = {x.id, y.id};
      const double lower = lower_bound(ids);
      if (!(lower > goal_.upper())) {
        candidates_.push_back({lower, ids});
      }
    }
  }
  std::sort(candidates_.begin(), candidates_.end());
  return true;
}

template <class Source>
bool FarSearch<Source>::run(Limit& limit) {
  Reach least_x;
  Reach least_y;
  if (!find_least(x_, limit, least_x) || !find_least(y_, limit, least_y)) {
    return false;
  }
  if (least_x.least + least_y.least > most()) {
    return true;
  }
  if (goal_.offer({least_x.id, least_y.id}, cost_)) {
    return true;
  }
  std::vector<Reach> of_x;
  std::vector<Reach> of_y;
  if (!collect(x_, most() - least_y.least, limit, of_x) ||
      !collect(y_, most() - least_x.least, limit, of_y) || !pair_up(of_x, of_y)) {
    return false;
  }
  for (const Candidate& candidate : candidates_) {
    if (candidate.lower > goal_.upper() || goal_.offer(candidate.ids, cost_)) {
      return true;
    }
    if (limit.spend(32)) {
      return false;
    }
  }
  return true;
}

template class FarSearch<WideSource>;
template class FarSearch<CompactSource>;

}  // namespace soms::detail
