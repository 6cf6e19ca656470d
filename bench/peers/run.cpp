#include "bench/peers/run.h"

#include "soms/query/distance.h"

#include "bench/peers/core/machine.h"
#include "bench/peers/links.h"
#include "bench/peers/scenarios/solids.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <memory>
#include <utility>

namespace soms::bench {

namespace {

/// A library with its bodies built, and what that took.
struct Ready {
  const Library* library = nullptr;
  std::vector<std::unique_ptr<Match>> matches;
  double build = 0;
  double bytes = 0;
};

template <class Item>
bool has(const std::vector<Item>& list, const Item& item) {
  return std::find(list.begin(), list.end(), item) != list.end();
}

bool wanted(const RunOptions& options, const Library& library) {
  return options.libraries.empty() ||
         std::any_of(options.libraries.begin(), options.libraries.end(),
                     [&](const std::string& name) { return library.name().starts_with(name); });
}

/// Builds matches of so many triangles in all.
template <class Build>
Ready prepare(const Library& library, std::size_t triangles, const Build& build) {
  Ready ready{&library, {}, 0, 0};
  const std::size_t before = heap_bytes();
  const double start = processor_seconds();
  build(ready.matches);
  ready.build = processor_seconds() - start;
  std::size_t bytes = heap_bytes() - before;
  for (const auto& match : ready.matches) {
    bytes += match->unseen_bytes();
  }
  ready.bytes = static_cast<double>(bytes) / static_cast<double>(triangles);
  return ready;
}

/// A match for each mover, with fixed bodies of their own or, where the library can, with one.
Ready prepare(const Library& library, std::span<const FloatMesh> movers, const FloatMesh& fixed,
              bool shared) {
  std::size_t triangles = shared ? fixed.triangles.size() : 0;
  for (const FloatMesh& mover : movers) {
    triangles += mover.triangles.size() + (shared ? 0 : fixed.triangles.size());
  }
  return prepare(library, triangles, [&](auto& matches) {
    for (const FloatMesh& mover : movers) {
      auto match = shared && !matches.empty() ? matches.front()->with(mover) : nullptr;
      matches.push_back(match ? std::move(match) : library.prepare(mover, fixed));
    }
  });
}

/// The bodies that move: one, or an arm's links.
std::span<const FloatMesh> movers_of(const Scene& scene) {
  return scene.links.empty() ? std::span(&scene.mover, 1) : std::span(scene.links);
}

Cell new_cell(const Scene& scene, Job job, const std::string& set) {
  Cell cell;
  cell.job = job;
  cell.scene = scene.name;
  cell.set = set;
  cell.triangles = scene.fixed.triangles.size();
  for (const FloatMesh& mover : movers_of(scene)) {
    cell.mover += mover.triangles.size();
  }
  return cell;
}

double sum_of_finite(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) {
    sum += std::isfinite(value) ? value : 0;
  }
  return sum;
}

using Judge = std::function<std::vector<Verdict>(std::span<const Answers>)>;

/// Races the lanes of a cell and has the answers judged.
Cell settle(Cell cell, std::span<const Ready> ready, std::span<const Lane> lanes,
            std::size_t questions, const RaceOptions& options, const Judge& judge) {
  const std::vector<Outcome> outcomes = race(lanes, questions, options);
  std::vector<Answers> answers;
  for (std::size_t k = 0; k < lanes.size(); ++k) {
    answers.push_back({outcomes[k].answers, ready[k].library->precision()});
    cell.questions = std::max(cell.questions, answers[k].values.size());
  }
  const std::vector<Verdict> verdicts = judge(answers);
  for (std::size_t k = 0; k < lanes.size(); ++k) {
    const Library& c = *ready[k].library;
    const std::vector<double>& values = answers[k].values;
    cell.entries.push_back({c.name(), c.version(), ready[k].build, ready[k].bytes, c.keeps_tree(),
                            c.watertight(), values.size(), outcomes[k].timing, verdicts[k]});
    if (values.size() == cell.questions && verdicts[k].wrong == 0) {
      cell.sum = sum_of_finite(values);
    }
  }
  return cell;
}

/// Judges the answers to questions about poses, points or rays.
using QuestionJudge = std::function<std::vector<Verdict>(const Questions& questions,
                                                         std::span<const Answers> answers)>;

/// Has a library answer by its only match, or by one for each link.
void answer(const Ready& ready, const Questions& questions, std::span<double> answers) {
  if (ready.matches.size() == 1) {
    ready.matches.front()->answer(questions, answers);
  } else {
    answer_links(ready.matches, questions, ready.library->batches(), answers);
  }
}

/// The libraries for the job, in lanes.
void run_questions(const Scene& scene, const std::string& set, const Questions& questions,
                   std::span<const Ready> ready, const QuestionJudge& judge,
                   const RunOptions& options, const Sink& sink) {
  std::vector<Lane> lanes;
  std::vector<Ready> racing;
  for (const Ready& r : ready) {
    if (r.library->does(questions.job)) {
      lanes.push_back({r.library->name(), [&r, &questions](std::span<double> answers) {
                         answer(r, questions.first(answers.size()), answers);
                       }});
      racing.push_back({r.library, {}, r.build, r.bytes});
    }
  }
  if (!lanes.empty() && questions.size() != 0) {
    sink(settle(new_cell(scene, questions.job, set), racing, lanes, questions.size(), options.race,
                [&](std::span<const Answers> answers) { return judge(questions, answers); }));
  }
}

/// Clearances as shares of the true distance, at the poses that leave one: one set for each share.
void run_clearances(const Scene& scene, const PoseSet& set, std::span<const Ready> ready,
                    const QuestionJudge& judge, const RunOptions& options, const Sink& sink) {
  const DistanceBatch all =
      distance(Shape(widened(scene.mover)), set.poses, Body(widened(scene.fixed)));
  std::vector<Pose> poses;
  std::vector<double> distances;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all.lower[i] > 0) {
      poses.push_back(set.poses[i]);
      distances.push_back(all.lower[i]);
    }
  }
  for (const auto& [name, share] : {std::pair{"half ", 0.5}, {"0.99 ", 0.99}, {"1.01 ", 1.01}}) {
    std::vector<double> clearances = distances;
    for (double& clearance : clearances) {
      clearance *= share;
    }
    run_questions(scene, name + set.name, {Job::within, poses, clearances}, ready, judge, options,
                  sink);
  }
}

