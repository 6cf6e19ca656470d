/// \file
/// How much of the machine a call may use, how it is stopped, and how it reports progress.
#pragma once

#include "soms/base/stop_token.h"

#include <cstddef>
#include <functional>

namespace soms {

/// Threads, cancellation and progress of one call. The default is one thread, no way to stop, no
/// reports. Results are the same bytes for any number of threads.
struct Parallel {
  /// Worker threads, the caller's included; 0 means one for each processor.
  int threads = 1;
  /// Ends the call with ErrorKind::cancelled soon after a stop is requested.
  StopToken stop = {};
  /// Called now and then with the share done, 0 to 1, by one thread at a time; may be empty.
  std::function<void(double)> progress = {};
};

/// Throws ErrorKind::cancelled if a stop was requested.
void check_stop(const Parallel& parallel);

/// Runs `body(begin, end)` for fixed chunks of `[0, count)`, each of `chunk` items (the last may be
/// smaller). Chunks run on any thread in any order; their bounds depend on `count` and `chunk`
/// only, so results written by chunk number are the same for any number of threads. Exceptions of a
/// body are rethrown once all threads have stopped. \errors ErrorKind::cancelled between chunks.
void for_each_chunk(std::size_t count, std::size_t chunk, const Parallel& parallel,
                    const std::function<void(std::size_t begin, std::size_t end)>& body);

}  // namespace soms
