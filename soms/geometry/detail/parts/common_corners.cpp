#include "soms/geometry/detail/parts/common_corners.h"

#include <array>
#include <utility>

namespace soms::detail {

namespace {

/// A triangle, segment or point: corners of one of the pair's triangles, none between others.
struct Simplex {
  const ExactPair* pair = nullptr;
  std::size_t triangle = 0;
  std::array<std::size_t, 3> corners = {};
  std::size_t size = 0;
  IntegerVec normal;  ///< of a triangle

  Simplex(const ExactPair& of, std::size_t which, Feature feature) : pair(&of), triangle(which) {
    for (std::size_t i = 0; i < 3; ++i) {
      if ((feature >> i & 1) != 0 && !holds(i)) {
        corners[size++] = i;
      }
    }
    if (size == 3) {
      normal = cross(at(1) - at(0), at(2) - at(0));
      if (is_zero(normal)) {
        drop_middle();
      }
    }
  }

  [[nodiscard]] const IntegerVec& at(std::size_t i) const { return pair->at(triangle, corners[i]); }

  /// Number of edges, of which the i-th runs from corner i to i + 1.
  [[nodiscard]] std::size_t edges() const { return size == 3 ? 3 : size - 1; }

  [[nodiscard]] Share share(std::size_t edge, Integer part, Integer whole) const {
    return {corners[edge], corners[(edge + 1) % size], std::move(part), std::move(whole)};
  }

 private:
  /// Whether one of the corners so far has the same coordinates.
  [[nodiscard]] bool holds(std::size_t i) const {
    for (std::size_t k = 0; k < size; ++k) {
      if (is_zero(at(k) - pair->at(triangle, i))) {
        return true;
      }
    }
    return false;
  }

  /// Of three corners on a line.
  void drop_middle() {
    std::size_t middle = 0;
    while (dot(at((middle + 1) % 3) - at(middle), at((middle + 2) % 3) - at(middle)).sign() > 0) {
      ++middle;
    }
    std::swap(corners[middle], corners[2]);
    size = 2;
  }
};

/// Relations of points and simplices in space, or as seen along a direction.
class View {
 public:
  explicit View(const std::optional<IntegerVec>& n) : n_(n ? &*n : nullptr) {}

  [[nodiscard]] bool same(const IntegerVec& p, const IntegerVec& q) const {
    const IntegerVec d = p - q;
    return is_zero(n_ == nullptr ? d : cross(d, *n_));
  }

  [[nodiscard]] bool is_in(const IntegerVec& p, const Simplex& s) const {
    if (s.size == 1) {
      return same(p, s.at(0));
    }
    return s.size == 2 ? is_on_segment(p, s) : is_on_face(p, s);
  }

  /// Points in the plane of a face, or of two edges that are not parallel, need no more.
  [[nodiscard]] bool is_level(const Integer& height) const {
    return n_ != nullptr || height.sign() == 0;
  }

  [[nodiscard]] bool is_flat() const { return n_ != nullptr; }

 private:
  [[nodiscard]] bool is_on_segment(const IntegerVec& p, const Simplex& s) const {
    const IntegerVec e = s.at(1) - s.at(0);
    const IntegerVec d = p - s.at(0);
    const IntegerVec turn = cross(d, e);
    const bool on_line = n_ == nullptr ? is_zero(turn) : dot(turn, *n_).sign() == 0;
    if (!on_line) {
      return false;
    }
    const Integer along = dot(d, e);
    return along.sign() >= 0 && along <= dot(e, e);
  }

  [[nodiscard]] bool is_on_face(const IntegerVec& p, const Simplex& s) const {
    if (!is_level(dot(p - s.at(0), s.normal))) {
      return false;
    }
    for (std::size_t i = 0; i < 3; ++i) {
      const IntegerVec& begin = s.at(i);
      if (dot(cross(s.at((i + 1) % 3) - begin, p - begin), s.normal).sign() < 0) {
        return false;
      }
    }
    return true;
  }

