#include "soms/geometry/detail/parts/odd_edges.h"

#include "soms/geometry/detail/parts/disjoint_sets.h"
#include "soms/geometry/detail/parts/joined.h"
#include "soms/geometry/orientation.h"

#include <algorithm>
#include <cstddef>
#include <tuple>

namespace soms::detail {

namespace {

/// An edge as a triangle uses it, in the bucket of its lesser end.
struct EdgeUse {
  std::uint32_t end = 0;  ///< the greater end
  TriangleId triangle = 0;

  [[nodiscard]] bool operator<(const EdgeUse& use) const {
    return std::tie(end, triangle) < std::tie(use.end, use.triangle);
  }
};

/// The same where edges of one run are sorted alone.
struct LooseUse {
  std::uint32_t low = 0;
  EdgeUse use;

  [[nodiscard]] bool operator<(const LooseUse& other) const {
    return low != other.low ? low < other.low : use < other.use;
  }
};

/// A mesh as its edges are counted.
struct CountedMesh {
  MeshView mesh;
  const std::vector<std::uint32_t>& joined;
  const std::vector<bool>& degenerate;

  /// The ends of the edge that begins at a triangle's corner, the lesser one first.
  [[nodiscard]] std::array<std::uint32_t, 2> edge(std::size_t triangle,
                                                  std::uint32_t corner) const {
    const auto& t = mesh.triangles[triangle];
    const std::uint32_t from = joined[t[corner]];
    const std::uint32_t to = joined[t[(corner + 1) % 3]];
    return {std::min(from, to), std::max(from, to)};
  }

  /// Puts the edges of a triangle between two places as (lesser end, use).
  template <class Put>
  void put_edges(std::size_t triangle, const Put& put) const {
    for (std::uint32_t corner = 0; corner < 3; ++corner) {
      const auto [low, high] = edge(triangle, corner);
      if (low != high) {
        put(low, EdgeUse{high, static_cast<TriangleId>(triangle)});
      }
    }
  }
};

/// Uses of one edge, as they come.
class Uses {
 public:
  Uses(const CountedMesh& mesh, std::vector<OddEdge>& odd) : mesh_(mesh), odd_(odd) {}

  void add(std::uint32_t low, const EdgeUse& use) {
    if (all_ == 0 || low != low_ || use.end != first_.end) {
      finish();
      low_ = low;
      first_ = use;
      second_ = use.triangle;
    } else if (all_ == 1) {
      second_ = use.triangle;
    }
    ++all_;
    proper_ += mesh_.degenerate[use.triangle] ? 0U : 1U;
  }

  /// Keeps the edge if it is odd.
  void finish() {
    if ((all_ | proper_) % 2 != 0) {
      const std::array<std::uint32_t, 2> ends{low_, first_.end};
      std::uint32_t corner = 0;
      while (mesh_.edge(first_.triangle, corner) != ends) {
        ++corner;
      }
      odd_.push_back(
          {ends, {first_.triangle, corner, second_, all_}, all_ % 2 != 0, proper_ % 2 != 0});
    }
    all_ = 0;
    proper_ = 0;
  }

 private:
  CountedMesh mesh_;
  std::vector<OddEdge>& odd_;
  std::uint32_t low_ = 0;
  EdgeUse first_;
  TriangleId second_ = 0;
  std::uint32_t all_ = 0;
  std::uint32_t proper_ = 0;
};

bool is_degenerate(const Triangle& t) {
  return orientation2d(t.a, t.b, t.c, Projection::xy) == Sign::zero &&
         orientation2d(t.a, t.b, t.c, Projection::yz) == Sign::zero &&
         orientation2d(t.a, t.b, t.c, Projection::zx) == Sign::zero;
}

/// One end of a segment, and the other.
struct SegmentEnd {
  Vec3 at;
  Vec3 other;
  std::size_t segment = 0;
};

int compare_places(const Vec3& p, const Vec3& q) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (p[axis] != q[axis]) {
      return p[axis] < q[axis] ? -1 : 1;
    }
  }
  return 0;
}

/// Compares the lines from `v` to `a` and to `b` by their slopes, whichever way along the lines
/// `a` and `b` lie: y and z over x, or z over y where x is equal. 0 exactly where the lines are
/// one. \pre `a` and `b` are not `v`.
int compare_lines(const Vec3& v, const Vec3& a, const Vec3& b) {
  const std::size_t axis = leading_axis(v, a);
  const std::size_t axis_b = leading_axis(v, b);
  if (axis != axis_b) {
    return axis < axis_b ? -1 : 1;
  }
  const int side = (a[axis] > v[axis]) == (b[axis] > v[axis]) ? 1 : -1;
  const auto turn = [&](Projection plane) {
    return side * static_cast<int>(orientation2d(v, a, b, plane));
  };
  if (axis == 0) {
    const int in_xy = -turn(Projection::xy);
    return in_xy != 0 ? in_xy : turn(Projection::zx);
  }
  return axis == 1 ? -turn(Projection::yz) : 0;
}

