/// \file
/// Sums of many angles with one arctangent: complex numbers are multiplied, and turns are counted.
#pragma once

#include <cmath>

namespace soms::detail {

/// The argument of re + i im in turns, in [-1/2, 1/2]: within `kArgumentError`. Of a negative
/// number it is 1/2 or -1/2, as the sign bit of `im` says. \pre Not both are 0.
[[nodiscard]] double argument_in_turns(double re, double im);

/// Largest error of `argument_in_turns`, in turns. With u = 2^-53: the reduced tangent s, at most
/// tan(pi/8) < 0.4143, is off by 3 u of itself, its arctangent by 1.25 u for that, by 1.3 u for
/// Horner's scheme (the terms alternate; the last factor is rounded twice, the others weigh
/// s^2 < 0.172 each) and by s^47 / 47 < 0.001 u for what the series leaves out. Over 2 pi, rounded
/// twice more, that is 0.55 u; then come at most three sums of numbers up to 1/2, u/4 each.
/// A tangent, or a square of one, that underflows is off by 2^-1074, which is nothing.
inline constexpr double kArgumentError = 4 * 0x1p-53;
static_assert((1.25 + 1.3 + 0.001) / 6.28 + 2 * 0.4143 / 6.28 + 3 * 0.25 < 4);

/// A sum of arguments.
///
/// The product of the numbers has the sum as its argument, but for whole turns. A factor whose
/// imaginary part has the other sign than the product so far never leads past half a turn. Where
/// the signs are the same, it does so if and only if the sign of the new product's imaginary part
/// is another. Signs are those of the sign bit: zeros have one, so the count is right on the axes,
/// too: where both factors are at most a quarter turn from 0, or both at least that far, the new
/// imaginary part is a sum of terms of one sign, which no rounding changes; else the sum is
/// between a quarter and three quarters of a turn, and at half a turn either way of counting it is
/// the same sum.
class AngleSum {
 public:
  /// Adds the argument of a number of magnitude 2^-100 to 2. Off by 2.24 u radians at most: the
  /// rounding of a complex product. \source Brent, Percival and Zimmermann 2007
  /// Products are at least 2^-401 in magnitude: a part of one that underflows, to a zero of its own
  /// sign, turns nothing.
  void add(double re, double im) {
    const double next_re = re_ * re - im_ * im;
    const double next_im = re_ * im + im_ * re;
    const bool below = std::signbit(im_);
    if (below == std::signbit(im) && below != std::signbit(next_im)) {
      turns_ += below ? -1 : 1;
    }
    re_ = next_re;
    im_ = next_im;
    const double size = std::abs(re_) + std::abs(im_);
    if (size < 0x1p-300) {
      re_ *= 0x1p300;
      im_ *= 0x1p300;
    } else if (size > 0x1p300) {
      re_ *= 0x1p-300;
      im_ *= 0x1p-300;
    }
  }

  /// Whole turns of the sum.
  [[nodiscard]] double turns() const { return turns_; }

  /// What is left of it, in turns.
  [[nodiscard]] double rest() const { return argument_in_turns(re_, im_); }

 private:
  double re_ = 1;
  double im_ = 0;
  double turns_ = 0;
};

}  // namespace soms::detail
