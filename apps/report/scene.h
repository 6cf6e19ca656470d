/// \file
/// What the view of a page shows: models, bodies at steps of time, and where they touch.
#pragma once

#include "soms/base/pose.h"
#include "soms/geometry/mesh.h"
#include "soms/query/overlap.h"

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace soms::report {

/// A mesh that may be drawn at many places. The page holds it once.
struct SceneModel {
  const Mesh* mesh = nullptr;
  std::string name;
};

/// A model at a place; one that moves is at another place at every step.
struct SceneBody {
  std::size_t model = 0;
  std::string name;
  bool moves = false;
};

/// Body `a` touches body `b` in each step from `begin` to `end`.
struct SceneContact {
  std::uint32_t a = 0;
  std::uint32_t b = 0;
  std::string part_a = {};  ///< as the file calls it; may be empty
  std::string part_b = {};
  std::uint64_t begin = 0;
  std::uint64_t end = 0;
  std::vector<TrianglePair> pairs = {};  ///< some, at step `begin`
  std::uint64_t pairs_in_all = 0;        ///< at step `begin`
};

/// Steps of time, or poses one after the other.
struct Steps {
  std::uint64_t count = 1;
  std::string noun = "frame";
  double a_second = 0;  ///< of simulated time; 0: steps are no time
  bool smooth = true;   ///< places between two steps mean something
  /// Steps whose poses the page is to hold; empty: as many as it has room for, evenly spread.
  std::vector<std::uint64_t> kept = {};
};

/// A scene. Whoever draws it asks for poses when it needs them.
struct Scene {
  std::vector<SceneModel> models = {};
  std::vector<SceneBody> bodies = {};
  std::vector<SceneContact> contacts = {};  ///< in order of `begin`
  std::uint64_t contacts_in_all = 0;
  Steps steps = {};
  std::function<Pose(std::uint32_t body, std::uint64_t step)> pose = {};
  bool y_is_up = false;
};

/// What a page has room for. With these it stays below 20 MB, the script and the plots included.
struct SceneLimits {
  std::uint64_t triangles = 300'000;        ///< in the page
  std::uint64_t drawn_at_once = 1'500'000;  ///< on the screen: a model counts for each body
  std::uint64_t mesh_bytes = 8'000'000;
  std::uint64_t pose_bytes = 3'000'000;
  std::size_t bodies = 20'000;
  std::size_t contacts = 10'000;
  std::size_t pairs = 20'000;
  std::size_t pairs_of_contact = 16;
};

/// First and last step of a contact.
struct Span {
  std::uint64_t begin = 0;
  std::uint64_t end = 0;
};

/// Numbers of the `most` longest spans, ascending; of equally long ones the first.
[[nodiscard]] std::vector<std::size_t> longest(std::span<const Span> spans, std::size_t most);

/// Steps evenly spread over `count`, the first and the last among them, at most `most`.
/// \pre most >= 2.
[[nodiscard]] std::vector<std::uint64_t> spread_steps(std::uint64_t count, std::uint64_t most);

/// Bodies to be drawn, ascending: all that stand still, those of contacts, then every so many of
/// the others, `most` in all or as many as the first two are.
[[nodiscard]] std::vector<std::uint32_t> chosen_bodies(const Scene& scene, std::size_t most);

/// How many triangles of each model may be drawn: all of small ones, and what they leave over is
/// shared by the large ones. A model that moves in many bodies gets less.
[[nodiscard]] std::vector<std::uint64_t> shared_out(const Scene& scene,
                                                    std::span<const std::uint32_t> bodies,
                                                    const SceneLimits& limits);

}  // namespace soms::report
