/// \file
/// Motions of a scene as JSON: by what law the page moves the first body.
#pragma once

#include "soms/base/vector.h"

#include "apps/report/scene.h"

#include <string>

namespace soms::report {

/// Where the page has what it draws.
struct MotionFrame {
  Vec3 middle = {};  ///< of the first body's model, in its own coordinates
  Vec3 origin = {};
  double scale = 1;
};

/// Members of the scene's object, each after a comma: ",\"motions\":[...],\"motions_in_all\":N".
///
/// The middle of the body at t is at w0 + t (w1 - w0) + R (arm), where `way` has w0 and w1, and R
/// is the rotation of q0 + t (q1 - q0), of which `turns` has q0 and q1 as x, y, z, w. Lengths are
/// those of the page. `row` is that of the motion's contact, or -1.
[[nodiscard]] std::string motions_json(const Scene& scene, const MotionFrame& frame);

}  // namespace soms::report
