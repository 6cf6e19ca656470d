#include "soms/tree/rule/rules.h"

namespace soms::rule {

namespace {

/// A triangle wider than this share of the inner box lies on both sides of the middle plane, or
/// nearly: whichever child gets it, the children's boxes overlap by much.
constexpr double kWideShare = 0.5;

/// The greatest width of a primitive's box on the axis.
double widest(const SplitNode& node, std::size_t axis) {
  float width = 0;
  for (const Primitive& p : node.primitives) {
    const float w = p.below[axis] + p.above[axis];
    width = w > width ? w : width;
  }
  return static_cast<double>(width) * node.unit;
}

}  // namespace

Split soms_sah(const SplitNode& node, std::size_t axis) {
  return widest(node, axis) > kWideShare * node.inner.extent()[axis] ? sah(node, axis)
                                                                     : soms(node, axis);
}

}  // namespace soms::rule
