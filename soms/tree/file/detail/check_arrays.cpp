#include "soms/tree/file/detail/check_arrays.h"

#include "soms/base/parallel.h"
#include "soms/base/pose.h"
#include "soms/tree/file/detail/head.h"
#include "soms/tree/layout/detail/compact_node.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <vector>

namespace soms::detail {

namespace {

constexpr std::uint32_t kIndexBits = WideNode::kMost - 1;
constexpr std::size_t kBlocksAtOnce = 4096;

/// True if no float among the words at `begin` is infinite or no number. \tparam kWords how many
template <std::size_t kWords>
bool are_finite(const void* begin) {
  constexpr std::int32_t kExponent = 0x7f800000;
  std::int32_t bad = 0;
  for (std::size_t i = 0; i < kWords; ++i) {
    std::int32_t word;
    std::memcpy(&word, static_cast<const std::byte*>(begin) + i * sizeof word, sizeof word);
    bad |= (word & kExponent) == kExponent ? 1 : 0;
  }
  return bad == 0;
}

bool are_finite(const std::array<double, 3>& numbers) {
  return std::isfinite(numbers[0]) && std::isfinite(numbers[1]) && std::isfinite(numbers[2]);
}

bool is_finite(const WideNode& node) {
  static_assert(offsetof(WideNode, child) == offsetof(WideNode, center) + 36 * sizeof(float));
  return are_finite<36>(&node.center) && std::isfinite(node.l1_radius) && are_finite(node.origin);
}

bool is_finite(const CompactNode& node) {
  // Sums of two of at most 127 steps are multiplied by them.
  constexpr float kMostStep = 0x1p119F;
  const auto fits = [](float step) { return step >= 0 && step < kMostStep; };
  return std::all_of(node.step.begin(), node.step.end(), fits) && are_finite<9>(&node.axes) &&
         std::isfinite(node.l1_radius) && are_finite(node.origin);
}

bool is_finite(const TriangleBlock& block) {
  static_assert(offsetof(TriangleBlock, upper) ==
                offsetof(TriangleBlock, own_half) + 8 * sizeof(float));
  return are_finite<72>(&block.corner) && are_finite<9>(&block.own_half) &&
         are_finite(block.origin);
}

/// True if it was set before.
bool set(std::vector<bool>& flags, std::size_t i) {
  const bool before = flags[i];
  flags[i] = true;
  return before;
}

/// Follows leaves and children of one kind of nodes.
class Check {
 public:
  Check(const LayoutArrays& arrays, const MeshView& mesh, const std::string& name)
      : arrays_(arrays),
        triangles_(mesh.triangles.size()),
        name_(name),
        compact_(!arrays.compact_nodes.empty()),
        node_seen_(compact_ ? arrays.compact_nodes.size() : arrays.nodes.size()),
        entry_seen_(compact_ ? arrays.compact_ids.size() : arrays.blocks.size()),
        entries_(entry_seen_.size()) {}

  void check_kind() {
    const bool wide = !arrays_.nodes.empty();
    if (wide == compact_ ? wide || triangles_ > 0 : triangles_ == 0) {
      fail_tree_file(name_,
                     "section nodes: there must be nodes of one kind where there are "
                     "triangles, and none else");
    }
    if (compact_ ? !arrays_.blocks.empty() : !arrays_.compact_ids.empty()) {
      fail_tree_file(name_, "section blocks: leaves of another kind than nodes");
    }
    if (arrays_.least_ids.size() != node_seen_.size()) {
      fail(Section::least_ids, arrays_.least_ids.size(), "records, and as many nodes are needed");
    }
    const Box& box = arrays_.bounds;
    const auto fits = [](double x) { return std::abs(x) <= kMaxCoordinate; };
    if (triangles_ > 0 &&
        (box.empty() || !(fits(box.lower.x) && fits(box.lower.y) && fits(box.lower.z) &&
                          fits(box.upper.x) && fits(box.upper.y) && fits(box.upper.z)))) {
      fail_tree_file(name_, "head: the bounds are no box of numbers up to 2^300");
    }
  }

