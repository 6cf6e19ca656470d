// Appends pairs of lanes to lists, with `put_all` as the includer has it. Included inside a
// namespace, after <immintrin.h>.

/// Ids of a node's children: see NodeTask.
inline __m128i node_ids_of(const WideNode& node, std::uint32_t own) {
  const __m128i child = _mm_loadu_si128(reinterpret_cast<const __m128i*>(node.child.data()));
  const __m128i lanes =
      _mm_add_epi32(_mm_set1_epi32(static_cast<int>(own)), _mm_setr_epi32(4, 5, 6, 7));
  return _mm_blendv_epi8(_mm_slli_epi32(child, 3), lanes, _mm_srai_epi32(child, 31));
}

/// Tokens of WideNode::child.
inline __m128i words_of(const WideNode& node) {
  return _mm_loadu_si128(reinterpret_cast<const __m128i*>(node.child.data()));
}

inline void append(const NodeTask* tasks, std::size_t count, PairSink& sink) {
  for (std::size_t i = 0; i < count; ++i) {
    const NodeTask& task = tasks[i];
    const std::uint32_t node_ids = task.node_ids();
    const std::size_t count_here = put_all(
        node_ids, node_ids_of(*task.x, task.node_id_x), node_ids_of(*task.y, task.node_id_y),
        sink.node_ids_x + sink.node_ids, sink.node_ids_y + sink.node_ids);
    if (task.order != 0) {
      put_last(sink, static_cast<std::size_t>(std::popcount(node_ids & task.below)), count_here);
    }
    sink.node_ids += count_here;
    const std::uint32_t leaves = task.pairs ^ node_ids;
    if (leaves != 0) {
      sink.blocks += put_all(leaves, words_of(*task.x), words_of(*task.y),
                             sink.blocks_x + sink.blocks, sink.blocks_y + sink.blocks);
    }
  }
}
