#include "apps/soms/simulate/simulate_run.h"

#include "soms/base/error.h"
#include "soms/base/hash.h"

#include "apps/cli/machine_use.h"
#include "apps/report/placing.h"
#include "apps/soms/simulate/simulate_events.h"

#include <algorithm>
#include <chrono>
#include <memory>
#include <numeric>
#include <optional>
#include <utility>

namespace soms::command {

namespace {

using Clock = std::chrono::steady_clock;

/// Places remembered of each mover, about.
constexpr std::uint64_t kPlacesOfATrack = 100;

Place place_of(const World& world, std::size_t mover, const Pose& pose) {
  const Vec3 at = pose.apply(world.models[world.routes[mover].model].foot);
  return {static_cast<float>(at.x), static_cast<float>(at.y)};
}

/// Poses of one frame, set and stepped; the time of both.
StepReport run_frame(Scene& scene, const World& world, std::uint64_t frame, const StepOptions& step,
                     const Limits& limits, std::vector<Pose>& poses,
                     std::vector<std::size_t>& lines, float& seconds) {
  constexpr std::uint32_t kPosesBetweenAsks = 4096;
  const auto begin = Clock::now();
  constexpr std::size_t kAhead = 8;
  for (std::uint32_t k = 0; k < world.routes.size(); ++k) {
    if (k % kPosesBetweenAsks == 0) {
      check_stop(limits);
    }
    if (k + kAhead < world.routes.size()) {
      world.routes[k + kAhead].fetch(lines[k + kAhead]);
    }
    poses[k] = world.routes[k].at(frame, lines[k]);
    scene.set_pose(k, poses[k]);
  }
  StepReport report = scene.step(step, limits);
  seconds = std::chrono::duration<float>(Clock::now() - begin).count();
  return report;
}

class Run {
 public:
  Run(const World& world, const SimulateOptions& options, Console& console, Recorder* recorder,
      Scene scene)
      : world_(world),
        options_(options),
        console_(console),
        recorder_(recorder),
        scene_(std::move(scene)),
        bodies_(event_bodies(world, scene_)),
        poses_(world.routes.size()),
        lines_(world.routes.size()),
        pause_(std::max<std::uint64_t>(1, options.frames / kPlacesOfATrack)) {
    if (options.traversal->named()) {
      method_ = options.traversal->method();
    }
    outcome_.tracks.resize(world.routes.size());
    if (options.verify) {
      verifier_.emplace(world, console.shared().seed);
      if (options.clearance > 0) {
        gap_verifier_.emplace(world, options.clearance, console.shared().seed);
        outcome_.verified_gaps.emplace();
      }
      if (options.swept) {
        passage_verifier_.emplace(world, console.shared().seed);
        outcome_.verified_passages.emplace();
      }
    }
  }

  Outcome go() {
    Progress bar = console_.progress("simulating");
    Fnv1a hash;
    for (std::uint64_t frame = 0; frame < options_.frames && !ended(); ++frame) {
      try {
        hash.add(run(frame));
      } catch (const Error& error) {
        if (error.kind() != ErrorKind::cancelled || !ended()) {
          throw;
        }
        break;
      }
      bar.show(static_cast<double>(frame + 1) / static_cast<double>(options_.frames));
    }
    outcome_.contacts.finish();
    outcome_.near.finish();
    outcome_.hash = hash.value();
    if (verifier_) {
      outcome_.verified = verifier_->result();
    }
    return std::move(outcome_);
  }

 private:
  bool ended() {
    if (console_.interrupted()) {
      outcome_.ending = Ending::interrupted;
    } else if (console_.out_of_time()) {
      outcome_.ending = Ending::timed_out;
    }
    return outcome_.ending != Ending::whole;
  }

