/// \file
/// Whole numbers of any length: what exact decisions are counted in.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

namespace soms::detail {

/// Sign and magnitude. Up to 1,536 bits lie in the object itself, which is room for the products of
/// ten differences of ordinary coordinates; longer ones take memory.
/// \errors None but memory.
class Integer {
 public:
  Integer() = default;

  explicit Integer(std::int64_t value) : Integer(value, 0) {}

  /// value * 2^shift
  Integer(std::int64_t value, std::size_t shift) {
    const auto bits = static_cast<std::uint64_t>(value);
    const std::uint64_t magnitude = value < 0 ? 0 - bits : bits;
    negative_ = value < 0;
    if (magnitude == 0) {
      return;
    }
    const std::size_t words = shift / 64;
    const std::size_t rest = shift % 64;
    std::uint64_t* const at = reserve(words + 2);
    std::fill_n(at, words, std::uint64_t{0});
    at[words] = magnitude << rest;
    at[words + 1] = rest == 0 ? 0 : magnitude >> (64 - rest);
    trim(words + 2);
  }

  /// Not negative, by its words, the least first.
  explicit Integer(std::span<const std::uint64_t> words) {
    std::copy(words.begin(), words.end(), reserve(words.size()));
    trim(words.size());
  }

  Integer(const Integer& other) : negative_(other.negative_) {
    std::copy_n(other.words(), other.size_, reserve(other.size_));
    size_ = other.size_;
  }

  Integer& operator=(const Integer& other) {
    if (this != &other) {
      negative_ = other.negative_;
      std::copy_n(other.words(), other.size_, reserve(other.size_));
      size_ = other.size_;
    }
    return *this;
  }

  Integer(Integer&& other) noexcept { take(other); }

  Integer& operator=(Integer&& other) noexcept {
    if (this != &other) {
      take(other);
    }
    return *this;
  }

  ~Integer() = default;

  /// -1, 0 or 1.
  [[nodiscard]] int sign() const { return size_ == 0 ? 0 : negative_ ? -1 : 1; }

  /// Number of bits of the magnitude; 0 for 0.
  [[nodiscard]] std::size_t bit_length() const {
    return size_ == 0 ? 0
                      : 64 * size_ - static_cast<std::size_t>(std::countl_zero(word(size_ - 1)));
  }

  /// Words of the magnitude, and one of them, the least first; 0 beyond them.
  [[nodiscard]] std::size_t size() const { return size_; }

  [[nodiscard]] std::uint64_t word(std::size_t at) const { return at < size_ ? words()[at] : 0; }

  [[nodiscard]] Integer operator-() const {
    Integer result = *this;
    result.negative_ = !negative_;
    return result;
  }

  friend Integer operator+(const Integer& a, const Integer& b) { return added(a, b, b.negative_); }

  friend Integer operator-(const Integer& a, const Integer& b) { return added(a, b, !b.negative_); }

  friend Integer operator*(const Integer& a, const Integer& b) {
    Integer result;
    if (a.size_ == 0 || b.size_ == 0) {
      return result;
    }
    result.negative_ = a.negative_ != b.negative_;
    const std::size_t size = a.size_ + b.size_;
    std::uint64_t* const out = result.reserve(size);
    std::fill_n(out, b.size_, std::uint64_t{0});
    const std::uint64_t* const x = a.words();
    const std::uint64_t* const y = b.words();
    for (std::size_t i = 0; i < a.size_; ++i) {
      Word2 carry = 0;
      for (std::size_t j = 0; j < b.size_; ++j) {
        carry += static_cast<Word2>(x[i]) * y[j] + out[i + j];
        out[i + j] = static_cast<std::uint64_t>(carry);
        carry >>= 64;
      }
      out[i + b.size_] = static_cast<std::uint64_t>(carry);
    }
    result.trim(size);
    return result;
  }

  /// *this * 2^shift
  [[nodiscard]] Integer operator<<(std::size_t shift) const {
    Integer result;
    if (size_ == 0) {
      return result;
    }
    const std::size_t whole = shift / 64;
    const std::size_t rest = shift % 64;
    const std::size_t size = size_ + whole + 1;
    std::uint64_t* const out = result.reserve(size);
    std::fill_n(out, whole, std::uint64_t{0});
    for (std::size_t i = 0; i <= size_; ++i) {
      const std::uint64_t below = rest == 0 || i == 0 ? 0 : word(i - 1) >> (64 - rest);
      out[whole + i] = word(i) << rest | below;
    }
    result.negative_ = negative_;
    result.trim(size);
    return result;
  }

