#include "soms/query/within.h"

#include "soms/base/arithmetic.h"
#include "soms/describe/columns.h"
#include "soms/query/detail/near/near_question.h"

#include <limits>

namespace soms {

namespace {

using detail::NearEnd;
using detail::NearMemory;
using detail::PairFrame;
using detail::WithinGoal;

/// Nearer than a clearance, or at it?
class WithinQuery {
 public:
  explicit WithinQuery(double clearance) : clearance_(clearance) {}

  [[nodiscard]] Within ask(const Body&, const Body&, PairFrame& frame, const Limits& limits,
                           NearMemory& memory) const {
    WithinGoal goal(frame, clearance_);
    const NearEnd end = detail::pursue(frame, goal, limits, memory);
    Within answer;
    answer.cost = end.cost;
    answer.within = goal.triangles().has_value();
    if (answer.within) {
      answer.triangles = goal.triangles();
      const auto points = goal.found().points();
      answer.point_a = points[0];
      answer.point_b = points[1];
    } else {
      answer.coverage = end.complete ? Coverage::complete : Coverage::cut;
      answer.at_least = end.complete ? clearance_ : end.at_least;
    }
    return answer;
  }

  [[nodiscard]] Within of_empty() const {
    return {.at_least = std::numeric_limits<double>::infinity()};
  }

 private:
  double clearance_;
};

void check_clearance(double clearance) {
  detail::check_length(clearance, "within: the clearance");
}

}  // namespace

Within within(const Body& a, const Body& b, double clearance, const Limits& limits) {
  const PlainArithmetic plain;
  check_clearance(clearance);
  return detail::ask_near(WithinQuery(clearance), a, b, limits);
}

Within WithinBatch::at(std::size_t pose) const {
  return row_of<Within>(*this, pose);
}

WithinBatch within(const Shape& mover, std::span<const Pose> poses, const Body& fixed,
                   double clearance, const Limits& limits) {
  const PlainArithmetic plain;
  check_clearance(clearance);
  return detail::ask_near_batch<Within>(WithinQuery(clearance), mover, poses, fixed, limits);
}

}  // namespace soms
