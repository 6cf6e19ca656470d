#include "bench/peers/core/report.h"

#include <algorithm>

namespace soms::bench {

std::string name(Job job) {
  switch (job) {
    case Job::any:
      return "any";
    case Job::all:
      return "all";
    case Job::still:
      return "still";
    case Job::distance:
      return "distance";
    case Job::within:
      return "within";
    case Job::solid:
      return "solid";
    case Job::closest:
      return "closest";
    case Job::contains:
      return "contains";
    case Job::closest_hit:
      return "closest-hit";
    case Job::any_hit:
      return "any-hit";
    case Job::broad:
      break;
  }
  return "broad";
}

std::string question(Job job) {
  switch (job) {
    case Job::broad:
      return "frame";
    case Job::closest:
    case Job::contains:
      return "point";
    case Job::closest_hit:
    case Job::any_hit:
      return "ray";
    default:
      return "pose";
  }
}

bool is_measure(const std::string& library) {
  return library == kByDistance || library == kByOverlap || library == kByOverlapBatch;
}

bool ranked(const Cell& cell, const Entry& entry) {
  const bool right =
      is_ours(entry.library) ? entry.verdict.wrong == 0 : entry.verdict.share <= kMostWrong;
  return entry.answered == cell.questions && right;
}

namespace {

bool meant(const Entry& entry, Against against) {
  switch (against) {
    case Against::by_distance:
      return entry.library == kByDistance;
    case Against::by_overlap:
      return entry.library == kByOverlap;
    case Against::by_overlap_batch:
      return entry.library == kByOverlapBatch;
    case Against::keeps_tree:
      return !is_ours(entry.library) && entry.keeps_tree;
    case Against::from_scratch:
      return !is_ours(entry.library) && !entry.keeps_tree;
    case Against::watertight:
      return !is_ours(entry.library) && entry.watertight;
    case Against::clock:
      return false;
    case Against::all:
      break;
  }
  return !is_ours(entry.library);
}

}  // namespace

const Entry* best_peer(const Cell& cell, Against against) {
  const Entry* best = nullptr;
  for (const Entry& entry : cell.entries) {
    if (meant(entry, against) && ranked(cell, entry) &&
        (best == nullptr || entry.timing.median < best->timing.median)) {
      best = &entry;
    }
  }
  return best;
}

std::optional<double> ratio(const Cell& cell, const std::string& library, Against against) {
  const Entry* peer = best_peer(cell, against);
  const auto own = std::find_if(cell.entries.begin(), cell.entries.end(),
                                [&](const Entry& entry) { return entry.library == library; });
  if (own == cell.entries.end() || !ranked(cell, *own)) {
    return std::nullopt;
  }
  if (against == Against::clock) {
    return 1e-6 / own->timing.median;
  }
  if (peer == nullptr) {
    return std::nullopt;
  }
  return peer->timing.median / own->timing.median;
}

Median median_ratio(const std::vector<Cell>& cells, const MedianGoal& goal) {
  Median median;
  std::vector<double> ratios;
  for (const Cell& cell : cells) {
    if (cell.job == goal.job && cell.scene.starts_with(goal.scenes) && best_peer(cell) != nullptr) {
      ++median.rows;
      if (const auto reached = ratio(cell, goal.library)) {
        ratios.push_back(*reached);
      }
    }
  }
  if (median.rows != 0 && ratios.size() == median.rows) {
    std::sort(ratios.begin(), ratios.end());
    const std::size_t half = ratios.size() / 2;
    median.ratio = ratios.size() % 2 == 1 ? ratios[half] : 0.5 * (ratios[half - 1] + ratios[half]);
  }
  return median;
}

bool sound(const std::vector<Cell>& cells) {
  return std::all_of(cells.begin(), cells.end(), [](const Cell& cell) {
    return std::all_of(cell.entries.begin(), cell.entries.end(),
                       [](const Entry& e) { return !is_ours(e.library) || e.verdict.wrong == 0; });
  });
}

}  // namespace soms::bench
