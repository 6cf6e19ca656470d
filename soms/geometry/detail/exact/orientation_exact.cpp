#include "soms/geometry/detail/exact/orientation_exact.h"

#include "soms/base/portable.h"
#include "soms/geometry/detail/projection.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace soms::detail {

namespace {

__extension__ using Int128 = __int128;
__extension__ using Uint128 = unsigned __int128;

using Axis = std::array<double, 4>;

constexpr int kExponentBias = 1023;

int biased_exponent(double x) {
  return static_cast<int>((bit_cast<std::uint64_t>(x) >> 52) & 0x7ff);
}

double power_of_two(int exponent) {
  return bit_cast<double>(static_cast<std::uint64_t>(exponent + kExponentBias) << 52);
}

/// The coordinates of one axis as integers below 2^60 in a unit of 2^exponent.
struct GridAxis {
  std::array<std::int64_t, 4> at = {};
  int exponent = 0;
};

/// Finds the unit of an axis, or false. A common factor of an axis is a positive factor of the
/// determinant, so each axis has its own.
bool to_grid(const Axis& in, GridAxis& out) {
  const double most = std::max(std::max(std::abs(in[0]), std::abs(in[1])),
                               std::max(std::abs(in[2]), std::abs(in[3])));
  if (most == 0) {
    return true;
  }
  const int exponent = biased_exponent(most) - kExponentBias;
  if (exponent < -900 || exponent > 900) {
    return false;
  }
  const double scale = power_of_two(59 - exponent);
  const double unit = power_of_two(exponent - 59);
  bool fits = true;
  for (std::size_t i = 0; i < 4; ++i) {
    out.at[i] = static_cast<std::int64_t>(in[i] * scale);
    // Multiplying back is exact, so equality also rules out a coordinate that vanished in `scale`.
    fits = fits && static_cast<double>(out.at[i]) * unit == in[i];
  }
  out.exponent = exponent - 59;
  return fits;
}

/// u0*v1 - u1*v0; entries below 2^61, so below 2^123.
Int128 minor(std::int64_t u0, std::int64_t u1, std::int64_t v0, std::int64_t v1) {
  return static_cast<Int128>(u0) * v1 - static_cast<Int128>(u1) * v0;
}

/// Sum of products of a 124-bit and a 62-bit integer, kept as high * 2^64 + low.
struct Sum192 {
  Int128 high = 0;
  Int128 low = 0;

  void add(Int128 m, std::int64_t w) {
    high += (m >> 64) * w;
    low += static_cast<Int128>(static_cast<std::uint64_t>(m)) * w;
  }

  [[nodiscard]] Sign sign() const {
    const Int128 top = high + (low >> 64);
    if (top != 0) {
      return top > 0 ? Sign::positive : Sign::negative;
    }
    return static_cast<std::uint64_t>(low) == 0 ? Sign::zero : Sign::positive;
  }

  /// The sum with two roundings: its upper and its lower part have one sign.
  [[nodiscard]] double value() const {
    const Int128 top = high + (low >> 64);
    const auto bottom = static_cast<std::uint64_t>(low);
    if (top >= 0) {
      return static_cast<double>(top) * 0x1p64 + static_cast<double>(bottom);
    }
    const Int128 opposite = -(top + (bottom != 0 ? 1 : 0));
    return -(static_cast<double>(opposite) * 0x1p64 + static_cast<double>(0 - bottom));
  }
};

/// The determinant of points on a grid, in a unit of 2^exponent.
struct GridDeterminant {
  Sum192 sum;
  int exponent = 0;
};

/// Nothing where the points are on no grid.
std::optional<GridDeterminant> determinant_of_grid(const Vec3& a, const Vec3& b, const Vec3& c,
                                                   const Vec3& d) {
  GridAxis x;
  GridAxis y;
  GridAxis z;
  if (!to_grid({a.x, b.x, c.x, d.x}, x) || !to_grid({a.y, b.y, c.y, d.y}, y) ||
      !to_grid({a.z, b.z, c.z, d.z}, z)) {
    return std::nullopt;
  }
  for (GridAxis* axis : {&x, &y, &z}) {
    for (std::size_t i = 1; i < 4; ++i) {
      axis->at[i] -= axis->at[0];
    }
  }
  GridDeterminant det{{}, x.exponent + y.exponent + z.exponent};
  det.sum.add(minor(y.at[1], z.at[1], y.at[2], z.at[2]), x.at[3]);
  det.sum.add(minor(z.at[1], x.at[1], z.at[2], x.at[2]), y.at[3]);
  det.sum.add(minor(x.at[1], y.at[1], x.at[2], y.at[2]), z.at[3]);
  return det;
}

/// |x| = mantissa * 2^exponent.
struct Decoded {
  std::uint64_t mantissa = 0;
  int exponent = 0;
  bool negative = false;
};

Decoded decode(double x) {
  const auto bits = bit_cast<std::uint64_t>(x);
  const int biased = biased_exponent(x);
  const std::uint64_t fraction = bits & ((std::uint64_t{1} << 52) - 1);
  return {biased == 0 ? fraction : fraction | (std::uint64_t{1} << 52), std::max(biased, 1) - 1075,
          (bits >> 63) != 0};
}

/// One axis of four points as mantissas and shifts above the least exponent among them.
struct DecodedAxis {
  std::array<Decoded, 4> at;
  int least = 4096;  ///< exponent that shifts count from
  int span = 0;      ///< largest shift

