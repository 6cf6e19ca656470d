/// \file
/// What a query of a point is after: which triangles matter, and how near they are.
#pragma once

#include "soms/base/vector.h"
#include "soms/geometry/detail/point_to_triangle.h"
#include "soms/query/answer.h"
#include "soms/query/detail/engine/limit.h"
#include "soms/query/detail/near/point_pose.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace soms::detail {

/// Decides triangles exactly, one after the other.
class PointGoal {
 public:
  PointGoal(const PointFrame& frame, const Vec3& point) : frame_(&frame), point_(point) {}

  PointGoal(const PointGoal&) = delete;
  PointGoal& operator=(const PointGoal&) = delete;
  virtual ~PointGoal() = default;

  /// Only triangles at most this far from the point in the world matter.
  [[nodiscard]] virtual double upper() const = 0;

  /// Takes a triangle.
  virtual void offer(TriangleId id, Cost& cost) = 0;

  /// More than the nearest triangle matters: none that is near should wait.
  [[nodiscard]] virtual bool eager() const = 0;

 protected:
  [[nodiscard]] PointToTriangle measure(TriangleId id) const;

 private:
  const PointFrame* frame_;
  Vec3 point_;
};

/// A triangle, and how far it is.
struct NearTriangle {
  TriangleId id = 0;
  PointToTriangle pair;
};

/// The nearest triangle, the least of equally near ones, unless all are beyond `at_most`.
class ClosestGoal final : public PointGoal {
 public:
  ClosestGoal(const PointFrame& frame, const Vec3& point, double at_most)
      : PointGoal(frame, point), at_most_(at_most), upper_(at_most) {}

  [[nodiscard]] double upper() const override { return upper_; }

  void offer(TriangleId id, Cost& cost) override;

  [[nodiscard]] bool eager() const override { return false; }

  /// Nothing if all that was offered is farther.
  [[nodiscard]] std::optional<NearTriangle>& found() { return found_; }

 private:
  double at_most_;
  double upper_;
  std::optional<NearTriangle> found_;
};

/// The `count` nearest triangles by distance and number, of those within `at_most`.
class SeveralGoal final : public PointGoal {
 public:
  SeveralGoal(const PointFrame& frame, const Vec3& point, std::size_t count, double at_most)
      : PointGoal(frame, point), count_(count), at_most_(at_most), upper_(at_most) {}

  /// \pre The count is above 0.
  [[nodiscard]] double upper() const override { return upper_; }

  void offer(TriangleId id, Cost& cost) override;

  [[nodiscard]] bool eager() const override { return true; }

  /// Those found, the nearest first, in an order of `found()`. Where the deadline passes first, by
  /// what is known of their distances.
  [[nodiscard]] const std::vector<std::size_t>& sorted(Limit& limit, Cost& cost);

  [[nodiscard]] std::vector<NearTriangle>& found() { return found_; }

 private:
  /// By distance and number.
  [[nodiscard]] bool is_before(NearTriangle& a, NearTriangle& b, Cost& cost);

  void narrow();
  void number_all();

  std::size_t count_;
  double at_most_;
  double upper_;
  std::vector<NearTriangle> found_;
  std::vector<std::size_t> heap_;  // the farthest of `found_` on top, once there are `count_`
};

}  // namespace soms::detail
