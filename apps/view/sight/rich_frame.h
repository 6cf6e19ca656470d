/// \file
/// The frame of a scene in which most touches: what a picture of it should show.
#pragma once

#include "soms/base/parallel.h"

#include "apps/view/scene/touch.h"
#include "apps/view/scene/view_scene.h"

#include <cstdint>
#include <limits>
#include <optional>
#include <set>
#include <vector>

namespace soms::view {

/// A frame that was searched for.
struct RichFrame {
  std::uint64_t frame = 0;
  std::uint64_t touching_movers = 0;  ///< 0 where nothing touches in any frame searched
  std::uint64_t frames = 1;           ///< that there are
  std::uint64_t searched = 1;

  [[nodiscard]] bool operator==(const RichFrame&) const = default;
};

/// The movers that touch anything.
[[nodiscard]] std::set<std::uint32_t> touching_movers(const std::vector<Touch>& touches);

/// Brings a scene to a frame in which many movers touch: the richest of 48 evenly chosen frames,
/// or of those that halving steps around it find. Where nothing touches in these, others follow,
/// evenly, until something does or `most` were searched. Of equal frames it is the one found first.
/// The scene is in frame 0 where nothing touches.
/// \errors ErrorKind::cancelled, timed_out; as `ViewScene::go_to`.
/// \cost   Some 60 steps of the scene where anything touches; else `most`.
[[nodiscard]] RichFrame go_to_richest(
    ViewScene& scene, std::uint64_t frames,
    std::uint64_t most = std::numeric_limits<std::uint64_t>::max(), const Limits& limits = {});

/// The frame nearest to that of the scene in which something touches, the earlier of two; the scene
/// stays in its frame. \errors As `go_to_richest`.
[[nodiscard]] std::optional<std::uint64_t> nearest_touching_frame(ViewScene& scene,
                                                                  std::uint64_t frames,
                                                                  const Limits& limits = {});

}  // namespace soms::view