  explicit DecodedAxis(const Axis& in) {
    for (std::size_t i = 0; i < 4; ++i) {
      at[i] = decode(in[i]);
      least = at[i].mantissa == 0 ? least : std::min(least, at[i].exponent);
    }
    for (Decoded& x : at) {
      x.exponent = x.mantissa == 0 ? 0 : x.exponent - least;
      span = std::max(span, x.exponent);
    }
  }
};

/// A sum of products of three mantissas, in two's complement. 24 products of 159 bits each fit into
/// 164 bits and a sign above the largest shift, and three times the 2045 binades of finite doubles
/// into 100 words.
class WideSum {
 public:
  explicit WideSum(int largest_shift) : count_(static_cast<std::size_t>(largest_shift) / 64 + 4) {
    std::fill_n(words_.begin(), count_, std::uint64_t{0});
  }

  void add(const Decoded& x, const Decoded& y, const Decoded& z, bool negate) {
    if (x.mantissa == 0 || y.mantissa == 0 || z.mantissa == 0) {
      return;
    }
    const Uint128 xy = static_cast<Uint128>(x.mantissa) * y.mantissa;
    const Uint128 low = static_cast<Uint128>(static_cast<std::uint64_t>(xy)) * z.mantissa;
    const Uint128 high = (xy >> 64) * z.mantissa + (low >> 64);
    const int shift = x.exponent + y.exponent + z.exponent;
    const std::array<std::uint64_t, 3> product{static_cast<std::uint64_t>(low),
                                               static_cast<std::uint64_t>(high),
                                               static_cast<std::uint64_t>(high >> 64)};
    const bool negative = ((x.negative != y.negative) != z.negative) != negate;
    add_shifted(product, shift, negative);
  }

  [[nodiscard]] Sign sign() const {
    if ((words_[count_ - 1] >> 63) != 0) {
      return Sign::negative;
    }
    const auto* end = words_.data() + count_;
    return std::all_of(words_.data(), end, [](std::uint64_t w) { return w == 0; }) ? Sign::zero
                                                                                   : Sign::positive;
  }

  /// The sum, of which 65 bits at least count.
  [[nodiscard]] ScaledNumber value() const {
    const bool negative = (words_[count_ - 1] >> 63) != 0;
    ScaledNumber result;
    double below = 0;  // the word below the one that was read last
    bool carry = true;
    for (std::size_t k = 0; k < count_; ++k) {
      const std::uint64_t word = negative ? ~words_[k] + (carry ? 1U : 0U) : words_[k];
      carry = carry && word == 0;
      const auto here = static_cast<double>(word);
      if (word != 0) {
        result = {here + 0x1p-64 * below, 64 * static_cast<int>(k)};
      }
      below = here;
    }
    result.fraction = negative ? -result.fraction : result.fraction;
    return result;
  }

