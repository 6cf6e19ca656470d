#include "apps/draw/svg.h"

#include "soms/base/text.h"

#include "apps/draw/look.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace soms::reproduce {

namespace {

static_assert(look::kSeries.size() == kSeriesColors);

/// Plain attributes give the light look, which every viewer of SVG knows; where the screen is dark,
/// these rules win over them.
std::string dark_rules() {
  const auto fill = [](std::string_view name, look::Rgb color) {
    return fmt::format(".sv .{}{{fill:{}}}", name, look::hex(color));
  };
  const auto stroke = [](std::string_view name, look::Rgb color) {
    return fmt::format(".sv .{}{{stroke:{}}}", name, look::hex(color));
  };
  std::string rules = fill("paper", look::kPaper.dark) + fill("ink", look::kInk.dark) +
                      fill("faint", look::kFaint.dark) + stroke("axis", look::rgb(0x9aa0a6)) +
                      stroke("grid", look::rgb(0x30353b)) + stroke("halo", look::kPaper.dark) +
                      fill("fa", look::kBodyA.dark) + fill("fb", look::kBodyB.dark);
  for (std::size_t k = 0; k < kSeriesColors; ++k) {
    rules += stroke(fmt::format("s{}", k), look::kSeries[k].dark) +
             fill(fmt::format("f{}", k), look::kSeries[k].dark);
  }
  return "<style>@media screen and (prefers-color-scheme:dark){" + rules + "}</style>\n";
}

/// Widths of the characters from ' ' to '~' in thousandths of the size, as of common sans-serifs.
constexpr std::array<std::uint16_t, 95> kWidths{
    278, 278, 355, 556, 556, 889, 667, 191, 333, 333, 389, 584, 278, 333,  278, 278, 556, 556, 556,
    556, 556, 556, 556, 556, 556, 556, 278, 278, 584, 584, 584, 556, 1015, 667, 667, 722, 722, 667,
    611, 778, 722, 278, 500, 667, 556, 833, 722, 778, 667, 778, 722, 667,  611, 722, 667, 944, 667,
    667, 611, 278, 278, 278, 469, 556, 333, 556, 556, 500, 556, 556, 278,  556, 556, 222, 222, 500,
    222, 833, 556, 556, 556, 556, 333, 500, 278, 556, 500, 722, 500, 500,  500, 334, 260, 334, 584};

/// The widest of the fonts that may stand in for the first choice.
constexpr double kWidestFont = 1.13;
constexpr double kBold = 1.15;

constexpr std::array<std::string_view, 3> kAnchors{"start", "middle", "end"};

}  // namespace

std::string series_color(std::size_t series) {
  return look::hex(look::kSeries[series % kSeriesColors].light);
}

std::string pixels(double value) {
  std::string text = fmt::format("{:.2f}", value);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') {
    text.pop_back();
  }
  return text == "-0" ? "0" : text;
}

std::string pixels(Spot spot) {
  return fmt::format("{},{}", pixels(spot.x), pixels(spot.y));
}

PathData& PathData::add(char command, Spot to) {
  data_ += command;
  data_ += pixels(to);
  return *this;
}

Svg::Svg(double width, double height, std::string_view title)
    : width_(width), height_(height), title_(xml_text(title)) {
}

void Svg::path(std::string_view d, std::string_view attributes) {
  body_ += fmt::format("<path d=\"{}\" {}/>\n", d, attributes);
}

void Svg::rect(Spot corner, double width, double height, std::string_view attributes) {
  body_ += fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" {}/>\n",
                       pixels(corner.x), pixels(corner.y), pixels(std::max(0.0, width)),
                       pixels(std::max(0.0, height)), attributes);
}

void Svg::circle(Spot center, double radius, std::string_view attributes) {
  body_ += fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"{}\" {}/>\n", pixels(center.x),
                       pixels(center.y), pixels(radius), attributes);
}

void Svg::line(Spot from, Spot to, std::string_view attributes) {
  body_ +=
      fmt::format("<path d=\"M{}L{}\" fill=\"none\" {}/>\n", pixels(from), pixels(to), attributes);
}

void Svg::text(Spot at, std::string_view words, const TextLook& look) {
  const auto put = [&](std::string_view look_of_rim) {
    body_ += fmt::format("<text x=\"{}\" y=\"{}\" font-size=\"{}\"", pixels(at.x), pixels(at.y),
                         pixels(look.size));
    if (look.anchor != Anchor::start) {
      body_ += fmt::format(" text-anchor=\"{}\"", kAnchors[static_cast<std::size_t>(look.anchor)]);
    }
    body_ += look.bold ? " font-weight=\"600\"" : "";
    body_ += ' ';
    body_ += look.more;
    body_ += fmt::format(" {}>{}</text>\n", look_of_rim, xml_text(words));
  };
  const std::string_view ink =
      look.faint ? "class=\"faint\" fill=\"#55595e\"" : "class=\"ink\" fill=\"#1d1f21\"";
  if (look.haloed) {
    body_ += "<g aria-hidden=\"true\">";
    put("class=\"halo paper\" fill=\"#fff\" stroke=\"#fff\" stroke-width=\"5\" "
        "stroke-linejoin=\"round\"");
    body_ += "</g>";
  }
  put(ink);
}

void Svg::lines(Spot at, const std::vector<std::string>& words, const TextLook& look) {
  for (const std::string& line : words) {
    text(at, line, look);
    at.y += 1.25 * look.size;
  }
}

void Svg::open_group(std::string_view attributes) {
  body_ += fmt::format("<g {}>\n", attributes);
}

void Svg::close_group() {
  body_ += "</g>\n";
}

std::string Svg::document() const {
  return fmt::format(
             "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"sv\" role=\"img\" "
             "viewBox=\"0 0 {0} {1}\" width=\"{0}\" height=\"{1}\" "
             "font-family=\"Helvetica, Arial, 'Liberation Sans', sans-serif\">\n"
             "<title>{2}</title>\n{3}"
             "<rect class=\"paper\" width=\"{0}\" height=\"{1}\" fill=\"#fff\"/>\n",
             pixels(width_), pixels(height_), title_, dark_rules()) +
         body_ + "</svg>\n";
}

double text_width(std::string_view words, double size, bool bold) {
  double thousandths = 0;
  for (std::size_t at = 0; at < words.size();) {
    const auto c = static_cast<unsigned char>(words[at]);
    thousandths += c >= 32 && c < 127 ? kWidths[c - 32U] : 700;
    at += std::max<std::size_t>(1, utf8_character(words, at));
  }
  return thousandths / 1000 * size * kWidestFont * (bold ? kBold : 1.0);
}

std::vector<std::string> wrapped(std::string_view words, double size, double width, bool bold) {
  std::vector<std::string> lines(1);
  while (!words.empty()) {
    const std::size_t end = std::min(words.find(' '), words.size());
    const std::string word(words.substr(0, end));
    words.remove_prefix(std::min(end + 1, words.size()));
    std::string& last = lines.back();
    const std::string longer = fmt::format("{} {}", last, word);
    if (last.empty()) {
      last = word;
    } else if (text_width(longer, size, bold) <= width) {
      last = longer;
    } else {
      lines.push_back(word);
    }
  }
  return lines;
}

}  // namespace soms::reproduce
