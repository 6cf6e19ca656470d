/// \file
/// Frames a second that the thesis calls suitable.
#pragma once

namespace soms::reproduce {

/// Frames a second of suitable applications, from and to. \source thesis, section 1.1.
inline constexpr double kLeastInteractive = 30;
inline constexpr double kMostInteractive = 60;

}  // namespace soms::reproduce
