/// \file
/// Builds compared by modern measures: what queries look at, SAH cost, memory, build rate.
#pragma once

#include "soms/base/limits.h"
#include "soms/base/pose.h"
#include "soms/query/answer.h"
#include "soms/tree/build_options.h"
#include "soms/tree/shape.h"
#include "soms/tree/statistics.h"
#include "soms/tree/visits.h"

#include "thesis/run/result.h"
#include "thesis/trips/models.h"
#include "thesis/trips/timing.h"

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace soms::reproduce {

/// A build to compare: a rule and whose options it has.
struct ComparedBuild {
  std::string rule = {};     ///< its name in the table of rules
  std::string options = {};  ///< "thesis", "one a leaf" or "product"
  BuildOptions build = {};
};

/// The rules of the thesis with its options to `level`, SAH to the same level with one triangle a
/// leaf, and every rule of the library with the product's options. `few` leaves out those that a
/// mesh of a million triangles can do without: of the thesis all but spatial median and SOMS, and
/// the object mean.
[[nodiscard]] std::vector<ComparedBuild> compared_builds(int level, bool few);

/// The queries on a model: cubes and a mover, all drawn from the model alone.
struct Workload {
  /// Cubes of one side.
  struct Cubes {
    double share = 0;                ///< side over the model's longest side
    Vec3 size = {};                  ///< the sides
    std::vector<Box> anywhere = {};  ///< those that overlap the model's box, placed evenly
    std::vector<Box> near = {};      ///< about triangles drawn evenly, off by up to a side
  };

  std::vector<Cubes> cubes = {};
  Shape mover = {};
  std::string mover_name = {};
  std::vector<Pose> poses = {};  ///< of the mover, about triangles drawn evenly, turned about z
};

/// Cubes of 0.1, 1 and 10 % of the model's longest side (of these a fifth as many) and poses of a
/// mover: the same in every run. \pre the mesh has triangles.
[[nodiscard]] Workload make_workload(const Mesh& mesh, const Mesh& mover, std::string mover_name,
                                     int cubes, int poses);

/// What one build makes of a model.
struct Measured {
  /// Visits of cubes of one side, on average.
  struct AtSide {
    double share = 0;
    ExpectedVisits expected = {};  ///< by volumes of grown boxes
    ExpectedVisits anywhere = {};  ///< counted over Workload::Cubes::anywhere
    ExpectedVisits near = {};      ///< counted over Workload::Cubes::near
  };

  ComparedBuild build = {};
  TreeStatistics counts = {};
  double sah_cost = 0;
  std::size_t tree_bytes = 0;
  std::size_t layout_bytes = 0;
  std::size_t mesh_bytes = 0;
  std::vector<AtSide> sides = {};
  std::uint64_t hits = 0;   ///< poses at which the mover overlaps the model
  std::uint64_t pairs = 0;  ///< pairs of triangles over all poses
  Cost any = {};            ///< of all poses, mode `any`
  Cost all = {};            ///< of all poses, mode `all`
  Timing build_ms = {};     ///< of the canonical tree
  Timing shape_ms = {};     ///< from the mesh to what queries run on
  Timing any_ms = {};       ///< of all poses as one batch
  Timing all_ms = {};
};

/// A model with the measures of its builds.
struct Compared {
  std::string model = {};
  std::uint64_t triangles = 0;
  double longest_side = 0;
  double spread =
      0;  ///< decades between the 5th and 95th percentile of the triangles' longest edges
  std::string mover = {};
  std::size_t queries = 0;
  std::vector<Measured> builds = {};
};

/// Measures all builds on a model; times in turn, on one thread. \errors ErrorKind::cancelled.
[[nodiscard]] Compared compare(const Model& model, std::span<const ComparedBuild> builds,
                               const Workload& workload, int repetitions, const Limits& limits);

/// Decades between the 5th and the 95th percentile of the triangles' longest edges; 0 where edges
/// of length 0 leave no ratio.
[[nodiscard]] double spread_of_sizes(const Mesh& mesh);

/// Nodes visited and triangles left to decide, in one number.
[[nodiscard]] double looks(const ExpectedVisits& visits);

/// Tables `<prefix>_models`, `<prefix>_trees`, `<prefix>_visits`, `<prefix>_queries`, the figures
/// `<prefix>_looks` and `<prefix>_build_rate`, and remarks on what the counts say.
[[nodiscard]] Result report(const std::string& prefix, std::span<const Compared> models);

}  // namespace soms::reproduce
