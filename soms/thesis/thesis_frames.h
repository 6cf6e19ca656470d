/// \file
/// How the thesis moves one object past another: the orientation tests and the drive through a
/// city, frame by frame.
#pragma once

#include "soms/base/box.h"
#include "soms/base/vector.h"

#include <array>
#include <cstddef>
#include <string_view>
#include <utility>
#include <vector>

namespace soms {

/// Side from which the moving object comes.
enum class Approach { right, left, top, bottom, front, back };

/// The four orientation tests, in the order of the thesis, by name.
inline constexpr std::array<std::pair<Approach, std::string_view>, 4> kApproaches{
    {{Approach::right, "right"},
     {Approach::left, "left"},
     {Approach::top, "top"},
     {Approach::bottom, "bottom"}}};

/// The four, and the two along the third axis, which the thesis has not.
inline constexpr std::array<std::pair<Approach, std::string_view>, 6> kAllApproaches{
    {kApproaches[0],
     kApproaches[1],
     kApproaches[2],
     kApproaches[3],
     {Approach::front, "front"},
     {Approach::back, "back"}}};

/// Frames of an orientation test, and of a drive.
inline constexpr std::size_t kApproachFrames = 49;
inline constexpr std::size_t kDriveFrames = 221;

/// Axis along which an object comes (0 x, 1 y, 2 z) and the side it comes from: 1 or -1.
struct ApproachLine {
  std::size_t axis = 0;
  double side = 1;

  [[nodiscard]] bool operator==(const ApproachLine&) const = default;
};

/// Line of an approach. Front is where one stands who has +x at the right hand and the up axis
/// overhead: +z with y up, -y with z up.
/// \pre `up` is 1 (y) or 2 (z).
[[nodiscard]] ApproachLine approach_line(Approach from, std::size_t up = 1);

/// Offsets of the moving object in an orientation test: from +x to -x (`right`), from the up axis
/// downwards (`top`), from the viewer away (`front`), or the reverse. Frame k is off by
/// (64 - k) / 32 of the width of `still` along that axis: an object of its size is clear of it
/// before frame 32, touches it in frame 32, and is half inside in frame 48.
///
/// \shape  49 offsets, frames 0 to 48.
/// \pre    `still` is not empty; `up` is 1 (y) or 2 (z).
/// \source thesis, chapter 5 (right, left, top, bottom); widths and steps are a reconstruction,
///         front and back an addition.
[[nodiscard]] std::vector<Vec3> orientation_test(const Box& still, Approach from,
                                                 std::size_t up = 1);

/// The same for an object of any size and place, of bounds `moving`: it starts with its middle in
/// that of `still`, so that equal models coincide as in the thesis.
///
/// \pre Neither box is empty; `up` is 1 (y) or 2 (z).
[[nodiscard]] std::vector<Vec3> orientation_test(const Box& still, const Box& moving, Approach from,
                                                 std::size_t up = 1);

/// Offsets of an object of bounds `moving` that drives through `still` along x, through its middle,
/// in 221 frames from clear to clear, its underside a hundredth of the height below that of
/// `still`. For a scene of the thesis `city_drive` has the path.
///
/// \pre    Neither box is empty; `up` is 1 (y) or 2 (z).
/// \source ours, after thesis, table 3.3: 5 % of the scene's length before it and behind it; more
///         for a long object.
[[nodiscard]] std::vector<Vec3> drive_through(const Box& still, const Box& moving,
                                              std::size_t up = 2);

/// Offsets of an object that drives through a scene of 4 km by 4 km along y = 2000: frame k is at
/// x = 20 k - 200. Made for the bunny turned z up and 500 times as large,
/// `transformed(mesh, 500, UpAxis::y)`.
/// \shape  221 offsets, frames 0 to 220.
/// \source thesis, table 3.3 and fig. 3.9; the path is a reconstruction.
[[nodiscard]] std::vector<Vec3> city_drive();

}  // namespace soms
