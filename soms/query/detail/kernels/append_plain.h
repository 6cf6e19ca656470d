// Appends what met, pair by pair. Included inside a namespace; see nodes.h.

inline std::uint32_t code_of(const WideNode& node, std::uint32_t own, std::uint32_t lane) {
  return (node.leaves >> lane & 1U) != 0 ? own + NodeTask::kLane + lane : node.child[lane] << 3;
}

inline void append(const NodeTask* tasks, std::size_t count, PairSink& sink) {
  for (std::size_t i = 0; i < count; ++i) {
    const NodeTask& task = tasks[i];
    const PairSink here = sink;
    for (std::uint32_t left = task.pairs; left != 0; left &= left - 1) {
      const auto bit = static_cast<std::uint32_t>(std::countr_zero(left));
      const std::uint32_t x = bit & 3;
      const std::uint32_t y = (bit + (bit >> 2)) & 3;
      if ((task.x->leaves >> x & task.y->leaves >> y & 1U) != 0) {
        sink.blocks_x[sink.blocks] = task.x->child[x];
        sink.blocks_y[sink.blocks++] = task.y->child[y];
      } else {
        sink.codes_x[sink.codes] = code_of(*task.x, task.code_x, x);
        sink.codes_y[sink.codes++] = code_of(*task.y, task.code_y, y);
      }
    }
    if (task.order != 0 && sink.codes > here.codes) {
      put_last(here, static_cast<std::size_t>(std::popcount(task.codes() & task.below)),
               sink.codes - here.codes);
    }
  }
}
