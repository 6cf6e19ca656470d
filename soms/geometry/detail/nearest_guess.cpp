#include "soms/geometry/detail/nearest_guess.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace soms::detail {

namespace {

/// Edges by their corners.
constexpr std::array<std::array<std::size_t, 2>, 3> kEdges{{{0, 1}, {1, 2}, {2, 0}}};

/// 0 for what is below it or not a number.
double clamped(double x) {
  return std::min(std::max(0.0, x), 1.0);
}

/// The part of an edge on which `parameter` lies.
Feature part(std::size_t edge, double parameter) {
  const auto begin = static_cast<Feature>(1U << kEdges[edge][0]);
  const auto end = static_cast<Feature>(1U << kEdges[edge][1]);
  return parameter <= 0 ? begin : parameter >= 1 ? end : static_cast<Feature>(begin | end);
}

/// A face and the corner of the other triangle that is nearest to its plane, if all are on one side
/// and the foot of that corner is on the face.
struct FaceGuess {
  bool found = false;
  std::size_t corner = 0;
};

FaceGuess guess_face(const Vec3* face, const Vec3* other) {
  const Vec3 n = cross(face[1] - face[0], face[2] - face[0]);
  const std::array<double, 3> h{dot(n, other[0] - face[0]), dot(n, other[1] - face[0]),
                                dot(n, other[2] - face[0])};
  const bool above = h[0] > 0 && h[1] > 0 && h[2] > 0;
  const bool below = h[0] < 0 && h[1] < 0 && h[2] < 0;
  if (!above && !below) {
    return {};
  }
  std::size_t k = std::abs(h[1]) < std::abs(h[0]) ? 1 : 0;
  k = std::abs(h[2]) < std::abs(h[k]) ? 2 : k;
  for (const auto& [i, j] : kEdges) {
    if (!(dot(cross(face[j] - face[i], other[k] - face[i]), n) > 0)) {
      return {};
    }
  }
  return {true, k};
}

/// Edges of both triangles and what their products need.
struct EdgeSet {
  std::array<Vec3, 3> direction;
  std::array<double, 3> squared;
  std::array<double, 3> inverse;

  explicit EdgeSet(const Vec3* corners) {
    for (std::size_t i = 0; i < 3; ++i) {
      direction[i] = corners[kEdges[i][1]] - corners[kEdges[i][0]];
      squared[i] = dot(direction[i], direction[i]);
      inverse[i] = squared[i] > std::numeric_limits<double>::min() ? 1 / squared[i] : 0;
    }
  }
};

FeaturePair guess_edges(const Vec3* a, const Vec3* b) {
  const EdgeSet ea(a);
  const EdgeSet eb(b);
  double least = std::numeric_limits<double>::infinity();
  FeaturePair best{1, 1};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      const Vec3& e = ea.direction[i];
      const Vec3& f = eb.direction[j];
      const Vec3 r = b[kEdges[j][0]] - a[kEdges[i][0]];
      const double ef = dot(e, f);
      const double er = dot(e, r);
      const double fr = dot(f, r);
      // Nearest points of the lines, then each end of the segment to the other's.
      const double area = ea.squared[i] * eb.squared[j] - ef * ef;
      const double s0 = area > 0 ? clamped((er * eb.squared[j] - ef * fr) / area) : 0;
      const double t = clamped((s0 * ef - fr) * eb.inverse[j]);
      const double s = clamped((t * ef + er) * ea.inverse[i]);
      const Vec3 w = r + f * t - e * s;
      const double squared = dot(w, w);
      if (squared < least) {
        least = squared;
        best = {part(i, s), part(j, t)};
      }
    }
  }
  return best;
}

}  // namespace

FeaturePair guess_features(const std::array<Vec3, 6>& corners) {
  const Vec3* const a = corners.data();
  const Vec3* const b = a + 3;
  if (const FaceGuess guess = guess_face(a, b); guess.found) {
    return {kFace, static_cast<Feature>(1U << guess.corner)};
  }
  if (const FaceGuess guess = guess_face(b, a); guess.found) {
    return {static_cast<Feature>(1U << guess.corner), kFace};
  }
  return guess_edges(a, b);
}

FeaturePair guess_features(const AboutCorner<double>& place) {
  std::array<Vec3, 6> corners;
  for (std::size_t i = 0; i < 6; ++i) {
    corners[i] = {place.corners[i][0], place.corners[i][1], place.corners[i][2]};
  }
  return guess_features(corners);
}

FeaturePair guess_features(const Triangle& a, const Triangle& b) {
  return guess_features(AboutCorner<double>(a, b));
}

}  // namespace soms::detail
