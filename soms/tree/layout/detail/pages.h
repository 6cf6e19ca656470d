/// \file
/// Memory for large arrays that are written once, in order: no page faults to speak of.
#pragma once

#include <cstddef>
#include <new>
#include <utility>
#include <vector>

namespace soms::layout {

namespace detail {

/// Bytes aligned for any array of the layout; large ones on pages of 2 MB where the system has
/// them.
[[nodiscard]] void* allocate_pages(std::size_t bytes);
void free_pages(void* pages, std::size_t bytes) noexcept;

}  // namespace detail

/// Allocator whose new elements are not written: `resize` leaves them undetermined. For types that
/// are whole once assigned.
template <class T>
class PageAllocator {
 public:
  using value_type = T;

  PageAllocator() = default;

  template <class U>  // NOLINTNEXTLINE(google-explicit-constructor): rebinds
  PageAllocator(const PageAllocator<U>& /*other*/) {}

  [[nodiscard]] T* allocate(std::size_t count) {
    if (count > static_cast<std::size_t>(-1) / 2 / sizeof(T)) {
      throw std::bad_array_new_length();
    }
    return static_cast<T*>(detail::allocate_pages(count * sizeof(T)));
  }

  void deallocate(T* at, std::size_t count) noexcept { detail::free_pages(at, count * sizeof(T)); }

  template <class U>
  void construct(U* /*at*/) noexcept {}

  template <class U, class First, class... Rest>
  void construct(U* at, First&& first, Rest&&... rest) {
    ::new (static_cast<void*>(at)) U(std::forward<First>(first), std::forward<Rest>(rest)...);
  }

  template <class U>
  [[nodiscard]] bool operator==(const PageAllocator<U>& /*other*/) const {
    return true;
  }
};

/// A vector that `resize` does not fill.
template <class T>
using Pages = std::vector<T, PageAllocator<T>>;

}  // namespace soms::layout
