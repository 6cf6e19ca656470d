#include "soms/query/detail/self/neighbor_queue.h"

#include <bit>

namespace soms::detail {

namespace {

constexpr std::size_t kLanes = TriangleBlock::kWidth;

/// Pairs of a block's lanes of which the second comes after the first.
constexpr std::uint64_t pairs_after() {
  std::uint64_t bits = 0;
  for (std::size_t i = 0; i < kLanes; ++i) {
    for (std::size_t k = i + 1; k < kLanes; ++k) {
      bits |= std::uint64_t{1} << (kLanes * i + k);
    }
  }
  return bits;
}

void put_corner(const Vec3& v, std::size_t corner, std::size_t lane, NeighborLanes& lanes) {
  for (std::size_t i = 0; i < 3; ++i) {
    lanes.corner[3 * corner + i][lane] = v[i];
  }
}

}  // namespace

NeighborQueue::NeighborQueue(const SelfFrame& frame, const Kernels& kernels)
    : frame_(&frame), at_corner_(kernels.apart_at_corner), at_edge_(kernels.apart_at_edge) {
}

bool NeighborQueue::take(const BlockTask& task, std::uint64_t& pairs, Collector& collector,
                         Cost& cost) {
  if (task.x->id[0] == task.y->id[0]) {
    pairs &= pairs_after();
  }
  if (pairs == 0) {
    return false;
  }
  std::array<CornerNames, kLanes> of_x;
  std::array<CornerNames, kLanes> of_y;
  for (std::size_t k = 0; k < kLanes; ++k) {
    of_x[k] = frame_->corners_of(task.x->id[k]);
    of_y[k] = frame_->corners_of(task.y->id[k]);
  }
  for (std::uint64_t left = pairs; left != 0; left &= left - 1) {
    const auto bit = static_cast<std::size_t>(std::countr_zero(left));
    const std::uint32_t common = common_corners(of_x[bit / kLanes], of_y[bit % kLanes]);
    if (common == 0) {
      continue;
    }
    pairs &= ~(std::uint64_t{1} << bit);
    if (take({task.x->id[bit / kLanes], task.y->id[bit % kLanes]}, common, collector, cost)) {
      return true;
    }
  }
  return false;
}

bool NeighborQueue::take(const TrianglePair& ids, std::uint32_t common, Collector& collector,
                         Cost& cost) {
  if (!collector.wants(frame_->in_callers_order(ids.a, ids.b))) {
    return false;
  }
  ++cost.triangle_tests;
  const CommonPlace& place = common_place(common);
  switch (place.kind) {
    case CommonPlace::Kind::nothing:
      return false;
    case CommonPlace::Kind::corner:
      put(ids, place, corners_);
      return corners_.count == NeighborLanes::kMost &&
             decide(at_corner_, corners_, collector, cost);
    case CommonPlace::Kind::edge:
      put(ids, place, edges_);
      return edges_.count == NeighborLanes::kMost && decide(at_edge_, edges_, collector, cost);
    case CommonPlace::Kind::duplicate:
      frame_->meet_duplicates();
      return false;
    case CommonPlace::Kind::unclear:
      return decide(ids, collector, cost);
  }
  return false;
}

void NeighborQueue::put(const TrianglePair& ids, const CommonPlace& place, Waiting& waiting) const {
  const CornerNames& a = frame_->mesh().triangles[ids.a];
  const CornerNames& b = frame_->mesh().triangles[ids.b];
  const std::span<const Vec3> vertices = frame_->mesh().vertices;
  const std::size_t lane = waiting.count++;
  waiting.ids[lane] = ids;
  const auto put = [&](std::size_t corner, std::uint32_t vertex) {
    put_corner(vertices[vertex], corner, lane, waiting.lanes);
  };
  const std::uint32_t next_a = a[(place.a + 1U) % 3];
  const std::uint32_t last_a = a[(place.a + 2U) % 3];
  if (place.kind == CommonPlace::Kind::edge) {
    put(0, next_a);
    put(1, last_a);
    put(2, a[place.a]);
    put(3, b[place.b]);
  } else {
    put(0, a[place.a]);
    put(1, next_a);
    put(2, last_a);
    put(3, b[(place.b + 1U) % 3]);
    put(4, b[(place.b + 2U) % 3]);
  }
}

bool NeighborQueue::decide(Collector& collector, Cost& cost) {
  return decide(at_corner_, corners_, collector, cost) || decide(at_edge_, edges_, collector, cost);
}

bool NeighborQueue::decide(Judge judge, Waiting& waiting, Collector& collector, Cost& cost) const {
  const std::size_t count = waiting.count;
  waiting.count = 0;
  if (count == 0) {
    return false;
  }
  for (std::uint32_t open = ~judge(waiting.lanes) & ((1U << count) - 1); open != 0;
       open &= open - 1) {
    if (decide(waiting.ids[static_cast<std::size_t>(std::countr_zero(open))], collector, cost)) {
      return true;
    }
  }
  return false;
}

bool NeighborQueue::decide(const TrianglePair& ids, Collector& collector, Cost& cost) const {
  const TrianglePair pair = frame_->in_callers_order(ids.a, ids.b);
  if (!collector.wants(pair)) {
    return false;
  }
  const Neighbors neighbors(frame_->corners_of(ids.a), frame_->corners_of(ids.b));
  if (neighbors.duplicate()) {
    frame_->meet_duplicates();
    return false;
  }
  ++cost.exact_tests;
  return neighbors.share_more(frame_->mesh().vertices) && collector.add(pair);
}

}  // namespace soms::detail
