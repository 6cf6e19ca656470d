/// \file
/// The moment that a picture of a moving scene shows, and what of it is seen.
#pragma once

#include "soms/base/parallel.h"

#include "apps/view/drawing/camera.h"
#include "apps/view/drawing/draw_list.h"
#include "apps/view/scene/view_scene.h"
#include "apps/view/sight/rich_frame.h"
#include "apps/view/verbs/render.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace soms::view {

/// A scene at the frame that is drawn.
struct Moment {
  ViewScene scene;
  std::uint64_t frames = 1;                       ///< that there are to search
  std::optional<RichFrame> found = std::nullopt;  ///< nothing where no frame was searched for
};

/// Throws that nothing touches, and names the nearest frame in which something does.
/// \errors ErrorKind::usage always; ErrorKind::cancelled.
[[noreturn]] void refuse_without_contact(Moment& moment, const Limits& limits);

/// What the camera looks at: as chosen, else as `subject_of`; of many poses in one picture all.
[[nodiscard]] CameraChoice::Subject chosen_subject(const RenderOptions& options,
                                                   const ViewScene& scene);

/// Removes entries of a key that name movers of which none is seen: all are hidden, outside, or
/// smaller than some pixels.
void keep_seen_entries(std::vector<KeyEntry>& key, const Camera& camera, Size size,
                       const ViewScene& scene);

/// "frame 73 of 600, 38 movers touch; the camera looks at car 712 and parked van 2003"; empty for a
/// scene that stands still and a camera on no contact.
[[nodiscard]] std::string words_of_moment(const Moment& moment, const AimedCamera& aimed);

}  // namespace soms::view
