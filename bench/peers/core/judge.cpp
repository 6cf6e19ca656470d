#include "bench/peers/core/judge.h"

#include "soms/query/solid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <unordered_map>

namespace soms::bench {

namespace {

bool any_contradiction(std::span<const Answers> answers, const Rules& rules, std::size_t question) {
  for (std::size_t k = 0; k < answers.size(); ++k) {
    for (std::size_t l = 0; l < k; ++l) {
      if (question < std::min(answers[k].values.size(), answers[l].values.size()) &&
          rules.contradict(question, answers[k], answers[l])) {
        return true;
      }
    }
  }
  return false;
}

std::size_t longest(std::span<const Answers> answers) {
  std::size_t n = 0;
  for (const Answers& a : answers) {
    n = std::max(n, a.values.size());
  }
  return n;
}

/// Every how many questions one is looked at, of `n` that look at `each` triangles.
std::size_t stride_of(std::size_t n, std::size_t each, double budget) {
  const double looks = budget / static_cast<double>(std::max<std::size_t>(1, each));
  const auto most = static_cast<std::size_t>(std::max(1.0, looks));
  return std::max<std::size_t>(1, (n + most - 1) / most);
}

bool differ(std::size_t question, const Answers& a, const Answers& b) {
  return a.values[question] != b.values[question];
}

/// Answers to the questions on which libraries contradict each other.
struct Checked {
  std::size_t answers = 0;
  std::size_t wrong = 0;
};

/// The part of `answered` answers that is wrong: what is known of the contested ones, and of the
/// others as many as in the sample of them.
double wrong_share(const Verdict& verdict, const Checked& contested, std::size_t answered) {
  const auto sampled = static_cast<double>(verdict.checked - contested.answers);
  const auto sampled_wrong = static_cast<double>(verdict.wrong - contested.wrong);
  const auto others = static_cast<double>(answered - contested.answers);
  const double expected = sampled > 0 ? others * sampled_wrong / sampled : 0;
  const auto all = static_cast<double>(std::max<std::size_t>(1, answered));
  return (static_cast<double>(contested.wrong) + expected) / all;
}

/// Exact answers are 0 where the bodies touch and nowhere else.
Right right_distances(double distance, Precision precision, double slack) {
  if (precision != Precision::exact) {
    return {distance - slack, distance + slack};
  }
  return distance == 0 ? Right{}
                       : Right{std::max(distance - slack, std::numeric_limits<double>::min()),
                               distance + slack};
}

/// Twice the mean side along y: the width of a strip.
double strip_width(std::span<const FloatBox> boxes) {
  double sum = 0;
  for (const FloatBox& b : boxes) {
    sum += static_cast<double>(b.upper[1]) - b.lower[1];
  }
  const double width = boxes.empty() ? 1 : 2 * sum / static_cast<double>(boxes.size());
  return width > 0 ? width : 1;
}

/// Overlapping pairs of boxes: a sweep along x in each strip of y that a box reaches into. A pair
/// is counted in the strip where its common part begins.
std::uint64_t count_pairs(std::span<const FloatBox> boxes) {
  const double width = strip_width(boxes);
  const auto strip_of = [width](float y) {
    return static_cast<std::int64_t>(std::floor(static_cast<double>(y) / width));
  };
  std::unordered_map<std::int64_t, std::vector<FloatBox>> strips;
  for (const FloatBox& b : boxes) {
    for (std::int64_t k = strip_of(b.lower[1]); k <= strip_of(b.upper[1]); ++k) {
      strips[k].push_back(b);
    }
  }
  std::uint64_t count = 0;
  for (auto& [k, strip] : strips) {
    std::sort(strip.begin(), strip.end(),
              [](const FloatBox& a, const FloatBox& b) { return a.lower[0] < b.lower[0]; });
    for (std::size_t i = 0; i < strip.size(); ++i) {
      for (std::size_t j = i + 1; j < strip.size() && strip[j].lower[0] <= strip[i].upper[0]; ++j) {
        const bool here = strip_of(std::max(strip[i].lower[1], strip[j].lower[1])) == k;
        count += here && overlaps(strip[i], strip[j]) ? 1U : 0U;
      }
    }
  }
  return count;
}

}  // namespace

std::vector<Verdict> judge(std::span<const Answers> answers, const Rules& rules) {
  std::vector<Verdict> verdicts(answers.size());
  std::vector<Checked> contested(answers.size());
  for (std::size_t i = 0; i < longest(answers); ++i) {
    const bool open = any_contradiction(answers, rules, i);
    if (!open && !rules.sampled(i)) {
      continue;
    }
    for (std::size_t k = 0; k < answers.size(); ++k) {
      if (i < answers[k].values.size()) {
        const Right right = rules.right(i, answers[k].precision);
        const double value = answers[k].values[i];
        const bool wrong = !(right.least <= value && value <= right.most);
        ++verdicts[k].checked;
        contested[k].answers += open ? 1 : 0;
        contested[k].wrong += open && wrong ? 1 : 0;
        if (wrong) {
          ++verdicts[k].wrong;
          verdicts[k].wrong_questions.push_back(i);
        }
      }
    }
  }
  for (std::size_t k = 0; k < answers.size(); ++k) {
    verdicts[k].share = wrong_share(verdicts[k], contested[k], answers[k].values.size());
  }
  return verdicts;
}

Rules rules_of_counts(const std::function<std::uint64_t(std::size_t)>& count) {
  const auto known = std::make_shared<std::unordered_map<std::size_t, double>>();
  return {[count, known](std::size_t i, Precision) {
            const auto [at, first] = known->try_emplace(i, 0);
            at->second = first ? static_cast<double>(count(i)) : at->second;
            return Right{at->second, at->second};
          },
          differ, [](std::size_t) { return true; }};
}

std::vector<Verdict> judge(std::span<const PairCounter> links, const Questions& questions,
                           std::span<const Answers> answers, double budget) {
  std::size_t triangles = 0;
  for (const PairCounter& link : links) {
    triangles += link.mover_triangles();
  }
  const std::size_t stride = stride_of(longest(answers), triangles, budget);
  Rules rules = rules_of_counts([&](std::size_t i) {
    const bool any = questions.job == Job::any;
    std::uint64_t count = 0;
    for (std::size_t k = 0; k < links.size() && !(any && count != 0); ++k) {
      count += links[k].count(questions.poses[i * links.size() + k], any);
    }
    return count;
  });
  rules.sampled = [stride](std::size_t i) { return i % stride == 0; };
  return judge(answers, rules);
}

std::vector<Verdict> judge(std::span<const std::vector<FloatBox>> frames,
                           std::span<const Answers> answers) {
  const std::size_t n = longest(answers);
  Rules rules = rules_of_counts([&](std::size_t i) { return count_pairs(frames[i]); });
  rules.sampled = [n](std::size_t i) { return i == 0 || i == n / 2 || i + 1 == n; };
  return judge(answers, rules);
}

std::vector<Verdict> judge(const DistanceJudge& measure, const Questions& questions,
                           std::span<const Answers> answers, double budget) {
  const std::size_t stride = stride_of(longest(answers), measure.mover_triangles(), budget);
  const auto pose_of = [&](std::size_t i) {
    if (questions.job != Job::closest) {
      return questions.poses[i];
    }
    const Vec3& p = questions.points[i];
    return Pose::translation(p.x, p.y, p.z);
  };
  std::unordered_map<std::size_t, double> known;
  const auto right = [&](std::size_t i, Precision precision) {
    const auto [at, first] = known.try_emplace(i, 0);
    at->second = first ? measure.distance(pose_of(i)) : at->second;
    const Right near = right_distances(at->second, precision, measure.slack(precision, pose_of(i)));
    if (questions.job != Job::within) {
      return near;
    }
    const double clearance = questions.clearances[i];
    return Right{near.most <= clearance ? 1.0 : 0.0, near.least <= clearance ? 1.0 : 0.0};
  };
  const auto contradict = [&](std::size_t i, const Answers& a, const Answers& b) {
    const double slack = questions.job == Job::within ? 0
                                                      : measure.slack(a.precision, pose_of(i)) +
                                                            measure.slack(b.precision, pose_of(i));
    return !(std::abs(a.values[i] - b.values[i]) <= slack);
  };
  return judge(answers, {right, contradict, [stride](std::size_t i) { return i % stride == 0; }});
}

std::vector<Verdict> judge(const SolidJudge& solids, const Questions& questions,
                           std::span<const Answers> answers, double budget) {
  const std::size_t stride = stride_of(longest(answers), solids.looks(), budget);
  std::unordered_map<std::size_t, double> known;
  const auto right = [&](std::size_t i, Precision) {
    const auto [at, first] = known.try_emplace(i, 0);
    at->second = first ? solids.relation(questions.poses[i]) : at->second;
    const bool open = at->second == SolidJudge::kTouching;
    return Right{at->second, open ? static_cast<double>(Relation::same) : at->second};
  };
  return judge(answers, {right, differ, [stride](std::size_t i) { return i % stride == 0; }});
}

std::vector<Verdict> judge(const SideJudge& sides, const Questions& questions,
                           std::span<const Answers> answers, double budget) {
  const std::size_t stride = stride_of(longest(answers), sides.looks(), budget);
  std::unordered_map<std::size_t, double> known;
  const auto right = [&](std::size_t i, Precision) {
    const auto [at, first] = known.try_emplace(i, 0);
    at->second = first ? sides.side(questions.points[i]) : at->second;
    return at->second == SideJudge::kOpen ? Right{0, 1} : Right{at->second, at->second};
  };
  return judge(answers, {right, differ, [stride](std::size_t i) { return i % stride == 0; }});
}

std::vector<Verdict> judge(const RayJudge& rays, const Questions& questions,
                           std::span<const Answers> answers, double budget) {
  const std::size_t stride = stride_of(longest(answers), rays.looks(), budget);
  const auto right = [&](std::size_t i, Precision precision) {
    const Crossings found = rays.crossings(questions.rays[i], precision);
    if (questions.job == Job::closest_hit) {
      return Right{found.least, found.most};
    }
    return Right{found.sure != 0 ? 1.0 : 0.0, found.sure + found.open != 0 ? 1.0 : 0.0};
  };
  const auto contradict = [&](std::size_t i, const Answers& a, const Answers& b) {
    const ProbeRay& ray = questions.rays[i];
    const double slack = (rays.slack(ray, a.precision) + rays.slack(ray, b.precision)) /
                         std::sqrt(dot(ray.direction, ray.direction));
    const bool rounded =
        questions.job == Job::closest_hit && std::abs(a.values[i] - b.values[i]) <= slack;
    return a.values[i] != b.values[i] && !rounded;
  };
  return judge(answers, {right, contradict, [stride](std::size_t i) { return i % stride == 0; }});
}

}  // namespace soms::bench
