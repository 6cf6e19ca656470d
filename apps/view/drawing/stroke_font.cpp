#include "apps/view/drawing/stroke_font.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace soms::view {

namespace {

// Letters are drawn on a grid on which digits are 10 high and 6 wide.
constexpr double kGridHeight = 10;
constexpr double kBetween = 2.4;  ///< letters
constexpr double kDegreesOfStroke = 24;

/// A letter that is being drawn.
struct Glyph {
  double width = 6;
  std::vector<TextStroke> strokes = {};

  Glyph& line(TextPoint from, TextPoint to) {
    strokes.push_back({from, to});
    return *this;
  }

  /// Part of an ellipse between two angles in degrees, counter-clockwise from the right.
  Glyph& arc(TextPoint center, TextPoint radius, double from, double to) {
    const int count = std::max(1, static_cast<int>(std::abs(to - from) / kDegreesOfStroke + 0.5));
    const auto at = [&](int k) {
      const double angle = (from + (to - from) * k / count) * std::numbers::pi / 180;
      return TextPoint{center.x + radius.x * std::cos(angle),
                       center.y + radius.y * std::sin(angle)};
    };
    for (int k = 0; k < count; ++k) {
      strokes.push_back({at(k), at(k + 1)});
    }
    return *this;
  }
};

Glyph turned(Glyph glyph) {
  for (TextStroke& stroke : glyph.strokes) {
    for (TextPoint* const p : {&stroke.from, &stroke.to}) {
      *p = {glyph.width - p->x, kGridHeight - p->y};
    }
  }
  return glyph;
}

Glyph six() {
  return Glyph{}.arc({3, 3.1}, {3, 3.1}, 0, 360).arc({5.2, 3.1}, {5.2, 6.9}, 180, 95);
}

Glyph digit(char c) {
  Glyph g;
  switch (c) {
    case '0':
      return g.arc({3, 7}, {3, 3}, 0, 180)
          .line({0, 7}, {0, 3})
          .arc({3, 3}, {3, 3}, 180, 360)
          .line({6, 3}, {6, 7});
    case '1':
      return g.line({1.2, 8}, {3.6, 10}).line({3.6, 10}, {3.6, 0});
    case '2':
      return g.arc({3, 7}, {3, 3}, 165, -38).line({5.36, 5.15}, {0, 0}).line({0, 0}, {6, 0});
    case '3':
      return g.arc({2.9, 7.6}, {2.5, 2.4}, 155, -90).arc({2.9, 2.6}, {3, 2.6}, 90, -155);
    case '4':
      return g.line({4.6, 0}, {4.6, 10}).line({4.6, 10}, {0, 3}).line({0, 3}, {6.2, 3});
    case '5':
      return g.line({5.4, 10}, {1, 10})
          .line({1, 10}, {0.6, 5.3})
          .arc({2.9, 3.2}, {3, 3.2}, 140, -150);
    case '6':
      return six();
    case '7':
      return g.line({0, 10}, {6, 10}).line({6, 10}, {2, 0});
    case '8':
      return g.arc({3, 7.6}, {2.5, 2.4}, 0, 360).arc({3, 2.6}, {3, 2.6}, 0, 360);
    default:
      return turned(six());
  }
}

Glyph letter(char c) {
  Glyph g;
  switch (c) {
    case 'c':
      g.width = 5.2;
      return g.arc({3, 3}, {3, 3}, 45, 315);
    case 'e':
      return g.line({0, 3.1}, {6, 3.1}).arc({3, 3}, {3, 3}, 2, 318);
    case 'f':
      g.width = 4;
      return g.line({1.4, 0}, {1.4, 7.8}).arc({3.4, 7.8}, {2, 2.2}, 180, 75).line({0, 6}, {3.4, 6});
    case 'i':
      g.width = 1;
      return g.line({0.5, 0}, {0.5, 6}).line({0.5, 8.6}, {0.5, 8.6});
    case 'k':
      g.width = 4.8;
      return g.line({0, 0}, {0, 10}).line({4.4, 6}, {0, 2.1}).line({1.6, 3.5}, {4.8, 0});
    case 'm':
      g.width = 8;
      return g.line({0, 0}, {0, 6})
          .arc({2, 4}, {2, 2}, 180, 0)
          .line({4, 4}, {4, 0})
          .arc({6, 4}, {2, 2}, 180, 0)
          .line({8, 4}, {8, 0});
    case 'n':
      g.width = 5;
      return g.line({0, 0}, {0, 6}).arc({2.5, 3.5}, {2.5, 2.5}, 180, 0).line({5, 3.5}, {5, 0});
    case 't':
      g.width = 4;
      return g.line({1.4, 9}, {1.4, 2}).arc({3.4, 2}, {2, 2}, 180, 285).line({0, 6}, {3.4, 6});
    default:
      return g.line({0, 0}, {6, 0})
          .line({6, 0}, {6, 10})
          .line({6, 10}, {0, 10})
          .line({0, 10}, {0, 0});
  }
}

Glyph glyph_of(char c) {
  if (c >= '0' && c <= '9') {
    return digit(c);
  }
  Glyph g;
  switch (c) {
    case ' ':
      g.width = 1;
      return g;
    case '.':
      g.width = 0.6;
      return g.line({0.3, 0}, {0.3, 0.3});
    case '-':
      g.width = 5;
      return g.line({0, 4.3}, {5, 4.3});
    case '+':
      g.width = 5;
      return g.line({0, 4.3}, {5, 4.3}).line({2.5, 1.8}, {2.5, 6.8});
    default:
      return letter(c);
  }
}

}  // namespace

std::vector<TextStroke> strokes_of(std::string_view text, double height) {
  const double scale = height / kGridHeight;
  std::vector<TextStroke> strokes;
  double start = 0;
  for (const char c : text) {
    const Glyph glyph = glyph_of(c);
    const auto placed = [&](TextPoint p) { return TextPoint{(start + p.x) * scale, p.y * scale}; };
    for (const TextStroke& stroke : glyph.strokes) {
      strokes.push_back({placed(stroke.from), placed(stroke.to)});
    }
    start += glyph.width + kBetween;
  }
  return strokes;
}

double width_of(std::string_view text, double height) {
  double width = 0;
  for (const char c : text) {
    width += glyph_of(c).width + kBetween;
  }
  return std::max(0.0, width - kBetween) * height / kGridHeight;
}

}  // namespace soms::view
