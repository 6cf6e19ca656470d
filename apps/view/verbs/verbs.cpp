#include "apps/view/verbs/verbs.h"

#include "apps/view/verbs/render.h"
#include "apps/view/verbs/view.h"

#include <array>

namespace soms::view {

std::span<const command::Verb> verbs() {
  static constexpr std::array<command::Verb, 2> kVerbs{{
      {"render", "draw a city, its movers and contacts to a PNG file, without a screen",
       add_render},
      {"view", "fly through a city and see what touches what, and why", add_view},
  }};
  return kVerbs;
}

}  // namespace soms::view
