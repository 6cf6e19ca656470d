#include "soms/tree/layout/wide_tree.h"

#include "soms/tree/layout/detail/widen.h"

#include <algorithm>
#include <cmath>

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

}  // namespace

WideTree::WideTree(const Tree& tree, const Mesh& mesh, const Parallel& parallel) {
  if (!tree.nodes.empty()) {
    *this = WideTree(layout::parts_of(tree), mesh, parallel);
  }
}

WideTree::WideTree(const layout::Parts& tree, const Mesh& mesh, const Parallel& parallel)
    : bounds_(tree.upper.front().bounds) {
  origin_ = bounds_.center();
  const Vec3 extent = bounds_.extent();
  const double size = std::max({extent.x, extent.y, extent.z});
  exponent_ = exponent_for(size);
  scale_ = std::ldexp(1.0, exponent_);
  layout::widen(tree, mesh, {origin_, scale_, size * scale_}, parallel, nodes_, blocks_);
}

std::size_t WideTree::memory() const {
  return sizeof *this + nodes_.capacity() * sizeof(WideNode) +
         blocks_.capacity() * sizeof(TriangleBlock);
}

}  // namespace soms
