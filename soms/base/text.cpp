#include "soms/base/text.h"

#include "soms/base/decimal.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace soms {

namespace {

/// U+FFFE and U+FFFF are UTF-8, but XML has no room for them.
bool fits_xml(std::string_view character) {
  const bool control = character.size() == 1 &&
                       (static_cast<unsigned char>(character[0]) < 0x20 || character[0] == 0x7f);
  return !character.empty() && !control && character != "\xef\xbf\xbe" &&
         character != "\xef\xbf\xbf";
}

/// The code of a UTF-8 character, as `utf8_character` accepts it.
std::uint32_t code_of(std::string_view character) {
  const auto byte = [&](std::size_t k) { return static_cast<unsigned char>(character[k]); };
  std::uint32_t code = character.size() == 1 ? byte(0) : byte(0) & (0x7fU >> character.size());
  for (std::size_t k = 1; k < character.size(); ++k) {
    code = (code << 6) | (byte(k) & 0x3fU);
  }
  return code;
}

/// Characters that a terminal obeys instead of showing them; U+0080 to U+009F are among them.
bool is_control(std::uint32_t code) {
  return code < 0x20 || (code >= 0x7f && code < 0xa0);
}

/// Line breaks of Unicode, and marks by which a text shows its characters in another order.
bool misleads(std::uint32_t code) {
  return code == 0x061c || code == 0x200e || code == 0x200f || (code >= 0x2028 && code <= 0x202e) ||
         (code >= 0x2066 && code <= 0x2069);
}

bool begins_formula(char c) {
  return c == '=' || c == '+' || c == '-' || c == '@';
}

bool breaks_line(char c) {
  return c == '\r' || c == '\n';
}

/// What may end a field for a reader that was given other separators than ours.
bool separates(char c) {
  return c == ',' || c == ';' || c == '\t' || breaks_line(c);
}

/// True if `csv_field` puts an apostrophe before `c`, given the character before it, 0 for none.
bool needs_guard(char before, char c) {
  const bool begins = before == 0;
  return begins ? begins_formula(c) || c == '\'' || c == '\t' || breaks_line(c)
                : separates(before) && (begins_formula(c) || c == '\'');
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

std::u32string code_points(std::string_view words) {
  constexpr char32_t kReplacement = 0xfffd;
  std::u32string points;
  for (std::size_t at = 0; at < words.size();) {
    const std::size_t size = utf8_character(words, at);
    points += size == 0 ? kReplacement : static_cast<char32_t>(code_of(words.substr(at, size)));
    at += std::max<std::size_t>(size, 1);
  }
  return points;
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
  return {text.data(), write_shortest(text.data(), text.data() + text.size(), value)};
}

std::string readable_bytes(std::uint64_t bytes) {
  if (bytes < 1024) {
    return std::to_string(bytes) + (bytes == 1 ? " byte" : " bytes");
  }
  constexpr std::array kUnits{" KiB", " MiB", " GiB", " TiB", " PiB", " EiB"};
  constexpr double kNext = 1023.95;  // from here on, a tenth would round to 1024.0
  double size = static_cast<double>(bytes) / 1024;
  std::size_t unit = 0;
  for (; size >= kNext && unit + 1 < kUnits.size(); ++unit) {
    size /= 1024;
  }
  std::array<char, 32> text;
  char* const end = write_fixed(text.data(), text.data() + text.size(), size, 1);
  return std::string(text.data(), end) + kUnits[unit];
}

std::string quoted_text(std::string_view words) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string text = "\"";
  for (std::size_t at = 0; at < words.size();) {
    const std::size_t size = utf8_character(words, at);
    const std::string_view character = words.substr(at, size);
    const std::uint32_t code = size == 0 ? 0 : code_of(character);
    if (is_control(code) || misleads(code)) {
      for (std::size_t k = 0; k < (size == 0 ? 1 : size); ++k) {
        const auto byte = static_cast<unsigned char>(words[at + k]);
        text += "\\x";
        text += kDigits[byte >> 4U];
        text += kDigits[byte & 15U];
      }
    } else {
      text += code == '"' || code == '\\' ? "\\" : "";
      text += character;
    }
    at += size == 0 ? 1 : size;
  }
  return text + '"';
}

std::string printable(std::string_view words) {
  std::string text;
  text.reserve(words.size());
  for (std::size_t at = 0; at < words.size();) {
    const std::size_t size = utf8_character(words, at);
    const std::string_view character = words.substr(at, size);
    const std::uint32_t code = size == 0 ? 0 : code_of(character);
    if (is_control(code) || misleads(code)) {
      text += '?';
    } else {
      text += character;
    }
    at += size == 0 ? 1 : size;
  }
  return text;
}

std::string csv_field(std::string_view words) {
  std::string text;
  text.reserve(words.size() + 2);
  bool quoted = false;
  char before = 0;
  for (std::size_t at = 0; at < words.size();) {
    const std::size_t size = utf8_character(words, at);
    const char c = words[at];
    const bool kept =
        size > 0 && (c == '\t' || breaks_line(c) || !is_control(code_of(words.substr(at, size))));
    if (kept && needs_guard(before, c)) {
      text += '\'';
    }
    if (kept) {
      text.append(c == '"' ? 1 : 0, '"');
      text += words.substr(at, size);
    } else {
      text += "\xef\xbf\xbd";
    }
    quoted = quoted || c == '"' || separates(c);
    before = kept ? c : '?';
    at += size == 0 ? 1 : size;
  }
  return quoted ? '"' + text + '"' : text;
}

std::string csv_words(std::string_view field) {
  std::string words;
  words.reserve(field.size());
  char before = 0;
  for (std::size_t at = 0; at < field.size(); ++at) {
    if (field[at] == '\'' && at + 1 < field.size() && needs_guard(before, field[at + 1])) {
      ++at;
    }
    words += field[at];
    before = field[at];
  }
  return words;
}

}  // namespace soms
