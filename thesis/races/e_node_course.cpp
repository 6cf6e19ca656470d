#include "thesis/races/e_node_course.h"

#include "thesis/run/traversal_tables.h"

#include <fmt/format.h>

#include <algorithm>

namespace soms::reproduce {

namespace {

std::size_t first_of(std::span<const std::size_t> frames) {
  return frames.empty() ? kNoFrame : frames.front();
}

FirstFrames first_frames(const MovedTrip& moved, std::span<const EarlierLevel> levels,
                         const EnodeTripWork& taken) {
  const Trip& trip = moved.trip();
  FirstFrames first{trip.model, trip.still, trip.test, moved.frames()};
  for (std::size_t k = 0; k < moved.frames() && first.root == kNoFrame; ++k) {
    if (overlaps(moved.still().boxes.front(), moved.moving(k).boxes.front())) {
      first.root = k;
    }
  }
  first.earlier = at_level(levels, kEarlierLevel).first_frame;
  first.leaf = first_of(taken.leaves.frames);
  first.contact = first_of(taken.contact.frames);
  return first;
}

/// All readings find the same pairs of leaves and the same frames with contact.
void check_alike(const Trip& trip, std::span<const EnodeTripWork> works,
                 std::span<const Frame> exact) {
  std::vector<std::size_t> contact;
  for (std::size_t k = 0; k < exact.size(); ++k) {
    if (!exact[k].contacts.empty()) {
      contact.push_back(k);
    }
  }
  for (std::size_t i = 0; i < works.size(); ++i) {
    require(works[i].whole.leaf_pairs == works[0].whole.leaf_pairs &&
                works[i].leaves.frames == works[0].leaves.frames &&
                works[i].contact.frames == contact,
            fmt::format("{} of {} past {}: answers by {} and by {}", trip.test, trip.moving,
                        trip.still, e_node_readings()[i].name, e_node_readings()[0].name));
  }
}

}  // namespace

void add(EarlierLevel& sum, const EarlierLevel& one) {
  sum.box_tests += one.box_tests;
  sum.entered += one.entered;
  sum.first_tests += one.first_tests;
  sum.pairs += one.pairs;
  sum.touching_pairs += one.touching_pairs;
  sum.called_frames += one.called_frames;
}

const EarlierLevel& at_level(std::span<const EarlierLevel> levels, int level) {
  return levels[std::min(levels.size(), static_cast<std::size_t>(level)) - 1];
}

EnodeWork work_of(const EnodeReading& reading, const EnodeTripWork& work,
                  const EarlierLevel& level) {
  switch (reading.answer) {
    case EnodeAnswer::first_leaves:
      return work.leaves.stopping;
    case EnodeAnswer::first_contact:
      return work.contact.stopping;
    case EnodeAnswer::boxes_only:
      return {level.box_tests, level.entered, level.pairs, 0};
    case EnodeAnswer::all_pairs:
      break;
  }
  return work.whole;
}

void run_trip(const Trip& trip, CourseWork& course, std::vector<FirstFrames>& first,
              const Limits& limits) {
  const MovedTrip moved(trip, limits);
  const std::vector<Frame> exact = answer_frames(trip, named_traversal("larger"), limits);
  std::vector<EnodeTripWork> works;
  for (const EnodeReading& reading : e_node_readings()) {
    const bool again = reading.answer != EnodeAnswer::all_pairs;  // work of the one taken
    works.push_back(again ? works.front() : e_node_work(moved, reading, limits));
    course.work[works.size() - 1] += works.back();
  }
  check_alike(trip, works, exact);
  const std::vector<EarlierLevel> levels = earlier_nodes(moved, exact, limits);
  for (const int level : kShownLevels) {
    const auto place = static_cast<std::size_t>(level);
    course.levels.resize(std::max(course.levels.size(), place));
    add(course.levels[place - 1], at_level(levels, level));
  }
  course.frames += moved.frames();
  course.contact_frames += works.front().contact.frames.size();
  first.push_back(first_frames(moved, levels, works.front()));
}

}  // namespace soms::reproduce