  const IntegerVec* n_;
};

Share whole_corner(std::size_t i) {
  return {i, i, Integer(), Integer(1)};
}

using Corners = std::vector<CommonCorner>;

void add_corners(const View& view, const Simplex& a, const Simplex& b, Corners& out) {
  for (std::size_t i = 0; i < a.size; ++i) {
    if (view.is_in(a.at(i), b)) {
      out.push_back({whole_corner(a.corners[i]), {}});
    }
  }
  for (std::size_t j = 0; j < b.size; ++j) {
    bool is_new = view.is_in(b.at(j), a);
    for (std::size_t i = 0; i < a.size; ++i) {
      is_new = is_new && !view.same(a.at(i), b.at(j));
    }
    if (is_new) {
      out.push_back({{}, whole_corner(b.corners[j])});
    }
  }
}

bool strictly_in_unit(const Integer& part, const Integer& whole) {
  return part.sign() > 0 && part < whole;
}

/// Points inside of two edges.
void add_edge_crossings(const View& view, const Simplex& a, const Simplex& b, Corners& out) {
  for (std::size_t i = 0; i < a.edges(); ++i) {
    const IntegerVec e = a.at((i + 1) % a.size) - a.at(i);
    for (std::size_t j = 0; j < b.edges(); ++j) {
      const IntegerVec f = b.at((j + 1) % b.size) - b.at(j);
      const IntegerVec r = b.at(j) - a.at(i);
      const IntegerVec n = cross(e, f);
      const Integer whole = dot(n, n);
      if (whole.sign() == 0 || !view.is_level(dot(r, n))) {
        continue;
      }
      Integer s = dot(cross(r, f), n);
      Integer t = dot(cross(r, e), n);
      if (strictly_in_unit(s, whole) && strictly_in_unit(t, whole)) {
        out.push_back({a.share(i, std::move(s), whole), b.share(j, std::move(t), whole)});
      }
    }
  }
}

/// Points inside of an edge and of the face that it passes through.
void add_face_crossings(const Simplex& edges, const Simplex& face, bool edges_first, Corners& out) {
  for (std::size_t i = 0; i < edges.edges(); ++i) {
    const IntegerVec& p = edges.at(i);
    const IntegerVec& q = edges.at((i + 1) % edges.size);
    Integer begin = dot(p - face.at(0), face.normal);
    const Integer end = dot(q - face.at(0), face.normal);
    if (begin.sign() * end.sign() >= 0) {
      continue;
    }
    // The edge passes all three edges of the face on the same side, as seen along it.
    std::array<int, 3> side;
    for (std::size_t k = 0; k < 3; ++k) {
      const IntegerVec& c = face.at(k);
      side[k] = dot(cross(face.at((k + 1) % 3) - c, p - c), q - p).sign();
    }
    if (side[0] == 0 || side[0] != side[1] || side[0] != side[2]) {
      continue;
    }
    Integer whole = begin - end;
    Share share = edges.share(i, std::move(begin), std::move(whole));
    out.push_back(edges_first ? CommonCorner{std::move(share), {}}
                              : CommonCorner{{}, std::move(share)});
  }
}

/// All corners of a triangle that are as far along `n` as a feature.
Feature level_corners(const ExactPair& pair, std::size_t triangle, Feature feature,
                      const IntegerVec& n) {
  unsigned all = feature;
  const IntegerVec& foot = pair.at(triangle, first_corner(feature));
  for (std::size_t i = 0; i < 3; ++i) {
    if ((feature >> i & 1) == 0 && dot(n, pair.at(triangle, i) - foot).sign() == 0) {
      all |= 1U << i;
    }
  }
  return static_cast<Feature>(all);
}

}  // namespace

IntegerVec direction(const ExactPair& pair, const FeaturePair& features) {
  const auto edge = [&](std::size_t t) {
    return pair.at(t, last_corner(features[t])) - pair.at(t, first_corner(features[t]));
  };
  for (std::size_t t = 0; t < 2; ++t) {
    if (features[t] == kFace) {
      return cross(pair.at(t, 1) - pair.at(t, 0), pair.at(t, 2) - pair.at(t, 0));
    }
  }
  const IntegerVec r =
      pair.at(1, first_corner(features[1])) - pair.at(0, first_corner(features[0]));
  const bool edge_a = corner_count(features[0]) == 2;
  if (edge_a && corner_count(features[1]) == 2) {
    return cross(edge(0), edge(1));
  }
  if (!edge_a && corner_count(features[1]) == 1) {
    return r;
  }
  const IntegerVec e = edge(edge_a ? 0 : 1);
  return r * dot(e, e) - e * dot(r, e);
}

std::vector<CommonCorner> common_corners(const ExactPair& pair, const FeaturePair& features,
                                         const std::optional<IntegerVec>& n) {
  const auto simplex = [&](std::size_t t) {
    return Simplex(pair, t, n ? level_corners(pair, t, features[t], *n) : kFace);
  };
  const Simplex a = simplex(0);
  const Simplex b = simplex(1);
  const View view(n);
  Corners corners;
  add_corners(view, a, b, corners);
  add_edge_crossings(view, a, b, corners);
  if (!view.is_flat()) {
    if (b.size == 3) {
      add_face_crossings(a, b, true, corners);
    }
    if (a.size == 3) {
      add_face_crossings(b, a, false, corners);
    }
  }
  return corners;
}

}  // namespace soms::detail
