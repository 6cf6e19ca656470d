#include "soms/base/text.h"

#include <array>
#include <charconv>

namespace soms {

namespace {

/// U+FFFE and U+FFFF are UTF-8, but XML has no room for them.
bool fits_xml(std::string_view character) {
  const bool control = character.size() == 1 &&
                       (static_cast<unsigned char>(character[0]) < 0x20 || character[0] == 0x7f);
  return !character.empty() && !control && character != "\xef\xbf\xbe" &&
         character != "\xef\xbf\xbf";
}

}  // namespace

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
  // The second byte tells long spellings of short characters, halves of pairs (surrogates) and what
  // lies beyond the last character.
  if ((first == 0xe0 && byte(at + 1) < 0xa0) || (first == 0xed && byte(at + 1) > 0x9f) ||
      (first == 0xf0 && byte(at + 1) < 0x90) || (first == 0xf4 && byte(at + 1) > 0x8f)) {
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
    if (!fits_xml(words.substr(at, size))) {
      text += '?';
      at += size == 0 ? 1 : size;
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

std::string shortest(double value) {
  std::array<char, 32> text;
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), value).ptr};
}

std::string quoted_text(std::string_view words) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string text = "\"";
  for (std::size_t at = 0; at < words.size();) {
    const std::size_t size = utf8_character(words, at);
    const auto byte = static_cast<unsigned char>(words[at]);
    // U+0080 to U+009F are controls, too, of two bytes.
    const bool control =
        byte < 0x20 || byte == 0x7f ||
        (size == 2 && byte == 0xc2 && static_cast<unsigned char>(words[at + 1]) < 0xa0);
    if (size == 0 || control) {
      for (std::size_t k = 0; k < (size == 0 ? 1 : size); ++k) {
        const auto code = static_cast<unsigned char>(words[at + k]);
        text += "\\x";
        text += kDigits[code >> 4U];
        text += kDigits[code & 15U];
      }
    } else {
      text += byte == '"' || byte == '\\' ? "\\" : "";
      text += words.substr(at, size);
    }
    at += size == 0 ? 1 : size;
  }
  return text + '"';
}

}  // namespace soms
