// Two triangles, posed: the exact verdict, and what the kernels of each instruction set say in
// float and in double, against whole numbers.
#include "soms/geometry/triangle_overlap.h"
#include "soms/query/detail/kernels/instruction_set.h"
#include "soms/query/detail/relative_pose.h"
#include "soms/query/overlap.h"
#include "soms/tree/layout/detail/wide_tree.h"
#include "soms/tree/shape.h"

#include "tests/fuzz/bytes.h"
#include "tests/fuzz/poses.h"
#include "tests/fuzz/require.h"
#include "tests/support/truth/triangle_truth.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

namespace soms {
namespace {

using fuzz::Bytes;
using fuzz::require;

/// Where corners lie: on a lattice, off it by a few steps of a double, anywhere, or any bits.
class Corners {
 public:
  explicit Corners(Bytes& bytes)
      : kind_(bytes.below(4)),
        unit_(std::ldexp(1.0, bytes.below(4) == 0 ? static_cast<int>(bytes.below(250)) - 150 : 0)) {
  }

  Vec3 next(Bytes& bytes) const {
    const double x = coordinate(bytes);
    const double y = coordinate(bytes);
    return {x, y, coordinate(bytes)};
  }

  [[nodiscard]] double unit() const { return unit_; }

 private:
  double coordinate(Bytes& bytes) const {
    if (kind_ == 3) {
      const double any = bytes.any_double();
      return std::abs(any) <= 0x1p298 ? any : 0;
    }
    if (kind_ == 2) {
      return unit_ * 8 * bytes.fraction();
    }
    const double even = unit_ * (static_cast<int>(bytes.below(9)) - 4);
    return kind_ == 0 ? even : even * (1 + 0x1p-52 * static_cast<int>(bytes.below(5)));
  }

  std::uint32_t kind_;
  double unit_;
};

/// A point of a triangle, but for rounding: a corner, on an edge, inside.
Vec3 point_of(const Triangle& t, Bytes& bytes) {
  const std::uint32_t kind = bytes.below(3);
  const double u = kind == 0 ? 0 : std::abs(bytes.fraction());
  const double v = kind == 2 ? std::abs(bytes.fraction()) * (1 - u) : 0;
  return t.a + u * (t.b - t.a) + v * (t.c - t.a);
}

Triangle triangle(Bytes& bytes, const Corners& corners) {
  const Vec3 a = corners.next(bytes);
  const Vec3 b = corners.next(bytes);
  return {a, b, corners.next(bytes)};
}

bool fits(const Triangle& t) {
  const auto within = [](const Vec3& v) {
    return std::abs(v.x) <= 0x1p298 && std::abs(v.y) <= 0x1p298 && std::abs(v.z) <= 0x1p298;
  };
  return within(t.a) && within(t.b) && within(t.c);
}

/// The triangle, up to 2^-60 of its size, about the origin or at a point of `other`.
Triangle shrunk(const Triangle& t, const Triangle& other, Bytes& bytes) {
  const double share = std::ldexp(1.0, -static_cast<int>(bytes.below(61)));
  const Vec3 at = bytes.below(2) == 0 ? Vec3{} : point_of(other, bytes);
  return {at + t.a * share, at + t.b * share, at + t.c * share};
}

/// One in two has a corner, or the middle of an edge, at a point of `other`; some are far smaller.
Triangle triangle_near(const Triangle& other, Bytes& bytes, const Corners& corners) {
  Triangle t = triangle(bytes, corners);
  if (bytes.below(4) == 0) {
    t = shrunk(t, other, bytes);
  }
  const std::uint32_t kind = bytes.below(6);
  if (kind < 3) {
    return fits(t) ? t : other;
  }
  t.a = point_of(other, bytes);
  if (kind == 4) {
    t.b = point_of(other, bytes);
  } else if (kind == 5) {
    t.b = t.a + (t.a - t.c);
  }
  return fits(t) ? t : other;
}

Triangle moved(const Triangle& t, const Pose& pose) {
  return {pose.apply(t.a), pose.apply(t.b), pose.apply(t.c)};
}

void check_exact(const Triangle& s, const Triangle& t, bool truth) {
  require(triangles_overlap(s, t) == truth, "two triangles");
  require(triangles_overlap(t, s) == truth, "two triangles, swapped");
  require(triangles_overlap({s.b, s.c, s.a}, {t.c, t.b, t.a}) == truth, "corners in another order");
}

Shape shape_of(const Triangle& t) {
  Mesh mesh;
  mesh.vertices = {t.a, t.b, t.c};
  mesh.triangles = {{0, 1, 2}};
  return Shape(std::move(mesh));
}

/// Slabs, boxes and verdicts of each instruction set: sure answers are right.
void check_kernels(const Body& a, const Body& b, bool truth) {
  const WideTree& x = a.shape.layout();
  const WideTree& y = b.shape.layout();
  if (x.exponent() < y.exponent()) {
    return;
  }
  detail::RelativePose relative(x, a.pose, detail::ReferenceFrame(y, b.pose));
  relative.prepare();
  for (const detail::Kernels* kernels : detail::kernels_here()) {
    detail::BlockTask task{&relative.numbers(), &x.blocks()[0], &y.blocks()[0], {}, 0, 0, 0};
    kernels->test_slabs(&task, 1);
    require(!truth || (task.lanes_x == 1 && task.lanes_y == 1), "slabs of touching triangles");
    detail::TriangleSlot slot;
    if (task.lanes_x == 0 || task.lanes_y == 0) {
      continue;
    }
    const std::uint64_t met = kernels->test_boxes(task, slot);
    require(!truth || met == 1, "boxes of touching triangles");
    if (met == 0) {
      continue;
    }
    std::array<std::uint32_t, detail::kJudged> first = {};
    std::array<std::uint32_t, detail::kJudged> second = {};
    second.fill(sizeof(detail::TriangleSlot::Corners) / sizeof(float));
    for (int turn = 0; turn < 2; ++turn) {
      const detail::Verdicts verdicts = kernels->judge(&slot, first.data(), second.data(), 1);
      require(verdicts.open == 1 || (verdicts.hit == 1) == truth, "a verdict in float");
      first.swap(second);
    }
    const std::uint16_t pair = 0;
    const detail::Verdicts closer = kernels->judge_in_double(&slot, relative.numbers(), &pair, 1);
    require(closer.open == 1 || (closer.hit == 1) == truth, "a verdict in double");
  }
}

void check_input(Bytes& bytes) {
  const Corners corners(bytes);
  const Triangle s = triangle(bytes, corners);
  const Triangle t = triangle_near(s, bytes, corners);
  check_exact(s, t, test::share_a_point(s, t));
  const Pose pose_a = fuzz::pose_of(bytes, corners.unit());
  const Pose pose_b = bytes.below(2) == 0 ? pose_a : fuzz::pose_of(bytes, corners.unit());
  const Triangle moved_s = moved(s, pose_a);
  const Triangle moved_t = moved(t, pose_b);
  const bool truth = test::share_a_point(moved_s, moved_t);
  check_exact(moved_s, moved_t, truth);
  const Body a(shape_of(s), pose_a);
  const Body b(shape_of(t), pose_b);
  require(overlap(a, b).any == truth, "bodies of one triangle");
  check_kernels(a, b, truth);
  check_kernels(b, a, truth);
}

}  // namespace
}  // namespace soms

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  soms::fuzz::Bytes bytes({data, size});
  soms::check_input(bytes);
  return 0;
}
