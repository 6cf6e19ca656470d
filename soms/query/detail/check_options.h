/// \file
/// What queries say of options that no query can follow.
#pragma once

#include "soms/query/closest.h"
#include "soms/query/distance.h"
#include "soms/query/overlap.h"

namespace soms::detail {

/// Throws ErrorKind::usage if `at_most` is negative or not a number.
void check_options(const ClosestOptions& options);
void check_options(const DistanceOptions& options);

/// Throws ErrorKind::usage for an option without effect: a `limit` above 0 with modes `any` and
/// `first`.
void check_options(const OverlapOptions& options);

}  // namespace soms::detail