  void check_plan() const {
    const bool none = arrays_.cells.empty();
    if (none && arrays_.list_ends.empty() && arrays_.list_nodes.empty()) {
      return;
    }
    if (none || compact_ || !layout::MinMaxGrid::is_fit(arrays_.plan)) {
      fail_tree_file(name_, "head: the ground plan has numbers out of range");
    }
    if (arrays_.cells.size() != layout::MinMaxGrid::count_cells(arrays_.plan)) {
      fail(Section::cells, arrays_.cells.size(),
           "records, and the plan has another number of cells");
    }
    const auto& ends = arrays_.list_ends;
    if (ends.size() != layout::StartNodes::count_lists(arrays_.plan) + 1) {
      fail(Section::list_ends, ends.size(), "records, and the plan has another number of lists");
    }
    for (std::size_t i = 0; i < ends.size(); ++i) {
      if (ends[i] > arrays_.list_nodes.size() || (i == 0 ? ends[i] != 0 : ends[i] < ends[i - 1])) {
        fail(Section::list_ends, i, "does not ascend within the lists");
      }
    }
    for (std::size_t i = 0; i < arrays_.list_nodes.size(); ++i) {
      if (arrays_.list_nodes[i] >= arrays_.nodes.size()) {
        fail(Section::list_nodes, i, "is no node");
      }
    }
  }

  void check_least_ids() const {
    for (std::size_t i = 0; i < arrays_.least_ids.size(); ++i) {
      if (arrays_.least_ids[i] >= triangles_) {
        fail(Section::least_ids, i, "is no triangle");
      }
    }
  }

  void check_entries(const Limits& limits) {
    for_each_chunk(entries_.size(), kBlocksAtOnce, limits, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        entries_[i] = compact_ ? checked_id(i) : checked_block(i);
      }
    });
  }

  void check_nodes() {
    if (compact_) {
      check_nodes(arrays_.compact_nodes, Section::compact_nodes);
    } else {
      check_nodes(arrays_.nodes, Section::nodes);
    }
  }

  /// \pre `check_nodes` passed.
  void check_sound() const {
    check_all_are_met();
    check_triangles();
    if (compact_) {
      check_least_ids_of(arrays_.compact_nodes);
    } else {
      check_least_ids_of(arrays_.nodes);
    }
  }

 private:
  /// A block of a wide layout, or a triangle of a compact one.
  struct Entry {
    TriangleId least;         ///< of its triangles
    std::uint32_t following;  ///< entries of the same leaf that follow; 1 for some, if compact
  };

  [[nodiscard]] Entry checked_block(std::size_t b) const {
    const TriangleBlock& block = arrays_.blocks[b];
    if (block.count < 1 || block.count > TriangleBlock::kWidth) {
      fail(Section::blocks, b, "has " + std::to_string(block.count) + " triangles");
    }
    TriangleId least = block.id[0];
    std::uint32_t beyond = 0;
    for (const TriangleId id : block.id) {
      least = std::min(least, id);
      beyond |= id >= triangles_ ? 1U : 0U;
    }
    if (beyond != 0) {
      fail(Section::blocks, b, "has a triangle that the mesh does not have");
    }
    if (!is_finite(block)) {
      fail(Section::blocks, b, "has a number that is not finite");
    }
    return {least, block.following};
  }

  [[nodiscard]] Entry checked_id(std::size_t i) const {
    const std::uint32_t id = arrays_.compact_ids[i];
    if ((id & ~CompactParts::kLast) >= triangles_) {
      fail(Section::compact_ids, i, "is no triangle");
    }
    return {id & ~CompactParts::kLast, (id & CompactParts::kLast) != 0 ? 0U : 1U};
  }

  void check_all_are_met() const {
    const auto check = [&](const std::vector<bool>& seen, std::size_t from, Section section,
                           const char* what) {
      const auto missed =
          std::find(seen.begin() + static_cast<std::ptrdiff_t>(std::min(from, seen.size())),
                    seen.end(), false);
      if (missed != seen.end()) {
        fail(section, static_cast<std::size_t>(missed - seen.begin()), what);
      }
    };
    check(node_seen_, 1, compact_ ? Section::compact_nodes : Section::nodes, "is nobody's child");
    check(entry_seen_, 0, compact_ ? Section::compact_ids : Section::blocks, "is in no leaf");
  }

