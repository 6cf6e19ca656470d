#include "reproduce/enode_racers.h"

#include "reproduce/touching_drive.h"
#include "reproduce/traversal_tables.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

namespace soms::reproduce {

namespace {

using Place = RacerPlace;

constexpr std::array<Pairing, 5> kCounted{
    {{"family test, both nodes", Place::e_node, Place::simultaneous},
     {"ours: descends on while one child pair overlaps, both nodes", Place::e_node_chain,
      Place::simultaneous, true},
     {"ours: from the last front, both nodes", Place::e_node_start, Place::simultaneous},
     {"ours: family test, larger node", Place::e_node_larger, Place::larger},
     {"ours: from the last front, larger node", Place::e_node_larger_start, Place::larger}}};

constexpr std::array<Pairing, 12> kTimed{
    {{"family test, both nodes; stack against stack", Place::e_node, Place::simultaneous},
     {"family test, both nodes; stack against recursion", Place::e_node,
      Place::simultaneous_recursive},
     {"family test, both nodes; recursion against recursion", Place::e_node_recursive,
      Place::simultaneous_recursive},
     {"ours: descends on while one child pair overlaps, both nodes; stack against stack",
      Place::e_node_chain, Place::simultaneous},
     {"ours: descends on while one child pair overlaps, both nodes; stack against recursion",
      Place::e_node_chain, Place::simultaneous_recursive},
     {"ours: from the last front, both nodes; stack against stack", Place::e_node_start,
      Place::simultaneous},
     {"ours: from the last front, both nodes; stack against recursion", Place::e_node_start,
      Place::simultaneous_recursive},
     {"ours: family test, larger node; stack against stack", Place::e_node_larger, Place::larger},
     {"ours: family test, larger node; stack against recursion", Place::e_node_larger,
      Place::larger_recursive},
     {"ours: family test, larger node; recursion against recursion", Place::e_node_larger_recursive,
      Place::larger_recursive},
     {"ours: from the last front, larger node; stack against stack", Place::e_node_larger_start,
      Place::larger},
     {"ours: from the last front, larger node; stack against recursion", Place::e_node_larger_start,
      Place::larger_recursive}}};

std::vector<Racer> make_racers() {
  const auto e_node = [](Descent descent, bool recursive) {
    return TraversalOptions{
        .traversal = Traversal::e_node, .descent = descent, .recursive = recursive};
  };
  const auto start = [](Descent descent) {
    return TraversalOptions{.traversal = Traversal::e_node_front, .descent = descent};
  };
  return {{"simultaneous", {.traversal = Traversal::simultaneous}},
          {"simultaneous_recursive", {.traversal = Traversal::simultaneous, .recursive = true}},
          {"enode_both", e_node(Descent::both, false)},
          {"enode_both_recursive", e_node(Descent::both, true)},
          {"enode_both_chain", e_node(Descent::both, false), true},
          {"enode_start_both", start(Descent::both)},
          {"larger", {.traversal = Traversal::larger}},
          {"larger_recursive", {.traversal = Traversal::larger, .recursive = true}},
          {"enode_larger", e_node(Descent::larger, false)},
          {"enode_larger_recursive", e_node(Descent::larger, true)},
          {"enode_start", start(Descent::larger)}};
}

bool meets(const Trip& trip) {
  LeafTraversal leaves(trip, {.traversal = Traversal::larger});
  for (std::size_t k = 0; k < trip.offsets.size(); ++k) {
    leaves.move(k);
    if (leaves.roots_overlap()) {
      return true;
    }
  }
  return false;
}

void add_kind(std::vector<TripKind>& kinds, TripKind kind) {
  std::erase_if(kind.trips, [](const Trip& trip) { return !meets(trip); });
  if (!kind.trips.empty()) {
    kinds.push_back(std::move(kind));
  }
}

TripKind orientation_kind(const Model& object, std::string_view rule) {
  const std::vector<Contender> builds = thesis_rules(kObjectLevel);
  const Contender& build = build_named(builds, rule);
  TripKind kind{"orientation tests, " + build.title + " trees", "orientation tests", build.name};
  for (const Approach from : {Approach::right, Approach::left, Approach::top}) {
    kind.trips.push_back(orientation_trip(object, from, build));
  }
  return kind;
}

/// The drives on trees of one rule: the fixed one, or the one that touches.
TripKind drive_kind(const Context& context, std::string_view rule,
                    std::span<const TouchingDrive> touching) {
  const std::vector<Contender> of_object = thesis_rules(kObjectLevel);
  const std::vector<Contender> of_scene = thesis_rules(kSceneLevel);
  const Contender& build = build_named(of_scene, rule);
  const Model& object = context.models.objects.front();
  const std::string tests = touching.empty() ? "drives" : "touching drives";
  TripKind kind{tests + ", " + build.title + " trees", tests, build.name};
  for (std::size_t i = 0; i < context.models.scenes.size(); ++i) {
    const Model& scene = context.models.scenes[i];
    kind.trips.push_back(
        touching.empty()
            ? drive_trip(scene, object, build, build_named(of_object, rule))
            : touching_drive_trip(scene, object, build, build_named(of_object, rule), touching[i]));
  }
  return kind;
}

}  // namespace

std::span<const Racer> enode_racers() {
  static const std::vector<Racer> racers = make_racers();
  return racers;
}

std::span<const Pairing> counted_pairings() {
  return kCounted;
}

std::span<const Pairing> timed_pairings() {
  return kTimed;
}

std::size_t EnodeTrips::trips() const {
  std::size_t count = 0;
  for (const TripKind& kind : kinds) {
    count += kind.trips.size();
  }
  return count;
}

EnodeTrips enode_trips(const Context& context) {
  const Model& object = context.models.objects.front();
  EnodeTrips all{.remarks = {object_remark(object)}};
  const std::vector<std::string> scenes = scene_remarks(context.models.scenes);
  all.remarks.insert(all.remarks.end(), scenes.begin(), scenes.end());
  for (const char* const rule : {"soms", "spatial_median"}) {
    add_kind(all.kinds, orientation_kind(object, rule));
  }
  std::vector<TouchingDrive> touching;
  for (const Model& scene : context.models.scenes) {
    touching.push_back(find_touching_drive(scene, object, {1, context.parallel.stop, {}}));
    all.remarks.push_back(touching_drive_remark(scene, touching.back()));
  }
  for (const char* const rule : {"soms", "object_median"}) {
    add_kind(all.kinds, drive_kind(context, rule, {}));
    if (!touching.empty()) {
      add_kind(all.kinds, drive_kind(context, rule, touching));
    }
  }
  return all;
}

std::string label_in_kind(const Trip& trip) {
  return trip.test == "drive" || trip.test == "touching_drive" ? trip.still : trip.test;
}

int enode_rounds(const Context& context) {
  return context.quick ? 20 : 100;
}

void add_rounds(std::vector<double>& sum, std::span<const double> rounds) {
  sum.resize(rounds.size());
  std::transform(rounds.begin(), rounds.end(), sum.begin(), sum.begin(),
                 [](double one, double other) { return one + other; });
}

}  // namespace soms::reproduce
