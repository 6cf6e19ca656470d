/// \file
/// Frames as a program draws them: what the experiments ask of the viewer, which is a program of
/// its own.
#pragma once

#include "soms/geometry/mesh.h"
#include "soms/thesis/traversal_options.h"
#include "soms/tree/build_options.h"

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace soms::reproduce {

/// A model that stands still, one that moves past it, and how contacts are found.
struct DrawRequest {
  std::shared_ptr<const Mesh> still = {};   ///< never null
  std::shared_ptr<const Mesh> moving = {};  ///< never null
  std::vector<Vec3> offsets = {};           ///< of the moving model, one a frame
  /// Of both trees. \pre `thesis_options` of a rule.
  BuildOptions build = {};
  int moving_level = 0;             ///< level of the moving model's tree
  TraversalOptions traversal = {};  ///< any but Traversal::fast
};

/// Milliseconds of finding contacts in a frame.
struct CollisionTime {
  double move = 0;   ///< moving the boxes
  double query = 0;  ///< traversing the trees and testing the triangles

  [[nodiscard]] double sum() const { return move + query; }
};

/// What a frame took (medians over the passes), and what it found.
struct DrawnFrame {
  CollisionTime alone = {};  ///< in passes that draw nothing
  CollisionTime drawn = {};  ///< in passes that draw each frame
  double draw = 0;           ///< milliseconds of drawing, until the device has finished
  std::size_t contacts = 0;
};

/// The answer to a request.
struct DrawnFrames {
  std::string device = {};  ///< the driver, in its own words
  int width = 0;            ///< of the pictures, in pixels
  int height = 0;
  int passes = 0;                       ///< over all frames, drawing and not
  std::vector<DrawnFrame> frames = {};  ///< as many as offsets; empty if nothing could be drawn
  std::string trouble = {};             ///< why not; empty if all is well
};

/// What draws. Empty where nothing does.
using DrawFrames = std::function<DrawnFrames(const DrawRequest& request)>;

}  // namespace soms::reproduce
