#include "soms/query/detail/box_tests.h"

#include "soms/query/detail/lanes.h"

#include <type_traits>

namespace soms::detail {

namespace {

/// Four boxes, axis by axis.
struct FourBoxes {
  std::array<F4, 3> center;
  std::array<F4, 3> half;

  FourBoxes(const WideNode& node, float scale) {
    for (std::size_t i = 0; i < 3; ++i) {
      center[i] = load(node.center[i]) * scale;
      half[i] = load(node.half[i]) * scale;
    }
  }

  explicit FourBoxes(const WideNode& node) {
    for (std::size_t i = 0; i < 3; ++i) {
      center[i] = load(node.center[i]);
      half[i] = load(node.half[i]);
    }
  }
};

constexpr std::uint32_t lanes(std::uint32_t count) {
  return (1U << count) - 1;
}

/// Where rotation r pairs lanes that are both in use.
constexpr std::uint32_t pairs_in_use(std::uint32_t x, std::uint32_t y) {
  std::uint32_t bits = 0;
  for (std::uint32_t r = 0; r < 4; ++r) {
    for (std::uint32_t k = 0; k < x; ++k) {
      bits |= static_cast<std::uint32_t>((k + r) % 4 < y) << (4 * r + k);
    }
  }
  return bits;
}

struct PairsInUse {
  std::array<std::array<std::uint32_t, 5>, 5> bits = {};

  constexpr PairsInUse() {
    for (std::uint32_t x = 0; x < 5; ++x) {
      for (std::uint32_t y = 0; y < 5; ++y) {
        bits[x][y] = pairs_in_use(x, y);
      }
    }
  }
};

constexpr PairsInUse kPairsInUse;

/// Intervals of four boxes on three axes.
struct Intervals {
  std::array<F4, 3> lower;
  std::array<F4, 3> upper;

  Intervals(const std::array<F4, 3>& center, const std::array<F4, 3>& radius) {
    for (std::size_t i = 0; i < 3; ++i) {
      lower[i] = center[i] - radius[i];
      upper[i] = center[i] + radius[i];
    }
  }
};

/// Lanes of `a` whose intervals miss those of `b`, turned by `R` lanes, on some axis. Comparisons
/// with a NaN are false, so it would count as an overlap.
template <int R>
M4 apart(const Intervals& a, const Intervals& b, M4 sum) {
  for (std::size_t i = 0; i < 3; ++i) {
    sum |= (a.lower[i] > rotate<R>(b.upper[i])) | (rotate<R>(b.lower[i]) > a.upper[i]);
  }
  return sum;
}

}  // namespace

std::uint32_t one_against_four(const Relation& relation, const std::array<float, 3>& half,
                               const WideNode& y) {
  const auto& n = relation.turn->entry;
  const auto& m = relation.turn->magnitude;
  const float ratio = relation.ratio;
  const FourBoxes four(y);
  const std::array<float, 3> h = {half[0] * ratio, half[1] * ratio, half[2] * ratio};
  std::array<F4, 3> gap;
  M4 sum = {};
  for (std::size_t i = 0; i < 3; ++i) {
    const float radius = ((m[i][0] * h[0] + m[i][1] * h[1]) + m[i][2] * h[2]) + relation.margin;
    gap[i] = four.center[i] - relation.offset[i];
    sum |= abs(gap[i]) > four.half[i] + radius;
  }
  for (std::size_t j = 0; j < 3; ++j) {
    const F4 along = (gap[0] * n[0][j] + gap[1] * n[1][j]) + gap[2] * n[2][j];
    const F4 radius = (four.half[0] * m[0][j] + four.half[1] * m[1][j]) + four.half[2] * m[2][j];
    sum |= abs(along) > radius + (h[j] + relation.margin);
  }
  return ~bits_of(sum) & lanes(y.count);
}

std::uint32_t four_against_one(const Relation& relation, const WideNode& x,
                               const std::array<float, 3>& half) {
  const auto& n = relation.turn->entry;
  const auto& m = relation.turn->magnitude;
  const FourBoxes four(x, relation.ratio);
  std::array<F4, 3> gap;
  M4 sum = {};
  for (std::size_t i = 0; i < 3; ++i) {
    gap[i] = ((four.center[0] * n[i][0] + four.center[1] * n[i][1]) + four.center[2] * n[i][2]) +
             relation.offset[i];
    const F4 radius = (four.half[0] * m[i][0] + four.half[1] * m[i][1]) + four.half[2] * m[i][2];
    sum |= abs(gap[i]) > radius + (half[i] + relation.margin);
  }
  for (std::size_t j = 0; j < 3; ++j) {
    const F4 along = (gap[0] * n[0][j] + gap[1] * n[1][j]) + gap[2] * n[2][j];
    const float radius =
        ((m[0][j] * half[0] + m[1][j] * half[1]) + m[2][j] * half[2]) + relation.margin;
    sum |= abs(along) > four.half[j] + radius;
  }
  return ~bits_of(sum) & lanes(x.count);
}

std::uint32_t four_against_four(const Relation& relation, const WideNode& x, const WideNode& y) {
  const auto& n = relation.turn->entry;
  const auto& m = relation.turn->magnitude;
  const FourBoxes fx(x, relation.ratio);
  const FourBoxes fy(y);
  std::array<F4, 3> center_x;
  std::array<F4, 3> radius_x;
  std::array<F4, 3> center_y;
  std::array<F4, 3> radius_y;
  std::array<F4, 3> away;
  for (std::size_t i = 0; i < 3; ++i) {
    center_x[i] = ((fx.center[0] * n[i][0] + fx.center[1] * n[i][1]) + fx.center[2] * n[i][2]) +
                  relation.offset[i];
    radius_x[i] =
        ((fx.half[0] * m[i][0] + fx.half[1] * m[i][1]) + fx.half[2] * m[i][2]) + relation.margin;
    away[i] = fy.center[i] - relation.offset[i];
  }
  for (std::size_t j = 0; j < 3; ++j) {
    center_y[j] = (away[0] * n[0][j] + away[1] * n[1][j]) + away[2] * n[2][j];
    radius_y[j] =
        ((fy.half[0] * m[0][j] + fy.half[1] * m[1][j]) + fy.half[2] * m[2][j]) + relation.margin;
  }
  const Intervals x_in_y(center_x, radius_x);
  const Intervals y_in_y(fy.center, fy.half);
  const Intervals x_in_x(fx.center, fx.half);
  const Intervals y_in_x(center_y, radius_y);
  const auto turned = [&]<int R>(std::integral_constant<int, R>) {
    return bits_of(apart<R>(x_in_x, y_in_x, apart<R>(x_in_y, y_in_y, M4{}))) << (4 * R);
  };
  const std::uint32_t sum =
      turned(std::integral_constant<int, 0>{}) | turned(std::integral_constant<int, 1>{}) |
      turned(std::integral_constant<int, 2>{}) | turned(std::integral_constant<int, 3>{});
  return ~sum & kPairsInUse.bits[x.count][y.count];
}

}  // namespace soms::detail
