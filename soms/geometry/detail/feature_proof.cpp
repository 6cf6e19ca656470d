#include "soms/geometry/detail/feature_proof.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace soms::detail {

namespace {

/// Squared sines of angles below this make feet unsteady, up to a factor of 3.
constexpr double kSteady = 0x1p-30;

bool surely_above(double value, double lengths) {
  return value > kSureShare * lengths;
}

/// Strictly between 0 and `whole`.
bool surely_in(double part, double lengths, double whole, double whole_lengths) {
  return surely_above(part, lengths) &&
         surely_above(whole - part, std::max(lengths, whole_lengths));
}

/// A bit for each coordinate that is not 0.
unsigned filled(const Vec3& v) {
  return (v.x != 0 ? 1U : 0U) | (v.y != 0 ? 2U : 0U) | (v.z != 0 ? 4U : 0U);
}

/// n.w is 0 without doubt.
bool surely_square(const Vec3& n, const Vec3& w) {
  return (filled(n) & filled(w)) == 0;
}

/// How the other corners lie to the planes across a segment.
enum class Parted { no, touched, surely };

class Prover {
 public:
  Prover(const Triangle& a, const Triangle& b, const FeaturePair& features)
      : triangles_{&a, &b}, features_(features) {}

  [[nodiscard]] FeatureProof prove() const {
    const int a = corner_count(features_[0]);
    const int b = corner_count(features_[1]);
    const std::size_t corner_of = a == 1 ? 0 : 1;
    return a == 1 && b == 1   ? corners()
           : a == 2 && b == 2 ? edges()
           : a + b == 3       ? corner_and_edge(corner_of)
                              : corner_and_face(corner_of);
  }

 private:
  [[nodiscard]] const Vec3& at(std::size_t t, std::size_t i) const {
    return corner(*triangles_[t], i);
  }

  [[nodiscard]] const Vec3& first(std::size_t t) const { return at(t, first_corner(features_[t])); }

  [[nodiscard]] Vec3 edge(std::size_t t) const {
    return at(t, last_corner(features_[t])) - first(t);
  }

  /// Whether all other corners are beyond the planes across n, which points from triangle `from`
  /// to the other and is made of `lengths`; those of which `in_plane` is sure may be in them.
  template <class InPlane>
  [[nodiscard]] Parted parts(const Vec3& n, double lengths, std::size_t from,
                             const InPlane& in_plane) const {
    Parted parted = Parted::surely;
    for (std::size_t t = 0; t < 2; ++t) {
      const double inward = t == from ? -1 : 1;
      for (std::size_t i = 0; i < 3; ++i) {
        if ((features_[t] >> i & 1) != 0) {
          continue;
        }
        const Vec3 w = at(t, i) - first(t);
        if (surely_above(inward * dot(n, w), lengths * safe_length(w))) {
          continue;
        }
        if (!in_plane(w)) {
          return Parted::no;
        }
        parted = Parted::touched;
      }
    }
    return parted;
  }

  [[nodiscard]] FeatureProof corners() const {
    const Vec3 r = first(1) - first(0);
    const Parted parted =
        safe_length(r) > 0
            ? parts(r, safe_length(r), 0, [&](const Vec3& w) { return surely_square(r, w); })
            : Parted::no;
    return {parted != Parted::no, parted == Parted::surely};
  }

  [[nodiscard]] FeatureProof corner_and_edge(std::size_t corner_of) const {
    const Vec3 e = edge(1 - corner_of);
    const Vec3 r = first(1 - corner_of) - first(corner_of);
    const double ee = dot(e, e);
    const double re = dot(r, e);
    const double long_e = safe_length(e);
    const double long_r = safe_length(r);
    const bool nearest = surely_in(-re, long_r * long_e, ee, long_e * long_e) &&
                         parts(r * ee - e * re, long_r * long_e * long_e, corner_of,
                               [](const Vec3&) { return false; }) == Parted::surely;
    return {nearest, nearest};
  }

  [[nodiscard]] FeatureProof corner_and_face(std::size_t corner_of) const {
    const std::size_t face_of = 1 - corner_of;
    const Vec3& tip = first(corner_of);
    const Vec3 e = at(face_of, 1) - at(face_of, 0);
    const Vec3 f = at(face_of, 2) - at(face_of, 0);
    const Vec3 r = at(face_of, 0) - tip;
    const Vec3 n = cross(e, f);
    const double lengths = safe_length(e) * safe_length(f);
    const double height = dot(n, r);
    if (!surely_above(std::abs(height), lengths * safe_length(r))) {
      return {};
    }
    const Parted parted = parts(height > 0 ? n : -n, lengths, corner_of,
                                [&](const Vec3& w) { return surely_coplanar(e, f, w); });
    if (parted == Parted::no) {
      return {};
    }
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3 side = at(face_of, (i + 1) % 3) - at(face_of, i);
      const Vec3 w = tip - at(face_of, i);
      if (!surely_above(dot(cross(side, w), n), safe_length(side) * safe_length(w) * lengths)) {
        return {};
      }
    }
    const bool alone = parted == Parted::surely;
    return {true, alone && dot(n, n) > kSteady * lengths * lengths};
  }

  [[nodiscard]] FeatureProof edges() const {
    const Vec3 e = edge(0);
    const Vec3 f = edge(1);
    const Vec3 r = first(1) - first(0);
    const Vec3 n = cross(e, f);
    const double long_r = safe_length(r);
    const double lengths = safe_length(e) * safe_length(f);
    const double height = dot(n, r);
    if (!surely_above(std::abs(height), lengths * long_r)) {
      return {};
    }
    const Parted parted = parts(height > 0 ? n : -n, lengths, 0,
                                [&](const Vec3& w) { return surely_coplanar(e, f, w); });
    if (parted == Parted::no) {
      return {};
    }
    const double nn = dot(n, n);
    const bool nearest =
        surely_in(dot(cross(r, f), n), long_r * safe_length(f) * lengths, nn, lengths * lengths) &&
        surely_in(dot(cross(r, e), n), long_r * safe_length(e) * lengths, nn, lengths * lengths);
    const bool alone = nearest && parted == Parted::surely;
    return {nearest, alone && nn > kSteady * lengths * lengths};
  }

  std::array<const Triangle*, 2> triangles_;
  FeaturePair features_;
};

}  // namespace

bool surely_coplanar(const Vec3& e, const Vec3& f, const Vec3& w) {
  const unsigned in_e = filled(e);
  const unsigned in_f = filled(f);
  const unsigned in_w = filled(w);
  const auto product = [&](unsigned i, unsigned j, unsigned k) {
    return (in_e >> i & in_f >> j & in_w >> k & 1U) != 0;
  };
  return !(product(0, 1, 2) || product(0, 2, 1) || product(1, 0, 2) || product(1, 2, 0) ||
           product(2, 0, 1) || product(2, 1, 0));
}

FeatureProof prove(const Triangle& a, const Triangle& b, const FeaturePair& features) {
  return Prover(a, b, features).prove();
}

}  // namespace soms::detail
