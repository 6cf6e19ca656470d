#include "soms/base/arithmetic.h"
#include "soms/base/error.h"
#include "soms/base/parallel.h"
#include "soms/tree/layout/detail/block.h"
#include "soms/tree/layout/detail/compact_node.h"
#include "soms/tree/layout/detail/wide_tree.h"

#include <algorithm>
#include <vector>

namespace soms {

namespace {

constexpr std::uint32_t kLast = CompactParts::kLast;
constexpr std::size_t kChunk = 4096;

bool is_leaf(std::uint8_t leaves, std::size_t k) {
  return (std::uint32_t{leaves} >> k & 1U) != 0;
}

/// A leaf's token with another place in it.
std::uint32_t word_at(std::uint32_t word, std::uint32_t place) {
  return (word & ~(WideNode::kMost - 1)) | place;
}

/// Where each block's triangles begin, and their number at the end.
std::vector<std::uint32_t> firsts_of(std::span<const TriangleBlock> blocks) {
  std::vector<std::uint32_t> first(blocks.size() + 1);
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    first[b + 1] = first[b] + blocks[b].count;
  }
  return first;
}

/// The same from the leaves' ends, and how many blocks of the leaf follow each.
struct Runs {
  std::vector<std::uint32_t> first;
  std::vector<std::uint32_t> following;

  explicit Runs(std::span<const std::uint32_t> ids) {
    std::uint32_t begin = 0;
    for (std::uint32_t i = 0; i < ids.size(); ++i) {
      if ((ids[i] & kLast) != 0) {
        const std::uint32_t count = i + 1 - begin;
        for (std::uint32_t done = 0; done < count; done += TriangleBlock::kWidth) {
          first.push_back(begin + done);
          following.push_back((count - 1 - done) / TriangleBlock::kWidth);
        }
        begin = i + 1;
      }
    }
  }
};

/// Reads up to a block of ids; returns their number, and whether the leaf goes on.
std::pair<std::size_t, bool> read_ids(const std::uint32_t* from,
                                      std::array<TriangleId, TriangleBlock::kWidth>& ids) {
  for (std::size_t k = 0; k < ids.size(); ++k) {
    ids[k] = from[k] & ~kLast;
    if ((from[k] & kLast) != 0) {
      return {k + 1, false};
    }
  }
  return {ids.size(), true};
}

}  // namespace

bool WideTree::operator==(const WideTree& other) const {
  const bool same =
      nodes_ == other.nodes_ && blocks_ == other.blocks_ && min_max_grid_ == other.min_max_grid_ &&
      start_nodes_ == other.start_nodes_ && origin_ == other.origin_ && bounds_ == other.bounds_ &&
      exponent_ == other.exponent_ && (compact_ != nullptr) == (other.compact_ != nullptr);
  return same && (!compact_ || (compact_->nodes == other.compact_->nodes &&
                                compact_->ids == other.compact_->ids));
}

WideTree WideTree::compacted(const Limits& limits) const {
  const PlainArithmetic plain;
  WideTree result;
  result.origin_ = origin_;
  result.bounds_ = bounds_;
  result.exponent_ = exponent_;
  result.scale_ = scale_;
  result.compact_ = compact_;
  result.owner_ = owner_;
  result.least_ids_ = least_ids_;
  if (nodes_.empty()) {
    return result;
  }
  const std::vector<std::uint32_t> first = firsts_of(blocks_);
  if (first.back() >= WideNode::kMost) {
    throw Error(ErrorKind::out_of_range, "a compact layout of 2^28 triangles", "use Layout::wide");
  }
  auto parts = std::make_shared<CompactParts>();
  parts->ids.resize(first.back());
  const std::span<std::uint32_t> ids = parts->ids.own();
  for_each_chunk(blocks_.size(), kChunk, limits.silent(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t b = begin; b < end; ++b) {
      std::copy_n(blocks_[b].id.begin(), blocks_[b].count, ids.begin() + first[b]);
      if (blocks_[b].following == 0) {
        ids[first[b + 1] - 1] |= kLast;
      }
    }
  });
  parts->nodes.resize(nodes_.size());
  for_each_chunk(nodes_.size(), kChunk, limits.silent(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      CompactNode node(nodes_[i]);
      for (std::size_t k = 0; k < node.count; ++k) {
        if (is_leaf(node.leaves, k)) {
          node.child[k] = word_at(node.child[k], first[node.child[k] & (WideNode::kMost - 1)]);
        }
      }
      parts->nodes.own()[i] = node;
    }
  });
  result.compact_ = std::move(parts);
  return result;
}

WideTree WideTree::expanded(const MeshView& mesh, const Limits& limits) const {
  const PlainArithmetic plain;
  if (!compact_) {
    return *this;
  }
  WideTree result;
  result.origin_ = origin_;
  result.bounds_ = bounds_;
  result.exponent_ = exponent_;
  result.scale_ = scale_;
  result.owner_ = owner_;
  result.least_ids_ = least_ids_;
  const Runs runs(compact_->ids);
  result.blocks_.resize(runs.first.size());
  for_each_chunk(runs.first.size(), kChunk, limits.silent(),
                 [&](std::size_t begin, std::size_t end) {
                   for (std::size_t b = begin; b < end; ++b) {
                     TriangleBlock& block = result.blocks_.own()[b];
                     read_block(runs.first[b], mesh, block);
                     block.following = runs.following[b] & (WideNode::kMost - 1);
                   }
                 });
  result.nodes_.resize(compact_->nodes.size());
  for_each_chunk(
      result.nodes_.size(), kChunk, limits.silent(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
          WideNode node;
          compact_->nodes[i].read(node);
          for (std::size_t k = 0; k < node.count; ++k) {
            if (is_leaf(node.leaves, k)) {
              const auto at = std::lower_bound(runs.first.begin(), runs.first.end(),
                                               node.child[k] & (WideNode::kMost - 1));
              node.child[k] =
                  word_at(node.child[k], static_cast<std::uint32_t>(at - runs.first.begin()));
            }
          }
          result.nodes_.own()[i] = node;
        }
      });
  result.make_plan(limits);
  return result;
}

void WideTree::read_block(std::uint32_t first, const MeshView& mesh, TriangleBlock& block) const {
  std::array<TriangleId, TriangleBlock::kWidth> ids;
  const auto [count, more] = read_ids(&compact_->ids[first], ids);
  double size = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    size = std::max(size, bounds_.extent()[axis]);
  }
  block = {};
  layout::make_block(mesh, std::span(ids).first(count), {origin_, scale_, size * scale_}, block);
  block.following = more ? 1 : 0;
}

}  // namespace soms
