/// \file
/// The truth set of tests/data/truth: poses of meshes and single pairs of triangles whose overlaps
/// were decided by two independent exact methods. Each is read once a process.
#pragma once

#include "soms/base/pose.h"
#include "soms/geometry/mesh.h"
#include "soms/query/overlap.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace soms::test {

/// Two posed meshes and the facts about them.
struct TruthCase {
  int number = 0;
  std::string mesh_a;
  std::string mesh_b;
  std::string kind;  ///< what the poses were meant to try, as in README.md of the set
  Pose pose_a;
  Pose pose_b;
  bool overlap = false;
  std::uint64_t count = 0;  ///< overlapping pairs
  std::uint64_t hash = 0;   ///< as Overlap::hash
  std::string solid;        ///< relation of the closed bodies
  bool listed = false;      ///< `truth_lists` has the pairs
};

/// All cases (4,620), in file order.
[[nodiscard]] const std::vector<TruthCase>& truth_cases();

/// Full sorted lists of pairs, by case number.
[[nodiscard]] const std::map<int, std::vector<TrianglePair>>& truth_lists();

/// A mesh of the set by name; null for models of others where SOMS_DATA is unset.
[[nodiscard]] const Mesh* truth_mesh(std::string_view name);

/// Whether a case needs a model of others, which only SOMS_DATA has.
enum class Models { own, of_others };

/// Every `stride`-th of the 3,780 cases on our own meshes or of the 840 on models of others; of the
/// latter none where SOMS_DATA is unset.
[[nodiscard]] std::vector<TruthCase> truth_cases(Models models, std::size_t stride = 1);

/// Cases that can be run here, and how many need models of others that are absent.
struct RunnableCases {
  std::vector<TruthCase> cases;
  std::size_t skipped = 0;
};

/// Every `stride`-th case, less those without their meshes.
[[nodiscard]] RunnableCases runnable_truth_cases(std::size_t stride = 1);

/// Which meshes of the set are closed by its own count: every directed edge has its reverse. Names
/// of own meshes only.
[[nodiscard]] std::map<std::string, bool> truth_closed();

/// A single pair of triangles.
struct TruthTriangles {
  std::string kind;  ///< `huge`: a coordinate beyond 2^300
  Triangle s;
  Triangle t;
  bool overlap = false;
};

/// All single pairs (27,900).
[[nodiscard]] const std::vector<TruthTriangles>& truth_triangles();

}  // namespace soms::test
