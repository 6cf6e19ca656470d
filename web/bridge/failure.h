/// \file
/// Errors on their way to JavaScript: no exception leaves the module.
#pragma once

#include "soms/base/error.h"

#include <exception>
#include <new>
#include <stdexcept>
#include <utility>

namespace soms::web {

/// Keeps an error until the next call; the functions of failure.cpp show it.
void keep(const Error& error);

inline void keep_out_of_memory() {
  keep(Error(ErrorKind::out_of_memory, "not enough memory for this call",
             "free shapes and meshes that are no longer needed, or use smaller ones"));
}

/// What `work` returns; null, and the error kept, where it throws.
template <class Work>
auto guarded(const Work& work) noexcept -> decltype(work()) {
  try {
    return work();
  } catch (const Error& error) {
    keep(error);
  } catch (const std::bad_alloc&) {
    keep_out_of_memory();
  } catch (const std::length_error&) {
    keep_out_of_memory();  // of a container larger than all of the module's memory
  } catch (const std::exception& error) {
    keep(Error(ErrorKind::unsupported, error.what(), ""));
  }
  return nullptr;
}

}  // namespace soms::web
