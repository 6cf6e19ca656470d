#include "soms/scene/clearance_along.h"

#include "soms/base/arithmetic.h"
#include "soms/base/error.h"
#include "soms/base/text.h"
#include "soms/scene/detail/search/clearance_search.h"

#include <cmath>

namespace soms {

namespace {

void check_options(const ClearanceOptions& options) {
  for (const auto& [name, value] : {std::pair("distance of stations", options.every),
                                    std::pair("accuracy", options.accuracy)}) {
    if (!(value > 0 && std::isfinite(value))) {
      throw Error(ErrorKind::usage,
                  "clearance: the " + std::string(name) + " is " + shortest(value),
                  "give a finite number above 0");
    }
  }
  if (!(options.clearance >= 0 && std::isfinite(options.clearance))) {
    throw Error(ErrorKind::usage, "clearance: the clearance is " + shortest(options.clearance),
                "give a finite number of at least 0");
  }
}

}  // namespace

ClearanceVerdict verdict(const ClearanceStation& station, double clearance) {
  return station.overlaps()              ? ClearanceVerdict::contact
         : station.gap.lower < clearance ? ClearanceVerdict::below
                                         : ClearanceVerdict::ok;
}

ClearanceVerdict verdict(const ClearanceStretch& stretch, double clearance) {
  const ClearanceVerdict at_least_gap = verdict(stretch.least, clearance);
  const bool proved = stretch.at_least >= clearance && stretch.at_least > 0;
  return at_least_gap != ClearanceVerdict::ok ? at_least_gap
         : proved                             ? ClearanceVerdict::ok
                                              : ClearanceVerdict::undecided;
}

Clearance clearance_along(const Shape& mover, const MotionPath& path, std::span<const Body> fixed,
                          const ClearanceOptions& options, const Limits& limits) {
  const PlainArithmetic plain;
  check(path);
  check_options(options);
  return detail::ClearanceSearch(mover, path, fixed, options, limits).run();
}

}  // namespace soms
