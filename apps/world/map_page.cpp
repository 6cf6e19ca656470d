#include "apps/world/map_page.h"

#include "soms/base/text.h"

#include "apps/cli/length_unit.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace soms::command {

namespace {

constexpr double kMapWidth = 900;
constexpr double kMapHeight = 860;
constexpr double kPanelWidth = 300;
constexpr double kMapMargin = 24;
/// Most pixels between lines of the grid.
constexpr double kGridSpace = 180;

double grid_step(const MapPage& page) {
  return round_length(kGridSpace / page.scale);
}

/// The numbers of the grid above the map and at its left.
void write_coordinates(std::ostream& out, const MapPage& page) {
  const double step = grid_step(page);
  out << fmt::format("<g fill=\"{}\" text-anchor=\"middle\">\n", look::hex(look::kFaint.light));
  for (const GridLine& line : grid_lines(page.area.lower.x, page.area.upper.x, step)) {
    out << map_text(page.x(line.at), page.top - 6, 10, line.text);
  }
  for (const GridLine& line : grid_lines(page.area.lower.y, page.area.upper.y, step)) {
    const double x = page.left - 6;
    const double y = page.y(line.at);
    out << map_text(x, y, 10, line.text,
                    fmt::format("transform=\"rotate(-90 {:.1f} {:.1f})\"", x, y));
  }
  out << "</g>\n";
}

/// An arrow to +y, whose tip is `tip` pixels from the upper edge of the page.
void draw_north(std::ostream& out, double x, double tip) {
  out << fmt::format(
      "<path d=\"M{0:.1f} {1:.1f}v16M{2:.1f} {3:.1f}l4 -6 4 6\" fill=\"none\" stroke=\"{4}\" "
      "stroke-width=\"1.5\"/>\n",
      x, tip, x - 4, tip + 6, kMapInk);
  out << map_text(x - 18, tip + 13, 12.5, "N", "font-weight=\"700\"");
}

}  // namespace

MapPage make_map_page(const Box& bounds, double unit) {
  MapPage page;
  page.unit = unit;
  page.area = bounds;
  const Vec3 extent = page.area.extent();
  const double longer = std::max(extent.x, extent.y);
  const double rim = longer > 0 ? 0.02 * longer : 0.5;
  page.area.lower = page.area.lower - Vec3{rim, rim, 0};
  page.area.upper = page.area.upper + Vec3{rim, rim, 0};
  const Vec3 size = page.area.extent();
  page.scale = std::min(kMapWidth / size.x, kMapHeight / size.y);
  page.width = size.x * page.scale;
  page.height = size.y * page.scale;
  page.left = kMapMargin;
  page.top = kMapMargin;
  return page;
}

std::string map_text(double x, double y, double size, std::string_view words,
                     std::string_view more) {
  return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" font-size=\"{:g}\"{}{}>{}</text>\n", x, y,
                     size, more.empty() ? "" : " ", more, xml_text(words));
}

void open_map(std::ostream& out, const MapPage& page, std::string_view title,
              std::string_view description) {
  const double width = page.left + page.width + kMapMargin + kPanelWidth;
  const double height = std::max(page.height, 560.0) + 2 * kMapMargin + 16;
  out << fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:.0f} {1:.0f}\" "
      "width=\"{0:.0f}\" height=\"{1:.0f}\" "
      "font-family=\"Helvetica, Arial, sans-serif\" fill=\"{2}\" role=\"img\" "
      "aria-labelledby=\"map-title map-about\">\n",
      width, height, kMapInk);
  out << fmt::format("<title id=\"map-title\">{}</title>\n<desc id=\"map-about\">{}</desc>\n",
                     xml_text(title), xml_text(description));
  out << "<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n";
  const std::string frame = fmt::format("x=\"{}\" y=\"{}\" width=\"{:.1f}\" height=\"{:.1f}\"",
                                        page.left, page.top, page.width, page.height);
  out << fmt::format("<clipPath id=\"map\"><rect {}/></clipPath>\n", frame);
  out << fmt::format("<rect {} fill=\"{}\"/>\n<g clip-path=\"url(#map)\">\n", frame, kMapPaper);
}

