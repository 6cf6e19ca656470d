#include "soms/robot/reference/robot_query.h"

#include "soms/base/arithmetic.h"
#include "soms/base/error.h"
#include "soms/clash/reference/clash.h"
#include "soms/geometry/closedness.h"
#include "soms/query/contains_parts.h"
#include "soms/query/reference/contains.h"
#include "soms/query/reference/distance.h"
#include "soms/query/reference/overlap.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <tuple>
#include <vector>

namespace soms::reference {

namespace {

/// Bodies where a state moves them, and their boxes.
struct PlacedBodies {
  std::vector<Body> bodies;
  std::vector<Box> boxes;
};

PlacedBodies placed(const RobotModel& model, std::span<const double> state) {
  const std::vector<Pose> poses = model.kinematics().link_poses(state, model.base());
  PlacedBodies result;
  for (std::size_t i = 0; i < model.bodies(); ++i) {
    Body body = model.body(i).part.body;
    if (i < model.link_bodies().size()) {
      body.pose = poses[model.body(i).owner];
    }
    Box box;
    const MeshView& mesh = body.shape.mesh();
    for (const auto& corners : mesh.triangles) {
      for (const std::uint32_t v : corners) {
        box.grow(body.pose.apply(mesh.vertices[v]));
      }
    }
    result.bodies.push_back(std::move(body));
    result.boxes.push_back(box);
  }
  return result;
}

/// Whether a corner of a triangle of one body is inside the other; `closed` is whether that is.
bool has_corner_inside(const Body& inner, const Body& outer, const Box& outer_box, bool closed) {
  if (!closed) {
    return false;
  }
  const MeshView& mesh = inner.shape.mesh();
  std::vector<Vec3> points;
  for (const auto& corners : mesh.triangles) {
    const Vec3 p = inner.pose.apply(mesh.vertices[corners[0]]);
    Box point;
    point.grow(p);
    if (outer_box.contains(point)) {
      points.push_back(p);
    }
  }
  std::sort(points.begin(), points.end(), [](const Vec3& a, const Vec3& b) {
    return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
  });
  points.erase(std::unique(points.begin(), points.end()), points.end());
  const std::vector<Side> sides = contains_by_brute_force(outer, points);
  return std::find(sides.begin(), sides.end(), Side::inside) != sides.end();
}

/// Whether a connected part of a body is in the box of an open one, or goes through what closes it.
bool may_be_inside(const Body& inner, const Body& open, const Box& open_box) {
  const MeshView& mesh = inner.shape.mesh();
  const DividedBody parts(Body(inner.shape), Partition::connected);
  std::vector<Box> boxes(parts.parts().size());
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    for (const std::uint32_t v : mesh.triangles[i]) {
      boxes[parts.part_of(static_cast<TriangleId>(i))].grow(inner.pose.apply(mesh.vertices[v]));
    }
  }
  return std::any_of(boxes.begin(), boxes.end(),
                     [&](const Box& box) { return open_box.contains(box); }) ||
         overlap(mesh, inner.pose, caps_by_brute_force(Body(open.shape)), open.pose, {}).any;
}

/// What is known of one pair of bodies.
struct PairFound {
  bool meet = false;
  bool inside = false;
  bool undecided = false;
};

PairFound look_at(const RobotModel& model, const PlacedBodies& placed, std::size_t i, std::size_t j,
                  const Limits& limits) {
  const Body& a = placed.bodies[i];
  const Body& b = placed.bodies[j];
  PairFound found;
  if (!overlaps(placed.boxes[i], placed.boxes[j])) {
    return found;
  }
  found.meet = overlap(a.shape.mesh(), a.pose, b.shape.mesh(), b.pose, {.stop = limits.stop}).any;
  if (found.meet) {
    return found;
  }
  for (const auto& [inner, outer] : {std::pair{i, j}, std::pair{j, i}}) {
    const Body& around = placed.bodies[outer];
    if (!model.body(outer).part.closed) {
      const Body core(closed_parts(around.shape.mesh()), around.pose);
      const bool closed =
          closedness(core.shape.mesh(), {.pose = core.pose, .places = 0}).whole.closed;
      found.inside = found.inside ||
                     has_corner_inside(placed.bodies[inner], core, placed.boxes[outer], closed);
      found.undecided =
          found.undecided || may_be_inside(placed.bodies[inner], around, placed.boxes[outer]);
      continue;
    }
    const bool closed =
        closedness(around.shape.mesh(), {.pose = around.pose, .places = 0}).whole.closed;
    found.undecided = found.undecided || !closed;
    found.inside = found.inside ||
                   has_corner_inside(placed.bodies[inner], around, placed.boxes[outer], closed);
  }
  found.undecided = found.undecided && !found.inside;
  return found;
}

/// At most the distance of two boxes: the gap along one axis, rounded down.
double gap_along_axis(const Box& a, const Box& b) {
  double gap = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    gap = std::max({gap, b.lower[axis] - a.upper[axis], a.lower[axis] - b.upper[axis]});
  }
  return gap > 0 ? std::nextafter(gap, 0.0) : 0;
}

