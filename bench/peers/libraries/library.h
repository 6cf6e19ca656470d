/// \file
/// What takes part in a comparison: a library, or one way to use it, and what it is queried for.
#pragma once

#include "soms/base/pose.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace soms::bench {

/// The meshes of all comparisons: float vertices, so that no library has to round them.
struct FloatMesh {
  std::vector<std::array<float, 3>> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;

  /// Corners of a triangle, widened.
  [[nodiscard]] Triangle triangle(std::size_t i) const {
    const auto corner = [this](std::uint32_t v) {
      return Vec3{vertices[v][0], vertices[v][1], vertices[v][2]};
    };
    const auto& t = triangles[i];
    return {corner(t[0]), corner(t[1]), corner(t[2])};
  }
};

/// The boxes of the broad phase, for the same reason in float.
struct FloatBox {
  std::array<float, 3> lower;
  std::array<float, 3> upper;
};

/// True if two closed boxes share a point.
[[nodiscard]] inline bool overlaps(const FloatBox& a, const FloatBox& b) {
  for (std::size_t k = 0; k < 3; ++k) {
    if (a.lower[k] > b.upper[k] || b.lower[k] > a.upper[k]) {
      return false;
    }
  }
  return true;
}

/// The kinds of queries.
enum class Job {
  any,          ///< do the mover, at each pose, and the fixed body share a point? 1 or 0
  all,          ///< how many pairs of triangles share a point at each pose?
  still,        ///< the same of two bodies that both stand where they were built
  broad,        ///< boxes all move: how many pairs of them overlap in each frame?
  distance,     ///< how far is the mover, at each pose, from the fixed body? 0 where they touch
  within,       ///< are they within a clearance of each other, one for each pose? 1 or 0
  solid,        ///< how does the mover stand to the fixed body, both closed? The number of the
                ///< soms::Relation: is interior shared, is one in the other, do they touch?
  closest,      ///< how far is each point from the fixed body's surface? 0 on it
  contains,     ///< is each point inside the fixed body, which is closed? 1, 0, or kOnSurface
  closest_hit,  ///< at which multiple of its direction does each ray meet the body? kMiss if never
  any_hit,      ///< does each ray meet it at all? 1 or 0
};

/// The answer of `contains` for a point of the surface.
inline constexpr double kOnSurface = 0.5;

/// The answer of `closest_hit` for a ray that meets nothing.
inline constexpr double kMiss = std::numeric_limits<double>::infinity();

/// A ray without end. Its numbers are floats, so that no library has to round them.
struct ProbeRay {
  Vec3 origin;
  Vec3 direction;
};

/// What a library computes in, which says how near to the truth an answer has to be.
enum class Precision { exact, doubles, floats };

/// Questions to a match. The columns that a job does not read are empty; the others have an entry
/// a question.
struct Questions {
  Job job = Job::any;
  std::span<const Pose> poses = {};         ///< of the mover
  std::span<const double> clearances = {};  ///< of `within`
  std::span<const Vec3> points = {};    ///< of `closest` and `contains`; their numbers are floats
  std::span<const ProbeRay> rays = {};  ///< of `closest_hit` and `any_hit`
  std::size_t links = 1;                ///< movers of a question, each with a pose, in turn

  [[nodiscard]] std::size_t size() const {
    return std::max({poses.size() / links, points.size(), rays.size()});
  }

  /// The first `count` of them.
  [[nodiscard]] Questions first(std::size_t count) const {
    const auto of = [count](auto column) { return column.empty() ? column : column.first(count); };
    return {job,
            poses.empty() ? poses : poses.first(count * links),
            of(clearances),
            of(points),
            of(rays),
            links};
  }
};

/// A mover and a fixed body, or a body that points and rays probe, ready to be queried.
class Match {
 public:
  virtual ~Match() = default;

  /// One answer a question, as the enumerators of `Job` say.
  virtual void answer(const Questions& questions, std::span<double> answers) = 0;

  /// A match of another mover with the same fixed body, which is built once; null where the library
  /// builds it for each mover.
  [[nodiscard]] virtual std::unique_ptr<Match> with(const FloatMesh& /*mover*/) const {
    return nullptr;
  }

  /// Bytes that it holds and that malloc does not know of.
  [[nodiscard]] virtual std::size_t unseen_bytes() const { return 0; }
};

/// Boxes that move.
class MovingBoxes {
 public:
  virtual ~MovingBoxes() = default;

  /// Tells the new places of all boxes; the number of overlapping pairs.
  virtual std::uint64_t step(std::span<const FloatBox> boxes) = 0;
};

/// A library, or one way to use it. Its name begins with the library's, up to a dash.
class Library {
 public:
  virtual ~Library() = default;

  [[nodiscard]] virtual std::string name() const = 0;
  [[nodiscard]] virtual std::string version() const = 0;
  [[nodiscard]] virtual bool does(Job job) const = 0;

  /// Of distances and clearances; counts have to be right whatever they are computed in.
  [[nodiscard]] virtual Precision precision() const { return Precision::exact; }

  /// False where the library cannot hold a body of so many triangles.
  [[nodiscard]] virtual bool takes(std::size_t /*triangles*/) const { return true; }

  /// True if it wants all poses in one call.
  [[nodiscard]] virtual bool batches() const { return false; }

  /// Of moving boxes: true if its tree lasts from frame to frame, false if each begins from
  /// nothing.
  [[nodiscard]] virtual bool keeps_tree() const { return false; }

  /// Of rays: true if none slips between two triangles that share an edge.
  [[nodiscard]] virtual bool watertight() const { return false; }

  /// Builds all that queries need, own copies of the meshes included.
  [[nodiscard]] virtual std::unique_ptr<Match> prepare(const FloatMesh& /*mover*/,
                                                       const FloatMesh& /*fixed*/) const {
    return nullptr;
  }

  /// The same for a job of points or rays.
  [[nodiscard]] virtual std::unique_ptr<Match> prepare_probes(Job /*job*/,
                                                              const FloatMesh& /*body*/) const {
    return nullptr;
  }

  [[nodiscard]] virtual std::unique_ptr<MovingBoxes> moving_boxes(
      std::span<const FloatBox> /*boxes*/) const {
    return nullptr;
  }
};

using Roster = std::vector<std::unique_ptr<Library>>;

/// What the referee lends to peers, which are compiled apart from soms.
struct Loan {
  /// Decides exactly whether two triangles share a point.
  bool (*triangles_overlap)(const Triangle&, const Triangle&);
};

/// The library that decides clearances by soms's distance: what `within` has to beat.
inline constexpr const char* kByDistance = "soms-distance";

/// Those that take bodies whose surfaces meet for crossing and others for clear, pose by pose and
/// in batches: what `solid` is measured by, at poses where this is right.
inline constexpr const char* kByOverlap = "soms-any";
inline constexpr const char* kByOverlapBatch = "soms-any-batch";

/// Adds soms, queried pose by pose, in batches, and for clearances by its distance.
void add_soms(Roster& roster);

}  // namespace soms::bench

/// The one function that the module of a peer shows: adds its libraries.
extern "C" void soms_bench_peer(soms::bench::Roster& roster, const soms::bench::Loan& loan);
