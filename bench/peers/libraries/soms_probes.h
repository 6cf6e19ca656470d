/// \file
/// soms queried for points and rays.
#pragma once

#include "soms/soms.h"

#include "bench/peers/libraries/library.h"

#include <memory>

#if __has_include("soms/query/ray.h")
#include "soms/query/ray.h"
#define SOMS_BENCH_RAYS
#endif

namespace soms::bench {

/// True for the jobs of points and rays that this soms does.
[[nodiscard]] constexpr bool answers_probes(Job job) {
#ifdef SOMS_BENCH_RAYS
  return job >= Job::closest;
#else
  return job == Job::closest || job == Job::contains;
#endif
}

/// A body ready for a job; with `batch` all questions of a call are handed over at once.
[[nodiscard]] std::unique_ptr<Match> soms_probes(Job job, Shape shape, bool batch);

}  // namespace soms::bench
