/// \file
/// The colors that carry meaning, by name, for readers with light and dark screens: the one source
/// of the window, pictures, report pages, maps and plots.
///
/// A test holds them to what people can tell apart: contrast with the paper, and distance between
/// the colors of bodies and marks for people who see fewer colors.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace soms::look {

/// A color in sRGB.
struct Rgb {
  std::uint8_t r = 0;
  std::uint8_t g = 0;
  std::uint8_t b = 0;

  [[nodiscard]] bool operator==(const Rgb&) const = default;
};

/// From 0xrrggbb.
[[nodiscard]] constexpr Rgb rgb(std::uint32_t hex) {
  return {static_cast<std::uint8_t>(hex >> 16U), static_cast<std::uint8_t>(hex >> 8U),
          static_cast<std::uint8_t>(hex)};
}

/// The characters of #rrggbb and a zero, for constants.
[[nodiscard]] constexpr std::array<char, 8> hex_characters(Rgb color) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::array<char, 8> text{'#'};
  std::size_t at = 1;
  for (const std::uint8_t part : {color.r, color.g, color.b}) {
    text[at++] = kDigits[part >> 4U];
    text[at++] = kDigits[part & 15U];
  }
  return text;
}

/// As #rrggbb.
[[nodiscard]] inline std::string hex(Rgb color) {
  return hex_characters(color).data();
}

/// One meaning on light paper and on dark.
struct Tone {
  Rgb light;
  Rgb dark;
};

// Bodies and marks. Contacts alone are red.
inline constexpr Tone kBodyA{rgb(0x0068b3), rgb(0x4a9fe0)};    ///< blue: what moves, or comes first
inline constexpr Tone kBodyB{rgb(0xd3b778), rgb(0xcbb079)};    ///< sand: what it meets
inline constexpr Tone kContact{rgb(0xd1150c), rgb(0xff4a2e)};  ///< where two share a point
inline constexpr Tone kContactPast{rgb(0xe3a59b), rgb(0xa05648)};  ///< where they did, or will
inline constexpr Tone kNearest{rgb(0x2b2a28), rgb(0xf4f3ef)};      ///< nearest points and their gap
inline constexpr Tone kFree{rgb(0x05a68e), rgb(0x55785e)};         ///< shown to be free

// Grounds, the same for all pages.
inline constexpr Tone kPaper{rgb(0xffffff), rgb(0x15181c)};
inline constexpr Tone kInk{rgb(0x1d1f21), rgb(0xecebe8)};
inline constexpr Tone kFaint{rgb(0x55595e), rgb(0xb4b8bd)};  ///< secondary words
inline constexpr Tone kLine{rgb(0xd9d8d4), rgb(0x363b42)};
inline constexpr Tone kSoft{rgb(0xf5f4f0), rgb(0x1e2227)};  ///< panels upon the paper
inline constexpr Tone kLink{rgb(0x00599c), rgb(0x7cc4f5)};

// Scenes.
inline constexpr Tone kSkyLow{rgb(0xf1f3f4), rgb(0x1a1e23)};
inline constexpr Tone kSkyHigh{rgb(0xcfdbe6), rgb(0x0f1215)};
inline constexpr Tone kGround{rgb(0xd9d7d1), rgb(0x2a2e33)};
inline constexpr Tone kRest{rgb(0xdcdbd7),
                            rgb(0x6a7179)};  ///< bodies and parts that nothing is said of

// Verdicts and warnings.
inline constexpr Tone kGood{rgb(0x0b6e4f), rgb(0x4fcf9f)};
inline constexpr Tone kPart{rgb(0x8a5a00), rgb(0xf0b84a)};
inline constexpr Tone kBad{rgb(0xa83200), rgb(0xff9a70)};
inline constexpr Tone kOpen{rgb(0x55595e), rgb(0xb4b8bd)};
inline constexpr Tone kWarn{rgb(0xfff4d6), rgb(0x33290f)};
inline constexpr Tone kWarnLine{rgb(0xe0b84c), rgb(0x8a6d1f)};

struct Named {
  std::string_view name;
  Tone tone;
};

/// As CSS names them on pages, each with two dashes before it.
inline constexpr std::array kColors{Named{"body-a", kBodyA},    Named{"body-b", kBodyB},
                                    Named{"contact", kContact}, Named{"contact-past", kContactPast},
                                    Named{"nearest", kNearest}, Named{"free", kFree},
                                    Named{"paper", kPaper},     Named{"ink", kInk},
                                    Named{"faint", kFaint},     Named{"line", kLine},
                                    Named{"soft", kSoft},       Named{"link", kLink},
                                    Named{"sky-low", kSkyLow},  Named{"sky-high", kSkyHigh},
                                    Named{"ground", kGround},   Named{"rest", kRest},
                                    Named{"good", kGood},       Named{"part", kPart},
                                    Named{"bad", kBad},         Named{"open", kOpen},
                                    Named{"warn", kWarn},       Named{"warn-line", kWarnLine}};

/// Series of plots, in order, where no meaning above is shown.
/// \source Okabe, Ito 2008, Color Universal Design.
inline constexpr std::array kSeries{
    Tone{rgb(0x0072b2), rgb(0x4aa8e8)}, Tone{rgb(0xd55e00), rgb(0xf27d26)},
    Tone{rgb(0x009e73), rgb(0x1fbf92)}, Tone{rgb(0xcc79a7), rgb(0xcc79a7)},
    Tone{rgb(0xe69f00), rgb(0xe69f00)}, Tone{rgb(0x56b4e9), rgb(0x9fd4f5)},
    Tone{rgb(0x555555), rgb(0xc8c8c8)}, Tone{rgb(0x8c6d1f), rgb(0xc9a64a)}};

/// Levels of trees, heights and distances: lightness rises steadily, so the order shows without
/// hue.
inline constexpr std::array kLevels{rgb(0x202864), rgb(0x2d6294), rgb(0x28948c), rgb(0x82c45c),
                                    rgb(0xf0e246)};

/// Style rules that give each color of `kColors` to a page, by the reader's scheme.
[[nodiscard]] inline std::string css_colors() {
  std::string light;
  std::string dark;
  for (const Named& color : kColors) {
    const std::string head = "--" + std::string(color.name) + ":";
    light += head + hex(color.tone.light) + ";";
    dark += head + hex(color.tone.dark) + ";";
  }
  return ":root{color-scheme:light dark;" + light +
         "}\n@media screen and (prefers-color-scheme:dark){:root{" + dark + "}}\n";
}

}  // namespace soms::look
