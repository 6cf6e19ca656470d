#include "soms/generate/statue.h"

#include "soms/base/arithmetic.h"
#include "soms/base/random.h"
#include "soms/generate/detail/counts.h"
#include "soms/generate/detail/solids.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <queue>
#include <utility>
#include <vector>

namespace soms {

namespace {

constexpr double kUnevenness = 0.04;    // shift of a new point, in lengths of the edge it cuts
constexpr double kMostUneven = 0.0025;  // and at most

Vec3 unit_vector(const Vec3& v) {
  return (1 / std::sqrt(dot(v, v))) * v;
}

double distance_between(const Vec3& a, const Vec3& b) {
  const Vec3 off = b - a;
  return std::sqrt(dot(off, off));
}

/// What the figure is at one latitude of the sphere that it is formed from.
struct Level {
  double latitude = 0;  ///< z of the direction, -1 to 1
  double height = 0;
  double across = 0;   ///< x for each unit of the direction's x
  double through = 0;  ///< y for each unit of the direction's y
  double forward = 0;  ///< shift of the whole level toward the face
};

constexpr std::array<Level, 14> kLevels{{
    {-1, 0, 0.42, 0.36, 0},            // middle of the base
    {-0.8, 0, 0.42, 0.36, 0},          // its edge
    {-0.74, 0.06, 0.38, 0.32, 0},      // foot of the plinth
    {-0.66, 0.09, 0.24, 0.21, 0},      // its waist
    {-0.58, 0.13, 0.22, 0.2, 0},       //
    {-0.45, 0.22, 0.29, 0.2, 0},       // chest
    {-0.2, 0.36, 0.37, 0.2, -0.01},    //
    {0, 0.46, 0.38, 0.19, -0.01},      // shoulders
    {0.14, 0.52, 0.24, 0.15, 0},       //
    {0.24, 0.56, 0.11, 0.115, 0.01},   // neck
    {0.34, 0.62, 0.105, 0.12, 0.03},   //
    {0.44, 0.67, 0.15, 0.18, 0.045},   // jaw
    {0.68, 0.83, 0.205, 0.255, 0.04},  // temples
    {1, 1, 0.25, 0.31, 0.02},          // crown
}};

/// A lump, or a hollow where `rise` is negative, around a direction.
struct Lump {
  Vec3 direction;
  double reach = 0;  ///< squared distance on the sphere to where it ends
  double rise = 0;   ///< as a share of the distance from the axis
};

constexpr std::array<Lump, 7> kLumps{{
    {{0, -0.82, 0.57}, 0.018, 0.32},      // nose
    {{0.19, -0.74, 0.645}, 0.02, -0.13},  // eyes
    {{-0.19, -0.74, 0.645}, 0.02, -0.13},
    {{0, -0.9, 0.43}, 0.02, 0.14},       // chin
    {{0.3, 0.72, 0.63}, 0.16, 0.3},      // knot of hair, worn to one side
    {{0.9, -0.2, -0.15}, 0.3, 0.12},     // a cloak over one shoulder
    {{-0.25, -0.9, -0.36}, 0.2, -0.12},  // its fold
}};

double lump(const Lump& l, const Vec3& direction) {
  const Vec3 off = direction - l.direction;
  const double share = dot(off, off) / l.reach;
  return share < 1 ? l.rise * (1 - share) * (1 - share) : 0;
}

/// Point of the figure that stands for a direction.
Vec3 on_figure(const Vec3& direction) {
  std::size_t i = 1;
  while (i + 1 < kLevels.size() && direction.z > kLevels[i].latitude) {
    ++i;
  }
  const Level& a = kLevels[i - 1];
  const Level& b = kLevels[i];
  const double t = std::clamp((direction.z - a.latitude) / (b.latitude - a.latitude), 0.0, 1.0);
  const double smooth = t * t * (3 - 2 * t);
  const auto between = [](double from, double to, double share) {
    return from + share * (to - from);
  };
  double swell = 1;
  for (const Lump& l : kLumps) {
    swell += lump(l, direction);
  }
  return {swell * between(a.across, b.across, smooth) * direction.x,
          swell * between(a.through, b.through, smooth) * direction.y -
              between(a.forward, b.forward, smooth),
          between(a.height, b.height, t)};
}

/// How much finer than elsewhere edges are cut there: the face is what a sculptor works on.
double fineness(const Vec3& direction) {
  const Vec3 off = direction - Vec3{0, -0.77, 0.6};
  return 1 + 1.5 / (1 + 6 * dot(off, off));
}

/// A closed surface of which edges are cut in two. Slot 3t + k is the side of triangle t from its
/// corner k to the next.
class Surface {
 public:
  Surface();

  /// Cuts the edge that is longest in view of fineness and chance: two triangles more.
  void cut();

  [[nodiscard]] std::size_t size() const { return triangles_.size(); }

  /// The mesh, moved to stand on z = 0, 1 high.
  Mesh finish();

 private:
  using Slot = std::uint32_t;
  using EdgeId = std::uint32_t;

  static Slot next(Slot s) { return s % 3 == 2 ? s - 2 : s + 1; }

  static Slot previous(Slot s) { return s % 3 == 0 ? s + 2 : s - 1; }

  std::uint32_t& start(Slot s) { return triangles_[s / 3][s % 3]; }

  std::uint32_t add_vertex(const Vec3& direction, const Vec3& position);
  Slot add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c);
  void join(Slot s, Slot t, EdgeId edge);
  void add_edge(Slot s, Slot t);
  void await(EdgeId edge);

