#include "apps/draw/stroke_font.h"

#include "apps/draw/stroke_letters.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>
#include <utility>

namespace soms::look {

namespace {

constexpr double kGridHeight = 10;
constexpr double kBetween = 2.4;  ///< letters
constexpr double kDegreesOfStroke = 24;
constexpr double kUnknownWidth = 6;

const StrokeLetter* find_letter(char c) {
  const auto* const found =
      std::find_if(kStrokeLetters.begin(), kStrokeLetters.end(),
                   [c](const StrokeLetter& letter) { return letter.letter == c; });
  return found == kStrokeLetters.end() ? nullptr : &*found;
}

double letter_width(char c) {
  const StrokeLetter* const letter = find_letter(c);
  return letter == nullptr ? kUnknownWidth : letter->width;
}

/// Reads paths of `stroke_letters.h`.
class StrokePathReader {
 public:
  explicit StrokePathReader(std::string_view path) : rest_(path) {}

  std::vector<TextStroke> strokes() {
    while (skip_spaces()) {
      const char what = rest_.front();
      rest_.remove_prefix(1);
      what == 'A' ? arc() : polyline();
    }
    return std::move(strokes_);
  }

 private:
  bool skip_spaces() {
    rest_.remove_prefix(std::min(rest_.find_first_not_of(' '), rest_.size()));
    return !rest_.empty();
  }

  [[nodiscard]] bool number_follows() { return skip_spaces() && rest_.front() < 'A'; }

  double number() {
    skip_spaces();
    double value = 0;
    const auto read = std::from_chars(rest_.data(), rest_.data() + rest_.size(), value);
    rest_.remove_prefix(static_cast<std::size_t>(read.ptr - rest_.data()));
    return value;
  }

  TextPoint point() {
    const double x = number();
    return {x, number()};
  }

  void polyline() {
    TextPoint last = point();
    while (number_follows()) {
      const TextPoint next = point();
      strokes_.push_back({last, next});
      last = next;
    }
  }

  void arc() {
    const TextPoint center = point();
    const TextPoint radius = point();
    const double from = number();
    const double to = number();
    const int count = std::max(1, static_cast<int>(std::abs(to - from) / kDegreesOfStroke + 0.5));
    const auto at = [&](int k) {
      const double angle = (from + (to - from) * k / count) * std::numbers::pi / 180;
      return TextPoint{center.x + radius.x * std::cos(angle),
                       center.y + radius.y * std::sin(angle)};
    };
    for (int k = 0; k < count; ++k) {
      strokes_.push_back({at(k), at(k + 1)});
    }
  }

  std::string_view rest_;
  std::vector<TextStroke> strokes_;
};

std::vector<TextStroke> letter_strokes(char c) {
  const StrokeLetter* const letter = find_letter(c);
  return StrokePathReader(letter == nullptr ? kUnknownLetter : letter->path).strokes();
}

}  // namespace

std::vector<TextStroke> strokes_of(std::string_view text, double height) {
  const double scale = height / kGridHeight;
  std::vector<TextStroke> strokes;
  double start = 0;
  for (const char c : text) {
    const auto placed = [&](TextPoint p) { return TextPoint{(start + p.x) * scale, p.y * scale}; };
    for (const TextStroke& stroke : letter_strokes(c)) {
      strokes.push_back({placed(stroke.from), placed(stroke.to)});
    }
    start += letter_width(c) + kBetween;
  }
  return strokes;
}

double width_of(std::string_view text, double height) {
  double width = 0;
  for (const char c : text) {
    width += letter_width(c) + kBetween;
  }
  return std::max(0.0, width - kBetween) * height / kGridHeight;
}

}  // namespace soms::look
