/// \file
/// soms queried for points and rays.
#pragma once

#include "soms/soms.h"

#include "bench/peers/libraries/library.h"

#include <memory>

namespace soms::bench {

/// True for the jobs of points and rays that this soms does.
[[nodiscard]] constexpr bool answers_probes(Job job) {
  return job >= Job::closest;
}

/// A body ready for a job; with `batch` all questions of a call are handed over at once.
[[nodiscard]] std::unique_ptr<Match> soms_probes(Job job, Shape shape, bool batch);

}  // namespace soms::bench
