#include "soms/geometry/defects.h"

#include "soms/base/arithmetic.h"
#include "soms/geometry/detail/parts/buckets.h"
#include "soms/geometry/detail/parts/joined.h"
#include "soms/geometry/detail/parts/part_work.h"
#include "soms/geometry/orientation.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <tuple>
#include <vector>

namespace soms {

namespace {

using detail::Least;
using detail::Work;
using CornerNames = std::array<std::uint32_t, 3>;

bool collinear(const Triangle& t) {
  return orientation2d(t.a, t.b, t.c, Projection::xy) == Sign::zero &&
         orientation2d(t.a, t.b, t.c, Projection::yz) == Sign::zero &&
         orientation2d(t.a, t.b, t.c, Projection::zx) == Sign::zero;
}

/// Names of vertices: those in one place share one, or each has its own.
class Names {
 public:
  explicit Names(const std::vector<std::uint32_t>* joined) : joined_(joined) {}

  [[nodiscard]] std::uint32_t operator()(std::uint32_t v) const {
    return joined_ == nullptr ? v : (*joined_)[v];
  }

  [[nodiscard]] CornerNames operator()(const CornerNames& t) const {
    return {(*this)(t[0]), (*this)(t[1]), (*this)(t[2])};
  }

 private:
  const std::vector<std::uint32_t>* joined_;
};

void count_vertices(const MeshView& mesh, const std::vector<std::uint32_t>& joined,
                    std::size_t most, Work& work, Defects& defects) {
  work.run(mesh.vertices.size(), [&](std::size_t i) {
    const auto v = static_cast<std::uint32_t>(i);
    if (joined[i] == detail::kUnused) {
      if (defects.unused_vertices++ < most) {
        defects.places.unused_vertices.push_back(v);
      }
    } else if (joined[i] != v && defects.repeated_vertices++ < most) {
      defects.places.repeated_vertices.push_back({v, joined[i]});
    }
  });
}

/// Finds the triangles without area, by number.
std::vector<bool> count_degenerate(const MeshView& mesh, const Names& names, std::size_t most,
                                   Work& work, Defects& defects) {
  std::vector<bool> degenerate(mesh.triangles.size());
  work.run(mesh.triangles.size(), [&](std::size_t i) {
    const auto triangle = static_cast<TriangleId>(i);
    const auto [a, b, c] = names(mesh.triangles[i]);
    if (a == b || b == c || c == a) {
      degenerate[i] = true;
      if (defects.repeated_corner++ < most) {
        defects.places.repeated_corner.push_back(triangle);
      }
    } else if (collinear(mesh.triangle(triangle))) {
      degenerate[i] = true;
      if (defects.places.collinear.size() < most) {
        defects.places.collinear.push_back(triangle);
      }
    }
    defects.degenerate += static_cast<std::uint64_t>(degenerate[i]);
  });
  return degenerate;
}

/// A triangle in the bucket of its least corner.
struct CornerKey {
  std::uint32_t middle;
  std::uint32_t greatest;
  TriangleId triangle;

  [[nodiscard]] bool same_corners(const CornerKey& k) const {
    return middle == k.middle && greatest == k.greatest;
  }

