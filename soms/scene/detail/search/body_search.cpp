#include "soms/scene/detail/search/body_search.h"

#include "soms/base/error.h"

#include <algorithm>
#include <string>
#include <utility>

namespace soms::detail {

void BodySet::build(std::vector<const Body*> bodies, std::span<const Box> boxes) {
  bodies_ = std::move(bodies);
  boxes_.build(boxes);
  filled_ = static_cast<std::size_t>(
      std::count_if(boxes.begin(), boxes.end(), [](const Box& box) { return !box.empty(); }));
}

const Body& body_of(BodySets sets, std::uint32_t number) {
  auto set = sets.begin();
  for (; number >= (*set)->size(); ++set) {
    number -= static_cast<std::uint32_t>((*set)->size());
  }
  return (*set)->body(number);
}

void check_left_out(BodySets sets, LeftOut left_out) {
  std::size_t size = 0;
  for (const BodySet* set : sets) {
    size += set->size();
  }
  if (left_out && *left_out >= size) {
    throw Error(ErrorKind::usage,
                "body filter: there is no body " + std::to_string(*left_out) + " to leave out",
                "bodies are numbered from 0");
  }
}

}  // namespace soms::detail
