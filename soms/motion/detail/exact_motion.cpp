#include "soms/motion/detail/exact_motion.h"

#include "soms/base/portable.h"
#include "soms/geometry/detail/exact/exact_ray.h"
#include "soms/geometry/detail/exact/grid.h"
#include "soms/motion/detail/exact/first_moment.h"
#include "soms/motion/detail/exact/sure_parting.h"
#include "soms/motion/detail/exact/turn_polynomials.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace soms::detail {

namespace {

using IntegerCorners = std::array<IntegerVec, 3>;

/// Corners of a triangle that an edge joins.
using EdgeEnds = std::array<std::size_t, 2>;

/// A triangle by the features that it has: of a segment its two ends, of a point one corner.
struct TriangleFeatures {
  IntegerCorners at;
  std::vector<std::size_t> corners;
  std::vector<EdgeEnds> edges;
  bool face = false;

  explicit TriangleFeatures(IntegerCorners places) : at(std::move(places)) {
    constexpr std::array<EdgeEnds, 3> kAll{{{0, 1}, {1, 2}, {2, 0}}};
    face = !is_zero(cross(at[1] - at[0], at[2] - at[0]));
    if (face) {
      corners = {0, 1, 2};
      edges.assign(kAll.begin(), kAll.end());
      return;
    }
    EdgeEnds longest{0, 0};
    Integer most;
    for (const EdgeEnds& ends : kAll) {
      const IntegerVec along = at[ends[1]] - at[ends[0]];
      const Integer square = dot(along, along);
      if (square > most) {
        longest = ends;
        most = square;
      }
    }
    corners = {0};
    if (most.sign() > 0) {
      corners = {longest[0], longest[1]};
      edges = {longest};
    }
  }

  [[nodiscard]] IntegerVec along(const EdgeEnds& ends) const { return at[ends[1]] - at[ends[0]]; }
};

/// All places of a pair on one grid.
struct TurnGrid {
  int unit = 0;
  IntegerCorners moving;
  IntegerCorners resting;

  TurnGrid(const RigidMotion& motion, const Triangle& body, const Triangle& world) {
    const std::array<Vec3, 9> places{body.a,           body.b,  body.c,         world.a,
                                     world.b,          world.c, motion.pivot(), motion.pivot_from(),
                                     motion.pivot_to()};
    std::array<Odd, 27> odds;
    for (std::size_t i = 0; i < places.size(); ++i) {
      put_odds(places[i], &odds[3 * i]);
    }
    unit = unit_of(odds);
    for (std::size_t i = 0; i < 3; ++i) {
      moving[i] = on_grid(&odds[3 * i], unit);
      resting[i] = on_grid(&odds[9 + 3 * i], unit);
    }
  }
};

IntegerVec place_at_begin(const PolynomialVec& place) {
  return {place[0].at(0), place[1].at(0), place[2].at(0)};
}

/// An edge of one meets the other.
bool edges_meet(const TriangleFeatures& of, const IntegerCorners& one,
                const IntegerCorners& other) {
  for (const EdgeEnds& ends : of.edges) {
    const IntegerVec& start = one[ends[0]];
    const ExactRay ray({other[0] - start, other[1] - start, other[2] - start}, 0,
                       one[ends[1]] - start, 0, 1);
    if (ray.hit()) {
      return true;
    }
  }
  return false;
}

/// Two edges, one of which moves, where the other rests. With W from the start of the one that
/// rests to that of the other, and U and V the directions of the moving and the resting one, the
/// volume is W.(U x V). Where that is 0, the moving one meets the line of the other at the part
/// (V x W).(U x V) / |U x V|^2 of itself.
class EdgeCrossing {
 public:
  EdgeCrossing(PolynomialVec w, const PolynomialVec& u, IntegerVec v)
      : w_(std::move(w)), v_(std::move(v)), across_(cross(u, v_)), volume_(dot(w_, across_)) {}

  [[nodiscard]] const IntegerPolynomial& volume() const { return volume_; }

  [[nodiscard]] IntegerPolynomial part() const {
    return IntegerPolynomial() - dot(cross(w_, v_), across_);
  }

  [[nodiscard]] IntegerPolynomial whole() const { return dot(across_, across_); }

 private:
  PolynomialVec w_;
  IntegerVec v_;
  PolynomialVec across_;  ///< U x V
  IntegerPolynomial volume_;
};

/// One pair of triangles over a stretch of time.
class ExactTurn {
 public:
  ExactTurn(const RigidMotion& motion, const TurnGrid& grid, double from, double until)
      : from_(from),
        until_(until),
        law_(motion, from, until, grid.unit),
        moving_(grid.moving),
        resting_(grid.resting) {
    for (std::size_t i = 0; i < 3; ++i) {
      moved_[i] = law_.moved(moving_.at[i]);
      seen_[i] = law_.seen(resting_.at[i]);
    }
  }

  [[nodiscard]] std::optional<Bracket> first() {
    if (cross_at_begin()) {
      return Bracket{from_, from_};
    }
    look_at_corners();
    look_at_edges();
    return first_;
  }

 private:
  /// An edge of one meets the other: what triangles of any shape do that share a point, unless one
  /// of them is a point.
  [[nodiscard]] bool cross_at_begin() const {
    IntegerCorners x;
    IntegerCorners y;
    const Integer scale = law_.squared().at(0);
    for (std::size_t i = 0; i < 3; ++i) {
      x[i] = place_at_begin(moved_[i]);
      y[i] = resting_.at[i] * scale;
    }
    return edges_meet(moving_, x, y) || edges_meet(resting_, y, x);
  }

