// Kernels of rays in any direction, for any kind of four lanes F4 and eight lanes F8. Included once
// for each instruction set, inside its namespace and after parity.h; so it has no include guard and
// includes nothing. ray/ray_frame.h proves the margins, and says of each product here what covers
// it where it underflows.

/// Where a ray is as a node's axes see it, and one over its direction.
struct LineInNode {
  LineInNode(const LineNumbers& line, const WideNode& node) {
    seen_from(line.node_view, node.origin).store(from.data());
    place = from[3];
    inverse = line.inverse;
    reach = line.reach;
    if (node.oriented != 0) {
      turn(line, node);
    }
  }

  void turn(const LineNumbers& line, const WideNode& node) {
    const F4 own = turned(from, node);
    const F4 ahead = turned(line.ahead, node);
    const F4 steep = max(abs(ahead), F4(kLeastAhead));
    own.store(from.data());
    const F4 one_over = F4(1.0F) / steep;
    one_over.store(reach.data());
    select(F4(0.0F) > ahead, F4(0.0F) - one_over, one_over).store(inverse.data());
  }

  /// What underflows here is within the margin: below 2^-147.
  static F4 turned(const std::array<float, 4>& v, const WideNode& node) {
    return (F4::load(node.row[0].data()) * F4(v[0]) + F4::load(node.row[1].data()) * F4(v[1])) +
           F4::load(node.row[2].data()) * F4(v[2]);
  }

  std::array<float, 4> from;
  std::array<float, 4> inverse;
  std::array<float, 4> reach;
  float place;
};

/// Boxes that a ray may meet, and bounds of where it enters them.
inline std::uint32_t meet_boxes(const LineNumbers& line, const WideNode& node,
                                std::array<float, 4>& first) {
  const LineInNode seen(line, node);
  const float margin = node.l1_radius * 0x1p-17F + line.node_slack;
  const float along = (node.l1_radius + std::abs(seen.place)) * 0x1p-20F + line.node_slack;
  F4 near;
  F4 far;
  for (std::size_t k = 0; k < 3; ++k) {
    const F4 middle = (F4::load(node.center[k].data()) - F4(seen.from[k])) * F4(seen.inverse[k]);
    const F4 reach = (F4::load(node.half[k].data()) + F4(margin)) * F4(seen.reach[k]);
    near = k == 0 ? middle - reach : max(near, middle - reach);
    far = k == 0 ? middle + reach : min(far, middle + reach);
  }
  const F4 begin = near + F4(seen.place - along);
  const F4 end = far + F4(seen.place + along);
  begin.store(first.data());
  const M4 apart = (near > far) | (begin > F4(line.far_open)) | (F4(line.near_open) > end);
  return ~bits(apart) & ((1U << node.count) - 1);
}

/// Tests a node's boxes and puts those that the ray may meet on the stack, the nearest one last.
inline void line_node(const WideNode& node, LineDescent& descent) {
  std::array<float, 4> near;
  const std::uint32_t lanes = meet_boxes(*descent.line, node, near);
  descent.boxes += node.count;
  Ahead* const begin = descent.stack + descent.size;
  Ahead* end = begin;
  for (std::size_t lane = 0; lane < WideNode::kWidth; ++lane) {
    *end = {near[lane], node.child[lane]};
    end += lanes >> lane & 1U;
  }
  for (Ahead* next = begin + 1; next < end; ++next) {
    for (Ahead* at = next; at != begin && at->near > at[-1].near; --at) {
      std::swap(*at, at[-1]);
    }
  }
  descent.size = static_cast<std::size_t>(end - descent.stack);
}

/// Drops what does not matter any more; true if a node is next that the ray may enter.
inline bool can_enter(LineDescent& descent) {
  const float far = descent.line->far_open;
  while (descent.size != 0 && descent.stack[descent.size - 1].near > far) {
    --descent.size;
  }
  return descent.size != 0 && (descent.stack[descent.size - 1].token & WideNode::kLeafBit) == 0 &&
         descent.steps != 0 && descent.size + WideNode::kWidth <= descent.room;
}

