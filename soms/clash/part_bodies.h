/// \file
/// The parts of a mesh, each as a body of its own.
///
/// \code
/// const soms::Mesh car = soms::generate_mover(soms::MoverKind::car);
/// const std::vector<soms::PartBody> parts = soms::part_bodies(car);
/// std::cout << parts.size() << " parts\n";
/// const soms::PartBody& first = parts.front();
/// std::cout << car.parts[first.part].name << ": " << first.triangles.size() << " triangles, "
///           << (first.closed ? "closed" : "open") << '\n';
/// \endcode
/// It prints:
/// \verbatim
/// 12 parts
/// hull: 420 triangles, closed
/// \endverbatim
#pragma once

#include "soms/base/box.h"
#include "soms/base/limits.h"
#include "soms/base/pose.h"
#include "soms/base/vector.h"
#include "soms/geometry/defects.h"
#include "soms/geometry/mesh.h"
#include "soms/query/body.h"
#include "soms/query/contains.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace soms {

/// Triangles of a part that are connected by vertices in one place, where its pose has moved them.
struct PartComponent {
  Vec3 corner = {};  ///< of one of the triangles
  Box box = {};      ///< around all of them

  [[nodiscard]] bool operator==(const PartComponent&) const = default;
};

struct PartBody;

/// What open parts enclose together: one body for all of them, which they share. A value.
struct OpenUnion {
  std::shared_ptr<const PartBody> body = nullptr;  ///< nothing: of no group of several parts

  /// True if both are of the same first part and as many triangles, or of none. The triangles are
  /// those of the parts, which are compared where these are.
  [[nodiscard]] bool operator==(const OpenUnion& other) const;
};

/// The triangles of a mesh whose innermost part it is, as a body; or those of several parts that
/// are one body together. A value; copies share the body.
struct PartBody {
  /// Index in Mesh::parts, of an object of several runs that of the first; Part::kNoParent for the
  /// triangles that no part holds. For a body of several parts it is the first.
  std::uint32_t part = Part::kNoParent;
  std::vector<std::uint32_t> joined = {};  ///< the other parts of the body, Part::kNoParent last
  Body body = {};
  std::optional<ClosedBody> closed = std::nullopt;  ///< `body`, if it is closed at its pose
  std::uint64_t odd_edges = 0;                      ///< edges of an odd number of triangles
  std::vector<EdgePlace> places = {};  ///< the first few of these; triangles are those of `body`
  /// What an open part is taken to be closed by, where the pose moves it: a triangle from each odd
  /// edge to the middle of its opening. That is the middle of the box around odd edges that hang
  /// together.
  Body caps = {};
  std::vector<PartComponent> components = {};  ///< by their first triangles
  std::vector<TriangleId> triangles = {};      ///< triangle i of `body` is triangles[i] of the mesh
  /// For a part that stays open in a group of several (`bodies_of`): all of them as one open body,
  /// named by the first, the others in its `joined`. It is the same object for each of them.
  OpenUnion together = {};

  /// True unless the part stays open together with others of which one comes before it.
  [[nodiscard]] bool leads() const { return !together.body || together.body->part == part; }

  /// Around the part, where its pose has moved it.
  [[nodiscard]] Box box() const;

  [[nodiscard]] bool operator==(const PartBody&) const = default;
};

/// What becomes of parts that stay open, and may enclose something together. Those that close each
/// other, though in several ways, are one body that counts as open.
enum class OpenParts : unsigned char {
  alone,   ///< each is a body of its own, which knows the others (PartBody::together)
  joined,  ///< those of a group of `bodies_of` are one body, which is open
};

/// The bodies of a mesh: every part that is the innermost of a triangle, by the order of
/// Mesh::parts; the triangles that no part holds come last. Parts that close each other, as
/// `bodies_of` decides it, are one body, in the place of the first. Vertices are copied as they
/// are, so each body has the very triangles of the mesh, in their order.
/// \pre     `check(mesh)` passes.
/// \errors  As `ClosedBody` for the pose; ErrorKind::cancelled.
/// \cost    O(n log n) for n triangles; a shape for each body, and for each group of open parts.
[[nodiscard]] std::vector<PartBody> part_bodies(const MeshView& mesh, const Pose& pose = {},
                                                const Limits& limits = {},
                                                OpenParts open = OpenParts::alone);

}  // namespace soms
