#include "apps/view/verbs/verbs.h"

#include "apps/view/verbs/render.h"
#include "apps/view/verbs/time_frames.h"
#include "apps/view/verbs/view.h"

#include <array>

namespace soms::view {

std::span<const command::Verb> verbs() {
  static constexpr std::array<command::Verb, 3> kVerbs{{
      {"render", "draw a city, its movers and contacts to a PNG file, without a screen",
       add_render},
      {"time-frames", "time each frame of a moving model, with drawing and without",
       add_time_frames},
      {"view", "fly through a city and see what touches what, and why", add_view},
  }};
  return kVerbs;
}

}  // namespace soms::view
