#include "thesis/races/enode_racers.h"

#include "soms/thesis/thesis_frames.h"

#include "thesis/races/touching_drive.h"
#include "thesis/run/traversal_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

namespace soms::reproduce {

namespace {

using Place = RacerPlace;

constexpr std::string_view kFamily = "family test, both nodes";
constexpr std::string_view kChain = "ours: descends on while one child overlaps, both nodes";
constexpr std::string_view kFront =
    "ours: from the last front (given the last frame's work), both nodes";
constexpr std::string_view kFamilyLarger = "ours: family test, larger node";
constexpr std::string_view kFrontLarger =
    "ours: from the last front (given the last frame's work), larger node";

constexpr std::string_view kLarsson = "Larsson's (simultaneous)";
constexpr std::string_view kEricson = "Ericson's (larger node)";

constexpr std::string_view kStacks = "stack / stack";
constexpr std::string_view kRecursions = "recursion / recursion";

constexpr std::string_view kNotLarsson =
    "figure 5.10 races E-Node against Larsson's traversal, which we take to descend both nodes, "
    "not "
    "against Ericson's";
constexpr std::string_view kOtherNodes =
    "not like against like: what descending the larger node alone saves is saved by any traversal "
    "that does so, Ericson's for one";

constexpr std::array<Pairing, 3> kCounted{
    {{kFamily, kLarsson, {}, Place::e_node, Place::simultaneous},
     {kChain, kLarsson, {}, Place::e_node_chain, Place::simultaneous},
     {kFront, kLarsson, {}, Place::e_node_start, Place::simultaneous}}};

constexpr std::array<Pairing, 7> kTimedPairings{
    {{kFamily, kLarsson, kStacks, Place::e_node, Place::simultaneous},
     {kFamily, kLarsson, "stack / recursion", Place::e_node, Place::simultaneous_recursive},
     {kFamily, kLarsson, "recursion / stack", Place::e_node_recursive, Place::simultaneous},
     {kFamily, kLarsson, kRecursions, Place::e_node_recursive, Place::simultaneous_recursive},
     {kChain, kLarsson, kStacks, Place::e_node_chain, Place::simultaneous},
     {kChain, kLarsson, kRecursions, Place::e_node_chain_recursive, Place::simultaneous_recursive},
     {kFront, kLarsson, kStacks, Place::e_node_start, Place::simultaneous}}};

constexpr std::array<Pairing, 4> kAside{
    {{kFamily, kEricson, kStacks, Place::e_node, Place::larger, kNotLarsson},
     {kFamilyLarger, kEricson, kStacks, Place::e_node_larger, Place::larger, kNotLarsson},
     {kFamilyLarger, kLarsson, kStacks, Place::e_node_larger, Place::simultaneous, kOtherNodes},
     {kFrontLarger, kEricson, kStacks, Place::e_node_larger_start, Place::larger, kNotLarsson}}};

std::vector<TripRacer> make_racers() {
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
          {"enode_both_chain_recursive", e_node(Descent::both, true), true},
          {"enode_start_both", start(Descent::both)},
          {"larger", {.traversal = Traversal::larger}},
          {"enode_larger", e_node(Descent::larger, false)},
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

void add_kind(const Context& context, std::vector<TripKind>& kinds, TripKind kind) {
  const Decision met = context.races->decide(
      fmt::format("trips of {} that meet, {}", kind.subject(), kind.rule), [&] {
        Decision each;
        for (const Trip& trip : kind.trips) {
          each.push_back(meets(trip) ? 1 : 0);
        }
        return each;
      });
  std::vector<Trip> meeting;
  for (std::size_t i = 0; i < kind.trips.size(); ++i) {
    if (met.at(i) != 0) {
      meeting.push_back(std::move(kind.trips[i]));
    }
  }
  kind.trips = std::move(meeting);
  if (!kind.trips.empty()) {
    kinds.push_back(std::move(kind));
  }
}

TripKind orientation_kind(const Model& object, std::string_view rule) {
  const std::vector<Contender> builds = thesis_rules(kObjectLevel);
  const Contender& build = build_named(builds, rule);
  TripKind kind{object.name, "orientation tests", build.name};
  for (const auto& [from, name] : kApproaches) {
    kind.trips.push_back(orientation_trip(object, from, build));
  }
  return kind;
}

/// The drives on trees of one rule: the fixed one, or the one that touches.
TripKind drive_kind(const Context& context, const Model& object, std::string_view rule,
                    std::span<const TouchingDrive> touching) {
  const std::vector<Contender> of_object = thesis_rules(kObjectLevel);
  const std::vector<Contender> of_scene = thesis_rules(kSceneLevel);
  const Contender& build = build_named(of_scene, rule);
  TripKind kind{object.name, touching.empty() ? "drives" : "touching drives", build.name};
  for (std::size_t i = 0; i < context.models.scenes.size(); ++i) {
    const Model& scene = context.models.scenes[i];
    kind.trips.push_back(
        touching.empty()
            ? drive_trip(scene, object, build, build_named(of_object, rule))
            : touching_drive_trip(scene, object, build, build_named(of_object, rule), touching[i]));
  }
  return kind;
}

/// Rules of the trees of an object's trips: that of the verdicts, and another one for the table; in
/// a quick run the other one for the first object alone.
std::vector<std::string_view> rules_of(const Context& context, const Model& object,
                                       std::string_view other) {
  std::vector<std::string_view> rules{kEnodeRule};
  if (!context.quick || &object == &context.models.objects.front()) {
    rules.push_back(other);
  }
  return rules;
}

void add_kinds_of(EnodeTrips& all, const Context& context, const Model& object) {
  for (const std::string_view rule : rules_of(context, object, "spatial_median")) {
    add_kind(context, all.kinds, orientation_kind(object, rule));
  }
  std::vector<TouchingDrive> touching;
  for (const Model& scene : context.models.scenes) {
    touching.push_back(touching_drive(context, scene, object));
    all.remarks.push_back(touching_drive_remark(scene, object, touching.back()));
  }
  for (const std::string_view rule : rules_of(context, object, "object_median")) {
    add_kind(context, all.kinds, drive_kind(context, object, rule, {}));
    if (!touching.empty()) {
      add_kind(context, all.kinds, drive_kind(context, object, rule, touching));
    }
  }
}

}  // namespace

std::span<const TripRacer> enode_racers() {
  static const std::vector<TripRacer> racers = make_racers();
  return racers;
}

std::span<const Pairing> counted_pairings() {
  return kCounted;
}

std::span<const Pairing> timed_pairings() {
  return kTimedPairings;
}

std::span<const Pairing> pairings_aside() {
  return kAside;
}

std::string reading_of(const Pairing& pairing) {
  return pairing.manner.empty()
             ? fmt::format("{}, against {}", pairing.e_node, pairing.opponent)
             : fmt::format("{}, against {}: {}", pairing.e_node, pairing.opponent, pairing.manner);
}

Revision revision_of(std::span<const ClaimRow> rows,
                     const std::function<bool(const ClaimRow&)>& judged_before,
                     std::string_view reason) {
  Claim part;
  std::copy_if(rows.begin(), rows.end(), std::back_inserter(part.rows), judged_before);
  const Verdict before = Verdict::does_not_hold;
  return {before, verdict_of(part) == before
                      ? std::string(reason)
                      : "its numbers were of other models or of another machine"};
}

std::string ericson_words(std::span<const ClaimRow> rows, std::string_view metric) {
  const std::string reading = fmt::format("{}, against {}", kFamily, kEricson);
  std::vector<double> values;
  for (const ClaimRow& row : rows) {
    if (row.metric.starts_with(metric) && row.reading.starts_with(reading)) {
      values.push_back(row.value);
    }
  }
  if (values.empty()) {
    return {};
  }
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  return fmt::format(
      "Against Ericson's traversal, which descends the larger node: ratio of {} from {:.3g} to "
      "{:.3g} (not judged).",
      metric, *low, *high);
}

std::size_t EnodeTrips::trips() const {
  std::size_t count = 0;
  for (const TripKind& kind : kinds) {
    count += kind.trips.size();
  }
  return count;
}

EnodeTrips enode_trips(const Context& context) {
  EnodeTrips all{.remarks = object_remarks(context.models.objects)};
  const std::vector<std::string> scenes = scene_remarks(context.models.scenes);
  all.remarks.insert(all.remarks.end(), scenes.begin(), scenes.end());
  for (const Model& object : context.models.objects) {
    add_kinds_of(all, context, object);
  }
  return all;
}

std::string label_in_kind(const Trip& trip) {
  return trip.test == "drive" || trip.test == "touching_drive" ? trip.still : trip.test;
}

int enode_rounds(const Context& context) {
  return context.quick ? 10 : 100;
}

void add_rounds(std::vector<double>& sum, std::span<const double> rounds) {
  sum.resize(rounds.size());
  std::transform(rounds.begin(), rounds.end(), sum.begin(), sum.begin(),
                 [](double one, double other) { return one + other; });
}

}  // namespace soms::reproduce
