#include "apps/view/scene/explain.h"

#include "soms/base/box.h"
#include "soms/geometry/triangle_overlap.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace soms::view {

namespace {

constexpr std::string_view kAxisNames = "xyz";

bool has_area(const Triangle& t) {
  return orientation2d(t.a, t.b, t.c, soms::Projection::xy) != Sign::zero ||
         orientation2d(t.a, t.b, t.c, soms::Projection::yz) != Sign::zero ||
         orientation2d(t.a, t.b, t.c, soms::Projection::zx) != Sign::zero;
}

CornerSide side(const Triangle& plane, const Vec3& corner) {
  const Vec3 n = cross(plane.b - plane.a, plane.c - plane.a);
  const double length = std::hypot(n.x, n.y, n.z);
  return {orientation(plane.a, plane.b, plane.c, corner),
          length > 0 ? dot(n, corner - plane.a) / length : 0};
}

std::array<CornerSide, 3> sides(const Triangle& plane, const Triangle& t) {
  return {side(plane, t.a), side(plane, t.b), side(plane, t.c)};
}

std::size_t count(const std::array<CornerSide, 3>& sides, Sign sign) {
  return static_cast<std::size_t>(std::count_if(
      sides.begin(), sides.end(), [sign](const CornerSide& s) { return s.sign == sign; }));
}

bool one_sided(const std::array<CornerSide, 3>& sides) {
  return count(sides, Sign::positive) == 3 || count(sides, Sign::negative) == 3;
}

/// Finds the axis on which two boxes are farthest apart; false where they are not.
bool boxes_apart(const Triangle& a, const Triangle& b, Explanation& out) {
  const Box box_a = bounds(a);
  const Box box_b = bounds(b);
  if (overlaps(box_a, box_b)) {
    return false;
  }
  out.gap = -1;
  for (std::size_t k = 0; k < 3; ++k) {
    // Compared before they are subtracted: a gap below the least double would round to 0.
    if (box_a.upper[k] < box_b.lower[k] || box_b.upper[k] < box_a.lower[k]) {
      const double gap = std::max(box_b.lower[k] - box_a.upper[k], box_a.lower[k] - box_b.upper[k]);
      if (gap > out.gap) {
        out.gap = gap;
        out.axis = k;
      }
    }
  }
  return true;
}

Stage deciding_stage(const Triangle& a, const Triangle& b, const Explanation& e) {
  if (!has_area(a) || !has_area(b)) {
    return Stage::flat;
  }
  if (one_sided(e.a_above_b)) {
    return Stage::plane_of_b;
  }
  if (one_sided(e.b_above_a)) {
    return Stage::plane_of_a;
  }
  return count(e.a_above_b, Sign::zero) == 3 ? Stage::coplanar : Stage::edges;
}

bool touches(const Vec3& p, const Triangle& t) {
  return triangles_overlap({p, p, p}, t);
}

bool touches(const Vec3& p, const Vec3& q, const Vec3& r, const Vec3& s) {
  return triangles_overlap({p, q, q}, {r, s, s});
}

/// True if points of each lie beyond the other's plane on both sides, at a common point that is no
/// end of either there: general position of edges, decided by exact signs.
bool goes_through(const Triangle& a, const Triangle& b, const Explanation& e) {
  const auto both = [](const std::array<CornerSide, 3>& s) {
    return count(s, Sign::positive) > 0 && count(s, Sign::negative) > 0;
  };
  if (!both(e.a_above_b) || !both(e.b_above_a)) {
    return false;
  }
  // They meet in a segment unless the pieces of the common line meet end to end: at a corner of one
  // on the other, or where two edges cross.
  if (e.common.count == 2) {
    return true;
  }
  const std::array<Vec3, 3> ca{a.a, a.b, a.c};
  const std::array<Vec3, 3> cb{b.a, b.b, b.c};
  for (std::size_t i = 0; i < 3; ++i) {
    if (touches(ca[i], b) || touches(cb[i], a)) {
      return false;
    }
    for (std::size_t k = 0; k < 3; ++k) {
      if (touches(ca[i], ca[(i + 1) % 3], cb[k], cb[(k + 1) % 3])) {
        return false;
      }
    }
  }
  return true;
}

TouchKind kind_of(const Triangle& a, const Triangle& b, const Explanation& e) {
  if (!e.touch) {
    return TouchKind::none;
  }
  switch (e.stage) {
    case Stage::flat:
      return TouchKind::without_area;
    case Stage::coplanar:
      return e.common.count > 2 ? TouchKind::common_area : TouchKind::touching;
    default:
      return goes_through(a, b, e) ? TouchKind::crossing : TouchKind::touching;
  }
}

std::string describe(const CornerSide& s) {
  if (s.sign == Sign::zero) {
    return "exactly in it";
  }
  return fmt::format("{:.3g} {}", std::abs(s.height), s.sign == Sign::positive ? "above" : "below");
}

std::string describe(const std::array<CornerSide, 3>& s) {
  return fmt::format("{}, {}, {}", describe(s[0]), describe(s[1]), describe(s[2]));
}

double segment_length(const CommonPoints& common) {
  const Vec3 d = common.corners[1] - common.corners[0];
  return std::hypot(d.x, d.y, d.z);
}

std::string describe(const CommonPoints& common) {
  const Vec3& p = common.corners[0];
  switch (common.count) {
    case 1:
      return fmt::format("in the point ({:.9g}, {:.9g}, {:.9g})", p.x, p.y, p.z);
    case 2:
      return fmt::format("in a segment of length {:.4g}", segment_length(common));
    default:
      return fmt::format("in an area with {} corners", common.count);
  }
}

std::string verdict(const Explanation& e) {
  switch (e.kind) {
    case TouchKind::none:
      return "They do not touch";
    case TouchKind::crossing:
      return "They cross " + describe(e.common);
    case TouchKind::common_area:
      return "They lie in one plane and overlap " + describe(e.common);
    case TouchKind::touching:
      return "They touch, without going through each other, " + describe(e.common);
    case TouchKind::without_area:
      return "They meet " + describe(e.common);
  }
  return {};
}

std::string reason(const Explanation& e) {
  switch (e.stage) {
    case Stage::boxes:
      return fmt::format("their boxes are {:.3g} apart along {}", e.gap, kAxisNames[e.axis]);
    case Stage::plane_of_b:
      return "all corners of the first lie on one side of the second's plane";
    case Stage::plane_of_a:
      return "all corners of the second lie on one side of the first's plane";
    case Stage::edges:
      return e.touch ? "on the line common to both planes, their segments meet"
                     : "on the line common to both planes, their segments do not meet";
    case Stage::coplanar:
      return e.touch ? "both lie in one plane, and no edge separates them"
                     : "both lie in one plane, and an edge separates them";
    case Stage::flat:
      return "one of them has no area: it counts as the segment or point that it is";
  }
  return {};
}

std::string text_of(const Explanation& e) {
  std::string text = verdict(e) + ": " + reason(e) + ".";
  if (e.stage == Stage::boxes || e.stage == Stage::flat) {
    return text;
  }
  text += "\nCorners of the first against the second's plane: " + describe(e.a_above_b) + ".";
  if (e.stage != Stage::plane_of_b) {
    text += "\nCorners of the second against the first's plane: " + describe(e.b_above_a) + ".";
  }
  text += e.exact_arithmetic ? "\nDecided by exact arithmetic: plain doubles left a sign open."
                             : "\nDecided by the filter: every sign was clear in plain doubles.";
  return text;
}

}  // namespace

