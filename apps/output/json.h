/// \file
/// JSON as text.
#pragma once

#include "soms/base/box.h"

#include <nlohmann/json.hpp>

#include <string>

namespace soms::command {

/// JSON whose keys keep their order.
using Json = nlohmann::ordered_json;

/// JSON on one line, without its end. Bytes that are not UTF-8 (of file names) become U+FFFD.
/// Control characters are escaped, those beyond ASCII and DEL too, so that a terminal obeys none.
[[nodiscard]] std::string json_text(const Json& value);

/// `json_text` with a line break.
[[nodiscard]] std::string json_line(const Json& value);

/// The corners of a box, `[[x,y,z],[x,y,z]]`; null for an empty box.
[[nodiscard]] Json json_box(const Box& box);

}  // namespace soms::command
