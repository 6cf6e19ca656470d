/// \file
/// Seeded random numbers that are the same on every machine.
#pragma once

#include <cstdint>

namespace soms {

/// SplitMix64: a small generator with a 64-bit state, every seed a good one.
/// \source Steele, Lea, Flood, Fast splittable pseudorandom number generators, OOPSLA 2014.
class Rng {
 public:
  explicit constexpr Rng(std::uint64_t seed) : state_(seed) {}

  constexpr std::uint64_t next() {
    state_ += 0x9e3779b97f4a7c15ULL;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
    return z ^ (z >> 31);
  }

  /// Uniform in [0, 1), a multiple of 2^-53.
  constexpr double unit() { return static_cast<double>(next() >> 11) * 0x1p-53; }

  /// Uniform in [lower, upper).
  constexpr double uniform(double lower, double upper) { return lower + (upper - lower) * unit(); }

  /// Uniform integer in [0, n); n at least 1. The bias is below n / 2^64.
  constexpr std::uint64_t below(std::uint64_t n) { return next() % n; }

 private:
  std::uint64_t state_;
};

}  // namespace soms
