#include "tests/support/truth/triangle_truth.h"

#include "tests/support/integer.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>

namespace soms::test {

namespace {

using Vector = std::array<Integer, 3>;
using Corners = std::array<Vector, 3>;

Vector operator-(const Vector& a, const Vector& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

Integer dot(const Vector& a, const Vector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

bool is_zero(const Vector& v) {
  return v[0].sign() == 0 && v[1].sign() == 0 && v[2].sign() == 0;
}

/// A double as an odd number times a power of two.
struct Odd {
  explicit Odd(double value) {
    int power = 0;
    number = static_cast<std::int64_t>(std::ldexp(std::frexp(value, &power), 53));
    const int zeros = number == 0 ? 0 : std::countr_zero(static_cast<std::uint64_t>(number));
    number /= std::int64_t{1} << zeros;
    exponent = power - 53 + zeros;
  }

  std::int64_t number = 0;
  int exponent = 0;
};

/// Both triangles in multiples of the largest power of two that divides all coordinates.
std::array<Corners, 2> whole(const Triangle& s, const Triangle& t) {
  const std::array<Vec3, 6> corners = {s.a, s.b, s.c, t.a, t.b, t.c};
  int least = std::numeric_limits<int>::max();
  for (const Vec3& v : corners) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const Odd odd(v[axis]);
      least = odd.number == 0 ? least : std::min(least, odd.exponent);
    }
  }
  std::array<Corners, 2> result;
  for (std::size_t i = 0; i < 6; ++i) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const Odd odd(corners[i][axis]);
      const int shift = odd.number == 0 ? 0 : odd.exponent - least;
      result[i / 3][i % 3][axis] = Integer(odd.number, static_cast<std::size_t>(shift));
    }
  }
  return result;
}

/// Least and greatest product of an axis with the corners.
struct Range {
  Range(const Vector& axis, const Corners& corners) : lower(dot(axis, corners[0])), upper(lower) {
    for (std::size_t i = 1; i < 3; ++i) {
      const Integer here = dot(axis, corners[i]);
      lower = std::min(lower, here);
      upper = std::max(upper, here);
    }
  }

  Integer lower;
  Integer upper;
};

/// True if a plane across the axis has the triangles on its two sides, and touches neither. The
/// axis 0 parts nothing.
bool parts(const Vector& axis, const Corners& s, const Corners& t) {
  const Range a(axis, s);
  const Range b(axis, t);
  return a.upper < b.lower || b.upper < a.lower;
}

}  // namespace

// The triangles are apart iff the origin is not among the differences of their points, which are a
// convex body whose edges have directions of the triangles' edges. It is apart from a body iff one
// of these parts them: the normal of a face, which is a product of two edges; where the body is
// flat, the normal of its plane (such a product too), or that of an edge within the plane; where it
// is a segment, its direction or a direction across it; where it is a point, the way to it.
bool share_a_point(const Triangle& s, const Triangle& t) {
  const std::array<Corners, 2> both = whole(s, t);
  const Corners& a = both[0];
  const Corners& b = both[1];
  const std::array<Vector, 6> edges = {a[1] - a[0], a[2] - a[0], a[2] - a[1],
                                       b[1] - b[0], b[2] - b[0], b[2] - b[1]};
  Vector normal;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    for (std::size_t j = i + 1; j < edges.size(); ++j) {
      const Vector axis = cross(edges[i], edges[j]);
      if (parts(axis, a, b)) {
        return false;
      }
      normal = is_zero(normal) ? axis : normal;
    }
  }
  const Vector direction = b[0] - a[0];
  if (!is_zero(normal)) {
    const auto leaves_plane = [&](const Vector& edge) { return dot(normal, edge).sign() != 0; };
    const auto parts_in_plane = [&](const Vector& edge) {
      return parts(cross(normal, edge), a, b);
    };
    return std::any_of(edges.begin(), edges.end(), leaves_plane) ||
           std::none_of(edges.begin(), edges.end(), parts_in_plane);
  }
  const auto proper = std::find_if_not(edges.begin(), edges.end(), is_zero);
  if (proper == edges.end()) {
    return is_zero(direction);
  }
  return !parts(*proper, a, b) && !parts(cross(*proper, cross(direction, *proper)), a, b);
}

}  // namespace soms::test
