/// \file
/// The truth set of distances: posed meshes, single pairs of triangles, and points beside meshes
/// whose least distances were decided by independent exact methods. tests/data/distance has a part
/// of it, SOMS_DATA all.
#pragma once

#include "soms/base/bracket.h"
#include "soms/base/pose.h"
#include "soms/base/vector.h"
#include "soms/geometry/point_distance.h"
#include "soms/query/answer.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace soms::test {

/// Two posed meshes (`truth_mesh` has them by name) and the facts about their distance d.
struct DistanceCase {
  int number = 0;
  std::string mesh_a;
  std::string mesh_b;
  std::string kind;  ///< what the poses were meant to try
  Pose pose_a;
  Pose pose_b;
  Bracket d;                         ///< the doubles next to d; equal where d is a double
  std::uint64_t ties = 0;            ///< pairs of triangles at exactly d
  TrianglePair pair;                 ///< the least of them
  TrianglePair pair_if_exchanged;    ///< the least of them for (B, A): a triangle of B first
  bool within_lower = false;         ///< d <= d.lower
  bool within_upper = false;         ///< d <= d.upper
  std::optional<bool> within_below;  ///< d <= the double below d.lower; none where that is 0
};

/// Two triangles and the doubles next to their distance.
struct TriangleDistanceRow {
  std::string kind;
  Triangle a;
  Triangle b;
  Bracket distance;
  bool zero = false;
};

/// A point, a mesh without pose (by name) and the facts about the nearest points of the mesh.
struct ClosestPointRow {
  std::string kind;
  std::string mesh;
  Vec3 point;
  Bracket distance;                                   ///< the doubles next to d
  TriangleId triangle = 0;                            ///< the least that is at exactly d
  std::uint64_t ties = 0;                             ///< triangles at exactly d
  TriangleFeature feature = TriangleFeature::vertex;  ///< of that triangle, which has `nearest`
  bool on = false;                                    ///< d = 0
  Vec3 nearest;  ///< of that triangle's points, each coordinate to the nearest double
};

/// Rows of a file of the set. \errors std::runtime_error for a row that is not as described there.
[[nodiscard]] std::vector<DistanceCase> read_distance_cases(const std::filesystem::path& file);
[[nodiscard]] std::vector<TriangleDistanceRow> read_triangle_distances(
    const std::filesystem::path& file);
[[nodiscard]] std::vector<ClosestPointRow> read_closest_points(const std::filesystem::path& file);

/// All 8,200 rows where SOMS_DATA has them, otherwise the 313 of tests/data. Read once a process.
[[nodiscard]] const std::vector<TriangleDistanceRow>& triangle_distances();

/// A file of the whole set in SOMS_DATA, or nothing where that is unset or lacks it.
[[nodiscard]] std::optional<std::filesystem::path> outside_distance(std::string_view name);

}  // namespace soms::test
