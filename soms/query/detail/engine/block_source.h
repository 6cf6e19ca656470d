/// \file
/// Where a traversal gets nodes and blocks from: in place, or written out when they are met.
#pragma once

#include "soms/query/detail/engine/fetch.h"
#include "soms/query/detail/engine/node_id.h"
#include "soms/tree/layout/detail/pages.h"
#include "soms/tree/layout/detail/wide_tree.h"
#include "soms/tree/shape.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace soms::detail {

/// A wide layout: all nodes and blocks lie in memory and stay there.
class WideSource {
 public:
  /// Nodes and blocks stay where they are, however many are requested.
  static constexpr bool kInPlace = true;

  explicit WideSource(const Shape& shape)
      : nodes_(shape.layout().nodes().data()), blocks_(shape.layout().blocks().data()) {}

  [[nodiscard]] const WideNode& node(std::uint32_t i) const { return nodes_[i]; }

  /// The block that a token names.
  [[nodiscard]] const TriangleBlock& block(std::uint32_t token) const {
    return blocks_[begin_of(token)];
  }

  /// The token of the next block of the same leaf.
  [[nodiscard]] static std::uint32_t next(std::uint32_t token) { return token + 1; }

  /// Start to load what will be looked at soon.
  void fetch_node(std::uint32_t i) const { fetch(nodes_[i]); }

  void fetch_block(std::uint32_t token) const { fetch(block(token)); }

  /// All nodes.
  [[nodiscard]] const WideNode* nodes() const { return nodes_; }

 private:
  const WideNode* nodes_;
  const TriangleBlock* blocks_;
};

/// A layout of either kind, for queries of which one side at least is compact. Nodes and blocks of
/// a compact one are written out when they are met; those written last are kept, one in each of a
/// few places.
class CompactSource {
 public:
  /// A node lasts until the next one is requested, and so does a block.
  static constexpr bool kInPlace = false;

  explicit CompactSource(const Shape& shape);

  [[nodiscard]] const WideNode& node(std::uint32_t i);

  [[nodiscard]] const TriangleBlock& block(std::uint32_t token);

  [[nodiscard]] std::uint32_t next(std::uint32_t token) const {
    return token + (tree_.compact() != nullptr ? TriangleBlock::kWidth : 1);
  }

  /// Nothing: what was found last is read next, and a block from all over the mesh.
  void fetch_node(std::uint32_t /*i*/) const {}

  void fetch_block(std::uint32_t /*token*/) const {}

 private:
  static constexpr std::uint32_t kNone = 0xffffffffU;
  static constexpr std::size_t kNodes = 16;
  static constexpr std::size_t kBlocks = 32;

  struct Kept {
    std::array<WideNode, kNodes> nodes;
    std::array<TriangleBlock, kBlocks> blocks;
  };

  const WideTree& tree_;
  const MeshView& mesh_;
  layout::Pages<Kept> kept_;  // one, or none where the tree is wide
  std::array<std::uint32_t, kNodes> kept_node_;
  std::array<std::uint32_t, kBlocks> kept_block_;
};

}  // namespace soms::detail
