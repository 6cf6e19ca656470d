/// \file
/// A drive through a scene in which the object touches in about half of the frames: the path of the
/// other drive is fixed and may touch nothing.
#pragma once

#include "soms/base/limits.h"
#include "soms/base/vector.h"

#include "thesis/run/experiment.h"
#include "thesis/trips/frames.h"
#include "thesis/trips/models.h"

#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace soms::reproduce {

/// A straight drive through a scene.
struct TouchingDrive {
  std::vector<Vec3> offsets = {};  ///< of the enlarged object, as many as `city_drive` has
  std::size_t contact_frames = 0;  ///< frames in which triangles touch; 0 if no line has any
  std::size_t lines = 0;           ///< candidates that were tried
  std::size_t touching_lines = 0;  ///< candidates with a contact frame
};

/// Finds the drive. The object, `driven`, crosses the scene's
/// box from the frame before it enters to the frame after it left, along x and along y, at 8
/// positions across and 8 heights. Of these 128 lines the one whose number of contact frames is
/// nearest to half of all frames is taken, the first of them if there are several.
/// \cost   28,288 queries that end at the first contact; under a second for a scene of the thesis.
/// \source ours. The thesis does not state the path of its drive.
/// \errors ErrorKind::cancelled.
[[nodiscard]] TouchingDrive find_touching_drive(const Model& scene, const Model& object,
                                                const Limits& limits = {});

/// The trip along a drive found for this scene and object; its test is called "touching_drive".
[[nodiscard]] Trip touching_drive_trip(const Model& scene, const Model& object,
                                       const Contender& build_of_scene,
                                       const Contender& build_of_object,
                                       const TouchingDrive& drive);

/// Drives that were found, so that the experiments of a run search for each once.
class TouchingDrives {
 public:
  /// The drive of this object through this scene, both known by name.
  /// \errors ErrorKind::cancelled.
  const TouchingDrive& of(const Model& scene, const Model& object, const Limits& limits);

 private:
  std::map<std::pair<std::string, std::string>, TouchingDrive> found_;
};

/// The drive among those that the run has found, or else one found now.
/// \errors ErrorKind::cancelled.
[[nodiscard]] TouchingDrive touching_drive(const Context& context, const Model& scene,
                                           const Model& object);

/// "touching_drive of bunny through u_boxes: ... contact in 110 of 221 frames", for remarks; says
/// so if nothing can be touched.
[[nodiscard]] std::string touching_drive_remark(const Model& scene, const Model& object,
                                                const TouchingDrive& drive);

}  // namespace soms::reproduce
