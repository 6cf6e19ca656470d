/// \file
/// Sizes from a fuzzer's input: of bodies, of heaps of small triangles in them, and the limits that
/// coordinates must keep.
#pragma once

#include "soms/base/vector.h"

#include "tests/fuzz/bytes.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace soms::fuzz {

/// A power of two that lengths are counted in: 2^-60 to 2^59, or any of 2^-1070 to 2^270.
inline double unit_of(Bytes& bytes) {
  if (bytes.below(2) == 0) {
    return std::ldexp(1.0, static_cast<int>(bytes.below(120)) - 60);
  }
  const int high = bytes.byte();
  return std::ldexp(1.0, (high << 8 | bytes.byte()) % 1341 - 1070);
}

/// The unit, or one of 2^0 to 2^-60 of it.
inline double unit_of_heap(Bytes& bytes, double unit) {
  return bytes.below(3) == 0 ? std::ldexp(unit, -static_cast<int>(bytes.below(61))) : unit;
}

/// 2^`exponent` units, at most 2^298.
inline double far_by(double unit, int exponent) {
  return std::min(std::ldexp(unit, exponent), 0x1p298);
}

/// The point, within 2^299 on every axis.
inline Vec3 within_limits(Vec3 p) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    p[axis] = std::clamp(p[axis], -0x1p299, 0x1p299);
  }
  return p;
}

}  // namespace soms::fuzz
