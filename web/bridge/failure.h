/// \file
/// Errors on their way to JavaScript: no exception leaves the module.
#pragma once

#include "soms/base/error.h"

#include <exception>
#include <new>
#include <utility>

namespace soms::web {

/// Keeps an error until the next call; the functions of failure.cpp show it.
void keep(const Error& error);

/// What `work` returns; null, and the error kept, where it throws.
template <class Work>
auto guarded(const Work& work) noexcept -> decltype(work()) {
  try {
    return work();
  } catch (const Error& error) {
    keep(error);
  } catch (const std::bad_alloc&) {
    keep(Error(ErrorKind::out_of_memory, "not enough memory for this call",
               "free shapes and meshes that are no longer needed, or use smaller ones"));
  } catch (const std::exception& error) {
    keep(Error(ErrorKind::unsupported, error.what(), ""));
  }
  return nullptr;
}

}  // namespace soms::web
