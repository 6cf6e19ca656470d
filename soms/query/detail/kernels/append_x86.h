// Appends pairs of lanes to lists, with `put_all` as the includer has it. Included inside a
// namespace, after <immintrin.h>.

/// Codes of a node's children: see NodeTask.
inline __m128i codes_of(const WideNode& node, std::uint32_t own) {
  const __m128i child = _mm_loadu_si128(reinterpret_cast<const __m128i*>(node.child.data()));
  const __m128i lanes =
      _mm_add_epi32(_mm_set1_epi32(static_cast<int>(own)), _mm_setr_epi32(4, 5, 6, 7));
  return _mm_blendv_epi8(_mm_slli_epi32(child, 3), lanes, _mm_srai_epi32(child, 31));
}

/// Words of WideNode::child.
inline __m128i words_of(const WideNode& node) {
  return _mm_loadu_si128(reinterpret_cast<const __m128i*>(node.child.data()));
}

inline void append(const NodeTask* tasks, std::size_t count, PairSink& sink) {
  for (std::size_t i = 0; i < count; ++i) {
    const NodeTask& task = tasks[i];
    const std::uint32_t codes = task.codes();
    const std::size_t count_here =
        put_all(codes, codes_of(*task.x, task.code_x), codes_of(*task.y, task.code_y),
                sink.codes_x + sink.codes, sink.codes_y + sink.codes);
    if (task.order != 0) {
      put_last(sink, static_cast<std::size_t>(std::popcount(codes & task.below)), count_here);
    }
    sink.codes += count_here;
    const std::uint32_t leaves = task.pairs ^ codes;
    if (leaves != 0) {
      sink.blocks += put_all(leaves, words_of(*task.x), words_of(*task.y),
                             sink.blocks_x + sink.blocks, sink.blocks_y + sink.blocks);
    }
  }
}