inline void line_descents(const WideNode* nodes, LineDescent* const* descents, std::size_t count) {
  std::array<LineDescent*, kMostDescents> going;
  std::size_t left = 0;
  for (std::size_t i = 0; i < count; ++i) {
    going[left] = descents[i];
    left += can_enter(*descents[i]) ? 1U : 0U;
  }
  while (left != 0) {
    const std::size_t turns = left;
    left = 0;
    for (std::size_t i = 0; i < turns; ++i) {
      LineDescent& descent = *going[i];
      --descent.steps;
      line_node(nodes[descent.stack[--descent.size].token], descent);
      going[left] = &descent;
      if (can_enter(descent)) {
        ++left;
        fetch(nodes[descent.stack[descent.size - 1].token]);
      }
    }
  }
}

/// Areas that are not surely above this are left open, so that one over a sum of three is a float.
constexpr float kLeastArea = 0x1p-126F;

/// Where the line of a ray crosses triangles: weighted by the shares of the areas that it parts
/// them into. A product of an area and a length would be one of three lengths, and underflow;
/// shares are at most 1, and what underflows in them, times a length, is within `along`.
inline void tighten(const Corners& q, const SeenAlong& areas, float area, float along, F8& near,
                    F8& far) {
  const F8 inverse = F8(1.0F) / ((areas.beside[0] + areas.beside[1]) + areas.beside[2]);
  const F8 place = q[0][0] + ((areas.beside[0] * inverse) * (q[2][0] - q[0][0]) +
                              (areas.beside[2] * inverse) * (q[1][0] - q[0][0]));
  const F8 error = (far - near) * (F8(area * 6) * abs(inverse) + F8(0x1p-20F)) + F8(along * 6);
  near = max(near, place - error);
  far = min(far, place + error);
}

inline void line_block(LineBlockTask& task) {
  const LineNumbers& line = *task.line;
  const TriangleBlock& block = *task.block;
  std::array<float, 4> view;
  seen_from(line.block_view, block.origin).store(view.data());
  const std::array<float, 3> seen{view[0], view[1], view[2]};
  const float size = block.l1_radius * 1.5F + (std::abs(seen[1]) + std::abs(seen[2]));
  const float error = size * 0x1p-21F + line.slack;
  const float along = (block.l1_radius + std::abs(seen[0])) * 0x1p-21F + line.slack;
  const float area = error * (size * 6 + error * 4) + kLeastArea;
  const Corners q = turned_corners(line.row, block, seen);
  const SeenAlong areas(q, error, area);
  F8 near = least(q[0][0], q[1][0], q[2][0]) - F8(along);
  F8 far = greatest(q[0][0], q[1][0], q[2][0]) + F8(along);
  const std::uint32_t miss =
      areas.miss | bits((F8(line.near_open) > far) | (near > F8(line.far_open)));
  const std::uint32_t lanes = ((1U << block.count) - 1) & ~miss;
  task.through = lanes & areas.within;
  task.open = lanes & ~task.through;
  near.store(task.near.data());
  far.store(task.far.data());
  task.sure = 0;
  if (task.through == 0) {
    return;
  }
  tighten(q, areas, area, along, near, far);
  task.sure = task.through & bits(near > F8(line.near_sure)) & bits(F8(line.far_sure) > far);
  std::array<float, 8> tight_near;
  std::array<float, 8> tight_far;
  near.store(tight_near.data());
  far.store(tight_far.data());
  for (std::uint32_t left = task.through; left != 0; left &= left - 1) {
    const auto lane = static_cast<std::size_t>(std::countr_zero(left));
    task.near[lane] = tight_near[lane];
    task.far[lane] = tight_far[lane];
  }
}
