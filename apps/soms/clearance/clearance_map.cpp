#include "apps/soms/clearance/clearance_map.h"

#include "apps/cli/text.h"
#include "apps/draw/look.h"
#include "apps/draw/outline.h"
#include "apps/report/script_text.h"
#include "apps/soms/simulate/map_city.h"
#include "apps/world/map_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace soms::command {

namespace {

constexpr std::size_t kBytesOfCity = 200'000;

/// A class of stretches: its color, and its text in the legend.
struct GapClass {
  std::string color;
  std::string legend;
};

/// Which stretch is of which class.
struct GapClasses {
  std::vector<GapClass> classes;
  std::vector<std::size_t> of_stretch;
};

GapClasses classes_by_verdict(const ClearanceReport& report) {
  GapClasses by;
  const std::string limit =
      gap_in_text({report.options.clearance, report.options.clearance}, report.unit);
  by.classes = {{look::hex(look::kFree.light), "at least " + limit},
                {look::hex(look::kSeries[4].light), "below " + limit},
                {look::hex(look::kContact.light), "contact"},
                {look::hex(look::kOpen.light), "undecided"}};
  for (const ClearanceStretch& stretch : report.answer.stretches) {
    by.of_stretch.push_back(static_cast<std::size_t>(verdict(stretch, report.options.clearance)));
  }
  return by;
}

/// Without a clearance: thirds of the path, bounded by round gaps.
GapClasses classes_by_gap(const ClearanceReport& report) {
  std::vector<double> gaps;
  for (const ClearanceStretch& stretch : report.answer.stretches) {
    if (stretch.least.gap.lower > 0 && std::isfinite(stretch.least.gap.lower)) {
      gaps.push_back(stretch.least.gap.lower);
    }
  }
  std::sort(gaps.begin(), gaps.end());
  const double low = gaps.empty() ? 1 : round_length(gaps[gaps.size() / 3]);
  const double high =
      gaps.empty() ? 2 : std::max(round_length(2.6 * low), round_length(gaps[2 * gaps.size() / 3]));
  const auto text = [&](double gap) { return gap_in_text({gap, gap}, report.unit); };
  GapClasses by;
  by.classes = {{look::hex(look::kFree.light), "gap of " + text(high) + " or more"},
                {look::hex(look::kBodyA.light), text(low) + " to " + text(high)},
                {look::hex(look::kSeries[4].light), "below " + text(low)},
                {look::hex(look::kContact.light), "contact"}};
  for (const ClearanceStretch& stretch : report.answer.stretches) {
    const double gap = stretch.least.gap.lower;
    by.of_stretch.push_back(stretch.least.overlaps() ? 3 : gap < low ? 2 : gap < high ? 1 : 0);
  }
  return by;
}

/// The area of the map: around the path, as far as there is a city.
Box area_of_path(const ClearanceReport& report) {
  Box path;
  for (const ClearanceStation& station : report.answer.stations) {
    path.grow(station.pose.apply(report.path.motion.pivot));
  }
  if (path.empty()) {
    return report.world.bounds;
  }
  const Vec3 extent = path.extent();
  const double rim = std::max({3 * report.profile().ground_radius, 10 * report.options.every,
                               0.15 * std::max(extent.x, extent.y)});
  Box area = path;
  area.lower = area.lower - Vec3{rim, rim, rim};
  area.upper = area.upper + Vec3{rim, rim, rim};
  // Square at the least, so that a straight street has surroundings.
  const double longer = std::max(extent.x, extent.y);
  for (const std::size_t axis : {0U, 1U}) {
    const double more = 0.2 * (longer - extent[axis]);
    area.lower[axis] -= more;
    area.upper[axis] += more;
  }
  return area;
}

void draw_path(std::ostream& out, const MapPage& page, const ClearanceReport& report,
               const GapClasses& by) {
  const Clearance& answer = report.answer;
  const auto at = [&](std::size_t station) {
    const Vec3 p = answer.stations[station].pose.apply(report.path.motion.pivot);
    return fmt::format("{:.1f} {:.1f}", page.x(p.x), page.y(p.y));
  };
  std::string whole;
  std::vector<std::string> paths(by.classes.size());
  for (std::size_t k = 0; k < answer.stretches.size(); ++k) {
    std::string& path = paths[by.of_stretch[k]];
    const bool goes_on = k > 0 && by.of_stretch[k] == by.of_stretch[k - 1];
    path += goes_on ? "" : fmt::format("M{}", at(k));
    path += fmt::format("L{}", at(k + 1));
    whole += fmt::format("{}{}", k == 0 ? 'M' : 'L', at(k));
  }
  whole += answer.stretches.empty() ? "" : fmt::format("L{}", at(answer.stretches.size()));
  const auto draw = [&](const std::string& path, const std::string& color, double width) {
    if (!path.empty()) {
      out << fmt::format(
          "<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"{:g}\" "
          "stroke-linejoin=\"round\" stroke-linecap=\"round\"/>\n",
          path, color, width);
    }
  };
  draw(whole, "#fff", 8);
  for (std::size_t k = 0; k < paths.size(); ++k) {
    draw(paths[k], by.classes[k].color, 5);
  }
}

/// A shortest segment and its length.
void draw_gap_at(std::ostream& out, const MapPage& page, const ClearanceStation& station,
                 const std::string& color, const std::string& words) {
  const Vec3 middle = (station.point_a + station.point_b) * 0.5;
  const std::string path =
      fmt::format("M{:.1f} {:.1f}L{:.1f} {:.1f}h.1", page.x(station.point_a.x),
                  page.y(station.point_a.y), page.x(station.point_b.x), page.y(station.point_b.y));
  for (const auto& [ink, width] : {std::pair(std::string("#fff"), 9.0), std::pair(color, 4.5)}) {
    out << fmt::format(
        "<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"{:g}\" "
        "stroke-linecap=\"round\"/>\n",
        path, ink, width);
  }
  const double x = std::clamp(page.x(middle.x), page.left + 60, page.left + page.width - 60);
  const double above = page.y(middle.y) - 10;
  const double y = above < page.top + 16 ? page.y(middle.y) + 22 : above;
  out << map_text(x, y, 12.5, words,
                  "text-anchor=\"middle\" font-weight=\"700\" stroke=\"#fff\" stroke-width=\"3\" "
                  "stroke-linejoin=\"round\" paint-order=\"stroke\"");
}

std::string swatch_of_line(const std::string& color) {
  return fmt::format(
      "<path d=\"M-8 0H8\" stroke=\"{}\" stroke-width=\"5\" stroke-linecap=\"round\"/>", color);
}

void write_classes(MapPanel& panel, const ClearanceReport& report, const GapClasses& by) {
  panel.head(report.options.clearance > 0 ? "Clearance along the path" : "Gap along the path");
  for (std::size_t k = 0; k < by.classes.size(); ++k) {
    const auto count = std::count(by.of_stretch.begin(), by.of_stretch.end(), k);
    if (count > 0) {
      panel.keyed(swatch_of_line(by.classes[k].color), by.classes[k].legend);
    }
  }
}

void write_places(MapPanel& panel, const ClearanceReport& report, const NearestNames& names) {
  const Clearance& answer = report.answer;
  if (answer.least.body) {
    panel.head("Least gap");
    panel.line(fmt::format("{} at {:.2f}", gap_in_text(answer.least.gap, report.unit),
                           answer.least.chainage));
    panel.line(report::shortened(names.text(answer.least), 38));
  }
  if (answer.first_contact) {
    panel.head("First contact");
    panel.line(fmt::format("at {:.2f}", answer.first_contact->station.chainage));
    panel.line(report::shortened(names.text(answer.first_contact->station), 38));
  }
}

}  // namespace

