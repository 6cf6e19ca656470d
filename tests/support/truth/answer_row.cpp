#include "tests/support/truth/answer_row.h"

#include "soms/geometry/closedness.h"

namespace soms::test {

namespace {

template <class One>
Coverage coverage_in(const One& answer) {
  return answer.coverage;
}

Coverage coverage_in(const SignedClosest& answer) {
  return answer.closest.coverage;
}

Coverage coverage_in(const AllHits& answer) {
  return answer.coverage.front();
}

template <class One>
const Cost& cost_in(const One& answer) {
  return answer.cost;
}

const Cost& cost_in(const SignedClosest& answer) {
  return answer.closest.cost;
}

}  // namespace

Coverage coverage_of(const Answer& answer) {
  return std::visit([](const auto& one) { return coverage_in(one); }, answer);
}

const Cost& cost_of(const Answer& answer) {
  return std::visit([](const auto& one) -> const Cost& { return cost_in(one); }, answer);
}

bool is_closed(const Body& body) {
  return closedness(body.shape.mesh(), {.pose = body.pose}).whole.closed;
}

}  // namespace soms::test