  /// One frame, whole or (by an exception) not at all.
  std::uint64_t run(std::uint64_t frame) {
    float seconds = 0;
    const Limits limits = console_.limited();
    const std::vector<Pose> before = passage_verifier_ ? poses_ : std::vector<Pose>();
    const StepReport report = run_frame(scene_, world_, frame,
                                        {.mover_mover = world_.filter.between,
                                         .method = method_.get(),
                                         .clearance = options_.clearance,
                                         .swept = options_.swept},
                                        limits, poses_, lines_, seconds);
    VerifiedGaps gaps;
    if (gap_verifier_) {
      gaps = gap_verifier_->verify(report, poses_, limits);
    }
    if (verifier_) {
      verifier_->verify(report, poses_, limits);
    }
    VerifiedPassages passages;
    if (passage_verifier_ && frame > 0) {
      passages = passage_verifier_->verify(report, before, poses_, limits);
    }
    if (recorder_ != nullptr) {
      recorder_->add(poses_, report);
    }
    look_for_neighbors();
    outcome_.contacts.add(report, frame);
    outcome_.events.follow(frame, report, bodies_);
    if (options_.clearance > 0) {
      outcome_.near.add(report, frame);
    }
    outcome_.passages.add(report, frame);
    if (outcome_.verified_gaps) {
      *outcome_.verified_gaps += gaps;
    }
    if (outcome_.verified_passages) {
      *outcome_.verified_passages += passages;
    }
    outcome_.queries += report.queries + report.gap_queries + report.passage_queries;
    outcome_.cost += report.cost;
    outcome_.frame_seconds.push_back(seconds);
    if (frame % pause_ == 0 || frame + 1 == options_.frames) {
      for (std::size_t k = 0; k < poses_.size(); ++k) {
        outcome_.tracks[k].push_back(place_of(world_, k, poses_[k]));
      }
    }
    ++outcome_.frames;
    return report.hash();
  }

  /// Ends with the first mover that is near the city, commonly in the first frame.
  void look_for_neighbors() {
    for (std::size_t k = 0; k < poses_.size() && !near_; ++k) {
      const Shape& shape = world_.models[world_.routes[k].model].shape;
      outcome_.boxes.look(report::moved(shape.bounds(), poses_[k]), world_.bounds);
      near_ = !outcome_.boxes.apart();
    }
  }

  const World& world_;
  const SimulateOptions& options_;
  Console& console_;
  Recorder* recorder_;
  Scene scene_;
  ContactBodies bodies_;
  std::vector<Pose> poses_;
  std::vector<std::size_t> lines_;  ///< of the routes, on which the movers are
  std::uint64_t pause_;
  std::unique_ptr<OverlapMethod> method_;  ///< none: the default
  bool near_ = false;                      ///< a mover was near the city
  std::optional<Verifier> verifier_;
  std::optional<GapVerifier> gap_verifier_;
  std::optional<PassageVerifier> passage_verifier_;
  Outcome outcome_;
};

double fps(double seconds) {
  return seconds > 0 ? 1 / seconds : 0;
}

}  // namespace

bool Outcome::is_wrong() const {
  return (verified && verified->wrong > 0) || (verified_gaps && verified_gaps->wrong > 0) ||
         (verified_passages && verified_passages->wrong > 0);
}

double Outcome::median_fps() const {
  if (frame_seconds.empty()) {
    return 0;
  }
  std::vector<float> sorted = frame_seconds;
  const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
  std::nth_element(sorted.begin(), middle, sorted.end());
  return fps(static_cast<double>(*middle));
}

double Outcome::worst_fps() const {
  return frame_seconds.empty() ? 0
                               : fps(static_cast<double>(*std::max_element(frame_seconds.begin(),
                                                                           frame_seconds.end())));
}

double Outcome::queries_a_second() const {
  const double all =
      std::accumulate(frame_seconds.begin(), frame_seconds.end(), 0.0,
                      [](double sum, float s) { return sum + static_cast<double>(s); });
  return all > 0 ? static_cast<double>(queries) / all : 0;
}

Outcome run_frames(const World& world, const SimulateOptions& options, Console& console,
                   Recorder* recorder) {
  Scene scene = console.run("placing movers",
                            [&](const Limits& limits) { return make_scene(world, limits); });
  const MachineUse use;
  Outcome outcome = Run(world, options, console, recorder, std::move(scene)).go();
  outcome.share_of_others = use.share_of_others();
  return outcome;
}

}  // namespace soms::command
