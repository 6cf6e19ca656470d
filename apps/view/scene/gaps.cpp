#include "apps/view/scene/gaps.h"

#include "apps/support/text.h"

#include <algorithm>
#include <tuple>

namespace soms::view {

std::vector<Gap> gaps_of(const StepReport& report) {
  std::vector<Gap> gaps;
  gaps.reserve(report.environment_gaps.size() + report.mover_gaps.size());
  for (const EnvironmentGap& gap : report.environment_gaps) {
    gaps.push_back({mover(gap.mover), city_part(gap.part), gap.i, gap.j, gap.distance, gap.point_a,
                    gap.point_b});
  }
  for (const MoverGap& gap : report.mover_gaps) {
    gaps.push_back(
        {mover(gap.a), mover(gap.b), gap.i, gap.j, gap.distance, gap.point_a, gap.point_b});
  }
  // Brackets are neighbors or equal, so their upper ends order what they tell apart.
  std::sort(gaps.begin(), gaps.end(), [](const Gap& x, const Gap& y) {
    return std::tuple(x.distance.upper, x.distance.lower, x.a, x.b) <
           std::tuple(y.distance.upper, y.distance.lower, y.a, y.b);
  });
  return gaps;
}

std::string length_of(const Gap& gap) {
  return command::four_digits(gap.distance.lower) + " m";
}

}  // namespace soms::view
