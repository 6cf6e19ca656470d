/// \file
/// What older standard libraries lack of C++20, each decided by its feature-test macro.
#pragma once

#include <atomic>
#include <bit>
#include <cstddef>
#include <memory>
#include <version>

namespace soms {

#ifdef __cpp_lib_bit_cast
using std::bit_cast;
#else
/// The value of another type that has the same bits.
template <class To, class From>
[[nodiscard]] constexpr To bit_cast(const From& from) noexcept {
  return __builtin_bit_cast(To, from);
}
#endif

#ifdef __cpp_lib_atomic_ref
template <class T>
using AtomicRef = std::atomic_ref<T>;
#else
/// A number that several threads read and write, each access relaxed.
template <class T>
class AtomicRef {
 public:
  explicit AtomicRef(T& value) : value_(&value) {}

  [[nodiscard]] T load(std::memory_order /*relaxed*/) const {
    T now;
    __atomic_load(value_, &now, __ATOMIC_RELAXED);
    return now;
  }

  [[nodiscard]] bool compare_exchange_weak(T& expected, T wanted,
                                           std::memory_order /*relaxed*/) const {
    return __atomic_compare_exchange(value_, &expected, &wanted, true, __ATOMIC_RELAXED,
                                     __ATOMIC_RELAXED);
  }

 private:
  T* value_;
};
#endif

/// An array, or an object, whose numbers are not cleared before they are written.
template <class T>
[[nodiscard]] std::unique_ptr<T> make_for_overwrite() {
#ifdef __cpp_lib_smart_ptr_for_overwrite
  return std::make_unique_for_overwrite<T>();
#else
  return std::unique_ptr<T>(new T);
#endif
}

template <class T>
[[nodiscard]] std::unique_ptr<T[]> make_array_for_overwrite(std::size_t size) {
#ifdef __cpp_lib_smart_ptr_for_overwrite
  return std::make_unique_for_overwrite<T[]>(size);
#else
  return std::unique_ptr<T[]>(new T[size]);
#endif
}

}  // namespace soms
