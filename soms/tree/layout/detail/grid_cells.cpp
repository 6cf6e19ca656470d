#include "soms/tree/layout/detail/grid_cells.h"

#include <cstring>

namespace soms::layout {

namespace {

// Compiled for the instructions that every processor has and for AVX2, as blocks are made: each
// lane is a number, so all give the same bytes.

#if defined(__GNUC__) && !defined(__clang__)
// How vectors would be passed without AVX does not matter: nothing passes them.
#pragma GCC diagnostic ignored "-Wpsabi"
#endif

constexpr std::size_t kHalf = 4;
using Doubles [[gnu::vector_size(32)]] = double;
using Singles [[gnu::vector_size(16)]] = float;
using Ints [[gnu::vector_size(16)]] = std::int32_t;

// Corners in a block are rounded to nearest.
constexpr double kCornerRounding = 0x1p-23;

[[gnu::always_inline]] inline Singles half_of(const std::array<float, TriangleBlock::kWidth>& row,
                                              std::size_t first) {
  Singles v;
  std::memcpy(&v, row.data() + first, sizeof v);
  return v;
}

[[gnu::always_inline]] inline Singles lesser(const Singles& a, const Singles& b) {
  return b < a ? b : a;
}

[[gnu::always_inline]] inline Singles greater(const Singles& a, const Singles& b) {
  return b > a ? b : a;
}

[[gnu::always_inline]] inline Doubles all(double x) {
  return Doubles{x, x, x, x};
}

/// `rounded_up` in each lane.
[[gnu::always_inline]] inline Singles up(const Doubles& x) {
  const Singles rounded = __builtin_convertvector(x, Singles);
  const Ints below = __builtin_convertvector(__builtin_convertvector(rounded, Doubles) < x, Ints);
  Ints bits;
  std::memcpy(&bits, &rounded, sizeof bits);
  const Ints one = {1, 1, 1, 1};
  bits += below & (rounded >= Singles{} ? one : -one);
  Singles result;
  std::memcpy(&result, &bits, sizeof result);
  return result;
}

/// As MinMaxGrid::cell in each lane.
[[gnu::always_inline]] inline Ints cells_at(const Doubles& x, const GridFrame& frame,
                                            std::size_t k) {
  const Doubles place = (x - all(frame.corner[k])) * all(frame.cells_a_unit);
  const Doubles last = all(frame.last[k]);
  const Doubles below = place < last ? place : last;
  return __builtin_convertvector(place > Doubles{} ? below : Doubles{}, Ints);
}

[[gnu::always_inline]] inline void find(const TriangleBlock& block, const GridFrame& frame,
                                        GridCells& cells) {
  const Doubles give = all(kCornerRounding * static_cast<double>(block.l1_radius));
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t axis = frame.axis[i];
    const Doubles at = all(block.origin[axis] * frame.scale);
    for (std::size_t first = 0; first < TriangleBlock::kWidth; first += kHalf) {
      const Singles a = half_of(block.corner[axis], first);
      const Singles b = half_of(block.corner[3 + axis], first);
      const Singles c = half_of(block.corner[6 + axis], first);
      const Singles least = lesser(lesser(a, b), c);
      const Singles most = greater(greater(a, b), c);
      const Doubles lower = at + (__builtin_convertvector(least, Doubles) - give);
      const Doubles upper = at + (__builtin_convertvector(most, Doubles) + give);
      if (i < 2) {
        const Ints from = cells_at(lower, frame, i);
        const Ints to = cells_at(upper, frame, i);
        std::memcpy(cells.from[i].data() + first, &from, sizeof from);
        std::memcpy(cells.to[i].data() + first, &to, sizeof to);
      } else {
        const Singles down = -up(-lower);
        const Singles top = up(upper);
        std::memcpy(cells.least.data() + first, &down, sizeof down);
        std::memcpy(cells.most.data() + first, &top, sizeof top);
      }
    }
  }
}

#if defined(__x86_64__)
[[gnu::target("avx2")]] void find_by_avx2(const TriangleBlock& block, const GridFrame& frame,
                                          GridCells& cells) {
  find(block, frame, cells);
}
#endif

}  // namespace

void find_cells_plainly(const TriangleBlock& block, const GridFrame& frame, GridCells& cells) {
  find(block, frame, cells);
}

void find_cells(const TriangleBlock& block, const GridFrame& frame, GridCells& cells) {
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx2")) {
    find_by_avx2(block, frame, cells);
    return;
  }
#endif
  find_cells_plainly(block, frame, cells);
}

}  // namespace soms::layout
