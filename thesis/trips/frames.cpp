#include "thesis/trips/frames.h"

#include "soms/thesis/named_overlap.h"
#include "soms/thesis/traversals.h"

#include "thesis/trips/statistics.h"

#include <algorithm>
#include <functional>
#include <list>
#include <memory>
#include <mutex>
#include <utility>

namespace soms::reproduce {

namespace {

/// The last shapes and driven meshes that trips were made of: many trips of a run have the same.
class RecentShapes {
 public:
  Shape of(const std::shared_ptr<const Mesh>& mesh, const BuildOptions& build) {
    const std::lock_guard lock(mutex_);
    return recent(
               shapes_, [&](const Made& made) { return made.mesh == mesh && made.build == build; },
               [&] {
                 return Made{mesh, build, Shape(mesh, {.build = build, .keep_tree = true})};
               })
        .shape;
  }

  std::shared_ptr<const Mesh> driven_of(const Model& model) {
    const std::lock_guard lock(mutex_);
    return recent(
               driven_,
               [&](const Driven& made) {
                 return made.mesh == model.mesh && made.fit == model.drive;
               },
               [&] {
                 return Driven{model.mesh, model.drive,
                               std::make_shared<const Mesh>(driven(model))};
               })
        .driven;
  }

 private:
  /// More than one object and all scenes have by the builds of one claim.
  static constexpr std::size_t kMost = 40;

  struct Made {
    std::shared_ptr<const Mesh> mesh = {};
    BuildOptions build = {};
    Shape shape = {};
  };

  struct Driven {
    std::shared_ptr<const Mesh> mesh = {};
    DriveFit fit = {};
    std::shared_ptr<const Mesh> driven = {};
  };

  /// The one that is sought, made now if it is not there; from now on the first.
  template <class Entry, class Is, class Make>
  static const Entry& recent(std::list<Entry>& entries, const Is& is, const Make& make) {
    const auto found = std::find_if(entries.begin(), entries.end(), is);
    if (found != entries.end()) {
      entries.splice(entries.begin(), entries, found);
    } else {
      entries.push_front(make());
      entries.resize(std::min(entries.size(), kMost));
    }
    return entries.front();
  }