  friend std::strong_ordering operator<=>(const Integer& a, const Integer& b) {
    if (a.sign() != b.sign()) {
      return a.sign() <=> b.sign();
    }
    const std::strong_ordering magnitudes = compare_magnitudes(a, b);
    return a.negative_ ? 0 <=> magnitudes : magnitudes;
  }

  friend bool operator==(const Integer& a, const Integer& b) { return (a <=> b) == 0; }

 private:
  static constexpr std::size_t kInside = 24;
  __extension__ using Word2 = unsigned __int128;

  [[nodiscard]] const std::uint64_t* words() const {
    return outside_ ? outside_.get() : inside_.data();
  }

  /// Room for `size` words; what was there may be lost.
  std::uint64_t* reserve(std::size_t size) {
    if (size > capacity_) {
      outside_.reset(new std::uint64_t[size]);
      capacity_ = size;
    }
    return outside_ ? outside_.get() : inside_.data();
  }

  void trim(std::size_t size) {
    const std::uint64_t* const at = words();
    while (size > 0 && at[size - 1] == 0) {
      --size;
    }
    size_ = size;
    negative_ = negative_ && size > 0;
  }

  void take(Integer& other) noexcept {
    negative_ = other.negative_;
    size_ = other.size_;
    if (other.outside_) {
      outside_ = std::move(other.outside_);
      capacity_ = other.capacity_;
      other.capacity_ = kInside;
      other.size_ = 0;
    } else {
      std::copy_n(other.inside_.data(), size_, outside_ ? outside_.get() : inside_.data());
    }
  }

  static std::strong_ordering compare_magnitudes(const Integer& a, const Integer& b) {
    if (a.size_ != b.size_) {
      return a.size_ <=> b.size_;
    }
    const std::uint64_t* const x = a.words();
    const std::uint64_t* const y = b.words();
    for (std::size_t i = a.size_; i-- > 0;) {
      if (x[i] != y[i]) {
        return x[i] <=> y[i];
      }
    }
    return std::strong_ordering::equal;
  }

  /// a plus b with another sign.
  static Integer added(const Integer& a, const Integer& b, bool negative) {
    if (a.negative_ == negative) {
      return a.size_ < b.size_ ? sum(b, a, negative) : sum(a, b, negative);
    }
    return compare_magnitudes(a, b) < 0 ? difference(b, a, negative)
                                        : difference(a, b, a.negative_);
  }

  /// |a| + |b|, the longer first.
  static Integer sum(const Integer& a, const Integer& b, bool negative) {
    Integer result;
    result.negative_ = negative;
    std::uint64_t* const out = result.reserve(a.size_ + 1);
    const std::uint64_t* const x = a.words();
    const std::uint64_t* const y = b.words();
    std::uint64_t carry = 0;
    for (std::size_t i = 0; i < a.size_; ++i) {
      const Word2 here = static_cast<Word2>(x[i]) + (i < b.size_ ? y[i] : 0) + carry;
      out[i] = static_cast<std::uint64_t>(here);
      carry = static_cast<std::uint64_t>(here >> 64);
    }
    out[a.size_] = carry;
    result.trim(a.size_ + 1);
    return result;
  }

  /// |a| - |b|, the larger first.
  static Integer difference(const Integer& a, const Integer& b, bool negative) {
    Integer result;
    result.negative_ = negative;
    std::uint64_t* const out = result.reserve(a.size_);
    const std::uint64_t* const x = a.words();
    const std::uint64_t* const y = b.words();
    std::uint64_t borrow = 0;
    for (std::size_t i = 0; i < a.size_; ++i) {
      const Word2 here = static_cast<Word2>(x[i]) - (i < b.size_ ? y[i] : 0) - borrow;
      out[i] = static_cast<std::uint64_t>(here);
      borrow = static_cast<std::uint64_t>(here >> 64) & 1;
    }
    result.trim(a.size_);
    return result;
  }

  bool negative_ = false;  ///< never of 0
  std::size_t size_ = 0;
  std::size_t capacity_ = kInside;
  std::array<std::uint64_t, kInside> inside_;  // NOLINT: words beyond `size_` are never read
  std::unique_ptr<std::uint64_t[]> outside_;   // NOLINT(*-avoid-c-arrays)
};

}  // namespace soms::detail
