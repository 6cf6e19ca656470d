// Two meshes of awkward numbers and sizes at awkward poses, by any rule in either layout, as built
// or refitted: every question of the table, at lengths at and beside the distance, a named
// traversal, and every question about points, against brute force.
#include "soms/thesis/overlap.h"
#include "soms/thesis/traversals.h"
#include "soms/tree/check.h"
#include "soms/tree/refit.h"
#include "soms/tree/rule/rules.h"
#include "soms/tree/shape.h"

#include "tests/fuzz/bytes.h"
#include "tests/fuzz/poses.h"
#include "tests/fuzz/require.h"
#include "tests/fuzz/scales.h"
#include "tests/support/truth/closest_check.h"
#include "tests/support/truth/query_table.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace soms {
namespace {

using fuzz::Bytes;
using fuzz::require;

/// How the coordinates of a mesh are drawn: a lattice makes features tie, powers of two mix all
/// sizes, steps of the last place make near ties, and slivers are thin along one axis. Some meshes
/// are flatter, as cities are.
struct Numbers {
  explicit Numbers(Bytes& bytes)
      : kind(bytes.below(5)),
        unit(fuzz::unit_of(bytes)),
        shift(bytes.below(4) == 0 ? fuzz::far_by(unit, static_cast<int>(bytes.below(50))) : 0),
        thin(bytes.below(4)),
        thinness(bytes.below(3) == 0 ? -3 : -30) {}

  /// In units of `size`, the mesh's or a far smaller one.
  double coordinate(Bytes& bytes, std::uint32_t axis, double size) const {
    const double on_lattice = static_cast<double>(bytes.below(5)) - 1;
    double x = 0;
    switch (kind) {
      case 0:
        x = on_lattice;
        break;
      case 1:
        x = std::ldexp(on_lattice, static_cast<int>(bytes.below(80)) - 60);
        break;
      case 2:
        x = on_lattice + std::ldexp(static_cast<double>(bytes.below(7)) - 3, -52);
        break;
      case 3:
        x = bytes.below(9);
        break;
      default:
        x = 4 * bytes.fraction();
    }
    return shift + size * (axis == thin ? std::ldexp(x, thinness) : x);
  }

