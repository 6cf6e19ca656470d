/// \file
/// Exit statuses of answers; those of errors are `exit_code`'s.
#pragma once

namespace soms::command {

inline constexpr int kConditionHolds = 1;  ///< what --fail-if asks for
inline constexpr int kOutOfTime = 4;
inline constexpr int kDifference = 6;  ///< found by --verify or `reproduce --golden`
inline constexpr int kInterrupted = 130;

}  // namespace soms::command
