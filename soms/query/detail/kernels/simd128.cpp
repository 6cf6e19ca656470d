// SIMD128 of WebAssembly: four lanes.
#include "soms/query/detail/engine/fetch.h"
#include "soms/query/detail/kernels/instruction_set.h"

#if defined(__wasm_simd128__)
#include <wasm_simd128.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <utility>

namespace soms::detail::simd128 {

namespace {

#include "soms/query/detail/kernels/lanes_simd128.h"
//
#include "soms/query/detail/kernels/append_plain.h"
//
#include "soms/query/detail/kernels/lanes_pair.h"
//
#include "soms/query/detail/kernels/offset.h"
//
#include "soms/query/detail/kernels/nodes.h"
//
#include "soms/query/detail/kernels/node_pairs.h"
#include "soms/query/detail/kernels/triangles.h"
//
#include "soms/query/detail/kernels/triangle_pairs.h"
//
#include "soms/query/detail/kernels/box_triangles.h"
//
constexpr std::size_t kDoubles = 2;
#include "soms/query/detail/kernels/lanes_double.h"
//
#include "soms/query/detail/kernels/triangle_pairs_double.h"
//
#include "soms/query/detail/kernels/relative_poses.h"
//
#include "soms/query/detail/kernels/pose_checks.h"
//
#include "soms/query/detail/kernels/neighbors.h"
//
#include "soms/query/detail/kernels/near_nodes.h"
#include "soms/query/detail/kernels/near_triangles.h"
//
#include "soms/query/detail/kernels/parity.h"
//
#include "soms/query/detail/kernels/lines.h"
#include "soms/query/detail/kernels/point_bounds.h"

}  // namespace

const Kernels& kernels() {
  static constexpr Kernels kTable{
      "simd128",     test_nodes,      test_larger,     append,      test_slabs,    test_boxes,
      meet_box,      judge,           judge_in_double, bound_nodes, near_boxes,    near_pairs,
      bound_boxes,   bound_triangles, ray_nodes,       ray_blocks,  passing_poses, apart_at_corner,
      apart_at_edge, relative_poses,  line_descents,   line_node,   line_block};
  return kTable;
}

}  // namespace soms::detail::simd128
#endif
