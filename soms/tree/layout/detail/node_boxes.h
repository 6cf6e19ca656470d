/// \file
/// The boxes of a node's lanes, rounded outward.
#pragma once

#include "soms/tree/layout/detail/frame.h"
#include "soms/tree/layout/detail/node_axes.h"
#include "soms/tree/layout/detail/wide_tree.h"

#include <span>

namespace soms::layout {

/// What lies in a lane of a node.
struct LaneContent {
  Box bounds;                             ///< of its triangles, in the mesh's own numbers
  std::span<const TriangleBlock> blocks;  ///< its triangles; not read if boxes are not turned
};

/// Sets all that tells of boxes in a node whose count and origin are set: along `axes` where boxes
/// get a tenth smaller by it, else along the mesh's.
void set_boxes(std::span<const LaneContent> lanes, const Axes& axes, const Frame& frame,
               WideNode& node);

/// The same bytes by the instructions that every processor has.
void set_boxes_plainly(std::span<const LaneContent> lanes, const Axes& axes, const Frame& frame,
                       WideNode& node);

}  // namespace soms::layout