  [[nodiscard]] bool operator<(const CornerKey& k) const {
    return std::tie(middle, greatest, triangle) < std::tie(k.middle, k.greatest, k.triangle);
  }
};

/// True if the corners, sorted, turn the other way than they stand.
bool turned(const CornerNames& t) {
  return (t[0] > t[1]) != (t[1] > t[2]) ? t[0] < t[2] : t[0] > t[2];
}

void count_duplicates(const MeshView& mesh, const Names& names, const std::vector<bool>& degenerate,
                      std::size_t most, Work& work, Defects& defects) {
  auto keys = detail::sort_into_buckets<CornerKey>(
      mesh.vertices.size(), mesh.triangles.size(), work, [&](std::size_t i, const auto& put) {
        CornerNames t = names(mesh.triangles[i]);
        std::sort(t.begin(), t.end());
        put(t[0], CornerKey{t[1], t[2], static_cast<TriangleId>(i)});
      });
  Least<TriangleCopy> duplicate(most);
  Least<TriangleCopy> doubled(most);
  work.run(keys.size(), [&](std::size_t k) {
    const auto bucket = keys[k];
    std::sort(bucket.begin(), bucket.end());
    std::array<bool, 2> seen{};
    for (std::size_t i = 0, first = 0; i < bucket.size(); ++i) {
      if (!bucket[i].same_corners(bucket[first])) {
        first = i;
      }
      const TriangleId triangle = bucket[i].triangle;
      const auto side = static_cast<std::size_t>(turned(names(mesh.triangles[triangle])));
      if (i == first) {
        seen = {};
      } else {
        const TriangleCopy copy{triangle, bucket[first].triangle};
        ++defects.duplicate;
        duplicate.add(copy);
        if (!degenerate[triangle] && !seen[side]) {
          ++defects.doubled;
          doubled.add(copy);
        }
      }
      seen[side] = true;
    }
  });
  defects.places.duplicate = duplicate.take();
  defects.places.doubled = doubled.take();
}

/// An edge as a triangle runs along it, in the bucket of its lesser end.
struct Use {
  std::uint32_t end_and_side = 0;  ///< twice the greater end, and 1 if the triangle begins there
  TriangleId triangle = 0;

  [[nodiscard]] std::uint32_t end() const { return end_and_side >> 1; }

  [[nodiscard]] bool begins_there() const { return (end_and_side & 1U) != 0; }

