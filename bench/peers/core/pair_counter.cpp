#include "bench/peers/core/pair_counter.h"

#include "soms/geometry/triangle_overlap.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace soms::bench {

namespace {

constexpr double kMostCells = 512;  // of one triangle; larger ones are queried by all

Triangle moved(const Pose& pose, const Triangle& t) {
  return {pose.apply(t.a), pose.apply(t.b), pose.apply(t.c)};
}

/// One and a half times the mean longest side of the triangles' boxes.
double cell_side(std::span<const Box> boxes) {
  double sum = 0;
  for (const Box& box : boxes) {
    const Vec3 e = box.extent();
    sum += std::max({e.x, e.y, e.z});
  }
  const double mean = boxes.empty() ? 1 : sum / static_cast<double>(boxes.size());
  return mean > 0 ? 1.5 * mean : 1;
}

}  // namespace

std::size_t PairCounter::CellHash::operator()(const Cell& c) const {
  std::uint64_t h = static_cast<std::uint64_t>(c.x) * 0x9e3779b97f4a7c15ULL;
  h = (h ^ (h >> 29)) + static_cast<std::uint64_t>(c.y) * 0xbf58476d1ce4e5b9ULL;
  h = (h ^ (h >> 31)) + static_cast<std::uint64_t>(c.z) * 0x94d049bb133111ebULL;
  return h ^ (h >> 30);
}

PairCounter::Cell PairCounter::cell_of(const Vec3& p) const {
  const auto index = [this](double v, double lower) {
    return static_cast<std::int64_t>(std::floor((v - lower) / side_));
  };
  return {index(p.x, bounds_.lower.x), index(p.y, bounds_.lower.y), index(p.z, bounds_.lower.z)};
}

template <class Visit>
void PairCounter::each_cell(const Box& box, const Visit& visit) const {
  const Cell from = cell_of(box.lower);
  const Cell to = cell_of(box.upper);
  for (std::int64_t x = from.x; x <= to.x; ++x) {
    for (std::int64_t y = from.y; y <= to.y; ++y) {
      for (std::int64_t z = from.z; z <= to.z; ++z) {
        visit(Cell{x, y, z});
      }
    }
  }
}

PairCounter::PairCounter(const FloatMesh& mover, const FloatMesh& fixed)
    : mover_(mover), fixed_(fixed) {
  for (std::size_t i = 0; i < fixed_.triangles.size(); ++i) {
    boxes_.push_back(bounds(fixed_.triangle(i)));
    bounds_.grow(boxes_.back());
  }
  side_ = cell_side(boxes_);
  for (std::uint32_t i = 0; i < boxes_.size(); ++i) {
    const Vec3 e = boxes_[i].extent();
    if ((e.x / side_ + 1) * (e.y / side_ + 1) * (e.z / side_ + 1) > kMostCells) {
      large_.push_back(i);
    } else {
      each_cell(boxes_[i], [&](const Cell& cell) { cells_[cell].push_back(i); });
    }
  }
}

/// Fixed triangles of the cells that a box reaches into, each once. Where these are more than there
/// are triangles, as of a large triangle over a fine mesh, it is sooner to take all.
std::vector<std::uint32_t> PairCounter::candidates(const Box& box) const {
  const Vec3 e = box.extent();
  const double cells = (e.x / side_ + 1) * (e.y / side_ + 1) * (e.z / side_ + 1);
  std::vector<std::uint32_t> near;
  if (cells > static_cast<double>(boxes_.size())) {
    near.resize(boxes_.size());
    std::iota(near.begin(), near.end(), 0U);
    return near;
  }
  near = large_;
  each_cell(box, [&](const Cell& cell) {
    const auto there = cells_.find(cell);
    if (there != cells_.end()) {
      near.insert(near.end(), there->second.begin(), there->second.end());
    }
  });
  std::sort(near.begin(), near.end());
  near.erase(std::unique(near.begin(), near.end()), near.end());
  return near;
}

template <class Visit>
void PairCounter::each_pair(const Pose& pose, const Visit& visit) const {
  for (std::uint32_t i = 0; i < mover_.triangles.size(); ++i) {
    const Triangle t = moved(pose, mover_.triangle(i));
    const Box box = bounds(t);
    if (!overlaps(box, bounds_)) {
      continue;
    }
    // Only cells within the fixed body's bounds hold anything.
    const Box inside{
        {std::max(box.lower.x, bounds_.lower.x), std::max(box.lower.y, bounds_.lower.y),
         std::max(box.lower.z, bounds_.lower.z)},
        {std::min(box.upper.x, bounds_.upper.x), std::min(box.upper.y, bounds_.upper.y),
         std::min(box.upper.z, bounds_.upper.z)}};
    for (const std::uint32_t k : candidates(inside)) {
      if (overlaps(box, boxes_[k]) && triangles_overlap(t, fixed_.triangle(k)) &&
          !visit(Pair{i, k})) {
        return;
      }
    }
  }
}

std::uint64_t PairCounter::count(const Pose& pose, bool any) const {
  std::uint64_t found = 0;
  each_pair(pose, [&](const Pair&) {
    ++found;
    return !any;
  });
  return found;
}

std::vector<PairCounter::Pair> PairCounter::pairs(const Pose& pose) const {
  std::vector<Pair> found;
  each_pair(pose, [&](const Pair& pair) {
    found.push_back(pair);
    return true;
  });
  return found;
}

}  // namespace soms::bench
