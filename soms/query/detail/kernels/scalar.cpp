// The twin of all other kernels: plain floats in arrays.
#include "soms/query/detail/engine/fetch.h"
#include "soms/query/detail/kernels/instruction_set.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <utility>

namespace soms::detail::scalar {

namespace {

struct M4 {
  std::uint32_t set;
};

inline M4 operator|(M4 a, M4 b) {
  return {a.set | b.set};
}

inline M4 operator&(M4 a, M4 b) {
  return {a.set & b.set};
}

inline M4 operator^(M4 a, M4 b) {
  return {a.set ^ b.set};
}

inline std::uint32_t bits(M4 m) {
  return m.set;
}

struct F4 {
  F4() = default;

  explicit F4(float x) : v{x, x, x, x} {}

  static F4 load(const float* from) {
    F4 a;
    for (std::size_t k = 0; k < 4; ++k) {
      a.v[k] = from[k];
    }
    return a;
  }

  static F4 gather(const float* from, const std::uint32_t* at) {
    F4 a;
    for (std::size_t k = 0; k < 4; ++k) {
      a.v[k] = from[at[k]];
    }
    return a;
  }

  void store(float* to) const {
    for (std::size_t k = 0; k < 4; ++k) {
      to[k] = v[k];
    }
  }

  std::array<float, 4> v;
};

template <class Of>
F4 each(Of of) {
  F4 c;
  for (std::size_t k = 0; k < 4; ++k) {
    c.v[k] = of(k);
  }
  return c;
}

F4 operator+(F4 a, F4 b) {
  return each([&](std::size_t k) { return a.v[k] + b.v[k]; });
}

F4 operator-(F4 a, F4 b) {
  return each([&](std::size_t k) { return a.v[k] - b.v[k]; });
}

F4 operator*(F4 a, F4 b) {
  return each([&](std::size_t k) { return a.v[k] * b.v[k]; });
}

F4 operator/(F4 a, F4 b) {
  return each([&](std::size_t k) { return a.v[k] / b.v[k]; });
}

F4 sqrt(F4 a) {
  return each([&](std::size_t k) { return std::sqrt(a.v[k]); });
}

M4 operator>(F4 a, F4 b) {
  std::uint32_t set = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    set |= static_cast<std::uint32_t>(a.v[k] > b.v[k]) << k;
  }
  return {set};
}

F4 min(F4 a, F4 b) {
  return each([&](std::size_t k) { return a.v[k] < b.v[k] ? a.v[k] : b.v[k]; });
}

F4 max(F4 a, F4 b) {
  return each([&](std::size_t k) { return a.v[k] > b.v[k] ? a.v[k] : b.v[k]; });
}

F4 abs(F4 a) {
  return each([&](std::size_t k) { return std::abs(a.v[k]); });
}

F4 select(M4 where, F4 a, F4 b) {
  return each([&](std::size_t k) { return (where.set >> k & 1U) != 0 ? a.v[k] : b.v[k]; });
}

/// Lane k takes what lane (k + R) mod 4 held.
template <int R>
F4 rotate(F4 a) {
  return each([&](std::size_t k) { return a.v[(k + R) % 4]; });
}

F4 with_last(F4 a, float x) {
  a.v[3] = x;
  return a;
}

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
      "scalar",      test_nodes,      test_larger,     append,      test_slabs,    test_boxes,
      meet_box,      judge,           judge_in_double, bound_nodes, near_boxes,    near_pairs,
      bound_boxes,   bound_triangles, ray_nodes,       ray_blocks,  passing_poses, apart_at_corner,
      apart_at_edge, relative_poses,  line_descents,   line_node,   line_block};
  return kTable;
}

}  // namespace soms::detail::scalar
