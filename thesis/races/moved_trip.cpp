#include "thesis/races/moved_trip.h"

#include "soms/base/arithmetic.h"
#include "soms/geometry/triangle_overlap.h"
#include "soms/thesis/traversals.h"

#include "thesis/races/e_node_chain.h"
#include "thesis/run/traversal_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <numeric>
#include <utility>

namespace soms::reproduce {

namespace {

/// Runs before the clock counts: enough to fill the caches, for rounds that are whole trips.
constexpr int kWarmUp = 2;

constexpr std::uint64_t kAll = std::numeric_limits<std::uint64_t>::max();

}  // namespace

MovedTrip::MovedTrip(const Trip& trip, const Limits& limits)
    : trip_(&trip), still_(trip.a.mesh(), *trip.a.tree()) {
  still_.move(Pose::identity());
  PosedBoxes moving(trip.b.mesh(), *trip.b.tree());
  for (std::size_t k = 0; k < trip.offsets.size(); ++k) {
    check_stop(limits);
    moving.move(trip.pose(k));
    boxes_.push_back(moving.boxes());
    vertices_.push_back(moving.vertices());
  }
}

std::vector<std::size_t> MovedTrip::all_frames() const {
  std::vector<std::size_t> frames(boxes_.size());
  std::iota(frames.begin(), frames.end(), std::size_t{0});
  return frames;
}

Triangle MovedTrip::moved(std::size_t frame, TriangleId triangle) const {
  const auto& corners = trip_->b.mesh().triangles[triangle];
  const std::vector<Vec3>& vertices = vertices_[frame];
  return {vertices[corners[0]], vertices[corners[1]], vertices[corners[2]]};
}

std::uint64_t MovedTrip::contacts(std::size_t frame, NodePair leaves, std::uint64_t most) const {
  const Tree& a = *trip_->a.tree();
  const Tree& b = *trip_->b.tree();
  std::uint64_t count = 0;
  for (const TriangleId j : b.triangles_of(b.nodes[leaves.b])) {
    const Triangle t = moved(frame, j);
    const Box box = bounds(t);
    for (const TriangleId i : a.triangles_of(a.nodes[leaves.a])) {
      const Triangle s = still_.triangle(i);
      if (overlaps(bounds(s), box) && triangles_overlap(s, t) && ++count == most) {
        return count;
      }
    }
  }
  return count;
}

FrameTraversal::FrameTraversal(const MovedTrip& moved, const TripRacer& racer)
    : moved_(&moved), racer_(&racer), function_(entry(racer.options.traversal).function) {
  // Checks the trees once: to look for their depths in each frame would slow recursion alone.
  (void)traverse(moved.still(), moved.moving(0), racer.options);
  if (racer.options.traversal == Traversal::e_node_front) {
    front_.emplace(*moved.trip().a.tree(), *moved.trip().b.tree(), racer.options.descent,
                   racer.options.order);
  }
}

void FrameTraversal::restart() {
  if (front_) {
    front_->restart();
  }
}

TraversalCounts FrameTraversal::run(std::size_t frame, const TraversalVisitor& visitor) {
  const PlainArithmetic plain;
  const PosedTree still = moved_->still();
  const PosedTree moving = moved_->moving(frame);
  if (front_) {
    return front_->next(still.boxes, moving.boxes, visitor);
  }
  return racer_->chain ? e_node_chain(still, moving, racer_->options.recursive, visitor, workspace_)
                       : function_(still, moving, racer_->options, visitor, workspace_);
}

std::uint64_t ask(const MovedTrip& moved, FrameTraversal& traversal, Question question,
                  std::span<const std::size_t> frames) {
  std::uint64_t answer = 0;
  std::size_t frame = 0;
  TraversalVisitor visitor;
  if (question == Question::contacts) {
    visitor.leaf_pair = [&](NodePair leaves) {
      answer += moved.contacts(frame, leaves, kAll);
      return true;
    };
  } else if (question == Question::first_leaf_pair) {
    visitor.leaf_pair = [&](NodePair) {
      ++answer;
      return false;
    };
  } else if (question == Question::first_contact) {
    visitor.leaf_pair = [&](NodePair leaves) {
      const std::uint64_t hit = moved.contacts(frame, leaves, 1);
      answer += hit;
      return hit == 0;
    };
  }
  traversal.restart();
  for (const std::size_t k : frames) {
    frame = k;
    const std::uint64_t leaf_pairs = traversal.run(k, visitor).leaf_pairs;
    answer += question == Question::leaf_pairs ? leaf_pairs : 0;
  }
  return answer;
}

std::vector<std::size_t> middle_of(std::span<const std::size_t> frames, std::size_t share) {
  const std::size_t count =
      std::min(frames.size(), std::max<std::size_t>(1, frames.size() / share));
  const auto first = frames.begin() + static_cast<std::ptrdiff_t>((frames.size() - count) / 2);
  return {first, first + static_cast<std::ptrdiff_t>(count)};
}

std::vector<Timing> race(RaceProcess& process, const MovedTrip& moved, const TripRace& race,
                         const Limits& limits) {
  const Trip& trip = moved.trip();
  std::vector<FrameTraversal> traversals;
  for (const TripRacer& racer : race.racers) {
    traversals.emplace_back(moved, racer);
  }
  std::vector<std::uint64_t> answers(race.racers.size());
  std::vector<std::function<void()>> works;
  for (std::size_t i = 0; i < race.racers.size(); ++i) {
    works.emplace_back([&, i] {
      for (std::size_t pass = 0; pass < race.passes; ++pass) {
        answers[i] = ask(moved, traversals[i], race.question, race.frames);
      }
    });
  }
  const RaceRounds shared{
      .label = fmt::format("{} of {} past {}, {}, question {}, {} frames {} times", trip.test,
                           trip.moving, trip.still, trip.rule, static_cast<int>(race.question),
                           race.frames.size(), race.passes),
      .rounds = race.rounds,
      .warm_up = rounds_of_each(process, kWarmUp)};
  std::vector<Timing> timings = time_in_turn(process, shared, limits, works);
  for (std::size_t i = 1; i < answers.size(); ++i) {
    require(answers[i] == answers[0],
            fmt::format("{} of {} past {}: answers by {} and by {}", trip.test, trip.moving,
                        trip.still, race.racers[i].name, race.racers[0].name));
  }
  for (Timing& timing : timings) {
    for (double& round : timing.rounds) {
      round /= static_cast<double>(race.passes);
    }
    timing = summarize(std::move(timing.rounds), timing.processes);
  }
  return timings;
}

}  // namespace soms::reproduce
