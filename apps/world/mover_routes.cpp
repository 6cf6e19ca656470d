#include "apps/world/mover_routes.h"

#include "soms/base/error.h"
#include "soms/base/pose.h"
#include "soms/base/random.h"
#include "soms/io/poses.h"
#include "soms/scene/scene.h"

#include "apps/cli/standard_input.h"
#include "apps/draw/height_grid.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

namespace soms::command {

namespace {

constexpr std::uint64_t kDefaultMovers = 1000;
/// Rounds in which movers that stand in something are given another place.
constexpr int kRounds = 64;
/// Rounds without progress by a tenth after which the place is full.
constexpr int kPatience = 3;
/// Height of a mover's underside above the ground: no street is as level as a straight line.
constexpr double kClearance = 0.3;
constexpr std::size_t kGridCells = 2048;

/// Another number for each mover and attempt.
std::uint64_t seed_of(std::uint64_t seed, std::uint64_t mover, std::uint64_t attempt) {
  Rng rng(seed * 0x9e3779b97f4a7c15ULL + mover);
  return rng.next() + attempt * 0xd1342543de82ef95ULL;
}

/// Two in five are cars, two persons, one a drone; models from files take turns.
std::size_t model_of(const World& world, std::uint64_t mover) {
  if (world.models[0].kind == Kind::model) {
    return mover % world.models.size();
  }
  constexpr std::size_t kTurns[] = {0, 1, 0, 1, 2};
  return kTurns[mover % std::size(kTurns)];
}

MoverRoute street_mover_route(const City& city, const Model& model, std::uint64_t seed) {
  MoverRoute mover_route;
  if (model.kind == Kind::drone) {
    mover_route.path = flight_route(city, seed, model.speed, 8, 60);
  } else {
    mover_route.path = street_route(city, seed, model.speed, kClearance);
  }
  return mover_route;
}

/// Draws level lines through a city of which nothing is known but its triangles.
class Lines {
 public:
  Lines(const World& world, const Limits& limits)
      : grid_(world.bounds, kGridCells), box_(world.bounds) {
    for (const Body& body : world.city) {
      grid_.add(body.shape.mesh(), limits);
    }
    grid_.find_ground(limits);
    double ground_radius = 0;
    for (const Model& model : world.models) {
      ground_radius = std::max(ground_radius, model.ground_radius);
    }
    // Room around the city, so that there is a free place even where all is built up.
    const Vec3 extent = box_.extent();
    const double rim = 1.5 * ground_radius + 0.02 * std::max(extent.x, extent.y) + 1;
    box_.lower = box_.lower - Vec3{rim, rim, 0};
    box_.upper = box_.upper + Vec3{rim, rim, 0};
  }

  [[nodiscard]] MoverRoute draw(const Model& model, std::uint64_t seed,
                                const Limits& limits) const {
    Rng rng(seed);
    Vec3 start;
    for (int attempt = 0; attempt < kAttempts; ++attempt) {
      check_stop(limits);  // a large mover stands on many cells
      start.x = rng.uniform(box_.lower.x, box_.upper.x);
      start.y = rng.uniform(box_.lower.y, box_.upper.y);
      start.z = grid_.standing(start.x, start.y, model.ground_radius);
      // In the city while there is room, at last anywhere.
      if (!std::isnan(start.z) && (grid_.built_near(start.x, start.y) || attempt > kAttempts / 2)) {
        break;
      }
    }
    if (std::isnan(start.z)) {
      start.z = grid_.ground(start.x, start.y);
    }
    start.z += model.kind == Kind::drone ? rng.uniform(8, 60) : kClearance;
    MoverRoute mover_route;
    mover_route.path = straight_route(box_, start, rng.next(), model.speed);
    return mover_route;
  }

 private:
  static constexpr int kAttempts = 200;

  HeightGrid grid_;
  Box box_;
};

/// A route of a mover, another for each attempt.
using Draw = std::function<MoverRoute(std::uint64_t mover, std::uint64_t attempt)>;

/// Moves whoever touches something to another route until all are free; gives up on the rest.
class FreeWays {
 public:
  FreeWays(World& world, const Draw& draw, const Limits& limits)
      : world_(world), draw_(draw), limits_(limits) {}

