/// \file
/// Whole numbers of great length: what exact twins in tests count with.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <stdexcept>

namespace soms::test {

/// Sign and magnitude of up to 8,192 bits, enough for products of four numbers that range over all
/// doubles up to 2^300. Sums, differences, products and comparison are all that is needed.
/// \errors std::length_error beyond that.
class Integer {
 public:
  Integer() = default;

  /// value * 2^shift
  Integer(std::int64_t value, std::size_t shift) : negative_(value < 0) {
    const auto bits = static_cast<std::uint64_t>(value);
    const std::uint64_t magnitude = negative_ ? 0 - bits : bits;
    const std::uint64_t low = (magnitude & 0xffffffffU) << (shift % 32);
    const std::uint64_t high = (magnitude >> 32) << (shift % 32);
    const std::uint64_t middle = (low >> 32) + (high & 0xffffffffU);
    resize(shift / 32 + 3);
    std::uint32_t* const limb = limbs_.data() + shift / 32;
    limb[0] = static_cast<std::uint32_t>(low);
    limb[1] = static_cast<std::uint32_t>(middle);
    limb[2] = static_cast<std::uint32_t>((high >> 32) + (middle >> 32));
    trim();
  }

  Integer(const Integer& other) { *this = other; }

  Integer& operator=(const Integer& other) {
    negative_ = other.negative_;
    size_ = other.size_;
    std::copy_n(other.limbs_.begin(), size_, limbs_.begin());
    return *this;
  }

  ~Integer() = default;

  /// -1, 0 or 1.
  [[nodiscard]] int sign() const { return size_ == 0 ? 0 : negative_ ? -1 : 1; }

  [[nodiscard]] Integer operator-() const {
    Integer result = *this;
    result.negative_ = !negative_;
    return result;
  }

  friend Integer operator+(const Integer& a, const Integer& b) {
    if (a.negative_ == b.negative_) {
      return a.size_ < b.size_ ? sum(b, a) : sum(a, b);
    }
    return magnitude_less(a, b) ? difference(b, a) : difference(a, b);
  }

  friend Integer operator-(const Integer& a, const Integer& b) { return a + -b; }

  friend Integer operator*(const Integer& a, const Integer& b) {
    Integer result;
    result.negative_ = a.negative_ != b.negative_;
    result.resize(a.size_ + b.size_);
    for (std::size_t i = 0; i < a.size_; ++i) {
      std::uint64_t carry = 0;
      for (std::size_t j = 0; j < b.size_; ++j) {
        carry += std::uint64_t{a.limbs_[i]} * b.limbs_[j] + result.limbs_[i + j];
        result.limbs_[i + j] = static_cast<std::uint32_t>(carry);
        carry >>= 32;
      }
      result.limbs_[i + b.size_] = static_cast<std::uint32_t>(carry);
    }
    result.trim();
    return result;
  }

  friend bool operator<(const Integer& a, const Integer& b) { return (a - b).sign() < 0; }

 private:
  static constexpr std::size_t kMost = 256;

  /// Adds limbs of 0.
  void resize(std::size_t size) {
    if (size > kMost) {
      throw std::length_error("an integer of more than 8,192 bits");
    }
    std::fill(limbs_.begin() + static_cast<std::ptrdiff_t>(size_),
              limbs_.begin() + static_cast<std::ptrdiff_t>(size), 0U);
    size_ = size;
  }

  void trim() {
    while (size_ > 0 && limbs_[size_ - 1] == 0) {
      --size_;
    }
  }

  static bool magnitude_less(const Integer& a, const Integer& b) {
    if (a.size_ != b.size_) {
      return a.size_ < b.size_;
    }
    for (std::size_t i = a.size_; i-- > 0;) {
      if (a.limbs_[i] != b.limbs_[i]) {
        return a.limbs_[i] < b.limbs_[i];
      }
    }
    return false;
  }

  /// Of two numbers of one sign, the longer first.
  static Integer sum(const Integer& a, const Integer& b) {
    Integer result = a;
    result.resize(a.size_ + 1);
    std::uint64_t carry = 0;
    for (std::size_t i = 0; i < result.size_; ++i) {
      carry += std::uint64_t{result.limbs_[i]} + (i < b.size_ ? b.limbs_[i] : 0U);
      result.limbs_[i] = static_cast<std::uint32_t>(carry);
      carry >>= 32;
    }
    result.trim();
    return result;
  }

  /// |a| - |b|, which is not negative, with the sign of a.
  static Integer difference(const Integer& a, const Integer& b) {
    Integer result = a;
    std::int64_t borrow = 0;
    for (std::size_t i = 0; i < a.size_; ++i) {
      borrow += std::int64_t{a.limbs_[i]} - (i < b.size_ ? std::int64_t{b.limbs_[i]} : 0);
      result.limbs_[i] = static_cast<std::uint32_t>(borrow);
      borrow >>= 32;
    }
    result.trim();
    return result;
  }

  bool negative_ = false;
  std::size_t size_ = 0;
  std::array<std::uint32_t, kMost> limbs_;  ///< least first; the last in use is not 0
};

}  // namespace soms::test
