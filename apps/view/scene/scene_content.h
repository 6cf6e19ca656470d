/// \file
/// What a scene is made of: bodies that stand and bodies that move, with the routes they take.
#pragma once

#include "soms/base/pose.h"
#include "soms/query/body.h"
#include "soms/scene/replay.h"

#include "apps/model/file_numbers.h"
#include "apps/model/frame_warnings.h"
#include "apps/view/scene/touch.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace soms::view {

/// Frames of a second of simulated time.
inline constexpr double kFramesASecond = 60;

/// Pose of a mover at a frame; an empty one leaves the mover where its body stands.
using Motion = std::function<Pose(std::uint64_t frame)>;

/// A body that moves. Its pose is that of frame 0 where `motion` is empty.
struct MovingBody {
  Body body;
  Motion motion = {};
};

/// Numbers in the files of a city, of which parts may be left out. Movers are whole, as are bodies
/// of the city that were added later.
struct CityNumbers {
  std::vector<command::FileNumbers> triangles = {};  ///< of each body
  std::vector<command::FileNumbers> vertices = {};   ///< likewise

  [[nodiscard]] TriangleId triangle(BodyRef body, TriangleId i) const {
    return in_file(triangles, body, i);
  }

  [[nodiscard]] std::uint32_t vertex(BodyRef body, std::uint32_t i) const {
    return in_file(vertices, body, i);
  }

 private:
  [[nodiscard]] static std::uint32_t in_file(const std::vector<command::FileNumbers>& numbers,
                                             BodyRef body, std::uint32_t i) {
    const bool known = body.role == Role::city && body.index < numbers.size();
    return known ? numbers[body.index](i) : i;
  }
};

/// A scene before its first frame: plain values, made by `load.h` or by hand.
struct SceneContent {
  std::string title;  ///< name of the city or model
  std::vector<Body> city;
  CityNumbers numbers = {};  ///< in the files of the city
  std::vector<MovingBody> movers;
  std::uint64_t frames = 600;      ///< in which contacts are searched for, if anything moves
  std::vector<std::string> notes;  ///< what the reader should know of how it was made
  std::vector<command::FrameWarning> warnings = {};  ///< where the models' numbers may not agree
  Georeference georeference = {};                    ///< of the city, so of all coordinates
  /// Frames that are played: poses of the movers in their order, and contacts. Null: none.
  std::shared_ptr<Replay> recording = nullptr;
};

}  // namespace soms::view
