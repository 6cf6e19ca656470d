#include "apps/view/verbs/render_report.h"

#include "apps/cli/text.h"
#include "apps/model/georeference.h"
#include "apps/output/json.h"
#include "apps/view/drawing/gl/gl_renderer.h"
#include "apps/view/scene/contact_look.h"
#include "apps/view/scene/shown_boxes.h"
#include "apps/view/scene/traversal_trace.h"
#include "apps/view/verbs/render_gaps.h"

#include <fmt/format.h>

#include <cstddef>
#include <optional>
#include <string>

namespace soms::view {

namespace {

command::Json point_json(const Vec3& p) {
  return command::Json::array({p.x, p.y, p.z});
}

/// The camera, with the names of what it looks at.
command::Json camera_json(CameraChoice::Subject subject, const ViewScene& scene,
                          const AimedCamera& aimed) {
  using Subject = CameraChoice::Subject;
  command::Json json{{"subject", subject == Subject::contact ? "contact"
                                 : subject == Subject::gap   ? "gap"
                                 : subject == Subject::mover ? "mover"
                                 : subject == Subject::place ? "place"
                                                             : "scene"},
                     {"eye", point_json(aimed.camera.eye)},
                     {"target", point_json(aimed.camera.target)}};
  if (aimed.pair) {
    json["bodies"] = {name_of_part(scene, aimed.pair->a, aimed.pair->part_a),
                      name_of_part(scene, aimed.pair->b, aimed.pair->part_b)};
  }
  return json;
}

/// With the keys of `soms distance --json`.
command::Json gap_json(const ViewScene& scene, const Gap& gap) {
  const Distance& near = gap.distance;
  return {{"lower", near.distance.lower},
          {"upper", near.distance.upper},
          {"triangles", command::Json::array({scene.numbers().triangle(gap.a, near.triangles->a),
                                              scene.numbers().triangle(gap.b, near.triangles->b)})},
          {"points", command::Json::array({point_json(near.point_a), point_json(near.point_b)})}};
}

/// The frame of an orientation test, for the line about a picture: most did not choose it.
std::string words_of_test(const ViewScene& scene) {
  const auto test = scene.test();
  return test ? fmt::format(", frame {} of 0 to {} of the test {}", scene.frame(),
                            scene.frames().value_or(1) - 1, *test)
              : std::string();
}

}  // namespace

bool draws_gap(const RenderOptions& options, const ViewScene& scene) {
  const bool clear = scene.movers() == 1 || scene.movers() + scene.city_parts() == 2;
  return !options.no_gap && clear;
}

BodyRef level_body(const RenderOptions& options) {
  return options.level_of == LevelOf::mover ? mover(0) : city_part(0);
}

void add_facts_of_files(command::Json& answer, const ViewScene& scene) {
  command::add_georeference(answer, scene.georeference());
  if (!scene.notes().empty()) {
    answer["notes"] = scene.notes();
  }
  if (!scene.warnings().empty()) {
    answer["warnings"] = command::warnings_json(scene.warnings());
  }
}

void report(const RenderOptions& options, Moment& moment, const AimedCamera& aimed,
            const DrawStatistics& drawn, command::Console& console) {
  ViewScene& scene = moment.scene;
  const SceneStatistics facts = scene.statistics();
  const std::optional<Gap> gap = draws_gap(options, scene) ? scene.gap() : std::nullopt;
  if (options.trace && facts.trace_cut) {
    console.note(fmt::format("--trace: stopped after {}; the rest is not drawn",
                             command::counted(kMostWatchedTests, "box test")));
  }
  if (!console.shared().json) {
    if (const std::string words = words_of_moment(moment, aimed); !words.empty()) {
      console.note(options.output + ": " + words);
    }
    console.note(fmt::format("{}: {}x{}, {}{}, {}{}, drawn by {}", options.output,
                             options.size.width, options.size.height,
                             command::counted(facts.triangles, "triangle"), words_of_test(scene),
                             command::counted(facts.contacts, "touching pair"),
                             words_of_gaps(scene, gap), GlRenderer::device()));
    return;
  }
  command::Json answer{{"schema", "soms.render/2"},
                       {"file", options.output},
                       {"width", options.size.width},
                       {"height", options.size.height},
                       {"frame", scene.frame()},
                       {"camera", camera_json(options.camera.subject, scene, aimed)},
                       {"triangles", facts.triangles},
                       {"movers", scene.movers()},
                       {"touching_pairs", facts.contacts},
                       {"touching_movers", facts.touching_movers},
                       {"markers", drawn.markers},
                       {"marked_movers", drawn.marked},
                       {"boxes", drawn.boxes},
                       {"draw_calls", drawn.draw_calls},
                       {"device", GlRenderer::device()}};
  if (moment.found) {
    answer["frames"] = moment.found->frames;
    answer["frames_searched"] = moment.found->searched;
  }
  if (!options.test.empty()) {
    answer["test"] = options.test;
  }
  if (options.level) {
    const Tree& tree = scene.tree(level_body(options));
    const std::size_t on_level = nodes_of_level(tree, *options.level, false).size();
    answer["level_boxes"] = on_level;
    answer["leaves_above"] = nodes_of_level(tree, *options.level, true).size() - on_level;
  }
  if (gap) {
    answer["gap"] = gap_json(scene, *gap);
  }
  add_gaps(answer, scene);
  add_facts_of_files(answer, scene);
  console.print(command::json_line(answer));
}

}  // namespace soms::view
