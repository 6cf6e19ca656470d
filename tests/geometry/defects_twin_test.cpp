// Defects of small random meshes against a twin that looks at all pairs, and what the search for
// them takes.
#include "soms/base/error.h"
#include "soms/generate/shapes.h"
#include "soms/geometry/defects.h"

#include "tests/support/allocation.h"
#include "tests/support/support.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <stop_token>
#include <utility>
#include <vector>

namespace soms {
namespace {

/// Corners of a triangle as places, or as numbers, and each edge with who uses it and which way.
using Place = std::array<double, 3>;
using Corners = std::array<Place, 3>;

/// The place of a vertex, or where only numbers join, its number.
Place name_of(const Mesh& mesh, std::uint32_t v, bool by_index) {
  const Vec3& p = mesh.vertices[v];
  return by_index ? Place{static_cast<double>(v), 0, 0} : Place{p.x, p.y, p.z};
}

Corners corners_of(const Mesh& mesh, TriangleId i, bool by_index = false) {
  const auto& t = mesh.triangles[i];
  return {name_of(mesh, t[0], by_index), name_of(mesh, t[1], by_index),
          name_of(mesh, t[2], by_index)};
}

/// Coordinates of these tests are small whole numbers, for which this is exact.
bool without_area(const Mesh& mesh, TriangleId i) {
  const Triangle t = mesh.triangle(i);
  return cross(t.b - t.a, t.c - t.a) == Vec3{};
}

bool is_same_direction(const Corners& s, Corners t) {
  for (int turn = 0; turn < 3; ++turn) {
    if (s == t) {
      return true;
    }
    std::rotate(t.begin(), t.begin() + 1, t.end());
  }
  return false;
}

void twin_triangles(const Mesh& mesh, Defects& defects) {
  for (TriangleId i = 0; i < mesh.triangles.size(); ++i) {
    const Corners t = corners_of(mesh, i);
    if (without_area(mesh, i)) {
      const bool repeated = t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
      ++defects.degenerate;
      defects.repeated_corner += static_cast<std::uint64_t>(repeated);
      (repeated ? defects.places.repeated_corner : defects.places.collinear).push_back(i);
    }
    std::vector<TriangleId> earlier;
    bool same_direction = false;
    for (TriangleId j = 0; j < i; ++j) {
      const Corners u = corners_of(mesh, j);
      if (std::is_permutation(t.begin(), t.end(), u.begin())) {
        earlier.push_back(j);
        same_direction = same_direction || is_same_direction(t, u);
      }
    }
    if (!earlier.empty()) {
      ++defects.duplicate;
      defects.places.duplicate.push_back({i, earlier.front()});
      if (!same_direction && !without_area(mesh, i)) {
        ++defects.doubled;
        defects.places.doubled.push_back({i, earlier.front()});
      }
    }
  }
}

struct EdgeUse {
  TriangleId triangle;
  std::uint32_t corner;
  bool forward;
};

EdgeCounts twin_edges(const Mesh& mesh, TriangleId first, TriangleId count, bool by_index,
                      DefectPlaces* places) {
  std::map<std::pair<Place, Place>, std::vector<EdgeUse>> edges;
  for (TriangleId i = first; i < first + count; ++i) {
    const Corners t = corners_of(mesh, i, by_index);
    for (std::uint32_t c = 0; c < 3 && !without_area(mesh, i); ++c) {
      const Place& from = t[c];
      const Place& to = t[(c + 1) % 3];
      edges[std::minmax(from, to)].push_back({i, c, from < to});
    }
  }
  EdgeCounts counts{.none = edges.empty()};
  const auto tell = [&](std::uint64_t& count_of_kind, std::vector<EdgePlace> DefectPlaces::*kind,
                        const std::vector<EdgeUse>& uses) {
    ++count_of_kind;
    if (places != nullptr) {
      (places->*kind)
          .push_back({uses[0].triangle, uses[0].corner, uses[uses.size() > 1 ? 1 : 0].triangle,
                      static_cast<std::uint32_t>(uses.size())});
    }
  };
  for (const auto& [ends, uses] : edges) {
    if (uses.size() == 1) {
      tell(counts.open, &DefectPlaces::open_edges, uses);
    } else if (uses.size() > 2) {
      tell(counts.non_manifold, &DefectPlaces::non_manifold_edges, uses);
    } else if (uses[0].forward == uses[1].forward) {
      tell(counts.flipped, &DefectPlaces::flipped_edges, uses);
    }
  }
  return counts;
}

void twin_vertices(const Mesh& mesh, Defects& defects) {
  std::set<std::uint32_t> used;
  for (const auto& t : mesh.triangles) {
    used.insert(t.begin(), t.end());
  }
  std::map<Place, std::uint32_t> first;
  for (std::uint32_t v = 0; v < mesh.vertices.size(); ++v) {
    if (!used.contains(v)) {
      ++defects.unused_vertices;
      defects.places.unused_vertices.push_back(v);
      continue;
    }
    const auto [original, is_new] = first.try_emplace(name_of(mesh, v, false), v);
    if (!is_new) {
      ++defects.repeated_vertices;
      defects.places.repeated_vertices.push_back({v, original->second});
    }
  }
}

template <class Value>
void keep_first(std::vector<Value>& values, std::size_t most) {
  std::sort(values.begin(), values.end());
  values.resize(std::min(values.size(), most));
}

Defects twin(const Mesh& mesh, std::size_t most) {
  const auto all = static_cast<TriangleId>(mesh.triangles.size());
  Defects d;
  twin_triangles(mesh, d);
  twin_vertices(mesh, d);
  const EdgeCounts edges = twin_edges(mesh, 0, all, false, &d.places);
  d.open_edges = edges.open;
  d.non_manifold_edges = edges.non_manifold;
  d.flipped_edges = edges.flipped;
  d.by_index = twin_edges(mesh, 0, all, true, nullptr);
  for (const Part& part : mesh.parts) {
    d.parts.push_back(twin_edges(mesh, part.first, part.count, false, nullptr));
  }
  DefectPlaces& p = d.places;
  for (std::vector<TriangleId>* list : {&p.repeated_corner, &p.collinear, &p.unused_vertices}) {
    keep_first(*list, most);
  }
  for (std::vector<EdgePlace>* list : {&p.open_edges, &p.non_manifold_edges, &p.flipped_edges}) {
    keep_first(*list, most);
  }
  keep_first(p.duplicate, most);
  keep_first(p.doubled, most);
  keep_first(p.repeated_vertices, most);
  return d;
}

/// Few places, many vertices in each, zeros of either sign, parts that may hold one another.
Mesh mesh_of_defects(Rng& rng) {
  const std::uint64_t places = 2 + rng.below(5);
  const auto vertices = static_cast<std::uint32_t>(3 + rng.below(25));
  Mesh mesh;
  for (std::uint32_t v = 0; v < vertices; ++v) {
    const auto coordinate = [&] {
      const auto x = static_cast<double>(rng.below(places)) - 1;
      return x == 0 && rng.below(2) == 0 ? -0.0 : x;
    };
    const double x = coordinate();
    const double y = coordinate();
    mesh.vertices.push_back({x, y, rng.below(3) == 0 ? coordinate() : 0});
  }
  const auto triangles = static_cast<std::uint32_t>(rng.below(60));
  for (std::uint32_t i = 0; i < triangles; ++i) {
    std::array<std::uint32_t, 3> t{};
    for (std::uint32_t& v : t) {
      v = static_cast<std::uint32_t>(rng.below(vertices));
    }
    mesh.triangles.push_back(i > 0 && rng.below(4) == 0 ? mesh.triangles[rng.below(i)] : t);
    if (rng.below(2) == 0) {
      std::swap(mesh.triangles.back()[0], mesh.triangles.back()[1]);
    }
  }
  for (std::uint64_t parts = rng.below(4); parts > 0; --parts) {
    const auto first = static_cast<std::uint32_t>(rng.below(triangles + 1));
    const auto count = static_cast<std::uint32_t>(rng.below(triangles - first + 1));
    mesh.parts.push_back({"part", Part::kNoParent, first, count});
  }
  return mesh;
}

TEST(Defects, EqualThoseOfATwinThatLooksAtAllPairs) {
  Defects sum;
  test::for_each_case("defects/twin", 400, [&](Rng& rng) {
    const Mesh mesh = mesh_of_defects(rng);
    for (const std::size_t most : {std::size_t{0}, std::size_t{3}, std::size_t{1000}}) {
      ASSERT_EQ(find_defects(mesh, {.places = most}), twin(mesh, most));
    }
    const Defects d = twin(mesh, 0);
    sum.repeated_corner += d.repeated_corner;
    sum.degenerate += d.degenerate;
    sum.duplicate += d.duplicate;
    sum.doubled += d.doubled;
    sum.open_edges += d.open_edges;
    sum.non_manifold_edges += d.non_manifold_edges;
    sum.flipped_edges += d.flipped_edges;
    sum.repeated_vertices += d.repeated_vertices;
    sum.unused_vertices += d.unused_vertices;
  });
  for (const std::uint64_t count :
       {sum.repeated_corner, sum.collinear(), sum.duplicate - sum.doubled, sum.doubled,
        sum.open_edges, sum.non_manifold_edges, sum.flipped_edges, sum.repeated_vertices,
        sum.unused_vertices}) {
    EXPECT_GT(count, 100U);  // no kind went untested
  }
}

/// The triangles of a mesh with corners of their own.
Mesh soup_of(const Mesh& mesh) {
  Mesh soup;
  for (TriangleId i = 0; i < mesh.triangles.size(); ++i) {
    const Triangle t = mesh.triangle(i);
    soup.vertices.insert(soup.vertices.end(), {t.a, t.b, t.c});
    soup.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  return soup;
}

TEST(Defects, OfASoupAreThoseOfTheClosedMeshByPosition) {
  Mesh knot = generate_knot(2000);
  knot.parts.clear();
  EXPECT_EQ(find_defects(knot), Defects{});
  const Defects defects = find_defects(soup_of(knot));
  EXPECT_TRUE(defects.closed());
  EXPECT_EQ(defects.by_index, (EdgeCounts{6000, 0, 0}));
  EXPECT_EQ(defects.repeated_vertices, 6000 - knot.vertices.size());
}

// Two bodies that meet along an edge, each with vertices of its own.
TEST(Defects, JoinByPositionWhatNumbersKeepApart) {
  Mesh two;
  two.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0},  {0, 0, 1},
                  {0, 0, 0}, {0, 0, 1}, {-1, 0, 0}, {0, -1, 0}};
  for (const std::array<std::uint32_t, 4>& v : {std::array{0U, 1U, 2U, 3U}, {4U, 6U, 7U, 5U}}) {
    two.triangles.insert(
        two.triangles.end(),
        {{v[0], v[2], v[1]}, {v[0], v[1], v[3]}, {v[1], v[2], v[3]}, {v[2], v[0], v[3]}});
  }
  const Defects defects = find_defects(two);
  EXPECT_TRUE(defects.by_index.closed());
  EXPECT_FALSE(defects.closed());
  EXPECT_EQ(defects.places.non_manifold_edges, (std::vector<EdgePlace>{{1, 2, 3, 4}}));
  EXPECT_EQ(defects.places.repeated_vertices, (std::vector<VertexCopy>{{4, 0}, {5, 3}}));
}

TEST(Defects, OfPartsAreLeftOutWherePartsHoldOneAnotherTooOften) {
  Mesh knot = generate_knot(200);
  knot.parts.assign(64, {"all", Part::kNoParent, 0, 200});
  EXPECT_EQ(find_defects(knot).parts, std::vector<EdgeCounts>(64));
  EXPECT_TRUE(find_defects(knot, {.parts = false}).parts.empty());
  knot.parts.push_back({"one more", Part::kNoParent, 0, 1});
  EXPECT_TRUE(find_defects(knot).parts.empty());
}

TEST(Defects, TakeTheMemoryThatIsStated) {
  for (const bool soup : {false, true}) {
    Mesh mesh = generate_sphere(100000);
    mesh = soup ? soup_of(mesh) : mesh;
    mesh.parts = {{"half", Part::kNoParent, 0, 50000}};
    const test::AllocationWatch watch;
    const Defects defects = find_defects(mesh);
    EXPECT_TRUE(defects.closed());
    const std::uint64_t stated = 25 * mesh.triangles.size() + 12 * mesh.vertices.size();
    EXPECT_LE(watch.peak(), stated + 20000);
    EXPECT_GE(watch.peak(), stated / 2);
    EXPECT_LT(watch.count(), 100U);
  }
}

// Thousands of triangles about one edge, and all vertices in two places: nothing is quadratic.
TEST(Defects, OfTrianglesThatAllMeetAreFoundSoon) {
  constexpr std::uint32_t kMany = 100000;
  Mesh fan;
  fan.vertices = {{0, 0, 0}, {0, 0, 1}};
  for (std::uint32_t i = 0; i < kMany; ++i) {
    fan.vertices.push_back({1.0 + (i < kMany / 2 ? 0 : i), 1, 0});
    fan.triangles.push_back({0, 1, i + 2});
  }
  const Defects defects = find_defects(fan, {.places = 1});
  EXPECT_EQ(defects.non_manifold_edges, 3U);
  EXPECT_EQ(defects.places.non_manifold_edges, (std::vector<EdgePlace>{{0, 0, 1, kMany}}));
  EXPECT_EQ(defects.duplicate, kMany / 2 - 1);
  EXPECT_EQ(defects.repeated_vertices, kMany / 2 - 1);
  EXPECT_EQ(defects.open_edges, kMany);
}

TEST(Defects, TellProgressThatOnlyGrowsToOneAndStopOnRequest) {
  Mesh mesh = soup_of(generate_knot(200000));
  mesh.parts = {{"a", Part::kNoParent, 0, 1000}, {"b", Part::kNoParent, 1000, 100000}};
  std::vector<double> shares;
  Limits limits;
  limits.progress = [&](double share) { shares.push_back(share); };
  static_cast<void>(find_defects(mesh, {}, limits));
  EXPECT_GT(shares.size(), 20U);
  EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
  EXPECT_NEAR(shares.back(), 1, 1e-5);

  std::stop_source source;
  limits.stop = source.get_token();
  limits.progress = [&](double share) {
    if (share > 0.5) {
      source.request_stop();
    }
  };
  try {
    static_cast<void>(find_defects(mesh, {}, limits));
    FAIL() << "went on";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::cancelled);
  }
}

}  // namespace
}  // namespace soms
