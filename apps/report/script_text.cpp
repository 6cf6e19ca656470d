#include "apps/report/script_text.h"

#include "soms/base/text.h"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace soms::report {

std::string script_text(std::string_view words) {
  using nlohmann::json;
  // ASCII only: U+2028 and its like, which some readers take for ends of lines, are escaped too.
  return script_json(json(words).dump(-1, ' ', true, json::error_handler_t::replace));
}

std::string script_json(std::string_view json) {
  std::string safe;
  safe.reserve(json.size());
  for (const char c : json) {
    switch (c) {
      case '<':
        safe += "\\u003c";
        break;
      case '>':
        safe += "\\u003e";
        break;
      case '&':
        safe += "\\u0026";
        break;
      default:
        safe += c;
    }
  }
  return safe;
}

std::string shortened(std::string_view words, std::size_t most) {
  if (words.size() <= most) {
    return std::string(words);
  }
  std::size_t end = 0;
  while (end < words.size()) {
    const std::size_t size = std::max<std::size_t>(1, utf8_character(words, end));
    if (end + size > most) {
      break;
    }
    end += size;
  }
  return std::string(words.substr(0, end)) + "...";
}

std::string shortened_front(std::string_view words, std::size_t most) {
  if (words.size() <= most) {
    return std::string(words);
  }
  std::size_t begin = 0;
  while (words.size() - begin > most) {
    begin += std::max<std::size_t>(1, utf8_character(words, begin));
  }
  return "..." + std::string(words.substr(begin));
}

}  // namespace soms::report