  std::mutex mutex_;
  std::list<Made> shapes_ = {};
  std::list<Driven> driven_ = {};
};

RecentShapes& recent_shapes() {
  static RecentShapes shapes;
  return shapes;
}

Shape shape_of(const std::shared_ptr<const Mesh>& mesh, const Contender& build) {
  return recent_shapes().of(mesh, build.options);
}

NamedTraversal e_node_traversal(std::string name, Descent descent, EntryOrder order) {
  return {std::move(name), {.traversal = Traversal::e_node, .descent = descent, .order = order}};
}

NamedTraversal front_traversal(std::string name, Descent descent, EntryOrder order) {
  return {std::move(name),
          {.traversal = Traversal::e_node_front, .descent = descent, .order = order}};
}

std::vector<Timing> summarized(std::vector<std::vector<double>> samples) {
  std::vector<Timing> timings;
  timings.reserve(samples.size());
  for (std::vector<double>& of_one : samples) {
    timings.push_back(of_one.empty() ? Timing{} : summarize(std::move(of_one)));
  }
  return timings;
}

/// Samples of the frames of one traversal, one a repetition.
struct FrameSamples {
  std::vector<std::vector<double>> collision;
  std::vector<std::vector<double>> frame;
};

/// A query of a trip whose still body was moved before.
thesis::NamedOverlap query_of(const Trip& trip, const NamedTraversal& traversal) {
  thesis::NamedOverlap query(trip.a, trip.b, traversal.options);
  query.move(Pose::identity(), Pose::identity());
  return query;
}

/// What reading the processor clock adds to what is timed between two readings, in milliseconds.
double clock_cost() {
  static const double cost = [] {
    std::vector<double> pairs(1001);
    for (double& pair : pairs) {
      const double start = processor_milliseconds();
      pair = processor_milliseconds() - start;
    }
    return median(std::move(pairs));
  }();
  return cost;
}

void time_trip(const TripRun& run, const Limits& limits, FrameSamples& samples) {
  const Trip& trip = *run.trip;
  thesis::NamedOverlap query = query_of(trip, run.traversal);
  for (std::size_t k = 0; k < trip.offsets.size(); k += run.step) {
    const Pose pose = trip.pose(k);
    const double start = processor_milliseconds();
    query.move(Pose::identity(), pose);
    const double moved = processor_milliseconds();
    const Overlap answer = query(Pose::identity(), pose, {}, limits);
    const double end = processor_milliseconds();
    samples.collision[k].push_back(std::max(0.0, end - moved - clock_cost()));
    samples.frame[k].push_back(std::max(0.0, end - start - 2 * clock_cost()));
  }
}

double time_traversal(const Trip& trip, const NamedTraversal& traversal, const Limits& limits,
                      std::size_t step) {
  LeafTraversal leaves(trip, traversal.options);
  double sum = 0;
  for (std::size_t k = 0; k < trip.offsets.size(); k += step) {
    check_stop(limits);
    leaves.move(k);
    const double start = processor_milliseconds();
    (void)leaves.run();
    sum += std::max(0.0, processor_milliseconds() - start - clock_cost());
  }
  return sum;
}

}  // namespace

Trip orientation_trip(const Model& object, Approach from, const Contender& build) {
  const auto named = std::find_if(kAllApproaches.begin(), kAllApproaches.end(),
                                  [&](const auto& entry) { return entry.first == from; });
  Trip trip{.model = object.name,
            .still = object.name,
            .moving = object.name,
            .test = std::string(named->second),
            .rule = build.name,
            .a = shape_of(object.mesh, build)};
  trip.b = trip.a;
  trip.offsets = orientation_test(trip.a.bounds(), from);
  return trip;
}

Trip drive_trip(const Model& scene, const Model& object, const Contender& build_of_scene,
                const Contender& build_of_object) {
  const std::shared_ptr<const Mesh> mover = recent_shapes().driven_of(object);
  return {.model = object.name,
          .still = scene.name,
          .moving = object.drive == DriveFit{}
                        ? object.name + std::to_string(static_cast<int>(kDriveScale))
                        : object.name + "_fitted",
          .test = "drive",
          .rule = build_of_scene.name,
          .a = shape_of(scene.mesh, build_of_scene),
          .b = shape_of(mover, build_of_object),
          .offsets = city_drive()};
}

std::vector<NamedTraversal> all_traversals() {
  std::vector<NamedTraversal> traversals;
  for (const Traversal baseline : {Traversal::a_first, Traversal::b_first, Traversal::alternate,
                                   Traversal::larger, Traversal::simultaneous}) {
    traversals.push_back({std::string(entry(baseline).name), {.traversal = baseline}});
  }
  for (const DescentEntry& descent : descents()) {
    const std::string name = "enode_" + std::string(descent.name);
    traversals.push_back(e_node_traversal(name, descent.descent, EntryOrder::tree));
    traversals.push_back(e_node_traversal(name + "_volume", descent.descent, EntryOrder::volume));
  }
  traversals.push_back(front_traversal("enode_start", Descent::larger, EntryOrder::tree));
  traversals.push_back(front_traversal("enode_start_volume", Descent::larger, EntryOrder::volume));
  traversals.push_back(front_traversal("enode_start_both", Descent::both, EntryOrder::tree));
  traversals.push_back(
      front_traversal("enode_start_both_volume", Descent::both, EntryOrder::volume));
  return traversals;
}

NamedTraversal named_traversal(std::string_view name) {
  const std::vector<NamedTraversal> traversals = all_traversals();
  return *std::find_if(traversals.begin(), traversals.end(),
                       [&](const NamedTraversal& traversal) { return traversal.name == name; });
}

void Totals::add(const Frame& frame) {
  ++frames;
  root_overlap_frames += frame.roots_overlap ? 1U : 0U;
  hit_frames += frame.counts.leaf_pairs > 0 ? 1U : 0U;
  counts += frame.counts;
  triangle_tests += frame.triangle_tests;
  contacts += frame.contacts.size();
}

Totals totals(std::span<const Frame> frames) {
  Totals sum;
  for (const Frame& frame : frames) {
    sum.add(frame);
  }
  return sum;
}

LeafTraversal::LeafTraversal(const Trip& trip, const TraversalOptions& options)
    : trip_(&trip),
      options_(options),
      a_(trip.a.mesh(), *trip.a.tree()),
      b_(trip.b.mesh(), *trip.b.tree()) {
  a_.move(Pose::identity());
  if (options.traversal == Traversal::e_node_front) {
    front_.emplace(*trip.a.tree(), *trip.b.tree(), options.descent, options.order);
  }
}

void LeafTraversal::move(std::size_t frame) {
  b_.move(trip_->pose(frame));
}

TraversalCounts LeafTraversal::run(const TraversalVisitor& visitor) {
  return front_ ? front_->next(a_.boxes(), b_.boxes(), visitor)
                : traverse(a_.view(), b_.view(), options_, visitor, workspace_);
}

bool LeafTraversal::roots_overlap() const {
  return !a_.boxes().empty() && !b_.boxes().empty() &&
         overlaps(a_.boxes().front(), b_.boxes().front());
}

std::vector<Frame> traverse_frames(const Trip& trip, const NamedTraversal& traversal,
                                   const Limits& limits, LeafPairs* pairs) {
  LeafTraversal leaves(trip, traversal.options);
  std::vector<Frame> frames(trip.offsets.size());
  if (pairs != nullptr) {
    pairs->assign(frames.size(), {});
  }
  for (std::size_t k = 0; k < frames.size(); ++k) {
    check_stop(limits);
    leaves.move(k);
    TraversalVisitor visitor;
    if (pairs != nullptr) {
      visitor.leaf_pair = [&found = (*pairs)[k]](NodePair p) {
        found.push_back(p);
        return true;
      };
    }
    frames[k].counts = leaves.run(visitor);
    frames[k].roots_overlap = leaves.roots_overlap();
    if (pairs != nullptr) {
      std::sort((*pairs)[k].begin(), (*pairs)[k].end(), [](NodePair left, NodePair right) {
        return std::pair(left.a, left.b) < std::pair(right.a, right.b);
      });
    }
  }
  return frames;
}

std::vector<Frame> answer_frames(const Trip& trip, const NamedTraversal& traversal,
                                 const Limits& limits) {
  thesis::NamedOverlap query(trip.a, trip.b, traversal.options);
  std::vector<Frame> frames(trip.offsets.size());
  for (std::size_t k = 0; k < frames.size(); ++k) {
    Overlap answer = query(Pose::identity(), trip.pose(k), {}, limits);
    Box moved = trip.b.bounds();
    moved.lower += trip.offsets[k];
    moved.upper += trip.offsets[k];
    frames[k] = {overlaps(trip.a.bounds(), moved), query.counts(), answer.cost.triangle_tests,
                 std::move(answer.pairs)};
  }
  return frames;
}

std::vector<FrameTimes> time_trips(std::span<const TripRun> runs, int repetitions,
                                   const Limits& limits) {
  std::vector<FrameSamples> samples;
  for (const TripRun& run : runs) {
    const std::vector<std::vector<double>> none(run.trip->offsets.size());
    samples.push_back({none, none});
    FrameSamples warm_up{none, none};
    time_trip(run, limits, warm_up);
  }
  for (int round = 0; round < repetitions; ++round) {
    for (std::size_t k = 0; k < runs.size(); ++k) {
      const std::size_t i = round % 2 == 0 ? k : runs.size() - 1 - k;
      time_trip(runs[i], limits, samples[i]);
    }
  }
  std::vector<FrameTimes> times;
  times.reserve(samples.size());
  for (FrameSamples& of_run : samples) {
    times.push_back({summarized(std::move(of_run.collision)), summarized(std::move(of_run.frame))});
  }
  return times;
}

std::vector<double> sums_by_round(std::span<const Timing> times, std::span<const Frame> frames) {
  std::vector<double> sums;
  for (std::size_t k = 0; k < frames.size(); ++k) {
    if (frames[k].roots_overlap && !times[k].rounds.empty()) {
      sums.resize(times[k].rounds.size());
      std::transform(sums.begin(), sums.end(), times[k].rounds.begin(), sums.begin(),
                     std::plus<>());
    }
  }
  return sums;
}

std::vector<FrameTimes> time_frames(const Trip& trip, std::span<const NamedTraversal> traversals,
                                    int repetitions, const Limits& limits, std::size_t step) {
  std::vector<TripRun> runs;
  for (const NamedTraversal& traversal : traversals) {
    runs.push_back({&trip, traversal, step});
  }
  return time_trips(runs, repetitions, limits);
}

Timing time_beside_traversal(const Trip& trip, const NamedTraversal& traversal, int repetitions,
                             const Limits& limits, std::size_t step) {
  std::vector<double> samples;
  for (int round = 0; round < repetitions; ++round) {
    thesis::NamedOverlap query = query_of(trip, traversal);
    LeafTraversal leaves(trip, traversal.options);
    double sum = 0;
    for (std::size_t k = 0; k < trip.offsets.size(); k += step) {
      const double start = processor_milliseconds();
      (void)query(Pose::identity(), trip.pose(k), {}, limits);
      const double end = processor_milliseconds();
      leaves.move(k);
      const double start_of_traversal = processor_milliseconds();
      (void)leaves.run();
      sum += (end - start) - (processor_milliseconds() - start_of_traversal);
    }
    samples.push_back(sum);
  }
  return summarize(std::move(samples));
}

std::vector<Timing> time_traversals(const Trip& trip, std::span<const NamedTraversal> traversals,
                                    int repetitions, const Limits& limits, std::size_t step) {
  std::vector<std::vector<double>> samples(traversals.size());
  for (int round = -1; round < repetitions; ++round) {  // the first warms up
    for (std::size_t k = 0; k < traversals.size(); ++k) {
      const std::size_t i = round % 2 == 0 ? k : traversals.size() - 1 - k;
      const double sample = time_traversal(trip, traversals[i], limits, step);
      if (round >= 0) {
        samples[i].push_back(sample);
      }
    }
  }
  return summarized(std::move(samples));
}

}  // namespace soms::reproduce