  void find() {
    for (const Body& body : world_.city) {
      scene_.add_environment(body);
    }
    for (std::uint64_t k = 0; k < world_.requested; ++k) {
      world_.routes.push_back(draw_(k, 0));
      scene_.add_mover(Body(world_.models[world_.routes[k].model].shape, world_.routes[k].at(0)));
      tell(kDrawn * static_cast<double>(k + 1) / static_cast<double>(world_.requested));
    }
    look();
    int idle = 0;
    for (std::uint64_t round = 1; left_ > 0 && round < kRounds && idle < kPatience; ++round) {
      for (std::uint32_t k = 0; k < touches_.size(); ++k) {
        if (touches_[k]) {
          check_stop(limits_);
          world_.routes[k] = draw_(k, round);
          scene_.set_pose(k, world_.routes[k].at(0));
        }
      }
      const std::size_t before = left_;
      look();
      idle = 10 * left_ > 9 * before ? idle + 1 : 0;
    }
    keep_free();
  }

 private:
  /// Share of the work that is done when all are drawn once.
  static constexpr double kDrawn = 0.4;

  /// Asks who touches something; of two movers it is the later one.
  void look() {
    const StepReport report =
        scene_.step({.mode = OverlapMode::any}, {.threads = limits_.threads, .stop = limits_.stop});
    touches_.assign(world_.routes.size(), false);
    for (const EnvironmentContact& contact : report.environment) {
      touches_[contact.mover] = true;
    }
    for (const MoverContact& contact : report.movers) {
      touches_[contact.b] = true;
    }
    left_ = static_cast<std::size_t>(std::count(touches_.begin(), touches_.end(), true));
    most_ = std::max(most_, left_);
    const double share =
        most_ == 0 ? 1 : 1 - static_cast<double>(left_) / static_cast<double>(most_);
    tell(kDrawn + (1 - kDrawn) * share);
  }

  void keep_free() {
    std::vector<MoverRoute> free;
    for (std::size_t k = 0; k < touches_.size(); ++k) {
      if (!touches_[k]) {
        free.push_back(std::move(world_.routes[k]));
      }
    }
    world_.routes = std::move(free);
  }

  void tell(double share) const {
    check_stop(limits_);
    if (limits_.progress) {
      limits_.progress(share);
    }
  }

