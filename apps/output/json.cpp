#include "apps/output/json.h"

#include <fmt/format.h>

#include <cstddef>

namespace soms::command {

std::string json_text(const Json& value) {
  const std::string text = value.dump(-1, ' ', false, Json::error_handler_t::replace);
  std::string safe;
  safe.reserve(text.size());
  for (std::size_t k = 0; k < text.size(); ++k) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    if (byte(k) == 0x7f) {
      safe += "\\u007f";
    } else if (byte(k) == 0xc2 && k + 1 < text.size() && byte(k + 1) < 0xa0) {
      safe += fmt::format("\\u{:04x}", byte(++k));
    } else {
      safe += text[k];
    }
  }
  return safe;
}

std::string json_line(const Json& value) {
  return json_text(value) + "\n";
}

Json json_box(const Box& box) {
  if (box.empty()) {
    return nullptr;
  }
  return Json::array(
      {{box.lower.x, box.lower.y, box.lower.z}, {box.upper.x, box.upper.y, box.upper.z}});
}

}  // namespace soms::command
