#include "apps/view/verbs/render_scene.h"

#include "soms/base/error.h"
#include "soms/scene/replay.h"

#include "apps/cli/parse.h"
#include "apps/rows/pose_source.h"
#include "apps/view/scene/load.h"
#include "apps/view/scene/orientation_menu.h"
#include "apps/view/scene/scene_colors.h"
#include "apps/world/world.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace soms::view {

namespace {

SceneContent placed(command::WorldOptions options, const std::string& pose,
                    command::Console& console) {
  if (options.movers.size() != 1 || !options.routes.empty() || options.count) {
    throw Error(ErrorKind::usage, "--pose places the one model of --mover",
                "give one --mover, and neither --route nor --count");
  }
  command::PoseSource poses("--pose", pose, console);
  options.count = 0;
  command::World world = command::load_world(options, console);
  const command::Model model = world.models.front();
  world.routes.clear();
  SceneContent content = content_of(std::move(world));
  const bool single = poses.is_constant();
  while (const auto at = poses.next()) {
    if (content.movers.size() == kMostPoses) {
      throw Error(ErrorKind::usage, fmt::format("--pose {}: more than {} poses", pose, kMostPoses),
                  "draw fewer at a time");
    }
    content.movers.push_back({Body(model.shape, *at, model.name), {}});
    if (single) {
      break;
    }
  }
  return content;
}

/// True if a model looks like a tile of a city: far wider than high, with many buildings.
bool looks_like_a_tile(const Body& body) {
  constexpr double kFlat = 0.2;
  constexpr std::uint32_t kManyBuildings = 50;
  const Vec3 extent = body.shape.bounds().extent();
  if (extent.z > kFlat * std::max(extent.x, extent.y)) {
    return false;
  }
  const std::vector<std::uint32_t> pieces = pieces_of_triangles(*body.shape.shared_mesh());
  return !pieces.empty() && *std::max_element(pieces.begin(), pieces.end()) >= kManyBuildings;
}

}  // namespace

void make_pair_of_two(SceneContent& content) {
  if (content.city.size() != 2 || !content.movers.empty() || content.recording ||
      !content.georeference.empty() ||
      std::any_of(content.city.begin(), content.city.end(), looks_like_a_tile)) {
    return;
  }
  content.movers.push_back({std::move(content.city.back()), {}});
  content.city.pop_back();
  for (auto* const numbers : {&content.numbers.triangles, &content.numbers.vertices}) {
    numbers->resize(std::min<std::size_t>(numbers->size(), 1));
  }
}

SceneContent load_content(command::WorldOptions options, const std::string& pose,
                          command::Console& console) {
  command::check_count(options);
  if (pose.empty() && options.cities.size() == 1 && is_recording(options.cities[0])) {
    return load_recording(options.cities[0], options, console);
  }
  if (!pose.empty()) {
    options.guess_up = false;
    return placed(std::move(options), pose, console);
  }
  if (!options.cities.empty() && options.movers.empty() && options.routes.empty() &&
      !options.count) {
    options.count = 0;
  } else if (!options.movers.empty() && options.routes.empty() && !options.count) {
    options.count = options.movers.size();  // who names one model means to see one
    options.guess_mover_up = options.guess_up;
  } else {
    options.guess_up = false;  // routes and poses are those of `simulate`
  }
  return content_of(command::load_world(options, console));
}

void add_test(command::Parser& parser, std::string& test, const std::string& text) {
  command::Choices<std::string> tests;
  for (const OrientationTest& row : orientation_tests()) {
    tests.emplace_back(row.name, row.name);
  }
  command::add_choice<std::string>(parser, "--test", test, std::move(tests), text);
}

SceneContent load_tested(command::WorldOptions options, const std::string& pose,
                         command::Console& console) {
  if (!pose.empty() || options.movers.size() != 1 || !options.routes.empty() || options.count) {
    throw Error(ErrorKind::usage, "--test moves the one model of --mover",
                "give one --mover, and no --pose, --route or --count");
  }
  options.guess_up = options.guess_mover_up = true;
  return placed(std::move(options), "0 0 0", console);
}

double meters_of_unit(const command::WorldOptions& options, bool is_recording, double declared) {
  const bool is_meter = options.cities.empty() || options.city_model.scale_is_given || is_recording;
  return is_meter ? 1 : declared;
}

}  // namespace soms::view
