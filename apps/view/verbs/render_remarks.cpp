#include "apps/view/verbs/render_remarks.h"

#include "apps/cli/text.h"
#include "apps/view/verbs/render_camera.h"

#include <fmt/format.h>

#include <cstdint>

namespace soms::view {

namespace {

/// Says of what a city of several files is shown in part.
void remark_parts(const RenderOptions& options, const ViewScene& scene,
                  const command::Console& console) {
  if (scene.city_parts() < 2) {
    return;
  }
  const auto remark = [&](const char* option, bool given) {
    if (given) {
      console.note(fmt::format("{}: of the city's {} files with the first alone, {}", option,
                               scene.city_parts(), scene.body(city_part(0)).name));
    }
  };
  remark("--level", options.level && options.level_of == LevelOf::city);
  remark("--trace", options.trace);
  remark("--test", !options.test.empty());
}

/// Says what of the scene a picture of it is framed without.
void remark_frame(const RenderOptions& options, const ViewScene& scene,
                  const command::Console& console) {
  if (const auto place = place_in(options.camera, scene)) {
    console.note(fmt::format(
        "{}: of places far apart, the one that holds most; {} and {} elsewhere (--camera scene,"
        "southwest frames all)",
        options.output, command::counted(place->triangles_left, "triangle"),
        command::counted(place->movers_left, "mover")));
    return;
  }
  if (options.camera.subject != CameraChoice::Subject::scene) {
    return;
  }
  if (const auto bulk = bulk_in(options.camera, scene)) {
    console.note(fmt::format(
        "{}: {} of the city far from the rest, not in the picture (--camera scene,southwest "
        "frames all)",
        options.output, command::counted(bulk->pieces_left, "part")));
  }
  const std::uint64_t astray = astray_movers(scene).size();
  if (astray > 0) {
    console.note(fmt::format("{}: {} far from the city, not in the picture", options.output,
                             command::counted(astray, "mover")));
  }
}

}  // namespace

void remark_what_is_left_out(const RenderOptions& options, const ViewScene& scene,
                             const command::Console& console) {
  remark_parts(options, scene, console);
  remark_frame(options, scene, console);
}

void remark_cut(const RenderOptions& options, const Camera& camera,
                const command::Console& console) {
  if (camera.cut > 0) {
    console.note(fmt::format("{}: what hides the subject is cut away, up to {:.3g} from the eye",
                             options.output, camera.cut));
  }
}

}  // namespace soms::view
