#include "soms/tree/layout/detail/wide_tree.h"

#include "soms/base/arithmetic.h"
#include "soms/base/parallel.h"
#include "soms/tree/layout/detail/compact_node.h"
#include "soms/tree/layout/detail/refit_layout.h"
#include "soms/tree/layout/detail/widen.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

namespace soms {

namespace {

// Between these, products of five lengths neither overflow a float nor lose what matters in it.
constexpr double kLeastUsualSize = 0x1p-20;
constexpr double kMostUsualSize = 0x1p20;
constexpr int kMostExponent = 1000;  // 2^1000 is a double, and 2^300 times 2^-1000 is too

int exponent_for(double size) {
  if (size == 0 || (size >= kLeastUsualSize && size <= kMostUsualSize)) {
    return 0;
  }
  return std::min(kMostExponent, -std::ilogb(size));
}

/// Half the area of a node's lanes.
double area_of_boxes(const WideNode& node) {
  double sum = 0;
  for (std::size_t k = 0; k < node.count; ++k) {
    const double x = node.half[0][k];
    const double y = node.half[1][k];
    const double z = node.half[2][k];
    sum += (x * y + y * z) + z * x;
  }
  return 4 * sum;
}

double area_of_triangles(const TriangleBlock& block) {
  constexpr std::size_t kLanes = TriangleBlock::kWidth;
  const auto& q = block.corner;
  std::array<float, kLanes> area;
  for (std::size_t k = 0; k < kLanes; ++k) {
    const float ux = q[3][k] - q[0][k];
    const float uy = q[4][k] - q[1][k];
    const float uz = q[5][k] - q[2][k];
    const float vx = q[6][k] - q[0][k];
    const float vy = q[7][k] - q[1][k];
    const float vz = q[8][k] - q[2][k];
    const float x = uy * vz - uz * vy;
    const float y = uz * vx - ux * vz;
    const float z = ux * vy - uy * vx;
    area[k] = std::sqrt((x * x + y * y) + z * z);
  }
  double sum = 0;
  for (std::size_t k = 0; k < block.count; ++k) {
    sum += static_cast<double>(area[k]);
  }
  return 0.5 * sum;
}

/// Sum over all places, in chunks whose sums are added in order.
template <class Place>
double sum_of(std::span<const Place> places, double (*area)(const Place&), const Limits& limits) {
  constexpr std::size_t kPlacesPerChunk = 4096;
  std::vector<double> sums((places.size() + kPlacesPerChunk - 1) / kPlacesPerChunk, 0.0);
  for_each_chunk(places.size(), kPlacesPerChunk, limits, [&](std::size_t begin, std::size_t end) {
    double sum = 0;
    for (const Place& place : places.subspan(begin, end - begin)) {
      sum += area(place);
    }
    sums[begin / kPlacesPerChunk] = sum;
  });
  return std::accumulate(sums.begin(), sums.end(), 0.0);
}

}  // namespace

WideTree::WideTree(const Tree& tree, const MeshView& mesh, const Limits& limits) {
  if (!tree.nodes.empty()) {
    *this = WideTree(layout::parts_of(tree), mesh, limits);
  }
}

WideTree::WideTree(const layout::Parts& tree, const MeshView& mesh, const Limits& limits)
    : bounds_(tree.bounds) {
  const PlainArithmetic plain;
  const double size = settle();
  layout::Laid laid = layout::widen(tree, mesh, {origin_, scale_, size}, limits);
  nodes_ = std::move(laid.nodes);
  blocks_ = std::move(laid.blocks);
  least_ids_ = std::move(laid.least_ids);
  make_plan(limits);
}

WideTree::WideTree(const WideTree& tree, const MeshView& mesh, const Limits& limits) {
  const PlainArithmetic plain;
  if (tree.compact_) {
    *this = WideTree(tree.expanded(mesh, limits), mesh, limits).compacted(limits);
  } else if (!tree.nodes_.empty()) {
    bounds_ = layout::bounds_of(mesh, limits);
    const double size = settle();
    nodes_.resize(tree.nodes_.size());
    blocks_.resize(tree.blocks_.size());
    owner_ = tree.owner_;
    least_ids_ = tree.least_ids_;
    layout::refit_layout(tree, mesh, {origin_, scale_, size}, limits, nodes_.own(), blocks_.own());
    make_plan(limits);
  }
}

WideTree::WideTree(const LayoutArrays& arrays, std::shared_ptr<const void> owner)
    : owner_(std::move(owner)),
      nodes_(layout::Stored<WideNode>::borrowed(arrays.nodes)),
      blocks_(layout::Stored<TriangleBlock>::borrowed(arrays.blocks)),
      least_ids_(layout::Stored<TriangleId>::borrowed(arrays.least_ids)),
      bounds_(arrays.bounds) {
  const PlainArithmetic plain;
  if (arrays.nodes.empty() && arrays.compact_nodes.empty()) {
    return;
  }
  static_cast<void>(settle());
  if (!arrays.cells.empty()) {
    min_max_grid_ = layout::MinMaxGrid(arrays.plan, arrays.cells);
    start_nodes_ = layout::StartNodes(arrays.plan, arrays.list_ends, arrays.list_nodes);
  }
  if (!arrays.compact_nodes.empty()) {
    auto parts = std::make_shared<CompactParts>();
    parts->nodes = layout::Stored<CompactNode>::borrowed(arrays.compact_nodes);
    parts->ids = layout::Stored<std::uint32_t>::borrowed(arrays.compact_ids);
    compact_ = std::move(parts);
  }
}

LayoutArrays WideTree::arrays() const {
  LayoutArrays arrays;
  arrays.nodes = nodes_;
  arrays.blocks = blocks_;
  arrays.least_ids = least_ids_;
  arrays.cells = min_max_grid_.cells();
  arrays.list_ends = start_nodes_.ends();
  arrays.list_nodes = start_nodes_.nodes();
  arrays.plan = min_max_grid_.plan();
  arrays.bounds = bounds_;
  if (compact_) {
    arrays.compact_nodes = compact_->nodes;
    arrays.compact_ids = compact_->ids;
  }
  return arrays;
}

void WideTree::make_plan(const Limits& limits) {
  min_max_grid_ = layout::MinMaxGrid(blocks_, bounds_, scale_, limits);
  if (!min_max_grid_.empty()) {
    start_nodes_ = layout::StartNodes(nodes_, min_max_grid_.plan(), scale_);
  }
}

double WideTree::settle() {
  origin_ = bounds_.center();
  const Vec3 extent = bounds_.extent();
  const double size = std::max({extent.x, extent.y, extent.z});
  exponent_ = exponent_for(size);
  scale_ = std::ldexp(1.0, exponent_);
  return size * scale_;
}

double WideTree::sah_area_ratio(const MeshView& mesh, const Limits& limits) const {
  const PlainArithmetic plain;
  if (compact_) {
    return expanded(mesh, limits).sah_area_ratio(mesh, limits);
  }
  const Limits silent = limits.silent();
  const double boxes = sum_of<WideNode>(nodes_, &area_of_boxes, silent);
  const double triangles = sum_of<TriangleBlock>(blocks_, &area_of_triangles, silent);
  return settled(triangles > 0 ? boxes / triangles : 0);
}

std::size_t WideTree::memory() const {
  return sizeof *this + nodes_.memory() + blocks_.memory() + least_ids_.memory() +
         min_max_grid_.memory() + start_nodes_.memory() +
         (compact_ ? sizeof *compact_ + compact_->nodes.memory() + compact_->ids.memory() : 0);
}

}  // namespace soms
