#include "soms/base/random.h"
#include "soms/generate/shapes.h"
#include "soms/io/read_mesh.h"
#include "soms/tree/layout/detail/compact_node.h"

#include "tests/golden/golden.h"
#include "tests/support/bodies.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace soms::golden {

Hash& Hash::operator<<(std::string_view text) {
  for (const char c : text) {
    hash_.add_byte(static_cast<std::uint8_t>(c));
  }
  return *this << text.size();
}

Hash& Hash::operator<<(const Vec3& v) {
  return *this << v.x << v.y << v.z;
}

Hash& Hash::operator<<(const Box& box) {
  return *this << box.lower << box.upper;
}

Hash& Hash::operator<<(const Pose& pose) {
  return *this << pose.m;
}

Hash& Hash::operator<<(const Cost& cost) {
  return *this << cost.node_tests << cost.triangle_tests << cost.exact_tests;
}

Hash& Hash::operator<<(const TrianglePair& pair) {
  return *this << pair.a << pair.b;
}

Hash& Hash::operator<<(const Mesh& mesh) {
  return *this << mesh.vertices << mesh.triangles << mesh.faces;
}

Hash& Hash::operator<<(const Overlap& answer) {
  return *this << answer.any << answer.hash() << answer.coverage;
}

Hash& Hash::operator<<(const WideTree& tree) {
  for (const WideNode& node : tree.nodes()) {
    *this << node.center << node.half << node.row << node.child << node.origin << node.l1_radius
          << node.count << node.leaves << node.oriented;
  }
  for (const TriangleBlock& block : tree.blocks()) {
    *this << block.corner << block.id << block.origin << block.own_half << block.l1_radius
          << block.normal << block.lower << block.upper << static_cast<std::uint32_t>(block.count)
          << static_cast<std::uint32_t>(block.following);
  }
  if (const CompactParts* parts = tree.compact()) {
    for (const CompactNode& node : parts->nodes) {
      *this << node.lower << node.upper << node.step << node.child << node.origin << node.axes
            << node.l1_radius << node.count << node.leaves << node.oriented;
    }
    *this << parts->ids;
  }
  return *this << tree.bounds() << tree.exponent();
}

namespace {

Mesh scaled(Mesh mesh, int exponent) {
  for (Vec3& v : mesh.vertices) {
    v = {std::ldexp(v.x, exponent), std::ldexp(v.y, exponent), std::ldexp(v.z, exponent)};
  }
  return mesh;
}

/// Corners of a lattice, some of them moved by a bit or by a subnormal number.
Vec3 lattice_point(Rng& rng) {
  Vec3 v;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    v[axis] = static_cast<double>(rng.below(4));
    const std::uint64_t kind = rng.below(8);
    v[axis] += kind == 0 ? 0x1p-52 : kind == 1 ? -0x1p-53 : 0;
    v[axis] = kind == 2 && v[axis] == 0 ? 0x1p-1074 : v[axis];
  }
  return v;
}

/// Four points nearly in one plane, of a size between 2^-360 and 2^290.
void add_near_coplanar(Rng& rng, std::vector<Vec3>& points) {
  const double scale = std::ldexp(1.0, static_cast<int>(rng.below(650)) - 360);
  for (int i = 0; i < 4; ++i) {
    const double x = rng.uniform(-1, 1);
    const double y = rng.uniform(-1, 1);
    const double off = rng.below(2) == 0 ? 0 : std::ldexp(rng.uniform(-1, 1), -52);
    points.push_back({scale * x, scale * y, scale * ((x + 0.5 * y) + off)});
  }
}

std::vector<Pose> touching_poses() {
  return {Pose(),
          Pose::translation(0.25, 0.125, 0),
          Pose::translation(0x1p-1050, 0, 0),
          Pose::from_quaternion(0.8, 0.36, 0.48, 0, {0.1, 0.2, 0.3}),
          Pose::from_quaternion(0, 0, 0.6, 0.8, {-0.4, 0.1, 0.7}),
          Pose::from_quaternion(0.5, -0.5, 0.5, 0.5)};
}

/// The greatest magnitude of a coordinate.
double reach(const Box& box) {
  double most = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    most = std::max({most, -box.lower[axis], box.upper[axis]});
  }
  return most;
}

