// The orientation tests frame by frame: figures 5.6 to 5.8, and the sides that the thesis has not.
#include "apps/draw/chart.h"
#include "apps/draw/look.h"
#include "thesis/experiments/experiments.h"
#include "thesis/pictures/side_view.h"
#include "thesis/run/steps.h"
#include "thesis/run/traversal_tables.h"
#include "thesis/trips/frames.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <limits>
#include <optional>
#include <set>
#include <utility>

namespace soms::reproduce {

namespace {

/// Frames that the picture shows: far, touching, coming in, half inside.
constexpr std::array<std::size_t, 4> kPictured{0, 32, 40, 48};

/// The traversal that the captions call generic: Ericson's, which descends the node of greater
/// volume.
NamedTraversal ericson_traversal() {
  return {"ericson", {.traversal = Traversal::ericson}};
}

/// A rule's trip, what it found, and how long it took.
struct RuleTrip {
  Contender build;
  Trip trip;
  std::vector<Frame> frames;
  FrameTimes times;
};

/// The first frame with a property; the number of frames where none has it.
template <class Property>
std::size_t first_frame(const RuleTrip& ride, const Property& property) {
  return static_cast<std::size_t>(std::find_if(ride.frames.begin(), ride.frames.end(), property) -
                                  ride.frames.begin());
}

std::size_t first_root_frame(const RuleTrip& ride) {
  return first_frame(ride, [](const Frame& frame) { return frame.roots_overlap; });
}

std::size_t first_leaf_frame(const RuleTrip& ride) {
  return first_frame(ride, [](const Frame& frame) { return frame.counts.leaf_pairs > 0; });
}

std::size_t first_contact_frame(const RuleTrip& ride) {
  return first_frame(ride, [](const Frame& frame) { return !frame.contacts.empty(); });
}

Cell frame_cell(const RuleTrip& ride, std::size_t frame) {
  return frame < ride.frames.size() ? count_cell(frame) : Cell{};
}

/// What overlaps in this frame for the first time.
std::string first_overlap(const RuleTrip& ride, std::size_t frame) {
  std::string words;
  for (const auto& [first, name] :
       {std::pair(first_root_frame(ride), "roots"), std::pair(first_leaf_frame(ride), "leaves"),
        std::pair(first_contact_frame(ride), "triangles")}) {
    if (first == frame) {
      words += words.empty() ? name : std::string("; ") + name;
    }
  }
  return words;
}

Table frame_table(const std::string& id, const std::vector<RuleTrip>& rides) {
  Table table{
      .id = id + "_frames",
      .caption = fmt::format(
          "Test {}: every frame by the generic traversal, trees of level {}; times are "
          "medians of {} repetitions (the number is ours), drawing off.{}",
          rides[0].trip.test, kObjectLevel, rides[0].times.frame[0].repetitions, kThesisOptions),
      .columns = {{"model"},
                  {"rule"},
                  {"frame"},
                  {"offset"},
                  {"root_overlap"},
                  {"first_overlap"},
                  {"drawing"},
                  {"collision", "ms", ColumnKind::timed},
                  {"frame_time", "ms", ColumnKind::timed},
                  {"fps", "", ColumnKind::timed}}};
  add_count_columns(table);
  table.columns.push_back({"triangle_tests"});
  table.columns.push_back({"contacts"});
  for (const RuleTrip& ride : rides) {
    for (std::size_t k = 0; k < ride.frames.size(); ++k) {
      const Frame& frame = ride.frames[k];
      const Vec3& offset = ride.trip.offsets[k];
      const double whole = ride.times.frame[k].median;
      const bool timed = !ride.times.frame[k].rounds.empty();
      std::vector<Cell> row{ride.trip.model,
                            ride.build.name,
                            count_cell(k),
                            offset.x + offset.y + offset.z,  // two of them are 0
                            yes_cell(frame.roots_overlap),
                            first_overlap(ride, k),
                            word_cell("off"),
                            timed ? number_cell(ride.times.collision[k].median) : Cell{},
                            timed ? number_cell(whole) : Cell{},
                            timed ? rate_cell(whole) : Cell{}};
      add_count_cells(row, frame.counts);
      row.push_back(count_cell(frame.triangle_tests));
      row.push_back(count_cell(frame.contacts.size()));
      table.rows.push_back(std::move(row));
    }
  }
  return table;
}

Table test_counts_table(const std::string& id, const std::vector<RuleTrip>& rides) {
  Table table{.id = id + "_counts",
              .caption = fmt::format("Test {}: counts of the generic traversal, summed over all "
                                     "frames (max_stack: the greatest), trees of level {}.{}",
                                     rides[0].trip.test, kObjectLevel, kThesisOptions),
              .columns = {{"model"},
                          {"rule"},
                          {"frames"},
                          {"root_overlap_frames"},
                          {"hit_frames"},
                          {"first_root_frame"},
                          {"first_leaf_frame"},
                          {"first_contact_frame"}}};
  add_count_columns(table);
  table.columns.push_back({"triangle_tests"});
  table.columns.push_back({"contacts"});
  for (const RuleTrip& ride : rides) {
    const Totals sum = totals(ride.frames);
    std::vector<Cell> row{ride.trip.model,
                          ride.build.name,
                          count_cell(sum.frames),
                          count_cell(sum.root_overlap_frames),
                          count_cell(sum.hit_frames),
                          frame_cell(ride, first_root_frame(ride)),
                          frame_cell(ride, first_leaf_frame(ride)),
                          frame_cell(ride, first_contact_frame(ride))};
    add_count_cells(row, sum.counts);
    row.push_back(count_cell(sum.triangle_tests));
    row.push_back(count_cell(sum.contacts));
    table.rows.push_back(std::move(row));
  }
  return table;
}

Table test_times_table(const std::string& id, const std::vector<RuleTrip>& rides) {
  Table table{
      .id = id + "_times",
      .caption = fmt::format(
          "Test {}: milliseconds and frames a second over the frames in which the roots "
          "overlap, each frame by its median of {} repetitions (the number is ours), drawing "
          "off; fps are 1000 / ms of the mean, median, longest and shortest frame; trees of "
          "level {}.{}",
          rides[0].trip.test, rides[0].times.frame[0].repetitions, kObjectLevel, kThesisOptions),
      .columns = {{"model"}, {"rule"}, {"quantity"}}};
  add_statistics_columns(table);
  for (const RuleTrip& ride : rides) {
    const auto collision = medians_where_roots_overlap(ride.times.collision, ride.frames);
    const auto whole = medians_where_roots_overlap(ride.times.frame, ride.frames);
    for (const auto& [quantity, numbers] :
         {std::pair("collision (ms)", collision), std::pair("frame (ms)", whole)}) {
      std::vector<Cell> row{ride.trip.model, ride.build.name, word_cell(quantity)};
      add_statistics_cells(row, numbers);
      table.rows.push_back(std::move(row));
    }
    table.rows.push_back({ride.trip.model, ride.build.name, word_cell("fps")});
    add_rate_cells(table.rows.back(), whole);
  }
  return table;
}

/// A chart over the frames from a little before the roots can touch.
template <class Value>
LineChart frame_chart(const std::vector<RuleTrip>& rides, const Value& value) {
  constexpr std::size_t kFrom = 28;
  LineChart chart;
  chart.x_label = "frame";
  for (const RuleTrip& ride : rides) {
    Line line{.name = ride.build.title};
    for (std::size_t k = kFrom; k < ride.frames.size(); ++k) {
      if (const std::optional<double> y = value(ride, k)) {
        line.x.push_back(static_cast<double>(k));
        line.y.push_back(*y);
      }
    }
    chart.lines.push_back(std::move(line));
  }
  return chart;
}

Figure box_test_figure(const std::string& id, const std::vector<RuleTrip>& rides) {
  LineChart chart = frame_chart(rides, [](const RuleTrip& ride, std::size_t k) {
    return std::optional(static_cast<double>(ride.frames[k].counts.box_tests));
  });
  chart.title = fmt::format("Box tests by frame, {} coming from the {}", rides[0].trip.model,
                            rides[0].trip.test);
  chart.y_label = "box tests";
  const std::size_t touch = first_root_frame(rides[0]);
  if (touch < rides[0].frames.size()) {
    chart.callouts.push_back({static_cast<double>(touch),
                              static_cast<double>(rides[0].frames[touch].counts.box_tests),
                              "the root boxes touch"});
  }
  return {.id = id + "_box_tests",
          .caption = fmt::format(
              "Test {}, {}: box tests of the generic traversal by frame; one until the roots "
              "touch, then more the deeper the object comes in.{}",
              rides[0].trip.test, rides[0].trip.model, kThesisOptions),
          .svg = draw(chart)};
}

Figure time_figure(const std::string& id, const std::vector<RuleTrip>& rides) {
  LineChart chart = frame_chart(rides, [](const RuleTrip& ride, std::size_t k) {
    const Timing& time = ride.times.collision[k];
    return time.rounds.empty() ? std::nullopt : std::optional(time.median);
  });
  chart.title = fmt::format("Time of collision detection by frame, {} coming from the {}",
                            rides[0].trip.model, rides[0].trip.test);
  chart.y_label = "ms a frame, collision only";
  return {.id = id,
          .caption =
              fmt::format("Test {}, {}: milliseconds of collision detection by frame, medians of "
                          "{} repetitions (the number is ours).{}",
                          rides[0].trip.test, rides[0].trip.model,
                          rides[0].times.frame[0].repetitions, kThesisOptions),
          .svg = draw(chart),
          .timed = true};
}

/// One frame: both bodies, and the triangles that touch in red.
void draw_frame(Svg& svg, const SideView& view, const RuleTrip& ride, std::size_t k) {
  const MeshView& mesh = ride.trip.a.mesh();
  const Vec3& offset = ride.trip.offsets[k];
  std::set<TriangleId> still;
  std::set<TriangleId> moving;
  for (const auto& [i, j] : ride.frames[k].contacts) {
    still.insert(i);
    moving.insert(j);
  }
  constexpr std::string_view kStill =
      "class=\"f5\" fill=\"#56b4e9\" fill-opacity=\"0.45\" stroke=\"#5c5f63\" "
      "stroke-width=\"0.25\"";
  constexpr std::string_view kMoving =
      "class=\"f4\" fill=\"#e69f00\" fill-opacity=\"0.45\" stroke=\"#5c5f63\" "
      "stroke-width=\"0.25\"";
  const std::string contact =
      fmt::format("fill=\"{0}\" fill-opacity=\"0.8\" stroke=\"{0}\" stroke-width=\"0.6\"",
                  look::hex(look::kContact.light));
  svg.path(view.facing(mesh, {}), kStill);
  svg.path(view.facing(ride.trip.b.mesh(), offset), kMoving);
  const std::vector<TriangleId> still_ids(still.begin(), still.end());
  const std::vector<TriangleId> moving_ids(moving.begin(), moving.end());
  svg.path(view.triangles(mesh, still_ids, {}), contact);
  svg.path(view.triangles(ride.trip.b.mesh(), moving_ids, offset), contact);
}

Figure picture(const std::string& id, const RuleTrip& ride, Approach from) {
  const bool upright = approach_line(from).axis == 1;
  const bool deep = approach_line(from).axis == 2;
  Box shown = ride.trip.a.bounds();
  shown.grow(Box{shown.lower + ride.trip.offsets[0], shown.upper + ride.trip.offsets[0]});
  const double width = upright ? 230 : 460;
  const double height = upright ? 520 : 180;
  const double room = height + 40;
  const std::size_t columns = upright ? 4 : 2;
  const double rows = upright ? 1 : 2;
  const std::string title = fmt::format(
      "Test {} in pictures: still object blue, moving object orange, contacts red", ride.trip.test);
  Svg svg(20 + static_cast<double>(columns) * (width + 10), 50 + rows * room, title);
  svg.text({20, 28}, title, {.size = 17, .bold = true});
  for (std::size_t i = 0; i < kPictured.size(); ++i) {
    const std::size_t k = kPictured[i];
    const std::size_t row = i / columns;
    const Spot corner{20 + static_cast<double>(i % columns) * (width + 10),
                      50 + static_cast<double>(row) * room};
    const SideView view(deep ? Side::right : Side::front, shown,
                        {{corner.x, corner.y + 24}, width - 10, height});
    svg.text({corner.x, corner.y + 14},
             fmt::format("frame {}: {}", k,
                         ride.frames[k].contacts.empty()
                             ? std::string("no contact")
                             : fmt::format("{} contacts", ride.frames[k].contacts.size())));
    draw_frame(svg, view, ride, k);
  }
  return {
      .id = id + "_picture",
      .caption = fmt::format("Test {}: {} and the same object that comes at it in frames 0, 32, "
                             "40 and 48; triangles that touch in red.",
                             ride.trip.test, ride.trip.model),
      .svg = svg.document()};
}

/// Contacts do not depend on the tree.
void check_same_contacts(const std::vector<RuleTrip>& rides) {
  for (const RuleTrip& ride : rides) {
    for (std::size_t k = 0; k < ride.frames.size(); ++k) {
      require(ride.frames[k].contacts == rides[0].frames[k].contacts,
              fmt::format("test {} of {}, frame {}: contacts by {} and by {}", ride.trip.test,
                          ride.trip.model, k, ride.build.title, rides[0].build.title));
    }
  }
}

/// Which rules make the fewest and the most box tests on one object.
std::string range_words(const std::vector<RuleTrip>& rides) {
  const auto box_tests = [](const RuleTrip& ride) { return totals(ride.frames).counts.box_tests; };
  const auto [least, most] = std::minmax_element(rides.begin(), rides.end(),
                                                 [&](const RuleTrip& one, const RuleTrip& other) {
                                                   return box_tests(one) < box_tests(other);
                                                 });
  return fmt::format("{}: fewest box tests {} ({}), most {} ({}).", rides[0].trip.model,
                     least->build.title, to_text(count_cell(box_tests(*least))), most->build.title,
                     to_text(count_cell(box_tests(*most))));
}

/// All rules on one object, each timed on its own: all frames of the first object, of others in a
/// quick run every so many.
std::vector<RuleTrip> rides_of(const Context& context, const Model& object, Approach from,
                               Steps& steps) {
  const bool first = &object == &context.models.objects.front();
  const NamedTraversal traversal = ericson_traversal();
  std::vector<RuleTrip> rides;
  for (const Contender& build : thesis_rules(kObjectLevel)) {
    RuleTrip ride{build, orientation_trip(object, from, build), {}, {}};
    ride.frames = answer_frames(ride.trip, traversal, steps.quiet());
    ride.times = time_frames(ride.trip, std::span(&traversal, 1), context.repetitions(100),
                             steps.quiet(), first ? 1 : context.timed_step(false))
                     .front();
    rides.push_back(std::move(ride));
    steps.done_one();
  }
  check_same_contacts(rides);
  return rides;
}

Result orientation(const Context& context, const std::string& id, Approach from) {
  const std::vector<Model>& objects = context.models.objects;
  Steps steps(context.limits, objects.size() * thesis_rules(kObjectLevel).size());
  Result result{.remarks = object_remarks(objects)};
  std::vector<RuleTrip> all;
  for (const Model& object : objects) {
    std::vector<RuleTrip> rides = rides_of(context, object, from, steps);
    const bool first = all.empty();
    const std::string own = first ? id : id + "_" + object.name;
    result.figures.push_back(time_figure(own, rides));
    result.figures.push_back(box_test_figure(own, rides));
    if (first) {
      result.figures.push_back(picture(id, rides.back(), from));
    }
    result.remarks.push_back(range_words(rides));
    std::move(rides.begin(), rides.end(), std::back_inserter(all));
  }
  result.tables = {test_times_table(id, all), test_counts_table(id, all), frame_table(id, all)};
  if (context.quick && objects.size() > 1) {
    result.remarks.push_back(
        fmt::format("Quick run: of each object but {} every {}th frame is timed.",
                    objects.front().name, context.timed_step(false)));
  }
  result.remarks.emplace_back(
      "On each object all four rules give the same contacts in every frame. Larger leaves make "
      "fewer box tests and more triangle tests, so compare times.");
  result.remarks.emplace_back(
      "Drawing is off in these times; drives-drawn has frames that are drawn. A frame is moving "
      "the boxes, traversing the trees and testing the triangles.");
  return result;
}

}  // namespace

Result figure_5_6(const Context& context) {
  return orientation(context, "figure_5_6", Approach::right);
}

Result figure_5_7(const Context& context) {
  return orientation(context, "figure_5_7", Approach::left);
}

Result figure_5_8(const Context& context) {
  return orientation(context, "figure_5_8", Approach::top);
}

Result orientation_bottom(const Context& context) {
  return orientation(context, "orientation_bottom", Approach::bottom);
}

Result orientation_front(const Context& context) {
  return orientation(context, "orientation_front", Approach::front);
}

Result orientation_back(const Context& context) {
  return orientation(context, "orientation_back", Approach::back);
}

}  // namespace soms::reproduce
