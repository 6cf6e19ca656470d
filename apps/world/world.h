/// \file
/// What a simulation starts from: the city, the models that move in it, and the route of each
/// mover.
#pragma once

#include "soms/base/box.h"
#include "soms/base/limits.h"
#include "soms/base/pose.h"
#include "soms/generate/routes.h"
#include "soms/geometry/parts_of.h"
#include "soms/query/body.h"
#include "soms/scene/recording.h"
#include "soms/scene/scene.h"

#include "apps/cli/console.h"
#include "apps/model/file_numbers.h"
#include "apps/model/frame_warnings.h"
#include "apps/world/mover_filter.h"
#include "apps/world/world_options.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace soms::command {

/// Frames of a second of simulated time.
inline constexpr double kFramesASecond = 60;

/// Kinds of movers; files that are given count as `model`.
enum class Kind : std::uint8_t { car, person, drone, model };

/// A body that moves, shared by all movers of its kind.
struct Model {
  Shape shape;
  std::string name;
  Kind kind = Kind::model;
  Vec3 foot;  ///< the point of the model that follows the route: middle of its underside
  double ground_radius = 0;  ///< half the diagonal of its ground plan
  double height = 0;         ///< of its box
  double speed = 0;          ///< meters a second
  RecordedMesh origin = {};  ///< how to come by it again; without triangles and hash
};

/// The route of one mover: a route that its foot follows, or recorded poses, one a frame.
struct MoverRoute {
  std::size_t model = 0;
  Route path;
  std::shared_ptr<const std::vector<Pose>> recorded = nullptr;
  std::size_t first = 0;  ///< recorded pose of frame 0
  Vec3 foot;

  [[nodiscard]] Pose at(std::uint64_t frame) const;

  /// The same; `line` as of Route::at.
  [[nodiscard]] Pose at(std::uint64_t frame, std::size_t& line) const;

  /// Starts to load what `at` will need near `line`.
  void fetch(std::size_t line) const;
};

/// A simulation before its first frame.
struct World {
  std::string title;  ///< name of the city
  std::vector<Body> city;
  std::vector<FileNumbers> numbers;   ///< of each body of the city: those in its file
  std::vector<FileNumbers> vertices;  ///< likewise of vertices
  std::vector<RecordedMesh> origins;  ///< of each body of the city; without triangles and hash
  std::vector<Model> models;
  std::vector<MoverRoute> routes;
  Box bounds;  ///< of the city
  std::uint64_t triangles = 0;
  double read_ms = 0;                       ///< reading or generating the city
  double build_ms = 0;                      ///< building its trees
  std::uint64_t requested = 0;              ///< movers requested; fewer routes if there was no room
  std::vector<std::string> notes = {};      ///< what reading the files noted, "FILE: NOTE"
  std::vector<FrameWarning> warnings = {};  ///< where numbers of city and movers may not agree
  Georeference georeference = {};           ///< of the city, so of all coordinates
  MoverFilter filter = {};                  ///< movers that are not tested against each other
};

/// Reads or generates everything and finds free places for the movers.
/// Says where the frames of the models may not agree; with --strict that is an error.
/// \errors As reading; ErrorKind::bad_file for a route without rows and for such frames, usage
///         where standard input is named twice.
[[nodiscard]] World load_world(const WorldOptions& options, Console& console);

/// Throws ErrorKind::usage for a --count by which a --route or --mover that is named has no mover.
void check_count(const WorldOptions& options);

/// Adds a body to the city; its bounds and triangles count from here on.
void add_to_city(World& world, Body body, RecordedMesh origin, FileNumbers numbers = {},
                 FileNumbers vertices = {});

/// A model of a shape, with what follows from its box and kind.
[[nodiscard]] Model make_model(Shape shape, std::string name, Kind kind);

/// The city and all movers at their places of frame 0; movers are numbered as their routes.
/// \errors ErrorKind::cancelled.
[[nodiscard]] Scene make_scene(const World& world, const Limits& limits = {});

/// Name of the part of the city that a triangle belongs to; of its file where there is none.
[[nodiscard]] std::string part_name(const World& world, EnvironmentId part, TriangleId triangle);

/// `part_name` of many triangles, in logarithmic time each. The world must stay.
class CityParts {
 public:
  explicit CityParts(const World& world);

  [[nodiscard]] std::string name(EnvironmentId part, TriangleId triangle) const;

  /// The number of the part in the mesh of its body, as of `PartsOf`, and its name as above.
  [[nodiscard]] std::uint32_t number(EnvironmentId body, TriangleId triangle) const;
  [[nodiscard]] std::string part_name(EnvironmentId body, std::uint32_t number) const;

 private:
  const World& world_;
  std::vector<PartsOf> parts_;  ///< of each body
};

[[nodiscard]] const std::string& model_name(const World& world, MoverId mover);

/// "car 17".
[[nodiscard]] std::string mover_name(const World& world, MoverId mover);

/// Name of a file without folder and extension.
[[nodiscard]] std::string short_name(const std::string& path);

}  // namespace soms::command
