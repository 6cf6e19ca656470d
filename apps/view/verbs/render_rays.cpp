#include "apps/view/verbs/render_rays.h"

#include "soms/base/error.h"

#include "apps/cli/length_unit.h"
#include "apps/cli/text.h"
#include "apps/model/georeference.h"
#include "apps/model/models.h"
#include "apps/output/json.h"
#include "apps/view/verbs/ray_picture.h"
#include "apps/view/verbs/sight_map.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <initializer_list>
#include <string>

namespace soms::view {

namespace {

/// True for the map, which is all that is written as SVG.
bool is_map(const RenderOptions& options) {
  std::string extension = std::filesystem::path(options.output).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension == ".svg";
}

/// Four digits, or a whole number with commas.
std::string length_in_words(double length) {
  constexpr double kMost = 1e15;
  return 1000 <= length && length < kMost
             ? command::with_commas(static_cast<std::uint64_t>(std::llround(length)))
             : command::four_digits(length);
}

const char* name_of_mode(const RenderOptions& options) {
  return options.depth ? "--depth" : "--visible-from";
}

Camera camera_of(const RenderOptions& options, const ViewScene& scene, const Limits& limits) {
  const Vec3 origin = options.center ? scene_bounds(scene).center() : Vec3{};
  return place_camera(options.camera, scene, options.size, origin, limits);
}

std::string size_of(const RenderOptions& options) {
  return fmt::format("{}: {}x{}", options.output, options.size.width, options.size.height);
}

void say(const RenderOptions& options, const ViewScene& scene, const std::string& words,
         const command::Json& facts, command::Console& console) {
  if (!console.shared().json) {
    console.note(words);
    return;
  }
  command::Json answer{{"schema", "soms.render/2"}, {"file", options.output}};
  if (!is_map(options)) {
    answer["width"] = options.size.width;
    answer["height"] = options.size.height;
  }
  answer["frame"] = scene.frame();
  answer["triangles"] = scene.statistics().triangles;
  answer["movers"] = scene.movers();
  answer["device"] = "rays";
  answer.update(facts);
  command::add_georeference(answer, scene.georeference());
  if (!scene.notes().empty()) {
    answer["notes"] = scene.notes();
  }
  if (!scene.warnings().empty()) {
    answer["warnings"] = command::warnings_json(scene.warnings());
  }
  console.print(command::json_line(answer));
}

void write_depth(const RenderOptions& options, ViewScene& scene, command::OutputFile& file,
                 command::Console& console) {
  const DepthPicture drawn = console.run("drawing " + options.output, [&](const Limits& limits) {
    return draw_depth(scene, camera_of(options, scene, limits), options.size, options.samples,
                      limits);
  });
  file.stream() << to_png(drawn.picture);
  file.commit();
  const std::string range =
      drawn.surface == 0
          ? std::string("no surface")
          : fmt::format("surfaces {} to {} {} from the eye", length_in_words(drawn.nearest),
                        length_in_words(drawn.farthest), command::unit_name(scene.unit()));
  say(options, scene, fmt::format("{}, {}", size_of(options), range),
      {{"surface_pixels", drawn.surface},
       {"nearest", drawn.nearest},
       {"farthest", drawn.farthest},
       {"unit", command::unit_name(scene.unit())}},
      console);
}

void write_sight(const RenderOptions& options, ViewScene& scene, command::OutputFile& file,
                 command::Console& console) {
  const Vec3 from = *options.visible_from;
  const command::Json place = command::Json::array({from.x, from.y, from.z});
  if (is_map(options)) {
    const SightMap map = console.run("drawing " + options.output, [&](const Limits& limits) {
      return draw_sight_map(scene, from, limits);
    });
    file.stream() << map.svg;
    file.commit();
    say(options, scene,
        fmt::format("{}: {} of the surface seen from above is in sight of ({:g}, {:g}, {:g})",
                    options.output, in_percent(map.in_sight, map.surface), from.x, from.y, from.z),
        {{"visible_from", place},
         {"cell", map.cell},
         {"cells", map.surface},
         {"cells_in_sight", map.in_sight}},
        console);
    return;
  }
  const SightPicture drawn = console.run("drawing " + options.output, [&](const Limits& limits) {
    return draw_sight(scene, camera_of(options, scene, limits), from, options.size, options.samples,
                      limits);
  });
  file.stream() << to_png(drawn.picture);
  file.commit();
  say(options, scene,
      fmt::format("{}, orange is in sight of ({:g}, {:g}, {:g}): {} of the surface shown",
                  size_of(options), from.x, from.y, from.z,
                  in_percent(drawn.in_sight, drawn.surface)),
      {{"visible_from", place}, {"surface_rays", drawn.surface}, {"rays_in_sight", drawn.in_sight}},
      console);
}

}  // namespace

bool is_ray_picture(const RenderOptions& options) {
  return options.depth || options.visible_from;
}

void check_ray_picture(const command::Parser& parser, const RenderOptions& options) {
  if (options.depth && options.visible_from) {
    throw Error(ErrorKind::usage, "--depth and --visible-from are two pictures",
                "draw one after the other");
  }
  if (is_map(options) && !options.visible_from) {
    throw Error(ErrorKind::usage, "only --visible-from draws a map as SVG", "name a .png file");
  }
  if (!is_ray_picture(options)) {
    return;
  }
  const auto refuse = [&](std::initializer_list<const char*> names, const std::string& where) {
    for (const char* const name : names) {
      if (parser.count(name) > 0) {
        throw Error(ErrorKind::usage, fmt::format("{} has no effect with {}", name, where),
                    "leave it out");
      }
    }
  };
  // Trees are shown by --level and --trace, which a picture by rays does not have either.
  if (const std::string trees = command::given_of_trees(parser); !trees.empty()) {
    refuse({trees.c_str()}, name_of_mode(options));
  }
  refuse({"--level", "--level-of", "--boxes", "--trace", "--no-prune", "--colors", "--see-through",
          "--edges", "--contacts-on-top", "--spots", "--no-gap", "--no-markers", "--title",
          "--no-key", "--no-ground", "--no-shadow"},
         name_of_mode(options));
  if (is_map(options)) {
    refuse({"--size", "--camera", "--center", "--samples"}, "a map");
  }
}

void write_ray_picture(const RenderOptions& options, ViewScene& scene, command::OutputFile& file,
                       command::Console& console) {
  if (options.depth) {
    write_depth(options, scene, file, console);
  } else {
    write_sight(options, scene, file, console);
  }
}

}  // namespace soms::view
