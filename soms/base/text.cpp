#include "soms/base/text.h"

namespace soms {

std::size_t utf8_character(std::string_view words, std::size_t at) {
  const auto byte = [&](std::size_t k) { return static_cast<unsigned char>(words[k]); };
  const unsigned char first = byte(at);
  const std::size_t size = first < 0x80                    ? 1
                           : first >= 0xc2 && first < 0xe0 ? 2
                           : (first & 0xf0U) == 0xe0       ? 3
                           : first >= 0xf0 && first < 0xf5 ? 4
                                                           : 0;
  if (size == 0 || at + size > words.size()) {
    return 0;
  }
  for (std::size_t k = 1; k < size; ++k) {
    if ((byte(at + k) & 0xc0U) != 0x80) {
      return 0;
    }
  }
  return size;
}

std::string xml_text(std::string_view words) {
  std::string text;
  for (std::size_t at = 0; at < words.size();) {
    const std::size_t size = utf8_character(words, at);
    const char c = words[at];
    if (size == 0 || (size == 1 && static_cast<unsigned char>(c) < 0x20) || c == 0x7f) {
      text += '?';
      ++at;
      continue;
    }
    if (c == '&') {
      text += "&amp;";
    } else if (c == '<') {
      text += "&lt;";
    } else if (c == '>') {
      text += "&gt;";
    } else if (c == '"') {
      text += "&quot;";
    } else {
      text += words.substr(at, size);
    }
    at += size;
  }
  return text;
}

}  // namespace soms
