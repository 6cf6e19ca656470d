/// \file
/// What the library asks of the processor: plain IEEE double arithmetic.
#pragma once

namespace soms {

/// Throws unless the calling thread rounds to nearest and keeps subnormal numbers, as every thread
/// does unless its program chose otherwise (`fesetround`, or flush-to-zero, which linking anything
/// with -ffast-math may switch on). Moved vertices and error bounds are facts about that
/// arithmetic. `check(Pose)`, the door of every query, calls it.
/// \errors ErrorKind::unsupported.
/// \cost   A few flops.
void check_arithmetic();

}  // namespace soms
