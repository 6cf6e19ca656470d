#include "soms/query/detail/engine/block_source.h"

#include "soms/tree/layout/detail/compact_node.h"

namespace soms::detail {

CompactSource::CompactSource(const Shape& shape) : tree_(shape.layout()), mesh_(shape.mesh()) {
  if (tree_.compact() != nullptr) {
    kept_.resize(1);
    kept_node_.fill(kNone);
    kept_block_.fill(kNone);
  }
}

const WideNode& CompactSource::node(std::uint32_t i) {
  if (tree_.compact() == nullptr) {
    return tree_.nodes()[i];
  }
  const std::size_t place = i % kNodes;
  WideNode& node = kept_[0].nodes[place];
  if (kept_node_[place] != i) {
    tree_.compact()->nodes[i].read(node);
    kept_node_[place] = i;
  }
  return node;
}

const TriangleBlock& CompactSource::block(std::uint32_t token) {
  const std::uint32_t first = begin_of(token);
  if (tree_.compact() == nullptr) {
    return tree_.blocks()[first];
  }
  // Leaves have several triangles, so neighbors differ in more than the last bits.
  const std::size_t place = (first ^ first >> 5) % kBlocks;
  TriangleBlock& block = kept_[0].blocks[place];
  if (kept_block_[place] != first) {
    tree_.read_block(first, mesh_, block);
    kept_block_[place] = first;
  }
  return block;
}

}  // namespace soms::detail
