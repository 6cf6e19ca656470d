// Kernels of rays in any direction, for any kind of four lanes F4 and eight lanes F8. Included once
// for each instruction set, inside its namespace and after parity.h; so it has no include guard and
// includes nothing. ray/ray_frame.h proves the margins.

/// B of the proof: places of a node's or block's origin along the ray and across it.
inline std::array<float, 3> seen_from(const LineNumbers& line,
                                      const std::array<double, 3>& origin) {
  std::array<float, 3> seen;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::array<double, 3>& r = line.exact[i];
    const double turned = (r[0] * origin[0] + r[1] * origin[1]) + r[2] * origin[2];
    seen[i] = static_cast<float>((line.from[i] + turned) * line.scale);
  }
  return seen;
}

inline void line_node(LineNodeTask& task) {
  const LineNumbers& line = *task.line;
  const WideNode& node = *task.node;
  const std::array<float, 3> seen = seen_from(line, node.origin);
  const float along = (node.l1_radius + std::abs(seen[0])) * 0x1p-19F + line.slack;
  const float across =
      (node.l1_radius * 1.5F + (std::abs(seen[1]) + std::abs(seen[2]))) * 0x1p-19F + line.slack;
  RayRows rows = line.row;
  if (node.oriented != 0) {
    for (std::size_t i = 0; i < 3; ++i) {
      rows[i] = turned_row(line.row[i], node);
    }
  }
  const Boxes boxes(node);
  const M4 apart = beside_strips(rows[1], rows[2], seen, boxes, across * 2.5F);
  const auto& x = rows[0];
  const F4 place = along_row(x, boxes.center) + F4(seen[0]);
  const F4 reach =
      along_row({std::abs(x[0]), std::abs(x[1]), std::abs(x[2]), 0}, boxes.half) + F4(along);
  const F4 near = place - reach;
  near.store(task.near.data());
  task.lanes = ~bits(apart | (F4(line.near_open) > place + reach) | (near > F4(line.far_open))) &
               ((1U << node.count) - 1);
}

inline void line_nodes(LineNodeTask* tasks, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    line_node(tasks[i]);
  }
}

inline void line_block(LineBlockTask& task) {
  const LineNumbers& line = *task.line;
  const TriangleBlock& block = *task.block;
  const std::array<float, 3> seen = seen_from(line, block.origin);
  const float size = block.l1_radius * 1.5F + (std::abs(seen[1]) + std::abs(seen[2]));
  const float error = size * 0x1p-21F + line.slack;
  const float along = (block.l1_radius + std::abs(seen[0])) * 0x1p-21F + line.slack;
  const Corners q = turned_corners(line.row, block, seen);
  const SeenAlong areas(q, error, error * (size * 6 + error * 4) + 0x1p-140F);
  const F8 near = least(q[0][0], q[1][0], q[2][0]) - F8(along);
  const F8 far = greatest(q[0][0], q[1][0], q[2][0]) + F8(along);
  near.store(task.near.data());
  const std::uint32_t miss =
      areas.miss | bits((F8(line.near_open) > far) | (near > F8(line.far_open)));
  const std::uint32_t lanes = ((1U << block.count) - 1) & ~miss;
  task.through = lanes & areas.within;
  task.sure = task.through & bits(near > F8(line.near_sure)) & bits(F8(line.far_sure) > far);
  task.open = lanes & ~task.through;
}

inline void line_blocks(LineBlockTask* tasks, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    line_block(tasks[i]);
  }
}