RobotGap least_gap(const RobotModel& model, const PlacedBodies& placed, const Limits& limits) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  std::vector<std::tuple<double, std::size_t, std::size_t>> order;
  for (std::size_t i = 0; i < model.link_bodies().size(); ++i) {
    for (std::size_t j = i + 1; j < model.bodies(); ++j) {
      if (model.compares(i, j)) {
        order.emplace_back(gap_along_axis(placed.boxes[i], placed.boxes[j]), i, j);
      }
    }
  }
  std::sort(order.begin(), order.end());
  RobotGap gap{.distance = {kInfinity, kInfinity}};
  for (const auto& [bound, i, j] : order) {
    if (bound > gap.distance.upper) {
      break;
    }
    const Bracket found =
        distance_by_brute_force(placed.bodies[i], placed.bodies[j], {.stop = limits.stop}).distance;
    const RobotPair pair = model.pair_of(i, j);
    if (!gap.pair || std::tuple(found.lower, found.upper, pair) <
                         std::tuple(gap.distance.lower, gap.distance.upper, *gap.pair)) {
      gap = {.distance = found, .pair = pair};
    }
  }
  return gap;
}

}  // namespace

RobotAnswer robot_contacts_by_brute_force(const RobotModel& model, std::span<const double> state,
                                          bool measure, const Limits& limits) {
  const PlainArithmetic plain;
  const PlacedBodies bodies = placed(model, state);
  RobotAnswer answer{.coverage = Coverage::complete};
  answer.beyond_limits = model.kinematics().beyond_limits(state);
  for (std::size_t i = 0; i < model.link_bodies().size(); ++i) {
    check(limits);
    for (std::size_t j = i + 1; j < model.bodies(); ++j) {
      if (!model.compares(i, j)) {
        continue;
      }
      const PairFound found = look_at(model, bodies, i, j, limits);
      answer.undecided += found.undecided ? 1U : 0U;
      if (!found.meet && !found.inside) {
        continue;
      }
      const RobotPair pair = model.pair_of(i, j);
      const auto known =
          std::find_if(answer.contacts.begin(), answer.contacts.end(),
                       [&](const RobotContact& contact) { return contact.pair == pair; });
      if (known == answer.contacts.end()) {
        answer.contacts.push_back({pair, found.meet});
      } else {
        known->surfaces_meet = known->surfaces_meet || found.meet;
      }
    }
  }
  std::sort(answer.contacts.begin(), answer.contacts.end(),
            [](const RobotContact& a, const RobotContact& b) { return a.pair < b.pair; });
  answer.verdict = !answer.contacts.empty() ? RobotVerdict::contact
                   : answer.undecided != 0  ? RobotVerdict::undecided
                                            : RobotVerdict::free;
  if (measure) {
    answer.gap = answer.contacts.empty()
                     ? least_gap(model, bodies, limits)
                     : RobotGap{.distance = {0, 0}, .pair = answer.contacts.front().pair};
  }
  return answer;
}

bool agrees(const RobotAnswer& answer, const RobotAnswer& twin) {
  if (answer.beyond_limits != twin.beyond_limits) {
    return false;
  }
  if (answer.coverage == Coverage::cut) {  // what was found is right, and there may be more
    return std::all_of(answer.contacts.begin(), answer.contacts.end(), [&](const auto& contact) {
      return std::any_of(twin.contacts.begin(), twin.contacts.end(),
                         [&](const auto& other) { return other.pair == contact.pair; });
    });
  }
  if (answer.verdict != twin.verdict) {
    return false;
  }
  const bool first = answer.coverage == Coverage::first;
  if (first ? answer.contacts.size() != 1 || answer.contacts.front() != twin.contacts.front()
            : answer.contacts != twin.contacts) {
    return false;
  }
  if (!answer.gap || !twin.gap) {
    return true;
  }
  if (answer.gap->farther) {
    return twin.gap->distance.upper > answer.gap->distance.lower;
  }
  return answer.gap->distance == twin.gap->distance && answer.gap->pair == twin.gap->pair;
}

}  // namespace soms::reference
