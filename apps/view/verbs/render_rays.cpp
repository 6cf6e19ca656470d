#include "apps/view/verbs/render_rays.h"

#include "soms/base/error.h"

#include "apps/cli/length_unit.h"
#include "apps/cli/text.h"
#include "apps/model/models.h"
#include "apps/output/json.h"
#include "apps/output/npz_file.h"
#include "apps/output/output.h"
#include "apps/view/verbs/ray_picture.h"
#include "apps/view/verbs/render_report.h"
#include "apps/view/verbs/render_scene.h"
#include "apps/view/verbs/sight_map.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <ios>
#include <string>
#include <string_view>
#include <vector>

namespace soms::view {

namespace {

bool has_extension(const RenderOptions& options, std::string_view extension) {
  return command::extension_of(options.output) == extension;
}

/// True for what is seen from above: a drawing, or a grid of numbers.
bool is_map(const RenderOptions& options) {
  return has_extension(options, ".svg") || has_extension(options, ".asc");
}

bool is_array(const RenderOptions& options) {
  return has_extension(options, ".npy");
}

/// An array of a row of numbers for each row of pixels, the topmost first.
template <typename Number>
void write_array(const RenderOptions& options, std::string_view type,
                 const std::vector<Number>& numbers, command::OutputFile& file) {
  static_assert(std::endian::native == std::endian::little);
  file.stream() << command::npy_header(
      type, fmt::format("({}, {})", options.size.height, options.size.width));
  file.stream().write(reinterpret_cast<const char*>(numbers.data()),
                      static_cast<std::streamsize>(numbers.size() * sizeof(Number)));
  file.commit();
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
  add_facts_of_files(answer, scene);
  console.print(command::json_line(answer));
}

/// The depths of an array as a picture counts them.
DepthPicture counts_of(const std::vector<double>& depths) {
  DepthPicture counted;
  for (const double depth : depths) {
    if (!std::isnan(depth)) {
      counted.nearest = counted.surface == 0 ? depth : std::min(counted.nearest, depth);
      counted.farthest = std::max(counted.farthest, depth);
      ++counted.surface;
    }
  }
  return counted;
}

DepthPicture write_depth_array(const RenderOptions& options, const ViewScene& scene,
                               command::OutputFile& file, const command::Console& console) {
  const auto depths = console.run("measuring " + options.output, [&](const Limits& limits) {
    return depths_of(scene, camera_of(options, scene, limits), options.size, limits);
  });
  write_array(options, "<f8", depths, file);
  return counts_of(depths);
}

DepthPicture write_depth_picture(const RenderOptions& options, const ViewScene& scene,
                                 command::OutputFile& file, const command::Console& console) {
  DepthPicture drawn = console.run("drawing " + options.output, [&](const Limits& limits) {
    return draw_depth(scene, camera_of(options, scene, limits), options.size, options.samples,
                      limits, meters_of(options, scene));
  });
  file.stream() << to_png(drawn.picture);
  file.commit();
  return drawn;
}

void write_depth(const RenderOptions& options, ViewScene& scene, command::OutputFile& file,
                 command::Console& console) {
  const DepthPicture drawn = is_array(options) ? write_depth_array(options, scene, file, console)
                                               : write_depth_picture(options, scene, file, console);
  const std::string unit = command::unit_name(meters_of(options, scene));
  const std::string range = drawn.surface == 0 ? std::string("no surface")
                                               : fmt::format("surfaces {} to {} {} from the eye",
                                                             length_in_words(drawn.nearest),
                                                             length_in_words(drawn.farthest), unit);
  say(options, scene, fmt::format("{}, {}", size_of(options), range),
      {{"surface_pixels", drawn.surface},
       {"nearest", drawn.nearest},
       {"farthest", drawn.farthest},
       {"unit", unit}},
      console);
}

/// Writes the cells of an array, and counts them as a picture's rays are.
SightPicture sight_in_cells(const RenderOptions& options, const ViewScene& scene,
                            const Camera& camera, command::OutputFile& file, const Limits& limits) {
  const auto cells = sight_cells(scene, camera, *options.visible_from, options.size, limits);
  write_array(options, "|u1", cells, file);
  const auto seen = std::count(cells.begin(), cells.end(), kSeenCell);
  const auto hidden = std::count(cells.begin(), cells.end(), kHiddenCell);
  return {.picture = {},
          .surface = static_cast<std::uint64_t>(seen + hidden),
          .in_sight = static_cast<std::uint64_t>(seen)};
}

void write_sight(const RenderOptions& options, ViewScene& scene, command::OutputFile& file,
                 command::Console& console) {
  const Vec3 from = *options.visible_from;
  const command::Json place = command::Json::array({from.x, from.y, from.z});
  if (is_map(options)) {
    const SightMap map = console.run("drawing " + options.output, [&](const Limits& limits) {
      return has_extension(options, ".svg") ? draw_sight_map(scene, from, limits)
                                            : sight_grid(scene, from, limits);
    });
    file.stream() << map.text;
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
    const Camera camera = camera_of(options, scene, limits);
    return is_array(options)
               ? sight_in_cells(options, scene, camera, file, limits)
               : draw_sight(scene, camera, from, options.size, options.samples, limits);
  });
  if (!is_array(options)) {
    file.stream() << to_png(drawn.picture);
    file.commit();
  }
  say(options, scene,
      fmt::format("{}, {} is in sight of ({:g}, {:g}, {:g}): {} of the surface shown",
                  size_of(options), is_array(options) ? "1" : "orange", from.x, from.y, from.z,
                  in_percent(drawn.in_sight, drawn.surface)),
      {{"visible_from", place}, {"surface_rays", drawn.surface}, {"rays_in_sight", drawn.in_sight}},
      console);
}

}  // namespace

double meters_of(const RenderOptions& options, const ViewScene& scene) {
  return meters_of_unit(options.world, scene.replaying(),
                        scene.city_parts() == 0 ? 0 : scene.body(city_part(0)).shape.mesh().unit);
}

bool is_ray_picture(const RenderOptions& options) {
  return options.depth || options.visible_from;
}

void check_ray_picture(const command::Parser& parser, const RenderOptions& options) {
  if (options.depth && options.visible_from) {
    throw Error(ErrorKind::usage, "--depth and --visible-from are two pictures",
                "draw one after the other");
  }
  if (options.depth && has_extension(options, ".asc")) {
    throw Error(ErrorKind::usage, "--depth is seen from an eye, and a grid .asc is a map",
                "name a .npy file, or use --visible-from");
  }
  if (is_map(options) && !options.visible_from) {
    throw Error(ErrorKind::usage, "only --visible-from makes a map, .svg or .asc",
                "name a .png file");
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
  if (is_array(options)) {
    refuse({"--samples"}, "an array, which has one ray for each pixel");
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