Explanation explain(const Triangle& a, const Triangle& b) {
  Explanation e;
  if (boxes_apart(a, b, e)) {
    e.text = text_of(e);
    return e;
  }
  std::uint64_t exact = 0;
  e.touch = triangles_overlap(a, b, &exact);
  e.exact_arithmetic = exact != 0;
  e.a_above_b = sides(b, a);
  e.b_above_a = sides(a, b);
  e.stage = deciding_stage(a, b, e);
  e.common = common_points(a, b);
  e.kind = kind_of(a, b, e);
  e.text = text_of(e);
  return e;
}

std::string_view name(Stage stage) {
  switch (stage) {
    case Stage::boxes:
      return "boxes";
    case Stage::plane_of_b:
      return "plane_of_b";
    case Stage::plane_of_a:
      return "plane_of_a";
    case Stage::edges:
      return "edges";
    case Stage::coplanar:
      return "coplanar";
    case Stage::flat:
      return "flat";
  }
  return {};
}

std::string_view name(TouchKind kind) {
  switch (kind) {
    case TouchKind::none:
      return "none";
    case TouchKind::crossing:
      return "crossing";
    case TouchKind::touching:
      return "touching";
    case TouchKind::common_area:
      return "common_area";
    case TouchKind::without_area:
      return "without_area";
  }
  return {};
}

}  // namespace soms::view
