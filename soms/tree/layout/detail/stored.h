/// \file
/// Arrays of a layout: their own memory, or memory that something else holds, such as a tree file.
#pragma once

#include "soms/tree/layout/detail/pages.h"

#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>

namespace soms::layout {

/// An array that is written once, by its owner, and read everywhere. A copy of a borrowed array
/// borrows, too.
template <class T>
class Stored {
 public:
  Stored() = default;

  // NOLINTNEXTLINE(google-explicit-constructor): it is the same array
  Stored(Pages<T> own) : own_(std::move(own)), begin_(own_.data()), size_(own_.size()) {}

  /// Elements that something else holds for as long as this array or a copy of it lives.
  [[nodiscard]] static Stored borrowed(std::span<const T> elements) {
    Stored array;
    array.begin_ = elements.data();
    array.size_ = elements.size();
    return array;
  }

  Stored(const Stored& other)
      : own_(other.own_), begin_(other.owns() ? own_.data() : other.begin_), size_(other.size_) {}

  Stored(Stored&& other) noexcept
      : own_(std::move(other.own_)),
        begin_(std::exchange(other.begin_, nullptr)),
        size_(std::exchange(other.size_, 0)) {}

  Stored& operator=(Stored other) noexcept {
    own_ = std::move(other.own_);
    begin_ = other.begin_;
    size_ = other.size_;
    return *this;
  }

  ~Stored() = default;

  /// Makes room for as many elements, undetermined until they are written to `own()`.
  void resize(std::size_t count) {
    own_.resize(count);
    begin_ = own_.data();
    size_ = count;
  }

  /// The elements, to be written. \pre They are not borrowed.
  [[nodiscard]] std::span<T> own() { return own_; }

  [[nodiscard]] const T* data() const { return begin_; }

  [[nodiscard]] std::size_t size() const { return size_; }

  [[nodiscard]] bool empty() const { return size_ == 0; }

  [[nodiscard]] const T* begin() const { return begin_; }

  [[nodiscard]] const T* end() const { return begin_ + size_; }

  [[nodiscard]] const T& operator[](std::size_t i) const { return begin_[i]; }

  [[nodiscard]] bool operator==(const Stored& other) const {
    return std::equal(begin(), end(), other.begin(), other.end());
  }

  /// Bytes of its own, or of those it borrows.
  [[nodiscard]] std::size_t memory() const {
    return (owns() ? own_.capacity() : size_) * sizeof(T);
  }

 private:
  [[nodiscard]] bool owns() const { return begin_ == own_.data(); }

  Pages<T> own_;
  const T* begin_ = nullptr;
  std::size_t size_ = 0;
};

}  // namespace soms::layout