void draw_grid(std::ostream& out, const MapPage& page) {
  const double step = grid_step(page);
  std::string path;
  for (const GridLine& line : grid_lines(page.area.lower.x, page.area.upper.x, step)) {
    path += fmt::format("M{:.1f} {:.1f}v{:.1f}", page.x(line.at), page.top, page.height);
  }
  for (const GridLine& line : grid_lines(page.area.lower.y, page.area.upper.y, step)) {
    path += fmt::format("M{:.1f} {:.1f}h{:.1f}", page.left, page.y(line.at), page.width);
  }
  out << fmt::format(
      "<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\".7\" "
      "stroke-opacity=\".25\"/>\n",
      path, kMapInk);
}

void close_map(std::ostream& out, const MapPage& page) {
  out << "</g>\n";
  write_coordinates(out, page);
  draw_north(out, page.left + page.width - 6, page.top + page.height + 8);
  const double stated = round_length(0.22 * page.width / page.scale);
  const double length = stated * page.scale;
  const double y = page.top + page.height + 22;
  out << fmt::format(
      "<path d=\"M{:.1f} {:.1f}v6h{:.1f}v-6\" fill=\"none\" stroke=\"{}\" "
      "stroke-width=\"1.5\"/>\n",
      page.left, y - 6, length, kMapInk);
  out << map_text(page.left + length + 8, y, 12.5, length_with_unit(stated, page.unit));
}

double round_length(double length) {
  const double power = std::pow(10, std::floor(std::log10(length)));
  const double digits = length / power;
  return power * (digits >= 5 ? 5 : digits >= 2 ? 2 : 1);
}

std::vector<GridLine> grid_lines(double lower, double upper, double step) {
  constexpr double kMostLines = 100;
  constexpr double kMostPlain = 1e9;  // larger numbers are written with a power of ten
  const double first = std::ceil(lower / step);
  const double count = std::floor(upper / step) - first + 1;
  std::vector<GridLine> lines;
  // Far from the origin, neighbors of a step may be one number.
  if (!(count >= 1) || count > kMostLines || first + 1 == first) {
    return lines;
  }
  const int decimals = std::max(0, static_cast<int>(-std::floor(std::log10(step))));
  for (int k = 0; k < static_cast<int>(count); ++k) {
    const double at = (first + k) * step + 0.0;  // no -0
    lines.push_back({at, std::abs(at) < kMostPlain && decimals <= 6
                             ? fmt::format("{:.{}f}", at, decimals)
                             : fmt::format("{:.12g}", at)});
  }
  return lines;
}

MapPanel::MapPanel(std::ostream& out, const MapPage& page)
    : out_(out), left_(page.left + page.width + kMapMargin), y_(page.top - 6) {
}

void MapPanel::title(std::string_view words) {
  out_ << map_text(left_, y_ += 22, 22, words, "font-weight=\"700\"");
  y_ += 4;
}

void MapPanel::head(std::string_view words) {
  y_ += 14;
  out_ << map_text(left_, y_ += 16, 14, words, "font-weight=\"700\"");
}

void MapPanel::line(std::string_view words, double indent) {
  out_ << map_text(left_ + indent, y_ += 17, 12.5, words);
}

void MapPanel::keyed(std::string_view swatch, std::string_view words) {
  line(words, 24);
  out_ << fmt::format("<g transform=\"translate({:.1f} {:.1f})\">{}</g>\n", left_ + 8, y_ - 4,
                      swatch);
}

void MapPanel::keyed_color(std::string_view color, std::string_view words) {
  keyed(fmt::format("<rect x=\"-8\" y=\"-6\" width=\"16\" height=\"12\" fill=\"{}\" "
                    "stroke=\"{}\" stroke-width=\".5\"/>",
                    color, kMapInk),
        words);
}

}  // namespace soms::command
