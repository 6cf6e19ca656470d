/// \file
/// The orientation tests as a menu: one object comes at another from a named side.
#pragma once

#include "soms/base/box.h"
#include "soms/base/pose.h"

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

namespace soms::view {

/// A test of the menu.
struct OrientationTest {
  std::string_view name;         ///< as on the command line
  std::string_view title;        ///< for people
  std::string_view description;  ///< one sentence
};

/// right, left, top, bottom (the thesis'), front, back, and the drive through a city.
/// \source  thesis, table 3.2, figs. 3.8, 5.6 to 5.10.
[[nodiscard]] std::span<const OrientationTest> orientation_tests();

/// The frame of a test in which most touches: the last one of an approach, and the one half way of
/// the drive, which ends in the clear again. \errors ErrorKind::usage as `orientation_poses`.
[[nodiscard]] std::size_t fullest_frame(std::string_view name);

/// Frames of a test. \errors ErrorKind::usage as `orientation_poses`.
[[nodiscard]] std::size_t frame_count(std::string_view name);

/// The row of a test in `orientation_tests`. \errors ErrorKind::usage as `orientation_poses`.
[[nodiscard]] std::size_t orientation_row(std::string_view name);

/// Poses of a moving object of bounds `moving`, one a frame, on its way to and into `still`.
///
/// Both start with their middles in one point, so that equal models coincide as in the thesis; the
/// offsets are those of `orientation_test`. The drive crosses `still` along x through its middle in
/// 221 frames, from clear to clear, its underside a hundredth of the height below that of `still`.
///
/// \pre     Neither box is empty; `up` is 1 (y) or 2 (z).
/// \errors  ErrorKind::usage for an unknown name, which lists the names.
[[nodiscard]] std::vector<Pose> orientation_poses(std::string_view name, const Box& still,
                                                  const Box& moving, std::size_t up);

}  // namespace soms::view