FloatMesh placed(const FloatMesh& mesh, const Pose& pose) {
  FloatMesh result = mesh;
  for (auto& v : result.vertices) {
    v = narrow(pose.apply(wide(v)));
  }
  return result;
}

/// Bodies that stand still: the mover is placed and rounded once, the same for all.
void run_still(const Scene& scene, const PoseSet& set, const Roster& roster,
               const RunOptions& options, const Sink& sink) {
  std::vector<FloatMesh> movers;
  const std::size_t poses = std::min(set.still, set.poses.size());
  movers.reserve(poses);
  for (std::size_t i = 0; i < poses; ++i) {
    movers.push_back(placed(scene.mover, set.poses[i]));
  }
  std::vector<Ready> ready;
  std::vector<Lane> lanes;
  for (const auto& library : roster) {
    if (library->does(Job::still) && wanted(options, *library)) {
      ready.push_back(prepare(*library, movers, scene.fixed, false));
    }
  }
  lanes.reserve(ready.size());
  for (const Ready& r : ready) {
    lanes.push_back({r.library->name(), [&r](std::span<double> answers) {
                       const Pose here;
                       for (std::size_t i = 0; i < answers.size(); ++i) {
                         r.matches[i]->answer({Job::still, {&here, 1}}, answers.subspan(i, 1));
                       }
                     }});
  }
  const Judge decide = [&](std::span<const Answers> answers) {
    return judge(answers, rules_of_counts([&](std::size_t i) {
                   return PairCounter(movers[i], scene.fixed).count({}, false);
                 }));
  };
  if (!lanes.empty()) {
    sink(settle(new_cell(scene, Job::still, set.name), ready, lanes, movers.size(), options.race,
                decide));
  }
}

void run_moving_boxes(const Scene& scene, const MovingBoxSet& set, const Roster& roster,
                      const RunOptions& options, const Sink& sink) {
  std::vector<Ready> ready;
  std::vector<std::unique_ptr<MovingBoxes>> moving_sets;
  std::vector<Lane> lanes;
  for (const auto& library : roster) {
    if (!library->does(Job::broad) || !wanted(options, *library)) {
      continue;
    }
    const double start = processor_seconds();
    moving_sets.push_back(library->moving_boxes(set.frames.front()));
    ready.push_back({library.get(), {}, processor_seconds() - start, 0});
    MovingBoxes* moving_boxes = moving_sets.back().get();
    lanes.push_back({library->name(), [moving_boxes, &set](std::span<double> answers) {
                       for (std::size_t i = 0; i < answers.size(); ++i) {
                         answers[i] = static_cast<double>(moving_boxes->step(set.frames[i]));
                       }
                     }});
  }
  Cell cell = new_cell(scene, Job::broad, set.name);
  cell.triangles = set.frames.front().size();
  const Judge decide = [&](std::span<const Answers> answers) { return judge(set.frames, answers); };
  if (!lanes.empty()) {
    sink(settle(std::move(cell), ready, lanes, set.frames.size(), options.race, decide));
  }
}

std::vector<Ready> prepare_all(const Scene& scene, const Roster& roster, std::span<const Job> jobs,
                               const RunOptions& options) {
  std::size_t larger = scene.fixed.triangles.size();
  for (const FloatMesh& mover : movers_of(scene)) {
    larger = std::max(larger, mover.triangles.size());
  }
  std::vector<Ready> ready;
  for (const auto& library : roster) {
    const bool requested =
        std::any_of(jobs.begin(), jobs.end(), [&](Job job) { return library->does(job); });
    if (requested && library->takes(larger) && wanted(options, *library)) {
      ready.push_back(prepare(*library, movers_of(scene), scene.fixed, true));
    }
  }
  return ready;
}

