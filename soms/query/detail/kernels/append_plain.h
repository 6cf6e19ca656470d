// Appends what met, pair by pair. Included inside a namespace; see nodes.h.

inline std::uint32_t node_id_of(const WideNode& node, std::uint32_t own, std::uint32_t lane) {
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
        sink.node_ids_x[sink.node_ids] = node_id_of(*task.x, task.node_id_x, x);
        sink.node_ids_y[sink.node_ids++] = node_id_of(*task.y, task.node_id_y, y);
      }
    }
    if (task.order != 0 && sink.node_ids > here.node_ids) {
      put_last(here, static_cast<std::size_t>(std::popcount(task.node_ids() & task.below)),
               sink.node_ids - here.node_ids);
    }
  }
}
