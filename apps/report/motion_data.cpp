#include "apps/report/motion_data.h"

#include "apps/report/script_text.h"

#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <optional>

namespace soms::report {

namespace {

std::string list_of_place(const Vec3& at) {
  return fmt::format("[{},{},{}]", at.x, at.y, at.z);
}

std::string list_of_turn(const RigidMotion::Quaternion& turn) {
  return fmt::format("[{},{},{},{}]", turn[1], turn[2], turn[3], turn[0]);
}

/// JSON has no infinity.
std::string number_or_null(double value) {
  return std::isfinite(value) ? fmt::format("{}", value) : "null";
}

}  // namespace

std::string motions_json(const Scene& scene, const MotionFrame& frame) {
  const auto placed = [&](const Vec3& at) {
    return list_of_place((at - frame.origin) * frame.scale);
  };
  std::string list;
  std::size_t row = 0;
  for (const SceneMotion& shown : scene.motions) {
    const RigidMotion& motion = shown.motion;
    list += fmt::format(
        "{}{{\"number\":{},\"blocked\":{},\"lower\":{},\"upper\":{},\"moment\":{},\"verdict\":{},"
        "\"words\":{},\"row\":{},\"place\":{},\"way\":[{},{}],\"turns\":[{},{}],\"arm\":{}}}",
        list.empty() ? "" : ",", shown.number, shown.blocked, number_or_null(shown.t.lower),
        number_or_null(shown.t.upper), shown.moment, script_text(shown.verdict),
        script_text(shown.words), shown.place ? static_cast<std::ptrdiff_t>(row++) : -1,
        shown.place ? placed(*shown.place) : "null", placed(motion.pivot_from()),
        placed(motion.pivot_to()), list_of_turn(motion.from()), list_of_turn(motion.to()),
        list_of_place((frame.middle - motion.pivot()) * frame.scale));
  }
  return fmt::format(",\"motions\":[{}],\"motions_in_all\":{}", list, scene.motions_in_all);
}

}  // namespace soms::report
