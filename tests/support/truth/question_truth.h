/// \file
/// The truth set of points in bodies, of closed meshes, of bodies' relations and of rays: rows that
/// were decided by two independent exact methods. tests/data/questions has a part of it, SOMS_DATA
/// all.
#pragma once

#include "soms/base/pose.h"
#include "soms/base/vector.h"
#include "soms/geometry/mesh.h"
#include "soms/query/contains.h"
#include "soms/query/ray.h"
#include "soms/query/solid.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace soms::test {

/// A point, a closed mesh without pose (by name), and the side that the point is on.
struct InsideRow {
  std::string mesh;
  std::string kind;  ///< what the point was meant to try
  Vec3 point;
  Side side = Side::undecided;
};

/// Two closed bodies by names of meshes, at poses, and their relation.
struct SolidRow {
  std::string mesh_a = {};
  std::string mesh_b = {};
  std::string kind = {};
  Pose pose_a = {};
  Pose pose_b = {};
  std::uint64_t count = 0;  ///< overlapping pairs of triangles
  Relation relation = Relation::undecided;
};

/// A mesh, or a part of it, and its odd edges.
struct ClosedRow {
  std::string mesh;
  int part = -1;  ///< -1: the whole mesh
  TriangleId first = 0;
  std::uint64_t triangles = 0;
  std::uint64_t flat = 0;  ///< triangles without area
  std::uint64_t odd = 0;
  std::uint64_t odd_proper = 0;
};

/// A ray, a mesh without pose, and what the ray hits.
struct RayTruthRow {
  std::string mesh;
  std::string kind;
  Ray ray;
  std::uint64_t hits = 0;  ///< triangles that it meets
  std::uint64_t ties = 0;  ///< of these, those at the least t
  ClosestHit closest;      ///< its `t` and `triangle`
};

/// A triangle that a ray meets. Rows of one ray are sorted by exact t, then by triangle.
struct RayListRow {
  std::uint64_t ray = 0;    ///< a row of the file of rays
  std::uint64_t group = 0;  ///< the same where t is exactly the same
  Bracket t;
  TriangleId triangle = 0;
};

/// Rows of a file of the set. \errors std::runtime_error for a row that is not as described there.
[[nodiscard]] std::vector<InsideRow> read_inside_rows(const std::filesystem::path& file);
[[nodiscard]] std::vector<SolidRow> read_solid_rows(const std::filesystem::path& file);
[[nodiscard]] std::vector<ClosedRow> read_closed_rows(const std::filesystem::path& file);
[[nodiscard]] std::vector<RayTruthRow> read_ray_rows(const std::filesystem::path& file);
[[nodiscard]] std::vector<RayListRow> read_ray_lists(const std::filesystem::path& file);

/// The relation that the truth set of overlaps states in its column `solid` for bodies whose
/// surfaces do not meet, "clear", "a_in_b" or "b_in_a"; nothing for other words.
[[nodiscard]] std::optional<Relation> relation_named(std::string_view name);

/// A mesh of the set by name, of tests/data/questions or of the truth set of overlaps; null for
/// models of others where SOMS_DATA is unset.
[[nodiscard]] const Mesh* question_mesh(std::string_view name);

/// A file of the whole set in SOMS_DATA, or nothing where that is unset or lacks it.
[[nodiscard]] std::optional<std::filesystem::path> outside_question(std::string_view name);

}  // namespace soms::test