bool chosen(const RunOptions& options, const std::string& set) {
  return options.sets.empty() || has(options.sets, set);
}

/// Jobs about poses that one judge decides; the libraries are prepared once for all of them.
void run_group(const Scene& scene, const Roster& roster, std::initializer_list<Job> group,
               const RunOptions& options, const std::function<QuestionJudge()>& make_judge,
               const Sink& sink) {
  std::vector<std::pair<const PoseSet*, Job>> planned;
  std::vector<Job> jobs;
  for (const PoseSet& set : scene.sets) {
    for (const Job job : group) {
      if (has(options.jobs, job) && chosen(options, set.name) && has(set.jobs, job)) {
        planned.emplace_back(&set, job);
        jobs.push_back(job);
      }
    }
  }
  if (planned.empty()) {
    return;
  }
  const std::vector<Ready> ready = prepare_all(scene, roster, jobs, options);
  const QuestionJudge judge = make_judge();
  for (const auto& [set, job] : planned) {
    if (job == Job::within) {
      run_clearances(scene, *set, ready, judge, options, sink);
    } else {
      Questions questions{job, set->poses};
      questions.links = movers_of(scene).size();
      run_questions(scene, set->name, questions, ready, judge, options, sink);
    }
  }
}

QuestionJudge judge_of_probes(Job job, const FloatMesh& body, double budget) {
  const auto with = [budget](auto judge_of_job) -> QuestionJudge {
    return [judge_of_job, budget](const Questions& questions, std::span<const Answers> answers) {
      return judge(*judge_of_job, questions, answers, budget);
    };
  };
  switch (job) {
    case Job::closest:
      return with(std::make_shared<DistanceJudge>(point_mesh(), body));
    case Job::contains:
      return with(std::make_shared<SideJudge>(body));
    default:
      return with(std::make_shared<RayJudge>(body));
  }
}

/// A job of points or rays; the libraries build what it needs.
void run_probes(const Scene& scene, Job job, const Roster& roster, const RunOptions& options,
                const Sink& sink) {
  std::vector<const ProbeSet*> sets;
  for (const ProbeSet& set : scene.probe_sets) {
    if (chosen(options, set.name) && has(set.jobs, job)) {
      sets.push_back(&set);
    }
  }
  if (sets.empty() || !has(options.jobs, job)) {
    return;
  }
  const std::size_t triangles = scene.fixed.triangles.size();
  std::vector<Ready> ready;
  for (const auto& library : roster) {
    if (library->does(job) && library->takes(triangles) && wanted(options, *library)) {
      ready.push_back(prepare(*library, triangles, [&](auto& matches) {
        matches.push_back(library->prepare_probes(job, scene.fixed));
      }));
    }
  }
  const QuestionJudge judge = judge_of_probes(job, scene.fixed, options.judge);
  for (const ProbeSet* set : sets) {
    const Questions questions{job, {}, {}, set->points, set->rays};
    run_questions(scene, set->name, questions, ready, judge, options, sink);
  }
}

}  // namespace

void run_scene(const Scene& scene, const Roster& roster, const RunOptions& options,
               const Sink& sink) {
  for (const MovingBoxSet& set : scene.moving_sets) {
    if (has(options.jobs, Job::broad) && chosen(options, set.name)) {
      run_moving_boxes(scene, set, roster, options, sink);
    }
  }
  const auto of_counts = [&]() -> QuestionJudge {
    const auto counters = std::make_shared<std::vector<PairCounter>>();
    for (const FloatMesh& mover : movers_of(scene)) {
      counters->emplace_back(mover, scene.fixed);
    }
    return [counters, &options](const Questions& questions, std::span<const Answers> answers) {
      return judge(*counters, questions, answers, options.judge);
    };
  };
  const auto of_distances = [&]() -> QuestionJudge {
    const auto measure = std::make_shared<DistanceJudge>(scene.mover, scene.fixed);
    return [measure, &options](const Questions& questions, std::span<const Answers> answers) {
      return judge(*measure, questions, answers, options.judge);
    };
  };
  run_group(scene, roster, {Job::any, Job::all}, options, of_counts, sink);
  const auto of_solids = [&]() -> QuestionJudge {
    const auto solids = std::make_shared<SolidJudge>(scene.mover, scene.fixed);
    return [solids, &options](const Questions& questions, std::span<const Answers> answers) {
      return judge(*solids, questions, answers, options.judge);
    };
  };
  run_group(scene, roster, {Job::distance, Job::within}, options, of_distances, sink);
  run_group(scene, roster, {Job::solid}, options, of_solids, sink);
  for (const PoseSet& set : scene.sets) {
    if (has(options.jobs, Job::still) && chosen(options, set.name) && set.still != 0) {
      run_still(scene, set, roster, options, sink);
    }
  }
  for (const Job job : {Job::closest, Job::contains, Job::closest_hit, Job::any_hit}) {
    run_probes(scene, job, roster, options, sink);
  }
}

}  // namespace soms::bench