  World& world_;
  const Draw& draw_;
  const Limits& limits_;
  Scene scene_;
  std::vector<bool> touches_;
  std::size_t left_ = 0;
  std::size_t most_ = 0;
};

/// What a route file holds.
struct RouteRows {
  std::shared_ptr<const std::vector<Pose>> rows;
  bool points = false;  ///< without rotations
};

/// Beyond it, the length of a route would be infinite, and its mover would stay where it is.
void check_place(const PoseReader& reader, const Vec3& place) {
  if (!(std::max({std::abs(place.x), std::abs(place.y), std::abs(place.z)}) <= kMaxCoordinate)) {
    throw reader.fault(Error(ErrorKind::out_of_range, "a coordinate exceeds 2^300",
                             "use coordinates of magnitude at most 2^300"));
  }
}

/// A file is opened once: a pipe has no second time.
RouteRows read_route(const std::string& path, const Limits& limits) {
  constexpr std::size_t kRowsPerLook = 4096;
  if (path == "-") {
    check_standard_input("a route");
    try {
      return read_route(std::string(kStandardInput), limits);
    } catch (const Error& error) {
      throw of_standard_input(error);
    }
  }
  PoseReader reader(path, limits);
  std::vector<Pose> rows;
  while (const auto pose = reader.next()) {
    check_place(reader, pose->shift());
    rows.push_back(*pose);
    if (rows.size() % kRowsPerLook == 0) {
      check_stop(limits);
    }
  }
  if (rows.empty()) {
    throw Error(ErrorKind::bad_file, path + ": no rows", "give at least one point or pose");
  }
  return {std::make_shared<const std::vector<Pose>>(std::move(rows)), reader.shifts_only()};
}

/// Movers on a line of points start at equal distances.
MoverRoute along_points(const std::vector<Pose>& rows, const Model& model, double share) {
  MoverRoute mover_route;
  for (const Pose& pose : rows) {
    mover_route.path.points.push_back(pose.shift());
  }
  double length = 0;
  for (std::size_t k = 1; k < mover_route.path.points.size(); ++k) {
    const Vec3 step = mover_route.path.points[k] - mover_route.path.points[k - 1];
    length += std::sqrt(dot(step, step));
  }
  mover_route.path.closed = mover_route.path.points.size() > 2 &&
                            mover_route.path.points.front() == mover_route.path.points.back();
  mover_route.path.start = share * length;
  mover_route.path.speed = model.speed;
  mover_route.path.measure();  // else each frame would
  return mover_route;
}

void plan_given_routes(World& world, const WorldOptions& options, const Limits& limits) {
  std::vector<RouteRows> given;
  for (const std::string& path : options.routes) {
    given.push_back(read_route(path, limits));
    check_stop(limits);
  }
  // One mover a route; of the models that were named none is left out.
  world.requested = options.count.value_or(std::max(given.size(), options.movers.size()));
  for (std::uint64_t k = 0; k < world.requested; ++k) {
    check_stop(limits);
    const std::size_t which = k % given.size();
    const std::uint64_t turn = k / given.size();
    const std::uint64_t turns = (world.requested - which - 1) / given.size() + 1;
    const RouteRows& source = given[which];
    const std::size_t model = model_of(world, k);
    MoverRoute mover_route;
    if (source.points) {
      mover_route = along_points(*source.rows, world.models[model],
                                 static_cast<double>(turn) / static_cast<double>(turns));
      mover_route.foot = world.models[model].foot;
    } else {
      mover_route.recorded = source.rows;
      mover_route.first = turn * source.rows->size() / turns;
    }
    mover_route.model = model;
    world.routes.push_back(std::move(mover_route));
  }
}

}  // namespace

Pose MoverRoute::at(std::uint64_t frame) const {
  std::size_t line = 0;
  return at(frame, line);
}

Pose MoverRoute::at(std::uint64_t frame, std::size_t& line) const {
  if (recorded != nullptr) {
    return (*recorded)[(first + frame) % recorded->size()];
  }
  Pose pose = path.at(static_cast<double>(frame) / kFramesASecond, line);
  // The foot, not the origin of the file, stands on the route.
  for (std::size_t row = 0; row < 3; ++row) {
    const double* const r = &pose.m[4 * row];
    pose.m[4 * row + 3] -= (r[0] * foot.x + r[1] * foot.y) + r[2] * foot.z;
  }
  return pose;
}

void MoverRoute::fetch(std::size_t line) const {
  if (line < path.points.size() && line < path.marks.size()) {
    __builtin_prefetch(&path.points[line]);
    __builtin_prefetch(&path.points[line] + 1);
    __builtin_prefetch(&path.marks[line]);
    __builtin_prefetch(&path.marks.back());
  }
}

void plan_routes(World& world, const WorldOptions& options, const City* city, Console& console) {
  if (!options.routes.empty()) {
    console.run("reading routes",
                [&](const Limits& limits) { plan_given_routes(world, options, limits); });
    return;
  }
  world.requested = options.count.value_or(kDefaultMovers);
  if (world.requested == 0) {
    return;
  }
  console.run("finding free places", [&](const Limits& limits) {
    const std::optional<Lines> lines =
        city == nullptr ? std::optional<Lines>(std::in_place, world, limits) : std::nullopt;
    const Draw draw = [&](std::uint64_t mover, std::uint64_t attempt) {
      const std::size_t model = model_of(world, mover);
      const std::uint64_t seed = seed_of(console.shared().seed, mover, attempt);
      MoverRoute mover_route = city == nullptr
                                   ? lines->draw(world.models[model], seed, limits)
                                   : street_mover_route(*city, world.models[model], seed);
      mover_route.model = model;
      mover_route.foot = world.models[model].foot;
      return mover_route;
    };
    FreeWays(world, draw, limits).find();
  });
  if (world.routes.size() < world.requested) {
    console.note(fmt::format("{} of {} movers found no free place and were left out",
                             world.requested - world.routes.size(), world.requested));
  }
}

}  // namespace soms::command