 private:
  void add_shifted(const std::array<std::uint64_t, 3>& product, int shift, bool negative) {
    std::size_t at = static_cast<std::size_t>(shift) / 64;
    const int bits = shift % 64;
    std::uint64_t carry = 0;
    for (std::size_t i = 0; i < 4 || (carry != 0 && at < count_); ++i, ++at) {
      const std::uint64_t upper = i < 3 ? product[i] << bits : 0;
      const std::uint64_t lower = i == 0 || i > 3 || bits == 0 ? 0 : product[i - 1] >> (64 - bits);
      const std::uint64_t term = upper | lower;
      const std::uint64_t old = words_[at];
      const std::uint64_t partial = negative ? old - term : old + term;
      const std::uint64_t result = negative ? partial - carry : partial + carry;
      // At most one of the two steps wraps, since `term + carry` is taken from one word.
      carry = negative ? static_cast<std::uint64_t>(old < term || partial < carry)
                       : static_cast<std::uint64_t>(partial < old || result < partial);
      words_[at] = result;
    }
  }

  std::size_t count_;
  std::array<std::uint64_t, 100> words_;
};

/// Adds or subtracts the determinant whose rows are points i, j, k.
void add_determinant(WideSum& sum, const DecodedAxis& x, const DecodedAxis& y, const DecodedAxis& z,
                     const std::array<std::size_t, 3>& rows, bool negate) {
  const auto [i, j, k] = rows;
  sum.add(x.at[i], y.at[j], z.at[k], negate);
  sum.add(x.at[j], y.at[k], z.at[i], negate);
  sum.add(x.at[k], y.at[i], z.at[j], negate);
  sum.add(x.at[i], y.at[k], z.at[j], !negate);
  sum.add(x.at[j], y.at[i], z.at[k], !negate);
  sum.add(x.at[k], y.at[j], z.at[i], !negate);
}

/// All 24 products of three axes.
WideSum sum_of_products(const DecodedAxis& x, const DecodedAxis& y, const DecodedAxis& z) {
  WideSum det(x.span + y.span + z.span);
  add_determinant(det, x, y, z, {1, 2, 3}, false);
  add_determinant(det, x, y, z, {0, 2, 3}, true);
  add_determinant(det, x, y, z, {0, 1, 3}, false);
  add_determinant(det, x, y, z, {0, 1, 2}, true);
  return det;
}

/// A point of the plane z = 0. Seen from `kAbovePlane`, the determinant is the planar one times 1.
Vec3 flat(const Vec3& p, Projection plane) {
  return {first_coordinate(p, plane), second_coordinate(p, plane), 0};
}

constexpr Vec3 kAbovePlane{0, 0, 1};

bool all_equal(double a, double b, double c, double d) {
  return a == b && a == c && a == d;
}

}  // namespace

std::optional<Sign> orientation_grid(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const std::optional<GridDeterminant> det = determinant_of_grid(a, b, c, d);
  return det ? std::optional(det->sum.sign()) : std::nullopt;
}

Sign orientation_wide(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const DecodedAxis x({a.x, b.x, c.x, d.x});
  const DecodedAxis y({a.y, b.y, c.y, d.y});
  const DecodedAxis z({a.z, b.z, c.z, d.z});
  return sum_of_products(x, y, z).sign();
}

Sign orientation_exact(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  if (all_equal(a.x, b.x, c.x, d.x) || all_equal(a.y, b.y, c.y, d.y) ||
      all_equal(a.z, b.z, c.z, d.z) || d == a || d == b || d == c) {
    return Sign::zero;
  }
  const std::optional<Sign> sign = orientation_grid(a, b, c, d);
  return sign ? *sign : orientation_wide(a, b, c, d);
}

Sign orientation2d_exact(const Vec3& a, const Vec3& b, const Vec3& c, Projection plane) {
  return orientation_exact(flat(a, plane), flat(b, plane), flat(c, plane), kAbovePlane);
}

ScaledNumber determinant(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  if (const std::optional<GridDeterminant> det = determinant_of_grid(a, b, c, d)) {
    return {det->sum.value(), det->exponent};
  }
  const DecodedAxis x({a.x, b.x, c.x, d.x});
  const DecodedAxis y({a.y, b.y, c.y, d.y});
  const DecodedAxis z({a.z, b.z, c.z, d.z});
  ScaledNumber value = sum_of_products(x, y, z).value();
  value.exponent += x.least + y.least + z.least;
  return value;
}

ScaledNumber determinant2d(const Vec3& a, const Vec3& b, const Vec3& c, Projection plane) {
  return determinant(flat(a, plane), flat(b, plane), flat(c, plane), kAbovePlane);
}

}  // namespace soms::detail
