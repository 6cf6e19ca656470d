/// \file
/// Climbs toward gaps that need most of the margins of near_pose.h.
///
///     near_margin_search [GAPS [SEED]]
///
/// looks at so many gaps (default 100,000) and prints the worst ones, with the shares of what the
/// proof grants that they need. Status 1 if anything needs more than it is granted.
#include "soms/base/arithmetic.h"
#include "soms/base/error.h"
#include "soms/query/detail/kernels/instruction_set.h"

#include "tests/query/margins/gap.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <span>

namespace soms {
namespace {

using test::Gap;
using test::NeededOfGap;

/// Steps without a better gap, and steps in all, before the next climb begins.
constexpr int kFutile = 200;
constexpr long kSteps = 2000;

struct Peak {
  const char* name;
  double NeededOfGap::*share;
  double most = -1;
  Gap worst = {};
};

using Peaks = std::array<Peak, 3>;

std::optional<NeededOfGap> needed_of(const Gap& gap) {
  try {
    check(gap.pose_x);
    check(gap.pose_y);
  } catch (const Error&) {
    return {};
  }
  const test::Seen seen(test::shape_of(gap.x), gap.pose_x, test::shape_of(gap.y), gap.pose_y);
  return test::needed(seen, detail::scalar::kernels());
}

void print_numbers(const char* name, std::span<const double> numbers) {
  std::printf("  %-7s", name);
  for (const double number : numbers) {
    std::printf(" %a,", number);
  }
  std::printf("\n");
}

void print_corners(const char* name, const Triangle& t) {
  print_numbers(name, std::array{t.a.x, t.a.y, t.a.z, t.b.x, t.b.y, t.b.z, t.c.x, t.c.y, t.c.z});
}

void print_peak(const Peak& peak) {
  std::printf("%s: %.4f\n", peak.name, peak.most);
  print_numbers("pose_x", peak.worst.pose_x.m);
  print_numbers("pose_y", peak.worst.pose_y.m);
  print_corners("x", peak.worst.x);
  print_corners("y", peak.worst.y);
}

/// Climbs from one random gap; returns the gaps looked at.
long climb_peak(Rng& rng, Peak& peak, bool far, long left) {
  const double place = rng.below(2) == 0 ? 2 : std::exp2(rng.uniform(1, 50));
  Gap best = far ? test::random_far_gap(rng, place) : test::random_gap(rng, place);
  std::optional<NeededOfGap> most = needed_of(best);
  long looked_at = 1;
  for (int stale = 0; most && stale < kFutile && looked_at < left; ++looked_at) {
    const Gap next = test::changed(rng, best);
    const std::optional<NeededOfGap> here = needed_of(next);
    const bool better = here && (*here).*peak.share > (*most).*peak.share;
    stale = better ? 0 : stale + 1;
    if (better) {
      best = next;
      most = here;
    }
  }
  if (most && (*most).*peak.share > peak.most) {
    peak.most = (*most).*peak.share;
    peak.worst = best;
  }
  return looked_at;
}

int search_peaks(long gaps, std::uint64_t seed) {
  const PlainArithmetic plain;
  Rng rng(seed);
  Peaks peaks{{{"keys of nodes", &NeededOfGap::nodes},
               {"slabs", &NeededOfGap::slabs},
               {"far bodies", &NeededOfGap::far}}};
  for (std::size_t turn = 0; gaps > 0; ++turn) {
    gaps -= climb_peak(rng, peaks[turn % 3], turn % 3 == 2, std::min(gaps, kSteps));
  }
  bool granted = true;
  for (const Peak& peak : peaks) {
    print_peak(peak);
    granted = granted && peak.most <= 1;
  }
  return granted ? 0 : 1;
}

}  // namespace
}  // namespace soms

int main(int count, char** arguments) {
  const long gaps = count > 1 ? std::atol(arguments[1]) : 100000;
  const long seed = count > 2 ? std::atol(arguments[2]) : 1;
  return soms::search_peaks(gaps, static_cast<std::uint64_t>(seed));
}
