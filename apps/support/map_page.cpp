#include "apps/support/map_page.h"

#include "soms/base/text.h"

#include "apps/support/length_unit.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace soms::command {

namespace {

constexpr double kMapWidth = 900;
constexpr double kMapHeight = 860;
constexpr double kPanelWidth = 300;
constexpr double kMapMargin = 24;

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

void open_map(std::ostream& out, const MapPage& page, std::string_view title) {
  const double width = page.left + page.width + kMapMargin + kPanelWidth;
  const double height = std::max(page.height, 560.0) + 2 * kMapMargin + 16;
  out << fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:.0f} {1:.0f}\" "
      "width=\"{0:.0f}\" height=\"{1:.0f}\" "
      "font-family=\"Helvetica, Arial, sans-serif\" fill=\"{2}\">\n",
      width, height, kMapInk);
  out << fmt::format("<title>{}</title>\n", xml_text(title));
  out << "<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n";
  const std::string frame = fmt::format("x=\"{}\" y=\"{}\" width=\"{:.1f}\" height=\"{:.1f}\"",
                                        page.left, page.top, page.width, page.height);
  out << fmt::format("<clipPath id=\"map\"><rect {}/></clipPath>\n", frame);
  out << fmt::format("<rect {} fill=\"{}\"/>\n<g clip-path=\"url(#map)\">\n", frame, kMapPaper);
}

void close_map(std::ostream& out, const MapPage& page) {
  out << "</g>\n";
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
