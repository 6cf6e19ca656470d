/// \file
/// The verb `render`: a picture without a screen.
#pragma once

#include "apps/cli/verb.h"
#include "apps/view/scene/view_options.h"
#include "apps/view/verbs/render_camera.h"
#include "apps/world/world_options.h"

#include <cstdint>
#include <optional>
#include <string>

namespace soms::view {

/// Whose tree is drawn by level.
enum class LevelOf : std::uint8_t { city, mover };

/// Options of the verb `render`.
struct RenderOptions {
  command::WorldOptions world = {};
  std::string output = {};  ///< "-" is standard output
  std::string pose = {};
  std::string test = {};  ///< name of an orientation test, or empty
  std::optional<std::uint64_t> frame =
      std::nullopt;  ///< that is drawn; none: a rich one, of a test the fullest
  Size size{1920, 1080};
  CameraChoice camera = {.subject = CameraChoice::Subject::open};
  bool center = false;  ///< numbers of --camera count from the middle of the scene
  int samples = 4;
  ViewOptions shown = {};
  std::optional<int> level = std::nullopt;
  LevelOf level_of = LevelOf::city;
  BoxStyle boxes = BoxStyle::wire;
  bool trace = false;
  bool see_through = false;
  bool no_gap = false;
  bool no_shadow = false;
  std::string title = {};
  bool depth = false;                               ///< a picture of distances
  std::optional<Vec3> visible_from = std::nullopt;  ///< a picture or map of what a point sees
};

/// Adds the options and returns what draws the picture.
[[nodiscard]] command::Action add_render(command::Parser& parser, command::Shared& shared);

/// \errors As `HeadlessContext`, `load_content`, `place_camera` and `make_draw_list`;
///         ErrorKind::cannot_write.
[[nodiscard]] int run_render(const RenderOptions& given, command::Console& console);

/// Reads "WxH", each from 1 to 16384. \errors ErrorKind::usage.
[[nodiscard]] Size parse_picture_size(const std::string& text);

}  // namespace soms::view
