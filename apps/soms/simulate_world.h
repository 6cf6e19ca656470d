/// \file
/// What a simulation starts from: the city, the models that move in it, and the way of each mover.
#pragma once

#include "soms/base/box.h"
#include "soms/base/pose.h"
#include "soms/generate/routes.h"
#include "soms/query/body.h"

#include "apps/soms/console.h"
#include "apps/soms/height_grid.h"
#include "apps/soms/simulate.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace soms::command {

/// Kinds of movers; files that are given count as `model`.
enum class Kind : std::uint8_t { car, person, drone, model };

/// A body that moves, shared by all movers of its kind.
struct Model {
  Shape shape;
  std::string name;
  Kind kind = Kind::model;
  Vec3 foot;          ///< the point of the model that follows the route: middle of its underside
  double reach = 0;   ///< half the diagonal of its ground plan
  double height = 0;  ///< of its box
  double speed = 0;   ///< metres a second
};

/// The way of one mover: a route that its foot follows, or recorded poses, one a frame.
struct Way {
  std::size_t model = 0;
  Route route;
  std::shared_ptr<const std::vector<Pose>> recorded = nullptr;
  std::size_t first = 0;  ///< recorded pose of frame 0
  Vec3 foot;

  [[nodiscard]] Pose at(std::uint64_t frame) const;
};

/// A simulation before its first frame.
struct World {
  std::string title;  ///< name of the city
  std::vector<Body> city;
  std::vector<Model> models;
  std::vector<Way> ways;
  Box bounds;  ///< of the city
  std::uint64_t triangles = 0;
  double read_ms = 0;       ///< reading or generating the city
  double build_ms = 0;      ///< building its trees
  std::uint64_t asked = 0;  ///< movers asked for; fewer ways if there was no room
};

/// Reads or generates everything and finds free places for the movers.
/// \errors As reading; ErrorKind::usage for a route without rows.
[[nodiscard]] World load_world(const SimulateOptions& options, Console& console);

/// Name of a file without folder and ending.
[[nodiscard]] std::string short_name(const std::string& path);

}  // namespace soms::command