  /// Each triangle once, and lanes that are not in use repeat the last one.
  void check_triangles() const {
    std::vector<bool> seen(triangles_);
    std::size_t count = 0;
    const auto see = [&](TriangleId id) {
      if (set(seen, id)) {
        fail_tree_file(name_,
                       "section blocks: triangle " + std::to_string(id) + " is in two leaves");
      }
      ++count;
    };
    for (std::size_t b = 0; b < arrays_.blocks.size(); ++b) {
      const TriangleBlock& block = arrays_.blocks[b];
      see(block.id[0]);
      for (std::size_t lane = 1; lane < block.id.size(); ++lane) {
        if (lane < block.count) {
          see(block.id[lane]);
        } else if (block.id[lane] != block.id[lane - 1]) {
          fail(Section::blocks, b, "has a triangle in a lane that is not in use");
        }
      }
    }
    for (const std::uint32_t entry : arrays_.compact_ids) {
      see(entry & ~CompactParts::kLast);
    }
    if (count != triangles_) {
      fail_tree_file(name_, "section blocks: " + std::to_string(count) + " of " +
                                std::to_string(triangles_) + " triangles are in a leaf");
    }
  }

  template <class Node>
  void check_least_ids_of(std::span<const Node> nodes) const {
    for (std::size_t i = nodes.size(); i-- > 0;) {
      const Node& node = nodes[i];
      TriangleId least = ~TriangleId{0};
      for (std::size_t lane = 0; lane < node.count; ++lane) {
        const bool leaf = (node.leaves >> lane & 1U) != 0;
        least = std::min(least, leaf ? least_of_leaf(node.child[lane] & kIndexBits)
                                     : arrays_.least_ids[node.child[lane]]);
      }
      if (least != arrays_.least_ids[i]) {
        fail(Section::least_ids, i, "is not the least triangle below the node");
      }
    }
  }

  [[nodiscard]] TriangleId least_of_leaf(std::size_t first) const {
    TriangleId least = entries_[first].least;
    while (entries_[first].following != 0) {
      least = std::min(least, entries_[++first].least);
    }
    return least;
  }

  [[noreturn]] void fail(Section section, std::size_t i, const std::string& what) const {
    fail_tree_file(name_, "section " + soms::detail::name(section) + ", record " +
                              std::to_string(i) + ": " + what);
  }

  template <class Node>
  void check_nodes(std::span<const Node> nodes, Section section) {
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      const Node& node = nodes[i];
      if (node.count < 1 || node.count > Node::kWidth || node.leaves >> node.count != 0 ||
          node.oriented > 1) {
        fail(section, i, "has a count that is out of range");
      }
      if (!is_finite(node)) {
        fail(section, i, "has a number that is not finite");
      }
      for (std::size_t lane = 0; lane < node.count; ++lane) {
        const std::uint32_t child = node.child[lane];
        if ((node.leaves >> lane & 1U) != 0) {
          check_leaf(section, i, child);
        } else if (child <= i || child >= nodes.size() || set(node_seen_, child)) {
          fail(section, i,
               "has child " + std::to_string(child) +
                   ", which does not follow it, or has another parent");
        }
      }
    }
  }

  void check_leaf(Section section, std::size_t node, std::uint32_t token) {
    const std::uint32_t first = token & kIndexBits;
    const std::size_t entries = follow(first);
    const bool run = entries > (compact_ ? std::size_t{TriangleBlock::kWidth} : 1);
    const std::uint32_t bits = WideNode::kLeafBit | (run ? WideNode::kRunBit : 0);
    if (entries == 0 || token != (bits | first)) {
      fail(section, node,
           "has a leaf at " + std::to_string(first) + ", which is not whole, or is another one's");
    }
  }

  /// Entries of the leaf that begins at `first`; 0 unless it is whole and nobody else's.
  std::size_t follow(std::uint32_t first) {
    std::size_t entries = 0;
    for (std::size_t at = first; at < entry_seen_.size(); ++at) {
      if (set(entry_seen_, at)) {
        return 0;
      }
      ++entries;
      if (entries_[at].following == 0) {
        return entries;
      }
      if (!compact_ &&
          (at + 1 == entries_.size() || entries_[at + 1].following + 1 != entries_[at].following)) {
        return 0;
      }
    }
    return 0;
  }

  const LayoutArrays& arrays_;
  std::size_t triangles_;
  const std::string& name_;
  bool compact_;
  std::vector<bool> node_seen_;
  std::vector<bool> entry_seen_;
  std::vector<Entry> entries_;
};

}  // namespace

void check_arrays(const LayoutArrays& arrays, const MeshView& mesh, const std::string& name,
                  bool sound, const Limits& limits) {
  Check check(arrays, mesh, name);
  check.check_kind();
  check.check_entries(limits);
  check.check_nodes();
  check.check_plan();
  check.check_least_ids();
  if (sound) {
    soms::check(limits);
    check.check_sound();
  }
}

}  // namespace soms::detail