  std::uint32_t kind;
  double unit;
  double shift;
  std::uint32_t thin;
  int thinness;
};

Mesh mesh_of(Bytes& bytes, const Numbers& numbers) {
  // Brute force about lengths takes its time: few meshes are as large as a tree of some levels.
  const std::uint32_t most = bytes.below(4) == 0 ? 40 : 12;
  Mesh mesh;
  const std::uint32_t triangles = bytes.below(most);
  for (std::uint32_t i = 0; i < triangles; ++i) {
    std::array<std::uint32_t, 3> corners = {};
    const double size = fuzz::unit_of_heap(bytes, numbers.unit);
    for (std::uint32_t& corner : corners) {
      const std::uint32_t choice = bytes.byte();
      if (choice < 160 || mesh.vertices.empty()) {
        Vec3 v;
        for (std::uint32_t axis = 0; axis < 3; ++axis) {
          v[axis] = numbers.coordinate(bytes, axis, size);
        }
        mesh.vertices.push_back(v);
        corner = static_cast<std::uint32_t>(mesh.vertices.size() - 1);
      } else {
        corner = choice % static_cast<std::uint32_t>(mesh.vertices.size());
      }
    }
    mesh.triangles.push_back(corners);
  }
  return mesh;
}

/// A pose, now and then off orthonormal by up to 9e-7, or far away.
Pose awkward_pose_of(Bytes& bytes, double unit) {
  Pose pose = fuzz::pose_of(bytes, unit);
  const std::uint32_t change = bytes.below(8);
  if (change < 2) {
    const std::uint32_t from = bytes.below(3);
    const std::uint32_t to = bytes.below(3);
    const double off = (from == to ? 4.5e-7 : 9e-7) * bytes.fraction();
    for (std::size_t row = 0; row < 3; ++row) {
      pose.m[4 * row + to] += off * pose.m[4 * row + from];
    }
  } else if (change == 2) {
    pose.m[4 * bytes.below(3) + 3] += fuzz::far_by(unit, static_cast<int>(bytes.below(64)));
  } else if (change == 3) {
    double& shift = pose.m[4 * bytes.below(3) + 3];
    shift = std::nextafter(shift, bytes.below(2) == 0 ? -1e300 : 1e300);
  }
  return pose;
}

ShapeOptions options_of(Bytes& bytes) {
  const auto table = rules();
  ShapeOptions options;
  options.build.rule = table[bytes.below(static_cast<std::uint32_t>(table.size()))].rule;
  options.build.per_leaf = static_cast<int>(1 + bytes.below(16));
  options.build.level = static_cast<int>(bytes.below(3) == 0 ? 1 + bytes.below(7) : 0);
  options.layout = bytes.below(3) == 0 ? Layout::compact : Layout::wide;
  options.keep_tree = true;
  return options;
}

/// The shape of a mesh. One in two was built for vertices at other places, and then refitted.
Shape shape_of(const Mesh& mesh, const Numbers& numbers, Bytes& bytes) {
  const ShapeOptions options = options_of(bytes);
  Mesh before = mesh;
  const bool refitted = bytes.below(2) == 0;
  for (std::size_t k = 0; refitted && k < before.vertices.size(); ++k) {
    const std::uint32_t axis = 2 * bytes.below(2);
    before.vertices[k][axis] = numbers.coordinate(bytes, axis, numbers.unit);
  }
  Shape shape(std::move(before), options);
  if (refitted) {
    shape = refit(shape, mesh.vertices);
    require(shape.mesh() == mesh, "the mesh of a refitted shape");
  }
  require(find_fault(*shape.tree(), shape.mesh()).empty(), "a whole tree");
  return shape;
}

/// What is wrong ends the program, with the question and the answer.
void expect_right(const test::QueryRow& row, const test::Answer& answer,
                  const test::PairTruth& truth, const Body& a, const Body& b, double length) {
  const std::string fault = row.fault(answer, truth, a, b, length);
  require(fault.empty(), (std::string(row.name) + ": " + fault + ": " + row.text(answer)).c_str());
}

/// Threads, and the other order of the bodies.
void check_pair(const Body& a, const Body& b, const test::PairTruth& truth) {
  for (const test::QueryRow& row : test::query_table(a, b)) {
    for (const double length : test::lengths_around(row, truth.distance.distance)) {
      const test::RowOptions options{.length = length};
      const test::Answer answer = row.ask(a, b, options, {});
      expect_right(row, answer, truth, a, b, length);
      const test::Answer threaded = row.ask(a, b, options, {.threads = 2});
      require(row.promised(threaded) == row.promised(answer), "two threads");
      require(test::coverage_of(answer) == Coverage::first ||
                  test::cost_of(threaded) == test::cost_of(answer),
              "cost of two threads");
      require(row.symmetric(row.ask(b, a, options, {}), true) == row.symmetric(answer, false),
              "bodies exchanged");
    }
  }
}

void check_traversal(const Body& a, const Body& b, const test::PairTruth& truth, Bytes& bytes) {
  const auto table = traversals();
  TraversalOptions settings;
  settings.traversal = table[bytes.below(static_cast<std::uint32_t>(table.size()))].traversal;
  settings.update = bytes.below(2) == 0 ? BoxUpdate::refit : BoxUpdate::rebox;
  settings = without_idle(settings);
  require(thesis::overlap(a, b, settings).answer.pairs == truth.overlap.pairs, "a named traversal");
}

/// Answers of a batch equal those of single queries, costs too, at lengths around one distance.
void check_batch(const Shape& mover, const std::vector<Pose>& poses, const Body& fixed,
                 const Bracket& distance) {
  for (const test::QueryRow& row : test::query_table()) {
    if (row.of_closed_bodies) {
      continue;  // that are hardly ever drawn
    }
    for (const double length : test::lengths_around(row, distance)) {
      const test::BatchAnswer batch = row.ask_batch(mover, poses, fixed, {.length = length}, {});
      for (std::size_t k = 0; k < poses.size(); ++k) {
        require(batch.answers[k] == row.ask(Body(mover, poses[k]), fixed, {.length = length}, {}),
                "a batch");
      }
    }
  }
}

/// A corner of the mover, now and then an ulp off, is a point beside the other body.
void check_point(const Body& mover, const Body& fixed, Bytes& bytes) {
  const MeshView& mesh = mover.shape.mesh();
  if (mesh.vertices.empty()) {
    return;
  }
  const auto corners = static_cast<std::uint32_t>(mesh.vertices.size());
  Vec3 point = mover.pose.apply(mesh.vertices[bytes.byte() % corners]);
  if (bytes.below(3) == 0) {
    double& x = point[bytes.below(3)];
    x = std::nextafter(x, bytes.below(2) == 0 ? -1e300 : 1e300);
  }
  const std::string fault = test::first_fault_of_point(fixed, point);
  require(fault.empty(), fault.c_str());
}

void check_input(Bytes& bytes) {
  const Numbers first(bytes);
  Numbers second = bytes.below(2) == 0 ? first : Numbers(bytes);
  // Often small beside the first.
  second.unit = std::ldexp(second.unit, -static_cast<int>(bytes.below(2) * bytes.below(12)));
  const Shape a = shape_of(mesh_of(bytes, first), first, bytes);
  const Shape b = shape_of(mesh_of(bytes, second), second, bytes);
  const Body fixed(b, awkward_pose_of(bytes, second.unit));
  std::vector<Pose> poses;
  for (std::uint32_t k = 0, count = 1 + bytes.below(6); k < count; ++k) {
    poses.push_back(awkward_pose_of(bytes, first.unit));
  }
  test::PairTruth truth;
  for (const Pose& pose : poses) {
    const Body mover(a, pose);
    truth = test::truth_of(mover, fixed);
    check_pair(mover, fixed, truth);
    check_traversal(mover, fixed, truth, bytes);
    check_point(mover, fixed, bytes);
  }
  poses.insert(poses.begin(), Pose());
  poses.push_back(poses.back());
  check_batch(a, poses, fixed, truth.distance.distance);
}

}  // namespace
}  // namespace soms

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  soms::fuzz::Bytes bytes({data, size});
  soms::check_input(bytes);
  return 0;
}
