#include "soms/scene/reference/clearance_along.h"

#include "soms/base/arithmetic.h"
#include "soms/base/text.h"
#include "soms/query/reference/distance.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace soms::reference {

namespace {

/// The rotation that leads from one pose to another, in the coordinates of the body: its axis, and
/// the angle from 0 to pi.
struct Turn {
  Vec3 axis;
  double angle = 0;
};

Turn turn_between(const Pose& from, const Pose& to) {
  double r[3][3];
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      r[i][j] = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        r[i][j] += from.m[4 * k + i] * to.m[4 * k + j];
      }
    }
  }
  const Vec3 twice{r[2][1] - r[1][2], r[0][2] - r[2][0], r[1][0] - r[0][1]};
  const double sine = std::sqrt(dot(twice, twice)) / 2;
  const double cosine = (r[0][0] + r[1][1] + r[2][2] - 1) / 2;
  const double angle = std::atan2(sine, cosine);
  if (sine > 1e-3 || cosine > 0) {
    return {twice, angle};
  }
  // Near a half turn, the rows of R + I tell the axis, and the antisymmetric part its sign.
  std::size_t most = 0;
  for (std::size_t i = 1; i < 3; ++i) {
    most = r[i][i] > r[most][most] ? i : most;
  }
  Vec3 axis;
  for (std::size_t j = 0; j < 3; ++j) {
    axis[j] = (r[most][j] + r[j][most]) / 2 + (j == most ? 1 : 0);
  }
  return {dot(axis, twice) < 0 ? -axis : axis, angle};
}

class Checker {
 public:
  Checker(const Clearance& answer, const Shape& mover, const MotionPath& path,
          std::span<const Body> fixed, const ClearanceOptions& options, const Limits& limits)
      : answer_(answer),
        mover_(mover),
        path_(path),
        fixed_(fixed),
        options_(options),
        limits_(limits) {}

  void check_same(const ClearanceStation& station) {
    const Pose pose =
        path_.segments() == 0 ? path_.poses.front() : pose_at(path_, station.segment, station.t);
    const ClearanceStation truth = query(pose);
    const bool same = station.pose == pose && station.gap == truth.gap &&
                      station.body == truth.body && station.triangles == truth.triangles;
    note(same, station.chainage,
         "the gap is " + shortest(truth.gap.lower) + ", not " + shortest(station.gap.lower) +
             ", or another is the nearest");
  }

  void check_between(std::size_t stretch, std::size_t samples) {
    const ClearanceStretch& known = answer_.stretches[stretch];
    const ClearanceStation& from = answer_.stations[stretch];
    const ClearanceStation& to = answer_.stations[stretch + 1];
    const double end = to.segment == from.segment ? to.t : 1;
    const double length = to.chainage - from.chainage;
    for (std::size_t k = 0; k < samples; ++k) {
      const double share = static_cast<double>(k + 1) / static_cast<double>(samples + 1);
      const double t = from.t + share * (end - from.t);
      const double gap = query(pose_by_angle(path_, from.segment, t)).gap.upper;
      const double chainage = from.chainage + share * length;
      note(gap >= known.at_least, chainage,
           "the gap is " + shortest(gap) + ", below " + shortest(known.at_least));
      note(known.below.upper > 0 || length == 0 || !(gap < options_.clearance), chainage,
           "the gap is " + shortest(gap) + ", and none should be below the clearance");
      note(known.below.lower < length * (1 - 1e-9) || length == 0 || gap < options_.clearance,
           chainage, "the gap is " + shortest(gap) + ", and all should be below the clearance");
      note(gap > 0 || !answer_.first_contact ||
               chainage >= answer_.first_contact->free_until - 1e-9 * (1 + chainage),
           chainage, "there is contact, before the first");
    }
  }

  ClearanceCheck result;

 private:
  ClearanceStation query(const Pose& pose) {
    ++result.places;
    return clearance_by_brute_force(mover_, pose, fixed_, limits_);
  }

  void note(bool right, double chainage, const std::string& fault) {
    if (right) {
      return;
    }
    if (result.wrong++ == 0) {
      result.first = "at chainage " + shortest(chainage) + " " + fault;
    }
  }

  const Clearance& answer_;
  const Shape& mover_;
  const MotionPath& path_;
  std::span<const Body> fixed_;
  const ClearanceOptions& options_;
  const Limits& limits_;
};

}  // namespace

Pose pose_by_angle(const MotionPath& path, std::size_t segment, double t) {
  const PlainArithmetic plain;
  const Pose& from = path.poses[segment];
  const Pose& to = path.poses[segment + 1];
  const Turn turn = turn_between(from, to);
  // Quaternions are at half the angle of the turn; a part of the chord between them is a part of
  // the angle by the tangent.
  const double half = turn.angle / 2;
  const double part = 2 * std::atan2(t * std::sin(half), 1 - t + t * std::cos(half));
  Pose pose = from;
  if (turn.angle > 0) {
    pose = from * Pose::from_axis_angle(turn.axis, part);
  }
  const Vec3 a = from.apply(path.pivot);
  const Vec3 b = to.apply(path.pivot);
  const Vec3 here = pose.apply(path.pivot);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    pose.m[4 * axis + 3] += (1 - t) * a[axis] + t * b[axis] - here[axis];
  }
  return pose;
}

ClearanceStation clearance_by_brute_force(const Shape& mover, const Pose& pose,
                                          std::span<const Body> fixed, const Limits& limits) {
  ClearanceStation station{.pose = pose};
  for (std::size_t k = 0; k < fixed.size(); ++k) {
    const Distance found = distance_by_brute_force(Body(mover, pose), fixed[k], limits);
    if (std::tie(found.distance.upper, found.distance.lower) <
        std::tie(station.gap.upper, station.gap.lower)) {
      station.gap = found.distance;
      station.body = k;
      station.triangles = found.triangles;
      station.point_a = found.point_a;
      station.point_b = found.point_b;
    }
  }
  return station;
}

ClearanceCheck check_clearance(const Clearance& answer, const Shape& mover, const MotionPath& path,
                               std::span<const Body> fixed, const ClearanceOptions& options,
                               std::size_t samples, const Limits& limits) {
  Checker checker(answer, mover, path, fixed, options, limits);
  const std::size_t all = answer.stations.size() + answer.stretches.size();
  for (std::size_t k = 0; k < all; ++k) {
    check(limits);
    if (k < answer.stations.size()) {
      checker.check_same(answer.stations[k]);
    } else {
      const std::size_t stretch = k - answer.stations.size();
      checker.check_same(answer.stretches[stretch].least);
      checker.check_between(stretch, samples);
    }
    if (limits.progress) {
      limits.progress(static_cast<double>(k + 1) / static_cast<double>(all));
    }
  }
  if (answer.first_contact) {
    checker.check_same(answer.first_contact->station);
  }
  return checker.result;
}

}  // namespace soms::reference
