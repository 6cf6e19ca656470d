/// \file
/// Work that is cut into chunks, which threads share.
#pragma once

#include "soms/base/limits.h"

#include <cstddef>
#include <functional>

namespace soms {

/// Runs `body(begin, end)` for fixed chunks of `[0, count)`, each of `chunk` items (the last may be
/// smaller). Chunks run on any thread in any order; their bounds depend on `count` and `chunk`
/// only, so results written by chunk number are the same for any number of threads. Exceptions of a
/// body are rethrown once all threads have stopped. \errors Between chunks, as `check(Limits)`.
void for_each_chunk(std::size_t count, std::size_t chunk, const Limits& limits,
                    const std::function<void(std::size_t begin, std::size_t end)>& body);

}  // namespace soms