  /// From a place that rests to one that moves, as polynomials.
  [[nodiscard]] PolynomialVec from_place(const IntegerVec& rests,
                                         const PolynomialVec& moves) const {
    return moves - rests * law_.squared();
  }

  void look_at_corners() {
    for (const std::size_t corner : moving_.corners) {
      look_at_corner(moved_[corner], resting_);
    }
    for (const std::size_t corner : resting_.corners) {
      look_at_corner(seen_[corner], moving_);
    }
  }

  /// A corner that moves, where the other triangle rests.
  void look_at_corner(const PolynomialVec& corner, const TriangleFeatures& other) {
    if (other.face) {
      look_at_face(corner, other);
    } else if (!moving_.face && !resting_.face) {
      look_at_segment(corner, other);
    }
  }

  void look_at_face(const PolynomialVec& corner, const TriangleFeatures& other) {
    const IntegerVec normal = cross(other.along({0, 1}), other.along({0, 2}));
    MomentConditions conditions;
    conditions.zero.push_back(dot(from_place(other.at[0], corner), normal));
    for (const EdgeEnds& ends : other.edges) {
      const IntegerVec inward = cross(normal, other.along(ends));
      conditions.not_negative.push_back(dot(from_place(other.at[ends[0]], corner), inward));
    }
    add(conditions);
  }

  void look_at_edges() {
    for (const EdgeEnds& x : moving_.edges) {
      for (const EdgeEnds& y : resting_.edges) {
        look_at_crossing(x, y);
      }
    }
  }

  void look_at_crossing(const EdgeEnds& x, const EdgeEnds& y) {
    const IntegerVec along_x = moving_.along(x);
    const IntegerVec along_y = resting_.along(y);
    const EdgeCrossing in_world(from_place(resting_.at[y[0]], moved_[x[0]]), law_.turned(along_x),
                                along_y);
    if (sure_sign(in_world.volume()) != 0) {
      return;
    }
    const EdgeCrossing in_body(from_place(moving_.at[x[0]], seen_[y[0]]), law_.turned_back(along_y),
                               along_x);
    MomentConditions conditions;
    conditions.zero.push_back(in_world.volume());
    // U x V is as long in both frames, and W is 2^k times too large beside U.
    const IntegerPolynomial whole = in_world.whole() * Integer(1, law_.halvings());
    for (const EdgeCrossing* crossing : {&in_world, &in_body}) {
      IntegerPolynomial part = crossing->part();
      conditions.not_negative.push_back(whole - part);
      conditions.not_negative.push_back(std::move(part));
    }
    conditions.nonzero = whole;
    add(conditions);
  }

  /// A segment or a point.
  void look_at_segment(const PolynomialVec& corner, const TriangleFeatures& other) {
    MomentConditions conditions;
    const PolynomialVec place = from_place(other.at[other.corners[0]], corner);
    if (other.edges.empty()) {
      conditions.zero.assign(place.begin(), place.end());
    } else {
      const IntegerVec along = other.along(other.edges[0]);
      const PolynomialVec beside = cross(place, along);
      conditions.zero.assign(beside.begin(), beside.end());
      const IntegerPolynomial part = dot(place, along);
      conditions.not_negative.push_back(part);
      conditions.not_negative.push_back(law_.squared() * dot(along, along) - part);
    }
    add(conditions);
  }

  void add(const MomentConditions& conditions) {
    for (const UnitRoot& moment : first_moments(conditions)) {
      const Bracket next = bracket_of(moment);
      if (!first_ || next.lower < first_->lower ||
          (next.lower == first_->lower && next.upper < first_->upper)) {
        first_ = next;
      }
    }
  }

  /// By halving the doubles from `from` to `until`, whose bits are in the order of their values.
  [[nodiscard]] Bracket bracket_of(const UnitRoot& moment) const {
    const auto order = [&](double t) {
      const StretchTime at = stretch_time(from_, until_, t);
      return moment.compare(at.above, at.below);
    };
    auto below = bit_cast<std::uint64_t>(from_ + 0.0);
    auto beyond = bit_cast<std::uint64_t>(until_) + 1;
    while (beyond - below > 1) {
      const std::uint64_t middle = below + (beyond - below) / 2;
      (order(bit_cast<double>(middle)) < 0 ? beyond : below) = middle;
    }
    const double lower = bit_cast<double>(below);
    return {lower, order(lower) == 0 ? lower : std::nextafter(lower, 2.0)};
  }

  double from_;
  double until_;
  TurnPolynomials law_;
  TriangleFeatures moving_;
  TriangleFeatures resting_;
  std::array<PolynomialVec, 3> moved_;
  std::array<PolynomialVec, 3> seen_;
  std::optional<Bracket> first_;
};

}  // namespace

std::optional<Bracket> exact_motion(const RigidMotion& motion, const Triangle& moving,
                                    const Triangle& resting, double from, double until) {
  if (surely_parted(motion, moving, resting, from, until)) {
    return std::nullopt;
  }
  return ExactTurn(motion, TurnGrid(motion, moving, resting), from, until).first();
}

}  // namespace soms::detail
