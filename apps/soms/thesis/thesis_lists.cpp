#include "apps/soms/thesis/thesis_lists.h"

#include "soms/base/text.h"
#include "soms/thesis/traversals.h"
#include "soms/tree/option_names.h"
#include "soms/tree/rule/rules.h"

#include <fmt/format.h>

#include <optional>
#include <string_view>

namespace soms::command {

namespace {

Json number_or_null(const std::optional<std::size_t>& frame) {
  return frame ? Json(*frame) : Json(nullptr);
}

Json rate_or_null(double fps) {
  return fps > 0 ? Json(fps) : Json(nullptr);
}

void add_counts(Json& to, const TraversalCounts& counts, std::uint64_t triangle_tests) {
  to["box_tests"] = counts.box_tests;
  to["entered"] = counts.entered;
  to["leaf_pairs"] = counts.leaf_pairs;
  to["triangle_pairs"] = counts.triangle_pairs;
  to["first_tests"] = counts.first_tests;
  to["max_stack"] = counts.max_stack;
  to["triangle_tests"] = triangle_tests;
}

Json frame_json(const ThesisResult& result, std::size_t k) {
  const reproduce::Frame& frame = result.frames[k];
  const Vec3& offset = result.what.trip.offsets[k];
  const double ms = result.ms[k];
  Json row{{"frame", k},
           {"offset", {offset.x, offset.y, offset.z}},
           {"root_overlap", frame.roots_overlap}};
  add_counts(row, frame.counts, frame.triangle_tests);
  row["contacts"] = frame.contacts.size();
  row["collision_ms"] = ms;
  row["fps"] = rate_or_null(ms > 0 ? 1000 / ms : 0);
  return row;
}

Json model_json(const std::string& name, const std::string& title, const Shape& shape,
                const LevelsOfTree& levels) {
  const LevelOfTree last = last_level(*shape.tree(), levels);
  return {{"name", name},
          {"title", title},
          {"triangles", shape.mesh().triangles.size()},
          {"nodes", shape.tree()->nodes.size()},
          {"levels", levels.last},
          {"level", last.level},
          {"level_boxes", last.boxes},
          {"leaves_above", last.leaves_above}};
}

Json test_json(const ThesisResult& result) {
  const ThesisTrip& what = result.what;
  const ThesisSummary& summary = result.summary;
  Json test{
      {"test", what.trip.test},
      {"still", model_json(what.trip.still, what.still_title, what.trip.a, what.still_levels)},
      {"moving", model_json(what.trip.moving, what.moving_title, what.trip.b, what.moving_levels)},
      {"stand_in", what.stand_in},
      {"up", what.up == 1 ? "y" : "z"},
      {"frames", summary.sums.frames},
      {"root_overlap_frames", summary.sums.root_overlap_frames},
      {"hit_frames", summary.sums.hit_frames},
      {"contact_frames", summary.contact_frames},
      {"first_root_frame", number_or_null(summary.first_root)},
      {"first_leaf_frame", number_or_null(summary.first_leaf)},
      {"first_contact_frame", number_or_null(summary.first_contact)}};
  add_counts(test, summary.sums.counts, summary.sums.triangle_tests);
  test["contacts"] = summary.sums.contacts;
  test["last_contacts"] = summary.last_contacts;
  const bool timed = summary.fps() > 0;
  test["mean_ms"] = timed ? Json(summary.mean_ms) : Json(nullptr);
  test["median_ms"] = timed ? Json(summary.median_ms) : Json(nullptr);
  test["max_ms"] = timed ? Json(summary.max_ms) : Json(nullptr);
  test["fps"] = rate_or_null(summary.fps());
  test["interactive"] = timed ? Json(std::string(interactive_word(summary.fps()))) : Json(nullptr);
  Json rows = Json::array();
  for (std::size_t k = 0; k < result.frames.size(); ++k) {
    rows.push_back(frame_json(result, k));
  }
  test["rows"] = std::move(rows);
  return test;
}

Json options_json(const ThesisOptions& options) {
  const BuildOptions& build = options.build;
  return {{"rule", entry(build.rule).name},
          {"midpoint", name(build.midpoint)},
          {"empty_side", name(build.empty_side)},
          {"axis_from", build.axis_from ? Json(name(*build.axis_from)) : Json(nullptr)},
          {"c_vertex", build.c_vertex},
          {"per_leaf", build.per_leaf},
          {"levels", build.level},
          {"root_level", build.root_level},
          {"traversal", entry(options.traversal.traversal).name},
          {"descent", entry(options.traversal.descent).name},
          {"repetitions", options.repetitions}};
}

}  // namespace

Json thesis_json(const ThesisReport& report) {
  Json tests = Json::array();
  for (const ThesisResult& result : report.results) {
    tests.push_back(test_json(result));
  }
  Json document{{"schema", "soms.thesis/1"}, {"options", options_json(report.options)}};
  if (!report.remarks.empty()) {
    document["notes"] = report.remarks;
  }
  if (!report.warnings.empty()) {
    document["warnings"] = warnings_json(report.warnings);
  }
  document["tests"] = std::move(tests);
  return document;
}

void write_thesis_csv(std::ostream& out, const ThesisReport& report) {
  out << "still,moving,test,rule,traversal,frame,x,y,z,root_overlap,box_tests,entered,leaf_pairs,"
         "triangle_pairs,first_tests,max_stack,triangle_tests,contacts,collision_ms,fps\n";
  const std::string_view traversal = entry(report.options.traversal.traversal).name;
  for (const ThesisResult& result : report.results) {
    const reproduce::Trip& trip = result.what.trip;
    const std::string head = fmt::format("{},{},{},{},{}", csv_field(trip.still),
                                         csv_field(trip.moving), trip.test, trip.rule, traversal);
    for (std::size_t k = 0; k < result.frames.size(); ++k) {
      const reproduce::Frame& frame = result.frames[k];
      const TraversalCounts& counts = frame.counts;
      const Vec3& offset = trip.offsets[k];
      const double ms = result.ms[k];
      out << fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n", head, k, offset.x,
                         offset.y, offset.z, frame.roots_overlap, counts.box_tests, counts.entered,
                         counts.leaf_pairs, counts.triangle_pairs, counts.first_tests,
                         counts.max_stack, frame.triangle_tests, frame.contacts.size(), ms,
                         ms > 0 ? fmt::format("{}", 1000 / ms) : std::string());
    }
  }
}

}  // namespace soms::command
