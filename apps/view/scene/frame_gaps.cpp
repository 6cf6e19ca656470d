#include "apps/view/scene/frame_gaps.h"

#include <algorithm>
#include <tuple>

namespace soms::view {

namespace {

template <class StepGap>
Gap gap_of(BodyRef a, BodyRef b, const StepGap& gap) {
  return {a, b,
          Distance{.distance = gap.distance,
                   .triangles = TrianglePair{gap.i, gap.j},
                   .point_a = gap.point_a,
                   .point_b = gap.point_b}};
}

}  // namespace

std::vector<Gap> gaps_of(const StepReport& report) {
  std::vector<Gap> gaps;
  gaps.reserve(report.environment_gaps.size() + report.mover_gaps.size());
  for (const EnvironmentGap& gap : report.environment_gaps) {
    gaps.push_back(gap_of(mover(gap.mover), city_part(gap.part), gap));
  }
  for (const MoverGap& gap : report.mover_gaps) {
    gaps.push_back(gap_of(mover(gap.a), mover(gap.b), gap));
  }
  // Brackets are neighbors or equal, so their upper ends order what they tell apart.
  const auto key = [](const Gap& gap) {
    return std::tuple(gap.distance.distance.upper, gap.distance.distance.lower, gap.a, gap.b);
  };
  std::sort(gaps.begin(), gaps.end(), [&](const Gap& x, const Gap& y) { return key(x) < key(y); });
  return gaps;
}

std::string meters_in_text(const Gap& gap) {
  return length_in_text(gap) + " m";
}

}  // namespace soms::view
