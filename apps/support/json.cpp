#include "apps/support/json.h"

namespace soms::command {

std::string json_line(const Json& value) {
  return value.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

Json json_box(const Box& box) {
  if (box.empty()) {
    return nullptr;
  }
  return Json::array(
      {{box.lower.x, box.lower.y, box.lower.z}, {box.upper.x, box.upper.y, box.upper.z}});
}

}  // namespace soms::command
