#include "apps/soms/simulate/map.h"

#include "soms/base/text.h"

#include "apps/cli/length_unit.h"
#include "apps/cli/text.h"
#include "apps/draw/look.h"
#include "apps/draw/outline.h"
#include "apps/report/script_text.h"
#include "apps/soms/simulate/map_city.h"
#include "apps/soms/simulate/map_marks.h"
#include "apps/soms/simulate/simulate_near_report.h"
#include "apps/soms/simulate/simulate_report.h"
#include "apps/world/map_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace soms::command {

namespace {

constexpr std::size_t kCityBudget = 200'000;
/// Tracks and movers drawn at most; of more, every so many.
constexpr std::size_t kMostDrawn = 2500;
/// Gaps drawn at most, and those whose lengths are written: the nearest.
constexpr std::size_t kMostGaps = 1000;
constexpr std::size_t kMostLengths = 40;
constexpr double kLengthWidth = 62;
constexpr double kLengthHeight = 14;
constexpr auto kMarkHex = look::hex_characters(look::kContact.light);
constexpr const char* kMarkColor = kMarkHex.data();

/// The first model is body A; the others differ from it and from contacts for the color-blind.
std::string color_of(std::size_t model) {
  constexpr std::array kModelColors{look::kBodyA.light, look::kSeries[4].light,
                                    look::kSeries[2].light, look::kSeries[3].light,
                                    look::kSeries[5].light};
  return look::hex(kModelColors[model % kModelColors.size()]);
}

std::size_t stride_of(const World& world) {
  return world.routes.size() / kMostDrawn + 1;
}

/// A tenth of a pixel as a whole number. What lies far beyond the map is held there: neither it nor
/// a step between two such places outgrows the number.
std::int32_t tenth(double pixels) {
  constexpr double kFarthest = 1e9;
  return static_cast<std::int32_t>(std::lround(std::clamp(10 * pixels, -kFarthest, kFarthest)));
}

/// Tracks in tenths of a pixel, so that whole numbers do.
void draw_tracks(std::ostream& out, const MapPage& page, const World& world,
                 const Outcome& outcome) {
  for (std::size_t model = 0; model < world.models.size(); ++model) {
    PathWriter writer;
    for (std::size_t k = 0; k < outcome.tracks.size(); k += stride_of(world)) {
      if (world.routes[k].model != model) {
        continue;
      }
      Loop line;
      for (const Place& place : outcome.tracks[k]) {
        line.push_back({tenth(page.x(place.x)), tenth(page.y(place.y))});
      }
      writer.add(simplified_line(line, 5), false);
    }
    out << fmt::format(
        "<path transform=\"scale(.1)\" fill=\"none\" stroke=\"{}\" "
        "stroke-width=\"11\" stroke-opacity=\".55\" stroke-linejoin=\"round\" "
        "d=\"{}\"/>\n",
        color_of(model), writer.path());
  }
}

const char* cap_of(const Model& model) {
  return model.kind == Kind::car || model.kind == Kind::model ? "square" : "round";
}

/// Movers as dots where they were last, with a halo.
void draw_movers(std::ostream& out, const MapPage& page, const World& world,
                 const Outcome& outcome) {
  out << "<defs>\n";
  for (std::size_t model = 0; model < world.models.size(); ++model) {
    std::string path;
    for (std::size_t k = 0; k < outcome.tracks.size(); k += stride_of(world)) {
      if (world.routes[k].model == model && !outcome.tracks[k].empty()) {
        const Place& last = outcome.tracks[k].back();
        path += fmt::format("M{:.0f} {:.0f}h1", 10 * page.x(last.x), 10 * page.y(last.y));
      }
    }
    out << fmt::format(
        "<path id=\"m{}\" transform=\"scale(.1)\" stroke-linecap=\"{}\" d=\"{}\"/>\n", model,
        cap_of(world.models[model]), path);
  }
  out << "</defs>\n";
  for (std::size_t model = 0; model < world.models.size(); ++model) {
    for (const auto& [color, width] :
         {std::pair(std::string("#fff"), 62), std::pair(color_of(model), 42)}) {
      out << fmt::format("<use href=\"#m{}\" stroke=\"{}\" stroke-width=\"{}\"/>\n", model, color,
                         width);
    }
  }
}

/// A filled disc with the numbers of a place in the list; wider where they need it.
std::string number_mark(double x, double y, const std::string& numbers) {
  constexpr double kNumberRadius = 8;
  constexpr double kDigitWidth = 5.5;
  const double half = kNumberRadius + 0.5 * kDigitWidth * static_cast<double>(numbers.size() - 1);
  return fmt::format(
             "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:g}\" rx=\"{:g}\" "
             "fill=\"{}\" stroke=\"#fff\" stroke-width=\"1.2\"/>\n",
             x - half, y - kNumberRadius, 2 * half, 2 * kNumberRadius, kNumberRadius, kMarkColor) +
         map_text(x, y + 4, 11, numbers,
                  "text-anchor=\"middle\" fill=\"#fff\" font-weight=\"700\"");
}

void draw_marks(std::ostream& out, const MapPage& page, const std::vector<Mark>& marks) {
  out << fmt::format("<g fill=\"{}\" fill-opacity=\".35\" stroke=\"{}\" stroke-width=\"1.1\">\n",
                     kMarkColor, kMarkColor);
  for (const Mark& mark : marks) {
    out << fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:.1f}\"/>\n", page.x(mark.x),
                       page.y(mark.y), mark_radius(mark.contacts));
  }
  out << "</g>\n";
}

