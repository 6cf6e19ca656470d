#include "apps/draw/look.h"

#include "apps/view/drawing/palette.h"
#include "apps/view/scene/view_options.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace soms::look {
namespace {

using Triple = std::array<double, 3>;
using Matrix = std::array<Triple, 3>;

double linear(double byte) {
  const double c = byte / 255;
  return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

Triple linear(Rgb color) {
  return {linear(color.r), linear(color.g), linear(color.b)};
}

double luminance(Rgb color) {
  const Triple c = linear(color);
  return 0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2];
}

/// \source W3C, Web Content Accessibility Guidelines 2.1, "contrast ratio".
double contrast(Rgb a, Rgb b) {
  const double p = luminance(a);
  const double q = luminance(b);
  return (std::max(p, q) + 0.05) / (std::min(p, q) + 0.05);
}

/// Who sees all colors, and who lacks one kind of cones altogether, in linear RGB.
/// \source Machado, Oliveira, Fernandes 2009, "A physiologically-based model for simulation of
/// color
///         vision deficiency", severity 1.
struct Sight {
  std::string_view name;
  Matrix seen;
};

constexpr std::array kSights{Sight{"all colors", {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}},
                             Sight{"protanopia",
                                   {{{0.152286, 1.052583, -0.204868},
                                     {0.114503, 0.786281, 0.099216},
                                     {-0.003882, -0.048116, 1.051998}}}},
                             Sight{"deuteranopia",
                                   {{{0.367322, 0.860646, -0.227968},
                                     {0.280085, 0.672501, 0.047413},
                                     {-0.011820, 0.042940, 0.968881}}}},
                             Sight{"tritanopia",
                                   {{{1.255528, -0.076749, -0.178779},
                                     {-0.078411, 0.930809, 0.147602},
                                     {0.004733, 0.691367, 0.303900}}}}};

Triple times(const Matrix& m, const Triple& v) {
  Triple result{};
  for (std::size_t r = 0; r < 3; ++r) {
    result[r] = m[r][0] * v[0] + m[r][1] * v[1] + m[r][2] * v[2];
  }
  return result;
}

/// CIELAB, white point D65.
Triple lab(Triple color) {
  for (double& part : color) {
    part = std::clamp(part, 0.0, 1.0);
  }
  constexpr Matrix kXyz{{{0.4124564, 0.3575761, 0.1804375},
                         {0.2126729, 0.7151522, 0.0721750},
                         {0.0193339, 0.1191920, 0.9503041}}};
  const Triple xyz = times(kXyz, color);
  const auto bent = [](double t) {
    return t > 216.0 / 24389 ? std::cbrt(t) : (24389.0 / 27 * t + 16) / 116;
  };
  const double x = bent(xyz[0] / 0.95047);
  const double y = bent(xyz[1]);
  const double z = bent(xyz[2] / 1.08883);
  return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

/// Delta E of 1976 as someone sees it.
double apart(const Sight& sight, Rgb a, Rgb b) {
  const Triple p = lab(times(sight.seen, linear(a)));
  const Triple q = lab(times(sight.seen, linear(b)));
  return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
}

/// Who reads: on light paper and on dark.
constexpr std::array kSchemes{&Tone::light, &Tone::dark};

TEST(Look, ColorsOfBodiesAndMarksAreApartForEverybody) {
  constexpr double kLeast = 20;  // 2.3 is just noticed side by side
  constexpr std::array kMeanings{Named{"body-a", kBodyA}, Named{"body-b", kBodyB},
                                 Named{"contact", kContact}, Named{"nearest", kNearest},
                                 Named{"free", kFree}};
  for (const auto scheme : kSchemes) {
    for (const Sight& sight : kSights) {
      for (const Named& a : kMeanings) {
        for (const Named& b : kMeanings) {
          if (a.name < b.name) {
            EXPECT_GE(apart(sight, a.tone.*scheme, b.tone.*scheme), kLeast)
                << a.name << ' ' << b.name << ' ' << sight.name;
          }
        }
      }
    }
  }
}

// Red boxes among surfaces whose contact is violet: who confuses them sees contacts in the air.
TEST(Look, BoxesThatCollideAreApartFromSurfacesThatTouchForEverybody) {
  const view::ViewColors colors;
  const auto plain = [](view::Color c) { return Rgb{c.r, c.g, c.b}; };
  const Rgb found = plain(colors.found);
  const Rgb touch = plain(colors.contact_beside_boxes);
  EXPECT_EQ(found, kContact.light);
  for (const Sight& sight : kSights) {
    EXPECT_GE(apart(sight, found, touch), 40) << sight.name;
    for (const Rgb beside : {plain(colors.visited), plain(colors.pruned), kBodyA.light,
                             kBodyB.light, plain(colors.plain_city), kNearest.light}) {
      EXPECT_GE(apart(sight, touch, beside), 20) << hex(beside) << ' ' << sight.name;
      EXPECT_GE(apart(sight, found, beside), 20) << hex(beside) << ' ' << sight.name;
    }
  }
  for (const Tone& ground : {kPaper, kGround, kSkyLow, kSkyHigh}) {
    EXPECT_GE(contrast(touch, ground.light), 3) << hex(ground.light);
  }
}

TEST(Look, WordsAreReadAndMarksAreSeenOnTheirGrounds) {
  for (const auto scheme : kSchemes) {
    for (const Tone& words : {kInk, kFaint, kLink, kGood, kPart, kBad, kOpen}) {
      for (const Tone& ground : {kPaper, kSoft}) {
        EXPECT_GE(contrast(words.*scheme, ground.*scheme), 4.5) << hex(words.*scheme);
      }
    }
    for (const Tone& mark : {kBodyA, kContact, kNearest, kFree}) {
      EXPECT_GE(contrast(mark.*scheme, kPaper.*scheme), 3) << hex(mark.*scheme);
    }
    for (const Tone& ground : {kGround, kSkyLow, kSkyHigh}) {
      EXPECT_GE(contrast(kContact.*scheme, ground.*scheme), 3) << hex(ground.*scheme);
    }
  }
}

TEST(Look, LevelsGrowLighterForEverybody) {
  for (const Sight& sight : kSights) {
    double last = -1;
    for (const Rgb level : kLevels) {
      const double now = lab(times(sight.seen, linear(level)))[0];
      EXPECT_GT(now, last + 5) << sight.name;
      last = now;
    }
  }
}

TEST(Look, PagesGetEveryColorForBothSchemes) {
  const std::string rules = css_colors();
  std::set<std::string_view> names;
  for (const Named& color : kColors) {
    EXPECT_TRUE(names.insert(color.name).second) << color.name;
    const std::string head = "--" + std::string(color.name) + ":";
    EXPECT_NE(rules.find(head + hex(color.tone.light) + ";"), std::string::npos) << color.name;
    EXPECT_NE(rules.rfind(head + hex(color.tone.dark) + ";"), rules.find(head)) << color.name;
  }
  EXPECT_EQ(hex(rgb(0x0068b3)), "#0068b3");
}

TEST(Look, TheWindowHasTheSameColors) {
  EXPECT_EQ(view::palette::kContact, (view::Color{0xd1, 0x15, 0x0c, 255}));
  EXPECT_EQ(view::mover_color(0), view::palette::kBodyA);
}

}  // namespace
}  // namespace soms::look
