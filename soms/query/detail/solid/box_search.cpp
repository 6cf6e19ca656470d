#include "soms/query/detail/solid/box_search.h"

#include "soms/query/detail/moved_triangle.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace soms::detail {

namespace {

// Constants of the proof in box_search.h.
constexpr double kBoxRounding = 128 * 0x1p-53;
constexpr double kBoxUnderflow = 0x1p-1060;
constexpr double kCornerRounding = 0x1p-22;
constexpr double kCornerUnderflow = 0x1p-140;
static_assert(3 * (3.01 * 3.5 + 4 * 3.5) + 4.01 + 2 * 3.5 < 128);
static_assert(15 + 3 * (3.01 * 3.5 + 4 * 3.5) + 2 * 3.5 < 128);
static_assert(15 + 3.47 + 6.94 + 4 * 3.5 + 2 * 3.5 < 128);
static_assert(2 * 0x1p-24 + 0x1p-24 < kCornerRounding);

/// A triangle of most meshes touches a dozen others.
constexpr std::size_t kUsuallyFound = 32;

std::variant<WideSource, CompactSource> source_of(const Shape& shape) {
  if (shape.layout().compact() != nullptr) {
    return CompactSource(shape);
  }
  return WideSource(shape);
}

}  // namespace

BoxSearch::BoxSearch(const Body& body)
    : body_(body),
      world_{body.pose, rotation(body.pose), true},
      origin_(body.shape.layout().origin()),
      rounding_(kBoxRounding * moved_extent(body.pose, body.shape.bounds()) + kBoxUnderflow),
      unit_(1 / body.shape.layout().scale()),
      source_(source_of(body.shape)) {
  stack_.reserve(kUsuallyFound);
}

Triangle BoxSearch::moved(TriangleId id) const {
  return moved_triangle(body_, id);
}

void BoxSearch::find(const Box& box, std::vector<MovedTriangle>& found, Cost& cost) {
  search(world_, box, found, cost);
}

void BoxSearch::find_beside(TriangleId id, std::vector<MovedTriangle>& found, Cost& cost) {
  const Place in_mesh{{}, rotation({}), false};
  search(in_mesh, bounds(body_.shape.mesh().triangle(id)), found, cost);
}

void BoxSearch::search(const Place& place, const Box& box, std::vector<MovedTriangle>& found,
                       Cost& cost) {
  found.clear();
  found.reserve(kUsuallyFound);
  if (body_.shape.layout().empty()) {
    return;
  }
  if (auto* wide = std::get_if<WideSource>(&source_)) {
    search(*wide, place, box, found, cost);
  } else {
    search(std::get<CompactSource>(source_), place, box, found, cost);
  }
}

template <class Source>
void BoxSearch::search(Source& source, const Place& place, const Box& box,
                       std::vector<MovedTriangle>& found, Cost& cost) {
  stack_.assign(1, kRootId);
  while (!stack_.empty()) {
    std::uint32_t token = stack_.back();
    stack_.pop_back();
    if ((token & WideNode::kLeafBit) == 0) {
      const WideNode& node = source.node(token);
      cost.node_tests += node.count;
      for (std::uint32_t left = lanes(node, place, box); left != 0; left &= left - 1) {
        stack_.push_back(node.child[static_cast<std::size_t>(std::countr_zero(left))]);
      }
      continue;
    }
    for (bool more = true; more; token = source.next(token)) {
      const TriangleBlock& block = source.block(token);
      cost.triangle_tests += block.count;
      more = block.following != 0;
      if (place.turned) {
        add_exactly(block, box, found);
      } else {
        add_near(block, box, found);
      }
    }
  }
}

void BoxSearch::add_exactly(const TriangleBlock& block, const Box& box,
                            std::vector<MovedTriangle>& found) const {
  for (std::size_t k = 0; k < block.count; ++k) {
    const Triangle t = moved(block.id[k]);
    if (overlaps(bounds(t), box)) {
      found.push_back({block.id[k], t});
    }
  }
}

void BoxSearch::add_near(const TriangleBlock& block, const Box& box,
                         std::vector<MovedTriangle>& found) const {
  constexpr std::size_t kWidth = TriangleBlock::kWidth;
  // Within the range of floats: one as wide leaves nothing out.
  constexpr double kWidestSlack = 0x1p126;
  const double slack = std::min(kWidestSlack, rounding_ / unit_) +
                       (kCornerRounding * static_cast<double>(block.l1_radius) + kCornerUnderflow);
  std::array<std::uint32_t, kWidth> apart{};
  for (std::size_t k = 0; k < 3; ++k) {
    const double at = origin_[k] + block.origin[k];
    const auto lower = static_cast<float>(
        std::clamp((box.lower[k] - at) / unit_ - slack, -kWidestSlack, kWidestSlack));
    const auto upper = static_cast<float>(
        std::clamp((box.upper[k] - at) / unit_ + slack, -kWidestSlack, kWidestSlack));
    for (std::size_t lane = 0; lane < kWidth; ++lane) {
      const float a = block.corner[k][lane];
      const float b = block.corner[3 + k][lane];
      const float c = block.corner[6 + k][lane];
      apart[lane] |= static_cast<std::uint32_t>(std::max(std::max(a, b), c) < lower) |
                     static_cast<std::uint32_t>(std::min(std::min(a, b), c) > upper);
    }
  }
  for (std::size_t lane = 0; lane < block.count; ++lane) {
    if (apart[lane] == 0) {
      found.push_back({block.id[lane], moved(block.id[lane])});
    }
  }
}

std::uint32_t BoxSearch::lanes(const WideNode& node, const Place& place, const Box& box) const {
  constexpr std::size_t kWidth = WideNode::kWidth;
  const Vec3 at = place.pose.apply(origin_ + Vec3{node.origin[0], node.origin[1], node.origin[2]});
  const std::uint32_t all = (1U << node.count) - 1;
  std::uint32_t apart = 0;
  for (std::size_t k = 0; k < 3 && (~apart & all) != 0; ++k) {
    std::array<double, 3> row = place.rotation[k];
    for (std::size_t j = 0; j < 3 && node.oriented != 0; ++j) {
      row[j] = place.rotation[k][0] * node.row[0][j] + place.rotation[k][1] * node.row[1][j] +
               place.rotation[k][2] * node.row[2][j];
    }
    std::array<double, kWidth> center{};
    std::array<double, kWidth> half{};
    for (std::size_t j = 0; j < 3; ++j) {
      for (std::size_t lane = 0; lane < kWidth; ++lane) {
        center[lane] += row[j] * node.center[j][lane];
        half[lane] += std::abs(row[j]) * node.half[j][lane];
      }
    }
    for (std::size_t lane = 0; lane < kWidth; ++lane) {
      const double middle = at[k] + center[lane] * unit_;
      const double reach = half[lane] * unit_ + rounding_;
      const bool beside = middle + reach < box.lower[k] || middle - reach > box.upper[k];
      apart |= beside ? 1U << lane : 0U;
    }
  }
  return ~apart & all;
}

}  // namespace soms::detail