/// The places where the most touched triangles were touched first.
std::vector<Label> places_of(const MapPage& page, const World& world,
                             const std::vector<Touched>& most) {
  std::vector<Label> places;
  for (const Touched& touched : most) {
    const MoverRoute& mover_route = world.routes[touched.mover];
    const Vec3 at = mover_route.at(touched.begin).apply(world.models[mover_route.model].foot);
    places.push_back({page.x(at.x), page.y(at.y)});
  }
  return places;
}

/// Numbers them as in the list.
void draw_most_touched(std::ostream& out, const std::vector<Label>& places) {
  const std::vector<NumberedPlace> numbered = numbered_places(places, 18);
  for (std::size_t k = numbered.size(); k-- > 0;) {  // the first on top
    out << number_mark(numbered[k].at.x, numbered[k].at.y, numbered[k].numbers);
  }
}

/// The least gaps of two bodies each, as many as are drawn, the nearest first.
struct MapGaps {
  std::vector<NearEvent> drawn;
  std::size_t all = 0;
};

MapGaps gaps_of(const Outcome& outcome) {
  const std::vector<std::size_t> numbers = outcome.near.nearest_of_pairs();
  MapGaps gaps{.drawn = {}, .all = numbers.size()};
  for (std::size_t k = 0; k < std::min(numbers.size(), kMostGaps); ++k) {
    gaps.drawn.push_back(outcome.near.events()[numbers[k]]);
  }
  return gaps;
}

/// A shortest segment with a halo and a dot at either end, which are seen however short it is.
/// Lengths keep clear of what is `taken`.
void draw_gaps(std::ostream& out, const MapPage& page, const std::vector<NearEvent>& gaps,
               const std::vector<Label>& taken) {
  std::string path;
  std::vector<Label> labels;
  for (std::size_t k = gaps.size(); k-- > 0;) {  // the nearest on top
    const Vec3& a = gaps[k].point_a;
    const Vec3& b = gaps[k].point_b;
    path += fmt::format("M{:.1f} {:.1f}h.1M{:.1f} {:.1f}L{:.1f} {:.1f}h.1", page.x(a.x),
                        page.y(a.y), page.x(a.x), page.y(a.y), page.x(b.x), page.y(b.y));
  }
  std::vector<std::string> texts;
  for (const NearEvent& gap : gaps) {
    const Vec3 middle = (gap.point_a + gap.point_b) * 0.5;
    if (page.holds(middle)) {
      const double least = page.left + kLengthWidth / 2;
      const double most = std::max(least, page.left + page.width - kLengthWidth / 2);
      labels.push_back({std::clamp(page.x(middle.x), least, most), page.y(middle.y) - 7});
      texts.push_back(meters_in_text(gap.distance.lower));
    }
  }
  out << fmt::format("<defs><path id=\"gaps\" d=\"{}\"/></defs>\n", path);
  for (const auto& [color, width] : {std::pair("#fff", 6.5), std::pair(kMapInk, 3.2)}) {
    out << fmt::format(
        "<use href=\"#gaps\" fill=\"none\" stroke-linecap=\"round\" stroke=\"{}\" "
        "stroke-width=\"{}\"/>\n",
        color, width);
  }
  out << "<g text-anchor=\"middle\" font-weight=\"700\" stroke=\"#fff\" stroke-width=\"3\" "
         "stroke-linejoin=\"round\" paint-order=\"stroke\">\n";
  for (const std::size_t k :
       labels_with_room(labels, taken, kLengthWidth, kLengthHeight, kMostLengths)) {
    out << map_text(labels[k].x, labels[k].y, 11, texts[k]);
  }
  out << "</g>\n";
}

/// "400 cars"; a file's name has no plural: "2 of car".
std::string counted_models(std::uint64_t count, const Model& model) {
  return model.kind == Kind::model ? with_commas(count) + " of " + report::shortened(model.name, 28)
                                   : counted(count, model.name);
}