void draw_clearance_map(std::ostream& out, const ClearanceReport& report,
                        const NearestNames& names) {
  const MapPage page = make_map_page(area_of_path(report), report.unit);
  const MapCity city = outline_city(report.world, page.area, kBytesOfCity);
  const GapClasses by =
      report.options.clearance > 0 ? classes_by_verdict(report) : classes_by_gap(report);
  const Clearance& answer = report.answer;
  const std::string title = report.profile().name + " in " + report.world.title;
  open_map(out, page, title,
           fmt::format("Map from above, north up: a path of {:.2f} with {}; the least gap is {}.",
                       report.length(), counted(answer.stations.size(), "station"),
                       gap_in_text(answer.least.gap, report.unit)));
  draw_layers(out, page, city.layers, city.cell);
  draw_grid(out, page);
  draw_path(out, page, report, by);
  if (answer.first_contact && answer.first_contact->station.triangles) {
    draw_gap_at(out, page, answer.first_contact->station, look::hex(look::kContact.light),
                "first contact");
  }
  if (answer.least.body && !answer.least.overlaps()) {
    draw_gap_at(out, page, answer.least, kMapInk, gap_in_text(answer.least.gap, report.unit));
  }
  close_map(out, page);
  MapPanel panel(out, page);
  panel.title(report::shortened(title, 24));
  panel.line(fmt::format("path of {:.2f}, {}", report.length(),
                         counted(answer.stations.size(), "station")));
  write_classes(panel, report, by);
  write_places(panel, report, names);
  panel.head("City, from above");
  for (const MapLayer& layer : city.layers) {
    panel.keyed_color(layer.color, layer.legend);
  }
  panel.line("outlines are simplified");
  out << "</svg>\n";
}

}  // namespace soms::command
