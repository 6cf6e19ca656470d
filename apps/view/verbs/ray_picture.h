/// \file
/// Pictures made of rays alone: how far surfaces are, and which of them a point sees. They need no
/// graphics driver.
#pragma once

#include "soms/base/parallel.h"

#include "apps/view/drawing/camera.h"
#include "apps/view/drawing/picture_file.h"
#include "apps/view/scene/view_scene.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace soms::view {

/// Distances from the camera's eye in a color scale, dark blue for the nearest surface to yellow
/// for the farthest.
struct DepthPicture {
  Picture picture;
  double nearest = 0;         ///< of the points at the centers of pixels; 0 where all is sky
  double farthest = 0;        ///< of these
  std::uint64_t surface = 0;  ///< pixels with a surface at their center
};

/// Draws a scene by `samples` rays a pixel, with a key of distances. Equal steps of the scale are
/// equal ratios of distances. `meters` is the unit that the key names; that of the scene's files by
/// default.
/// \errors ErrorKind::cancelled; out_of_memory.
[[nodiscard]] DepthPicture draw_depth(const ViewScene& scene, const Camera& camera, Size size,
                                      int samples, const Limits& limits = {},
                                      std::optional<double> meters = std::nullopt);

/// How far from the eye the surface at the center of each pixel is, row by row from the top; NaN
/// where there is none. \errors As `draw_depth`.
[[nodiscard]] std::vector<double> depths_of(const ViewScene& scene, const Camera& camera, Size size,
                                            const Limits& limits = {});

/// Surfaces that a point sees: what it sees is orange, what it does not is gray.
struct SightPicture {
  Picture picture;
  std::uint64_t surface = 0;   ///< rays that hit a surface
  std::uint64_t in_sight = 0;  ///< of these, those whose surface the point sees
};

/// Draws a scene by `samples` rays a pixel, and marks the point by a blue disc, which is a ring
/// where something hides it.
/// \errors As `draw_depth`.
[[nodiscard]] SightPicture draw_sight(const ViewScene& scene, const Camera& camera,
                                      const Vec3& observer, Size size, int samples,
                                      const Limits& limits = {});

/// What a cell of a grid of visibility holds.
inline constexpr std::uint8_t kHiddenCell = 0;
inline constexpr std::uint8_t kSeenCell = 1;
inline constexpr std::uint8_t kEmptyCell = 255;  ///< no surface

/// Whether a point sees the surface at the center of each pixel, as `depths_of`.
[[nodiscard]] std::vector<std::uint8_t> sight_cells(const ViewScene& scene, const Camera& camera,
                                                    const Vec3& observer, Size size,
                                                    const Limits& limits = {});

/// Which of `hits` a point sees. It sees a point of a surface if nothing is hit before it on the
/// way there but the triangle itself, the last 2^-30 of the way left out, for hits are rounded. The
/// point must be on the side of the triangle that the hit's ray came from.
/// \shape  `hits`: n; `rays`: n, which found them. n flags, 0 where nothing was hit.
/// \errors As `ViewScene::first_hits`.
[[nodiscard]] std::vector<std::uint8_t> seen_from(const ViewScene& scene, const Vec3& observer,
                                                  std::span<const SurfaceHit> hits,
                                                  std::span<const Ray> rays,
                                                  const Limits& limits = {});

/// A share, as "12.5 %"; of nothing "0.0 %".
[[nodiscard]] std::string in_percent(std::uint64_t part, std::uint64_t whole);

}  // namespace soms::view