  [[nodiscard]] bool operator<(const Use& u) const {
    return end() != u.end() ? end() < u.end() : triangle < u.triangle;
  }
};

/// Where the three kinds of edges are, for as many as are requested.
struct EdgePlaces {
  Least<EdgePlace> open;
  Least<EdgePlace> non_manifold;
  Least<EdgePlace> flipped;
};

/// Puts the edges of a triangle as (lesser end, use).
template <class Put>
void put_edges(const CornerNames& t, TriangleId triangle, const Put& put) {
  for (std::size_t c = 0; c < 3; ++c) {
    const std::uint32_t from = t[c];
    const std::uint32_t to = t[(c + 1) % 3];
    put(std::min(from, to), Use{2 * std::max(from, to) + (from > to ? 1U : 0U), triangle});
  }
}

EdgePlace place_of(const CornerNames& t, std::uint32_t low, std::span<const Use> uses) {
  const std::uint32_t from = uses[0].begins_there() ? uses[0].end() : low;
  const auto corner = static_cast<std::uint32_t>(std::find(t.begin(), t.end(), from) - t.begin());
  return {uses[0].triangle, corner, uses[uses.size() > 1 ? 1 : 0].triangle,
          static_cast<std::uint32_t>(uses.size())};
}

/// Counts the edges of all proper triangles; `places` may be null.
EdgeCounts count_edges(const MeshView& mesh, const Names& names,
                       const std::vector<bool>& degenerate, EdgePlaces* places, Work& work) {
  auto edges = detail::sort_into_buckets<Use>(
      mesh.vertices.size(), mesh.triangles.size(), work, [&](std::size_t i, const auto& put) {
        if (!degenerate[i]) {
          put_edges(names(mesh.triangles[i]), static_cast<TriangleId>(i), put);
        }
      });
  EdgeCounts counts{.none = edges.items.empty()};
  const auto tell = [&](std::uint64_t& count, Least<EdgePlace> EdgePlaces::*kind, std::size_t low,
                        std::span<const Use> uses) {
    ++count;
    if (places != nullptr) {
      const CornerNames t = names(mesh.triangles[uses[0].triangle]);
      (places->*kind).add(place_of(t, static_cast<std::uint32_t>(low), uses));
    }
  };
  work.run(edges.size(), [&](std::size_t low) {
    const auto bucket = edges[low];
    std::sort(bucket.begin(), bucket.end());
    for (std::size_t begin = 0; begin < bucket.size();) {
      std::size_t end = begin + 1;
      while (end < bucket.size() && bucket[end].end() == bucket[begin].end()) {
        ++end;
      }
      const auto uses = bucket.subspan(begin, end - begin);
      if (uses.size() == 1) {
        tell(counts.open, &EdgePlaces::open, low, uses);
      } else if (uses.size() > 2) {
        tell(counts.non_manifold, &EdgePlaces::non_manifold, low, uses);
      } else if (uses[0].begins_there() == uses[1].begins_there()) {
        tell(counts.flipped, &EdgePlaces::flipped, low, uses);
      }
      begin = end;
    }
  });
  return counts;
}

/// Counts the edges of a run of triangles by sorting them alone.
EdgeCounts count_part(const MeshView& mesh, const Part& part, const Names& names,
                      const std::vector<bool>& degenerate) {
  std::vector<std::uint64_t> edges;  // lesser end, greater end, way
  edges.reserve(3 * std::size_t{part.count});
  for (std::size_t i = part.first; i < std::size_t{part.first} + part.count; ++i) {
    if (!degenerate[i]) {
      put_edges(names(mesh.triangles[i]), 0, [&](std::uint32_t low, const Use& use) {
        edges.push_back(std::uint64_t{low} << 32 | use.end_and_side);
      });
    }
  }
  std::sort(edges.begin(), edges.end());
  EdgeCounts counts{.none = edges.empty()};
  for (std::size_t begin = 0; begin < edges.size();) {
    std::size_t end = begin + 1;
    while (end < edges.size() && edges[end] >> 1 == edges[begin] >> 1) {
      ++end;
    }
    const std::size_t uses = end - begin;
    counts.open += static_cast<std::uint64_t>(uses == 1);
    counts.non_manifold += static_cast<std::uint64_t>(uses > 2);
    counts.flipped += static_cast<std::uint64_t>(uses == 2 && edges[begin] == edges[begin + 1]);
    begin = end;
  }
  return counts;
}

std::vector<EdgeCounts> count_parts(const MeshView& mesh, const Names& names,
                                    const std::vector<bool>& degenerate, const EdgeCounts& whole,
                                    Work& work) {
  std::vector<EdgeCounts> counts;
  counts.reserve(mesh.parts.size());
  for (const Part& part : mesh.parts) {
    const bool all = part.count == mesh.triangles.size();
    counts.push_back(all ? whole : count_part(mesh, part, names, degenerate));
    work.skip(part.count);
  }
  return counts;
}

}  // namespace

Defects find_defects(const MeshView& mesh, const DefectOptions& options, const Limits& limits) {
  const PlainArithmetic plain;
  Defects defects;
  const std::uint64_t vertices = mesh.vertices.size();
  const std::uint64_t triangles = mesh.triangles.size();
  const std::uint64_t of_edges = 2 * triangles + vertices;
  const std::optional<std::uint64_t> of_parts =
      options.parts ? detail::part_work(mesh) : std::nullopt;
  Work work(limits, detail::joining_work(mesh) + vertices + triangles + 3 * of_edges +
                        of_parts.value_or(0) + 1);
  const std::vector<std::uint32_t> joined = detail::joined_by_position(mesh, work);
  const Names by_position(&joined);
  count_vertices(mesh, joined, options.places, work, defects);
  const std::vector<bool> degenerate =
      count_degenerate(mesh, by_position, options.places, work, defects);
  count_duplicates(mesh, by_position, degenerate, options.places, work, defects);
  EdgePlaces places{Least<EdgePlace>(options.places), Least<EdgePlace>(options.places),
                    Least<EdgePlace>(options.places)};
  const EdgeCounts whole = count_edges(mesh, by_position, degenerate, &places, work);
  defects.open_edges = whole.open;
  defects.non_manifold_edges = whole.non_manifold;
  defects.flipped_edges = whole.flipped;
  defects.places.open_edges = places.open.take();
  defects.places.non_manifold_edges = places.non_manifold.take();
  defects.places.flipped_edges = places.flipped.take();
  if (defects.repeated_vertices == 0) {
    defects.by_index = whole;
    work.skip(of_edges);
  } else {
    defects.by_index = count_edges(mesh, Names(nullptr), degenerate, nullptr, work);
  }
  if (of_parts) {
    defects.parts = count_parts(mesh, by_position, degenerate, whole, work);
  }
  return defects;
}

}  // namespace soms