void write_movers(MapPanel& panel, const World& world) {
  panel.head(counted(world.routes.size(), "mover") + ", with tracks");
  for (std::size_t model = 0; model < world.models.size(); ++model) {
    const auto count = static_cast<std::uint64_t>(
        std::count_if(world.routes.begin(), world.routes.end(),
                      [&](const MoverRoute& mover_route) { return mover_route.model == model; }));
    panel.keyed(fmt::format("<path d=\"M-8 0H8\" stroke=\"{0}\" stroke-opacity=\".55\" "
                            "stroke-width=\"1.1\"/><path d=\"M0 0h.1\" stroke=\"{0}\" "
                            "stroke-width=\"6\" stroke-linecap=\"{1}\"/>",
                            color_of(model), cap_of(world.models[model])),
                counted_models(count, world.models[model]));
  }
  if (stride_of(world) > 1) {
    panel.line(fmt::format("(one in {} is drawn)", stride_of(world)), 24);
  }
}

void write_contacts(MapPanel& panel, const Outcome& outcome, const std::vector<Mark>& marks) {
  const std::uint64_t all = outcome.contacts.contacts().size();
  panel.head(all == 0 ? "No contact" : counted(all, "contact"));
  for (const std::uint64_t size : {1U, 10U, 100U}) {
    if (!marks.empty() && marks.front().contacts >= size) {
      panel.keyed(fmt::format("<circle r=\"{:.1f}\" fill=\"{}\" fill-opacity=\".35\" "
                              "stroke=\"{}\" stroke-width=\"1.1\"/>",
                              mark_radius(size), kMarkColor, kMarkColor),
                  fmt::format("{} at one place", size));
    }
  }
}

void write_gaps(MapPanel& panel, const MapGaps& gaps) {
  if (gaps.all > 0) {
    panel.head(gaps.all > gaps.drawn.size()
                   ? fmt::format("The {} nearest of {}", with_commas(gaps.drawn.size()),
                                 counted(gaps.all, "gap"))
                   : counted(gaps.all, "gap") + " without a touch");
    panel.keyed(fmt::format("<path d=\"M-8 0H8\" stroke=\"{}\" stroke-width=\"2.5\" "
                            "stroke-linecap=\"round\"/>",
                            kMapInk),
                "least of two bodies, with its length");
  }
}

/// The list of the table.
void write_most_touched(MapPanel& panel, const World& world, const std::vector<Touched>& most) {
  if (most.empty()) {
    return;
  }
  panel.head("Most touched");
  for (std::size_t k = 0; k < most.size(); ++k) {
    panel.keyed(number_mark(0, 0, std::to_string(k + 1)),
                report::shortened(name_of(world, most[k]), 38));
    panel.line(counts_of(most[k]), 24);
  }
}

/// What the map shows, for those who do not see it.
std::string in_words(const World& world, const Outcome& outcome) {
  return fmt::format("Map from above, north up: {}, {}, {} in {}.",
                     counted(world.triangles, "triangle"), counted(world.routes.size(), "mover"),
                     counted(outcome.contacts.contacts().size(), "contact"),
                     counted(outcome.frames, "frame"));
}

}  // namespace

void draw_map(std::ostream& out, const World& world, const Outcome& outcome) {
  const MapPage page = make_map_page(world.bounds, common_unit(world.city));
  const MapCity city = outline_city(world, page.area, kCityBudget);
  const std::vector<Touched> most = outcome.contacts.most_touched(kMostTouched);
  const std::vector<Mark> marks = find_marks(world, outcome, 13 / page.scale);
  const std::vector<Label> places = places_of(page, world, most);
  const MapGaps gaps = gaps_of(outcome);
  open_map(out, page, world.title, in_words(world, outcome));
  draw_layers(out, page, city.layers, city.cell);
  draw_grid(out, page);
  draw_tracks(out, page, world, outcome);
  draw_movers(out, page, world, outcome);
  if (gaps.all > 0) {
    draw_gaps(out, page, gaps.drawn, places);
  }
  draw_marks(out, page, marks);
  draw_most_touched(out, places);
  close_map(out, page);
  MapPanel panel(out, page);
  panel.title(report::shortened(world.title, 24));
  panel.line(fmt::format("{} triangles, {} frames of 1/60 s", with_commas(world.triangles),
                         with_commas(outcome.frames)));
  write_movers(panel, world);
  write_contacts(panel, outcome, marks);
  write_most_touched(panel, world, most);
  write_gaps(panel, gaps);
  panel.head("City, from above");
  for (const MapLayer& layer : city.layers) {
    panel.keyed_color(layer.color, layer.legend);
  }
  panel.line("outlines are simplified");
  out << "</svg>\n";
}

}  // namespace soms::command
