/// \file
/// Answers about tiles beside those about one shape with all of their triangles.
#pragma once

#include "soms/base/error.h"
#include "soms/base/random.h"
#include "soms/geometry/mesh.h"
#include "soms/tiles/cut_tiles.h"
#include "soms/tiles/tiled_queries.h"

#include <cstddef>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace soms::test {

/// A folder of tiles of some meshes, opened.
[[nodiscard]] TileSet tiles_of(const std::filesystem::path& folder, std::span<const Mesh> meshes,
                               const CutOptions& options, const TileOptions& opening = {});

/// The mesh without what it states of its frame, so that any go together.
[[nodiscard]] Mesh unstated(Mesh mesh);

/// All meshes as one, in their order.
[[nodiscard]] Mesh whole_of(std::span<const Mesh> meshes);

/// Questions for both.
struct TiledQuestions {
  Shape mover = {};
  std::vector<Pose> poses = {};
  std::vector<Vec3> points = {};
  std::vector<Ray> rays = {};
  std::vector<Ray> segments = {};
  double at_most = 0;  ///< of distances
};

/// Random questions about what lies in `box`.
[[nodiscard]] TiledQuestions random_questions(Rng& rng, Shape mover, const Box& box,
                                              std::size_t rows);

/// The first answer that differs in what is promised, in words; empty if there is none.
[[nodiscard]] std::string difference(const TiledQuestions& questions, const TiledBody& tiles,
                                     const Body& whole, const Limits& limits = {});

/// The kind of the error that an action throws; a failure if it throws none.
[[nodiscard]] ErrorKind kind_of(const std::function<void()>& action);

}  // namespace soms::test