/// Calls `visit` with the ends that are in one place, of segments on one line, until it is false.
template <class Visit>
void for_each_common_end(std::span<const Segment> segments, const Visit& visit) {
  std::vector<SegmentEnd> ends;
  ends.reserve(2 * segments.size());
  for (std::size_t k = 0; k < segments.size(); ++k) {
    const Segment& s = segments[k];
    if (s[0] != s[1]) {
      ends.push_back({s[0], s[1], k});
      ends.push_back({s[1], s[0], k});
    }
  }
  std::sort(ends.begin(), ends.end(), [](const SegmentEnd& a, const SegmentEnd& b) {
    const int places = compare_places(a.at, b.at);
    return places != 0 ? places < 0 : compare_lines(a.at, a.other, b.other) < 0;
  });
  for (std::size_t begin = 0; begin < ends.size();) {
    std::size_t end = begin + 1;
    while (end < ends.size() && ends[end].at == ends[begin].at &&
           compare_lines(ends[begin].at, ends[begin].other, ends[end].other) == 0) {
      ++end;
    }
    if (!visit(std::span<const SegmentEnd>(ends).subspan(begin, end - begin))) {
      return;
    }
    begin = end;
  }
}

}  // namespace

bool covers_evenly(std::span<const Segment> segments) {
  bool even = true;
  for_each_common_end(segments, [&](std::span<const SegmentEnd> ends) {
    even = ends.size() % 2 == 0;
    return even;
  });
  return even;
}

std::vector<std::uint32_t> lines_of(std::span<const Segment> segments) {
  DisjointSets sets(segments.size());
  for_each_common_end(segments, [&](std::span<const SegmentEnd> ends) {
    for (const SegmentEnd& end : ends) {
      sets.unite(static_cast<std::uint32_t>(ends.front().segment),
                 static_cast<std::uint32_t>(end.segment));
    }
    return true;
  });
  std::vector<std::uint32_t> lines(segments.size());
  for (std::uint32_t k = 0; k < lines.size(); ++k) {
    lines[k] = sets.find(k);
  }
  return lines;
}

bool cover_evenly(const MeshView& mesh, std::span<const OddEdge> edges, const Pose& pose) {
  const auto moved = [&](const OddEdge& edge) {
    return Segment{pose.apply(mesh.vertices[edge.ends[0]]),
                   pose.apply(mesh.vertices[edge.ends[1]])};
  };
  const auto first = std::find_if(edges.begin(), edges.end(), [&](const OddEdge& edge) {
    const Segment s = moved(edge);
    return edge.among_all && s[0] != s[1];
  });
  if (first == edges.end()) {
    return true;
  }
  const Segment line = moved(*first);
  std::uint64_t ends = 0;  // of edges on this line, at the first one's end
  for (const OddEdge& edge : edges) {
    const Segment s = moved(edge);
    if (edge.among_all && s[0] != s[1] && (s[0] == line[0] || s[1] == line[0])) {
      const Vec3& other = s[0] == line[0] ? s[1] : s[0];
      ends += compare_lines(line[0], line[1], other) == 0 ? 1U : 0U;
    }
  }
  if (ends % 2 != 0) {
    return false;
  }
  std::vector<Segment> segments;
  for (const OddEdge& edge : edges) {
    if (edge.among_all) {
      segments.push_back(moved(edge));
    }
  }
  return covers_evenly(segments);
}

std::vector<bool> degenerate_triangles(const MeshView& mesh, Work& work) {
  std::vector<bool> degenerate(mesh.triangles.size());
  work.run(mesh.triangles.size(), [&](std::size_t i) {
    degenerate[i] = is_degenerate(mesh.triangle(static_cast<TriangleId>(i)));
  });
  return degenerate;
}

std::vector<OddEdge> odd_edges(const MeshView& mesh, const std::vector<std::uint32_t>& joined,
                               const std::vector<bool>& degenerate, Work& work) {
  const CountedMesh counted{mesh, joined, degenerate};
  auto edges = sort_into_buckets<EdgeUse>(
      mesh.vertices.size(), mesh.triangles.size(), work,
      [&](std::size_t i, const auto& put) { counted.put_edges(i, put); });
  std::vector<OddEdge> odd;
  Uses uses(counted, odd);
  work.run(edges.size(), [&](std::size_t low) {
    const auto bucket = edges[low];
    std::sort(bucket.begin(), bucket.end());
    for (const EdgeUse& use : bucket) {
      uses.add(static_cast<std::uint32_t>(low), use);
    }
  });
  uses.finish();
  std::sort(odd.begin(), odd.end(),
            [](const OddEdge& a, const OddEdge& b) { return a.place < b.place; });
  return odd;
}

std::vector<OddEdge> odd_edges(const MeshView& mesh, const Limits& limits) {
  Work work(limits, joining_work(mesh) + mesh.triangles.size() + odd_edges_work(mesh) + 1);
  const auto joined = joined_by_position(mesh, work);
  const auto degenerate = degenerate_triangles(mesh, work);
  return odd_edges(mesh, joined, degenerate, work);
}

std::uint64_t odd_edges_work(const MeshView& mesh) {
  return 2 * std::uint64_t{mesh.triangles.size()} + mesh.vertices.size();
}

std::vector<OddEdge> odd_edges_of_run(const MeshView& mesh,
                                      const std::vector<std::uint32_t>& joined,
                                      const std::vector<bool>& degenerate, const Part& run) {
  const CountedMesh counted{mesh, joined, degenerate};
  std::vector<LooseUse> edges;
  edges.reserve(3 * std::size_t{run.count});
  for (std::size_t i = run.first; i < std::size_t{run.first} + run.count; ++i) {
    counted.put_edges(i, [&](std::uint32_t low, const EdgeUse& use) {
      edges.push_back({low, use});
    });
  }
  std::sort(edges.begin(), edges.end());
  std::vector<OddEdge> odd;
  Uses uses(counted, odd);
  for (const LooseUse& edge : edges) {
    uses.add(edge.low, edge.use);
  }
  uses.finish();
  return odd;
}

}  // namespace soms::detail
