#include "soms/tree/layout/detail/start_nodes.h"

#include "soms/base/lanes.h"
#include "soms/tree/layout/detail/wide_tree.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <utility>

namespace soms::layout {

namespace {

/// Columns of the finest cell along each axis, as a power of two: two cells of the height grid.
constexpr std::uint32_t kFinestBits = 3;

/// A cell that would have more, or for which more would have to be looked at, keeps the list of the
/// cell above it. Where all triangles are as wide as the plan, all nodes are above every cell.
constexpr std::size_t kMostNodes = 16;
constexpr std::size_t kMostVisits = 64;

constexpr std::uint32_t kRoot = 0;

/// What lies above a cell of a ground plan.
class CellColumn {
 public:
  CellColumn(const GroundPlan& plan, double scale, std::uint32_t bits, std::uint32_t x,
             std::uint32_t y)
      : axis_{plan.axis[0], plan.axis[1]}, scale_(scale) {
    constexpr double kEndless = std::numeric_limits<double>::infinity();
    const std::array<std::uint64_t, 2> at = {x, y};
    for (std::size_t k = 0; k < 2; ++k) {
      const std::uint64_t last = static_cast<std::uint64_t>(plan.last[k]) >> bits;
      // The first and the last column take up what is outside of the plan.
      lower_[k] = at[k] == 0 ? -kEndless : plan.begin_of(k, at[k] << bits) - plan.rounding;
      upper_[k] = at[k] == last ? kEndless : plan.begin_of(k, (at[k] + 1) << bits) + plan.rounding;
    }
    half_side_ = static_cast<float>(0.5 * static_cast<double>(1U << bits) / plan.columns_a_unit);
  }

  /// Lanes of an axis-aligned node that reach into the cell. Floats are off by 2^-22 of what is
  /// added here, or less.
  [[nodiscard]] std::uint32_t lanes_of(const WideNode& node) const {
    I4 meets = I4{} - 1;
    for (std::size_t k = 0; k < 2; ++k) {
      const double place = node.origin[axis_[k]] * scale_;
      const auto lower = static_cast<float>(lower_[k] - place);
      const auto upper = static_cast<float>(upper_[k] - place);
      const float least = lower - 0x1p-20F * (node.l1_radius + std::abs(lower));
      const float most = upper + 0x1p-20F * (node.l1_radius + std::abs(upper));
      const F4 center = row(node.center[axis_[k]]);
      const F4 half = row(node.half[axis_[k]]);
      meets &= (center + half >= lanes::splat(least)) & (center - half <= lanes::splat(most));
    }
    std::uint32_t bits = 0;
    for (std::uint32_t lane = 0; lane < node.count; ++lane) {
      bits |= static_cast<std::uint32_t>(meets[lane] & 1) << lane;
    }
    return bits;
  }

  /// All of the lanes are nodes larger than the cell.
  [[nodiscard]] bool goes_below(const WideNode& node, std::uint32_t lanes) const {
    bool below = (lanes & node.leaves) == 0;
    for (; lanes != 0; lanes &= lanes - 1) {
      const auto lane = static_cast<std::size_t>(std::countr_zero(lanes));
      below = below &&
              std::max({node.half[0][lane], node.half[1][lane], node.half[2][lane]}) > half_side_;
    }
    return below;
  }

 private:
  using F4 = lanes::F4;
  using I4 [[gnu::vector_size(16)]] = std::int32_t;

  static F4 row(const std::array<float, 4>& from) {
    F4 v;
    std::memcpy(&v, from.data(), sizeof v);
    return v;
  }

  std::array<std::uint8_t, 2> axis_;
  double scale_;
  std::array<double, 2> lower_;
  std::array<double, 2> upper_;
  float half_side_;
};

/// Finds the nodes at which a list may begin, as long as they are few and soon found.
class ListSearch {
 public:
  ListSearch(std::span<const WideNode> nodes, const CellColumn& column,
             std::vector<std::uint32_t>& list)
      : nodes_(nodes), column_(column), list_(list) {}

