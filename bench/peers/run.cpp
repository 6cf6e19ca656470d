#include "bench/peers/run.h"

#include "bench/peers/core/machine.h"
#include "bench/peers/scenarios/solids.h"

#include <algorithm>
#include <numeric>
#include <optional>

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

Ready prepare(const Library& library, std::span<const FloatMesh> movers, const FloatMesh& fixed) {
  Ready ready{&library, {}, 0, 0};
  const std::size_t before = heap_bytes();
  const double start = processor_seconds();
  for (const FloatMesh& mover : movers) {
    ready.matches.push_back(library.prepare(mover, fixed));
  }
  ready.build = processor_seconds() - start;
  std::size_t bytes = heap_bytes() - before;
  std::size_t triangles = 0;
  for (std::size_t i = 0; i < movers.size(); ++i) {
    bytes += ready.matches[i]->unseen_bytes();
    triangles += movers[i].triangles.size() + fixed.triangles.size();
  }
  ready.bytes = static_cast<double>(bytes) / static_cast<double>(triangles);
  return ready;
}

Cell new_cell(const Scene& scene, Job job, const std::string& set) {
  Cell cell;
  cell.job = job;
  cell.scene = scene.name;
  cell.set = set;
  cell.triangles = scene.fixed.triangles.size();
  cell.mover = scene.mover.triangles.size();
  return cell;
}

using Judge = std::function<std::vector<Verdict>(std::span<const std::vector<std::uint64_t>>)>;

/// Races the lanes of a cell and has the answers judged.
Cell settle(Cell cell, std::span<const Ready> ready, std::span<const Lane> lanes,
            std::size_t questions, const RaceOptions& options, const Judge& judge) {
  const std::vector<Outcome> outcomes = race(lanes, questions, options);
  std::vector<std::vector<std::uint64_t>> answers;
  for (const Outcome& outcome : outcomes) {
    answers.push_back(outcome.answers);
    cell.questions = std::max(cell.questions, outcome.answers.size());
  }
  const std::vector<Verdict> verdicts = judge(answers);
  for (std::size_t k = 0; k < lanes.size(); ++k) {
    const Library& c = *ready[k].library;
    cell.entries.push_back({c.name(), c.version(), ready[k].build, ready[k].bytes, c.keeps_tree(),
                            answers[k].size(), outcomes[k].timing, verdicts[k]});
    if (answers[k].size() == cell.questions && verdicts[k].wrong == 0) {
      cell.sum = std::accumulate(answers[k].begin(), answers[k].end(), std::uint64_t{0});
    }
  }
  return cell;
}

/// The libraries for `job`, with lanes that ask their only match.
void run_poses(const Scene& scene, const PoseSet& set, Job job, std::span<Ready> ready,
               const PairCounter& counter, const RunOptions& options, const Sink& sink) {
  std::vector<Lane> lanes;
  std::vector<Ready> racing;
  for (Ready& r : ready) {
    if (r.library->does(job)) {
      Match* match = r.matches.front().get();
      lanes.push_back({r.library->name(), [match, job, &set](std::span<std::uint64_t> answers) {
                         match->answer(job, std::span(set.poses).first(answers.size()), answers);
                       }});
      racing.push_back({r.library, {}, r.build, r.bytes});
    }
  }
  const Judge decide = [&](std::span<const std::vector<std::uint64_t>> answers) {
    return judge(counter, job, set.poses, answers, options.judge);
  };
  if (!lanes.empty()) {
    sink(settle(new_cell(scene, job, set.name), racing, lanes, set.poses.size(), options.race,
                decide));
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
      ready.push_back(prepare(*library, movers, scene.fixed));
    }
  }
  lanes.reserve(ready.size());
  for (const Ready& r : ready) {
    lanes.push_back({r.library->name(), [&r](std::span<std::uint64_t> answers) {
                       const Pose here;
                       for (std::size_t i = 0; i < answers.size(); ++i) {
                         r.matches[i]->answer(Job::still, {&here, 1}, answers.subspan(i, 1));
                       }
                     }});
  }
  const Judge decide = [&](std::span<const std::vector<std::uint64_t>> answers) {
    std::vector<Verdict> verdicts(answers.size());
    for (std::size_t i = 0; i < movers.size(); ++i) {
      const std::uint64_t truth = PairCounter(movers[i], scene.fixed).count({}, false);
      for (std::size_t k = 0; k < answers.size(); ++k) {
        if (i < answers[k].size()) {
          ++verdicts[k].checked;
          if (answers[k][i] != truth) {
            ++verdicts[k].wrong;
            verdicts[k].wrong_questions.push_back(i);
          }
        }
      }
    }
    return verdicts;
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
    lanes.push_back({library->name(), [moving_boxes, &set](std::span<std::uint64_t> answers) {
                       for (std::size_t i = 0; i < answers.size(); ++i) {
                         answers[i] = moving_boxes->step(set.frames[i]);
                       }
                     }});
  }
  Cell cell = new_cell(scene, Job::broad, set.name);
  cell.triangles = set.frames.front().size();
  const Judge decide = [&](std::span<const std::vector<std::uint64_t>> answers) {
    return judge(set.frames, answers);
  };
  if (!lanes.empty()) {
    sink(settle(std::move(cell), ready, lanes, set.frames.size(), options.race, decide));
  }
}

std::vector<Ready> prepare_all(const Scene& scene, const Roster& roster,
                               const RunOptions& options) {
  std::vector<Ready> ready;
  for (const auto& library : roster) {
    const bool requested = (library->does(Job::any) && has(options.jobs, Job::any)) ||
                           (library->does(Job::all) && has(options.jobs, Job::all));
    const std::size_t larger = std::max(scene.mover.triangles.size(), scene.fixed.triangles.size());
    if (requested && library->takes(larger) && wanted(options, *library)) {
      ready.push_back(prepare(*library, {&scene.mover, 1}, scene.fixed));
    }
  }
  return ready;
}

}  // namespace

void run_scene(const Scene& scene, const Roster& roster, const RunOptions& options,
               const Sink& sink) {
  const auto chosen = [&](const std::string& set) {
    return options.sets.empty() || has(options.sets, set);
  };
  for (const MovingBoxSet& set : scene.moving_sets) {
    if (has(options.jobs, Job::broad) && chosen(set.name)) {
      run_moving_boxes(scene, set, roster, options, sink);
    }
  }
  if (scene.sets.empty()) {
    return;
  }
  if (has(options.jobs, Job::any) || has(options.jobs, Job::all)) {
    std::vector<Ready> ready = prepare_all(scene, roster, options);
    const PairCounter counter(scene.mover, scene.fixed);
    for (const PoseSet& set : scene.sets) {
      for (const Job job : {Job::any, Job::all}) {
        if (has(options.jobs, job) && chosen(set.name) && (job == Job::any || set.all)) {
          run_poses(scene, set, job, ready, counter, options, sink);
        }
      }
    }
  }
  for (const PoseSet& set : scene.sets) {
    if (has(options.jobs, Job::still) && chosen(set.name) && set.still != 0) {
      run_still(scene, set, roster, options, sink);
    }
  }
}

}  // namespace soms::bench
