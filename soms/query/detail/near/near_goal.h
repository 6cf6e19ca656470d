/// \file
/// What a query of nearness is after: which pairs of triangles matter, and when it is over.
#pragma once

#include "soms/base/vector.h"
#include "soms/geometry/detail/pair_distance.h"
#include "soms/query/answer.h"
#include "soms/query/detail/engine/pair_frame.h"

#include <array>
#include <memory>
#include <optional>

namespace soms::detail {

/// Decides pairs of triangles exactly, one after the other.
class NearGoal {
 public:
  explicit NearGoal(const PairFrame& frame) : frame_(&frame) {}

  NearGoal(const NearGoal&) = delete;
  NearGoal& operator=(const NearGoal&) = delete;
  virtual ~NearGoal() = default;

  /// Only pairs at most this far apart in the world matter.
  [[nodiscard]] virtual double upper() const = 0;

  /// Takes a triangle of x and one of y; true when the query is over.
  [[nodiscard]] virtual bool offer(const TrianglePair& ids, Cost& cost) = 0;

  /// The same goal, with nothing offered yet, for a part of what is left: what does not matter to
  /// this one by now does not matter to it.
  [[nodiscard]] virtual std::unique_ptr<NearGoal> for_part() const = 0;

  /// The pair of x and y that was kept of those offered, if any.
  [[nodiscard]] const std::optional<TrianglePair>& kept() const { return kept_; }

  /// The kept pair ended the query.
  [[nodiscard]] bool over() const { return over_; }

 protected:
  [[nodiscard]] const PairFrame& frame() const { return *frame_; }

  /// The caller's first triangle and the second of a pair of x and y.
  [[nodiscard]] PairDistance measure(const TrianglePair& ids) const;

  void keep(const TrianglePair& ids, bool over) {
    kept_ = ids;
    over_ = over;
  }

 private:
  const PairFrame* frame_;
  std::optional<TrianglePair> kept_;
  bool over_ = false;
};

/// The nearest pair, the least (i, j) of equally near ones, unless all are beyond `at_most`.
class NearestGoal final : public NearGoal {
 public:
  NearestGoal(const PairFrame& frame, double at_most)
      : NearGoal(frame), at_most_(at_most), upper_(at_most) {}

  [[nodiscard]] double upper() const override { return upper_; }

  /// Over at the first pair that overlaps.
  [[nodiscard]] bool offer(const TrianglePair& ids, Cost& cost) override;

  [[nodiscard]] std::unique_ptr<NearGoal> for_part() const override {
    return std::make_unique<NearestGoal>(frame(), upper_);
  }

  /// `triangles` overlap; they need not be the least pair that does.
  [[nodiscard]] bool touching() const { return touching_; }

  [[nodiscard]] const std::optional<TrianglePair>& triangles() const { return triangles_; }

  /// \pre There is a nearest pair.
  [[nodiscard]] PairDistance& nearest() { return nearest_; }

 private:
  double at_most_;
  double upper_;
  bool touching_ = false;
  std::optional<TrianglePair> triangles_;
  PairDistance nearest_;
};

/// Any pair within a clearance.
class WithinGoal final : public NearGoal {
 public:
  WithinGoal(const PairFrame& frame, double clearance) : NearGoal(frame), clearance_(clearance) {}

  [[nodiscard]] double upper() const override { return clearance_; }

  [[nodiscard]] bool offer(const TrianglePair& ids, Cost& cost) override;

  [[nodiscard]] std::unique_ptr<NearGoal> for_part() const override {
    return std::make_unique<WithinGoal>(frame(), clearance_);
  }

  [[nodiscard]] const std::optional<TrianglePair>& triangles() const { return triangles_; }

  /// \pre There is a pair.
  [[nodiscard]] PairDistance& found() { return found_; }

 private:
  double clearance_;
  std::optional<TrianglePair> triangles_;
  PairDistance found_;
};

}  // namespace soms::detail