  std::vector<Vec3> directions_;
  std::vector<Vec3> positions_;
  std::vector<std::array<std::uint32_t, 3>> triangles_;
  std::vector<Slot> twins_;    ///< of slots: the side of the neighbor
  std::vector<EdgeId> edges_;  ///< of slots
  std::vector<Slot> slots_;    ///< of edges: one of the two
  std::priority_queue<std::pair<double, EdgeId>> waiting_;
  Rng random_{948};
};

Surface::Surface() {
  for (const Vec3& d : {Vec3{0, 0, -1}, Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{-1, 0, 0},
                        Vec3{0, -1, 0}, Vec3{0, 0, 1}}) {
    add_vertex(d, on_figure(d));
  }
  // Below and above triangle i of each four stands side i of the equator.
  std::array<Slot, 4> below{};
  std::array<Slot, 4> above{};
  for (std::uint32_t i = 0; i < 4; ++i) {
    below[i] = add_triangle(1 + i, 0, 1 + (i + 1) % 4);
    above[i] = add_triangle(1 + i, 1 + (i + 1) % 4, 5);
  }
  for (std::uint32_t i = 0; i < 4; ++i) {
    add_edge(previous(below[i]), above[i]);
    add_edge(next(below[i]), below[(i + 1) % 4]);
    add_edge(next(above[i]), previous(above[(i + 1) % 4]));
  }
}

std::uint32_t Surface::add_vertex(const Vec3& direction, const Vec3& position) {
  directions_.push_back(direction);
  positions_.push_back(position);
  return static_cast<std::uint32_t>(directions_.size() - 1);
}

Surface::Slot Surface::add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  triangles_.push_back({a, b, c});
  twins_.resize(3 * triangles_.size());
  edges_.resize(3 * triangles_.size());
  return static_cast<Slot>(twins_.size() - 3);
}

void Surface::join(Slot s, Slot t, EdgeId edge) {
  twins_[s] = t;
  twins_[t] = s;
  edges_[s] = edge;
  edges_[t] = edge;
  slots_[edge] = s;
}

void Surface::add_edge(Slot s, Slot t) {
  const auto edge = static_cast<EdgeId>(slots_.size());
  slots_.push_back(s);
  join(s, t, edge);
  await(edge);
}

/// An edge counts as long as the way over the figure, the finer the more. Whatever stands between
/// its ends counts too, and chance less than twofold: else a thin triangle beside an edge that
/// never comes up would be cut forever.
void Surface::await(EdgeId edge) {
  const std::uint32_t a = start(slots_[edge]);
  const std::uint32_t b = start(twins_[slots_[edge]]);
  const Vec3 middle = unit_vector(directions_[a] + directions_[b]);
  const Vec3 over = on_figure(middle);
  const double length =
      distance_between(positions_[a], over) + distance_between(over, positions_[b]);
  const double fine =
      std::max({fineness(directions_[a]), fineness(middle), fineness(directions_[b])});
  waiting_.emplace(length * fine * random_.uniform(0.65, 1.25), edge);
}

void Surface::cut() {
  const EdgeId edge = waiting_.top().second;
  waiting_.pop();
  const Slot s = slots_[edge];
  const Slot t = twins_[s];
  const std::uint32_t a = start(s);
  const std::uint32_t b = start(t);
  const std::uint32_t c = start(previous(s));
  const std::uint32_t d = start(previous(t));
  const Vec3 direction = unit_vector(directions_[a] + directions_[b]);
  const double shift =
      std::min(kMostUneven, kUnevenness * distance_between(positions_[a], positions_[b]));
  Vec3 position = on_figure(direction);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    position[axis] += shift * random_.uniform(-1, 1);
  }
  const std::uint32_t m = add_vertex(direction, position);

  // (a, b, c) becomes (a, m, c) and (m, b, c); (b, a, d) becomes (m, a, d) and (b, m, d).
  const Slot bc = next(s);
  const Slot db = previous(t);
  const Slot one = add_triangle(m, b, c);
  const Slot two = add_triangle(b, m, d);
  join(next(one), twins_[bc], edges_[bc]);
  join(previous(two), twins_[db], edges_[db]);
  start(bc) = m;
  start(t) = m;
  join(s, t, edge);
  await(edge);
  add_edge(one, two);
  add_edge(bc, previous(one));
  add_edge(db, next(two));
}

Mesh Surface::finish() {
  const auto [lowest, highest] = std::minmax_element(
      positions_.begin(), positions_.end(), [](const Vec3& a, const Vec3& b) { return a.z < b.z; });
  const double bottom = lowest->z;
  const double height = highest->z - bottom;
  Mesh mesh;
  mesh.up = UpAxis::z;
  mesh.source = "generated statue";
  mesh.vertices.reserve(positions_.size());
  for (const Vec3& p : positions_) {
    mesh.vertices.push_back({p.x / height, p.y / height, (p.z - bottom) / height});
  }
  mesh.triangles = std::move(triangles_);
  const std::uint32_t part = detail::open_part(mesh, "statue");
  mesh.parts[part].first = 0;
  detail::close_part(mesh, part);
  return mesh;
}

}  // namespace

Mesh generate_statue(std::uint64_t triangles) {
  const PlainArithmetic plain;
  detail::check_closed_count("statue", triangles, 8);
  Surface surface;
  while (surface.size() < triangles) {
    surface.cut();
  }
  return surface.finish();
}

}  // namespace soms