  /// Adds those that are, or lie below, `index`; false where there are too many.
  [[nodiscard]] bool descend(std::uint32_t index) {
    const WideNode& node = nodes_[index];
    if (++visited_ > kMostVisits) {
      return false;
    }
    std::uint32_t lanes = node.oriented != 0 ? 0 : column_.lanes_of(node);
    if (node.oriented != 0 || (lanes != 0 && !column_.goes_below(node, lanes))) {
      list_.push_back(index);
      return list_.size() <= kMostNodes;
    }
    bool few = true;
    for (; few && lanes != 0; lanes &= lanes - 1) {
      few = descend(node.child[static_cast<std::size_t>(std::countr_zero(lanes))]);
    }
    return few;
  }

 private:
  std::span<const WideNode> nodes_;
  const CellColumn& column_;
  std::vector<std::uint32_t>& list_;
  std::size_t visited_ = 0;
};

}  // namespace

void StartNodes::lay_levels(const GroundPlan& plan) {
  const auto cells = [&](std::size_t k, std::uint32_t bits) {
    return static_cast<std::uint32_t>(static_cast<std::uint64_t>(plan.last[k]) >> bits) + 1;
  };
  std::uint32_t bits = kFinestBits;
  levels_.push_back({0, cells(0, bits), cells(1, bits)});
  while (levels_.back().width > 1 || levels_.back().height > 1) {
    ++bits;
    levels_.push_back({0, cells(0, bits), cells(1, bits)});
  }
  std::size_t first = 0;
  for (std::size_t k = levels_.size(); k-- > 0;) {
    levels_[k].first = first;
    first += std::size_t{levels_[k].width} * levels_[k].height;
  }
}

std::size_t StartNodes::count_lists(const GroundPlan& plan) {
  StartNodes laid;
  laid.lay_levels(plan);
  const Level& finest = laid.levels_.front();
  return finest.first + std::size_t{finest.width} * finest.height;
}

StartNodes::StartNodes(const GroundPlan& plan, std::span<const std::uint32_t> ends,
                       std::span<const std::uint32_t> nodes)
    : ends_(Stored<std::uint32_t>::borrowed(ends)), nodes_(Stored<std::uint32_t>::borrowed(nodes)) {
  lay_levels(plan);
}

StartNodes::StartNodes(std::span<const WideNode> nodes, const GroundPlan& plan, double scale) {
  lay_levels(plan);
  Pages<std::uint32_t> ends;
  Pages<std::uint32_t> listed;
  ends.push_back(0);
  std::vector<std::uint32_t> above;
  std::vector<std::uint32_t> list;
  std::uint32_t bits = kFinestBits + static_cast<std::uint32_t>(levels_.size()) - 1;
  for (std::size_t k = levels_.size(); k-- > 0; --bits) {
    const Level& level = levels_[k];
    for (std::uint32_t y = 0; y < level.height; ++y) {
      for (std::uint32_t x = 0; x < level.width; ++x) {
        above = {kRoot};
        if (k + 1 < levels_.size()) {
          const Level& coarser = levels_[k + 1];
          const std::size_t cell = coarser.first + std::size_t{y >> 1} * coarser.width + (x >> 1);
          above.assign(listed.begin() + ends[cell], listed.begin() + ends[cell + 1]);
        }
        const CellColumn column(plan, scale, bits, x, y);
        list.clear();
        ListSearch search(nodes, column, list);
        const bool few = std::all_of(above.begin(), above.end(),
                                     [&](std::uint32_t node) { return search.descend(node); });
        const auto& chosen = few ? list : above;
        listed.insert(listed.end(), chosen.begin(), chosen.end());
        ends.push_back(static_cast<std::uint32_t>(listed.size()));
      }
    }
  }
  ends_ = std::move(ends);
  nodes_ = std::move(listed);
}

std::span<const std::uint32_t> StartNodes::of(const PlanBox& box) const {
  const std::uint32_t differ = (box.from[0] ^ box.to[0]) | (box.from[1] ^ box.to[1]);
  const auto bits = std::max(kFinestBits, static_cast<std::uint32_t>(std::bit_width(differ)));
  const Level& level = levels_[bits - kFinestBits];
  return list(level.first + std::size_t{box.from[1] >> bits} * level.width + (box.from[0] >> bits));
}

}  // namespace soms::layout
