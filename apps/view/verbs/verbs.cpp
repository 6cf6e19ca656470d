#include "apps/view/verbs/verbs.h"

#include "apps/view/verbs/view.h"

#include <array>

namespace soms::view {

std::span<const command::Verb> verbs() {
  static constexpr std::array<command::Verb, 1> kVerbs{{
      {"view", "fly through a city and see what touches what, and why", add_view},
  }};
  return kVerbs;
}

}  // namespace soms::view