/// Those of `poses` whose shift does not dwarf both models (a shift that does makes points of them,
/// and of all pairs of triangles ties, which take seconds), and four that leave them apart. Turned,
/// `a` reaches as far as sqrt(3) times its greatest coordinate, so shifts of 1.75 `r` and more
/// along an axis leave it clear of `b`. In the first of the four the boxes are a millionth apart.
std::vector<Pose> poses_around(const Box& a, const Box& b, const std::vector<Pose>& poses) {
  const double r = reach(a) + reach(b);
  std::vector<Pose> result;
  for (const Pose& pose : poses) {
    if (std::max({std::abs(pose.m[3]), std::abs(pose.m[7]), std::abs(pose.m[11])}) <= 0x1p16 * r) {
      result.push_back(pose);
    }
  }
  result.push_back(Pose::translation((b.upper.x - a.lower.x) + 0x1p-20 * r, 0, 0));
  result.push_back(Pose::translation(0.125 * r, -0.5 * r, 1.75 * r));
  result.push_back(Pose::from_quaternion(0.8, 0.36, 0.48, 0, {-1.75 * r, 1.5 * r, 0.25 * r}));
  result.push_back(Pose::from_quaternion(0, 0, 0.6, 0.8, {0.5 * r, 3 * r, -0.25 * r}));
  return result;
}

constexpr std::array<std::pair<const char*, const char*>, 9> kPairs{{{"ring", "soup"},
                                                                     {"soup", "slivers"},
                                                                     {"slivers", "degen"},
                                                                     {"degen", "needles"},
                                                                     {"needles", "star"},
                                                                     {"star", "knot"},
                                                                     {"subnormal", "subnormal"},
                                                                     {"subnormal", "star"},
                                                                     {"huge", "huge"}}};

/// Poses of a box of side 1 beside another of side 1 at the origin: the same, with a face in a
/// plane, sharing a face, an edge and a corner, a bit beside that, apart, and inside one of side 4.
std::vector<Pose> poses_of_boxes() {
  return {Pose(),
          Pose::translation(0.5, 0, 0),
          Pose::translation(1, 0, 0),
          Pose::translation(1, 0.5, 0.25),
          Pose::translation(1, 1, 0),
          Pose::translation(-1, 1, 1),
          Pose::translation(1 - 0x1p-53, 0, 0),
          Pose::translation(1 + 0x1p-52, 0, 0),
          Pose::translation(0, 2, 0x1p40),
          Pose::from_quaternion(0.8, 0.36, 0.48, 0, {0.1, 0.2, 0.3}),
          Pose::translation(-1, -1, -1)};
}

constexpr std::array<std::pair<const char*, const char*>, 5> kSolidPairs{
    {{"box", "box"}, {"box", "large box"}, {"boxes", "box"}, {"box", "knot"}, {"huge", "huge"}}};

}  // namespace

Inputs::Inputs(std::filesystem::path folder) : data(std::move(folder)), poses(touching_poses()) {
  Rng rng(12);
  for (int i = 0; i < 1000; ++i) {
    add_near_coplanar(rng, points);
  }
  for (int i = 0; i < 1600; ++i) {
    triangles.push_back({lattice_point(rng), lattice_point(rng), lattice_point(rng)});
  }
  const auto truth = [&](const char* name) {
    return read_mesh(data / "truth" / "meshes" / (std::string(name) + ".ply"));
  };
  models = {{"ring", truth("ring")},       {"soup", truth("soup")},
            {"slivers", truth("slivers")}, {"degen", truth("degen")},
            {"needles", truth("needles")}, {"star", truth("star")},
            {"knot", generate_knot(240)}};
  // Corners keep all or only some of their bits as subnormal numbers.
  models["subnormal"] = scaled(models["knot"], -1055);
  models["huge"] = scaled(models["knot"], 295);
  for (const auto& [first, second] : kPairs) {
    pairs.push_back(
        {first, second, poses_around(bounds(models[first]), bounds(models[second]), poses)});
  }
  const Mesh box = test::box_body({0, 0, 0}, {1, 1, 1}, 2);
  solids = {{"box", box},
            {"large box", test::box_body({-1, -1, -1}, {3, 3, 3})},
            {"boxes", test::joined(box, test::box_body({0, 0, 1}, {1, 1, 2}))}};
  for (const auto& [first, second] : kSolidPairs) {
    solid_pairs.push_back({first, second, poses_of_boxes()});
  }
  constexpr std::size_t kProbedTriangles = 12;
  for (const auto& [name, mesh] : models) {
    const Shape shape(mesh);
    for (const std::size_t pose : {0U, 1U, 3U}) {
      probed.push_back(
          {name, poses[pose], test::probes_of(Body(shape, poses[pose]), kProbedTriangles)});
    }
  }
  bent = models["ring"];
  for (Vec3& v : bent.vertices) {
    v = {v.x + 0.1 * v.y * v.y, 1.25 * v.y, v.z - 0.2 * v.x};
  }
}

}  // namespace soms::golden
