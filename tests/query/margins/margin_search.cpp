/// \file
/// Climbs toward touches that need most of the margins of relative_pose.h.
///
///     margin_search [TOUCHES [SEED]]
///
/// looks at so many touches (default 20,000) and prints the worst ones, with the shares of what the
/// proof grants that they need. Status 1 if anything needs more than it is granted.
#include "soms/base/arithmetic.h"
#include "soms/base/error.h"

#include "tests/query/margins/touch.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <span>

namespace soms {
namespace {

using test::Needed;
using test::Touch;

/// Steps without a better touch before the next climb begins.
constexpr int kPatience = 300;

struct Goal {
  const char* name;
  double Needed::*share;
  double most = -1;
  Touch worst = {};
};

using Goals = std::array<Goal, 3>;

std::optional<Needed> needed_if_valid(Touch& touch) {
  try {
    check(touch.pose_x);
    check(touch.pose_y);
  } catch (const Error&) {
    return {};
  }
  return test::bring_together(touch) ? std::optional(test::needed(touch)) : std::nullopt;
}

void print(const char* name, std::span<const double> numbers) {
  std::printf("  %-7s", name);
  for (const double number : numbers) {
    std::printf(" %a,", number);
  }
  std::printf("\n");
}

void print(const char* name, const Vec3& v) {
  print(name, std::array{v.x, v.y, v.z});
}

void print(const Goal& goal) {
  const Touch& t = goal.worst;
  std::printf("%s: %.4f\n", goal.name, goal.most);
  print("pose_x", t.pose_x.m);
  print("pose_y", t.pose_y.m);
  print("x", t.x);
  print("end_x", t.end_x);
  print("y", t.y);
  print("end_y", t.end_y);
}

void note(const Touch& touch, const Needed& here, Goals& goals) {
  for (Goal& goal : goals) {
    if (here.*goal.share > goal.most) {
      goal.most = here.*goal.share;
      goal.worst = touch;
    }
  }
}

/// Climbs from one random touch toward one goal; returns the touches looked at.
long climb(Rng& rng, double Needed::*share, long left, Goals& goals) {
  const double far = rng.below(2) == 0 ? 2 : std::exp2(rng.uniform(1, 60));
  Touch best = test::random_touch(rng, far);
  std::optional<Needed> most = needed_if_valid(best);
  long looked_at = 1;
  for (int stale = 0; most && stale < kPatience && looked_at < left; ++looked_at) {
    Touch next = test::changed(rng, best);
    const std::optional<Needed> here = needed_if_valid(next);
    const bool better = here && (*here).*share > (*most).*share;
    stale = better ? 0 : stale + 1;
    if (better || (here && (*here).*share == (*most).*share)) {
      best = next;
      most = here;
    }
  }
  if (most) {
    note(best, *most, goals);
  }
  return looked_at;
}

int search(long touches, std::uint64_t seed) {
  const PlainArithmetic plain;
  Rng rng(seed);
  Goals goals{{{"along the axes of y", &Needed::along_y},
               {"along the axes of x", &Needed::along_x},
               {"between the roots", &Needed::of_roots}}};
  for (std::size_t turn = 0; touches > 0; ++turn) {
    touches -= climb(rng, goals[turn % goals.size()].share, touches, goals);
  }
  bool granted = true;
  for (const Goal& goal : goals) {
    print(goal);
    granted = granted && goal.most <= 1;
  }
  return granted ? 0 : 1;
}

}  // namespace
}  // namespace soms

int main(int count, char** arguments) {
  const long touches = count > 1 ? std::atol(arguments[1]) : 20000;
  const long seed = count > 2 ? std::atol(arguments[2]) : 1;
  return soms::search(touches, static_cast<std::uint64_t>(seed));
}
