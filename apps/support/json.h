/// \file
/// JSON as text.
#pragma once

#include "soms/base/box.h"

#include <nlohmann/json.hpp>

#include <string>

namespace soms::command {

/// JSON whose keys keep their order.
using Json = nlohmann::ordered_json;

/// One line of JSON, with its end. Bytes that are no UTF-8 (of file names) are replaced.
[[nodiscard]] std::string json_line(const Json& value);

/// The corners of a box, `[[x,y,z],[x,y,z]]`; null for an empty box.
[[nodiscard]] Json json_box(const Box& box);

}  // namespace soms::command
