#include "soms/scene/detail/search/clearance_search.h"

#include "soms/base/arithmetic.h"
#include "soms/base/error.h"
#include "soms/base/parallel.h"
#include "soms/query/distance.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <tuple>
#include <utility>

namespace soms::detail {

namespace {

constexpr double kMostStations = 1'000'000;
/// Places that are queried together: what a stop may lose.
constexpr std::size_t kPlacesAtOnce = 1024;
constexpr std::size_t kPlacesOfAThread = 4;
/// The least part of a segment that is halved: below, places round to the same.
constexpr double kLeastPart = 0x1p-40;

bool is_nearer(const ClearanceStation& a, const ClearanceStation& b) {
  return std::tie(a.gap.upper, a.gap.lower) < std::tie(b.gap.upper, b.gap.lower);
}

double chainage_at(const MotionPath& path, std::size_t segment, double t) {
  const double from = path.chainage[segment];
  return from + t * (path.chainage[segment + 1] - from);
}

}  // namespace

std::vector<PathPlace> stations_of(const MotionPath& path, double every) {
  const double length = path.chainage.back() - path.chainage.front();
  if (length / every + static_cast<double>(path.poses.size()) > kMostStations) {
    throw Error(ErrorKind::usage,
                "a path of the length " + std::to_string(length) + " with " +
                    std::to_string(path.poses.size()) + " poses has more than 1,000,000 stations",
                "put them farther apart, or divide the path");
  }
  std::vector<PathPlace> places;
  double next = every;  // along the path
  for (std::size_t k = 0; k < path.segments(); ++k) {
    const double from = path.chainage[k] - path.chainage.front();
    const double to = path.chainage[k + 1] - path.chainage.front();
    places.push_back({k, 0, path.chainage[k]});
    // One that nearly is a pose of the path stands for it.
    const double near = 1e-9 * every;
    for (; next < to + near; next = every * std::round(next / every + 1)) {
      if (next > from + near && next < to - near) {
        places.push_back({k, (next - from) / (to - from), path.chainage.front() + next});
      }
    }
  }
  const std::size_t last = path.segments();
  places.push_back(last == 0 ? PathPlace{0, 0, path.chainage.front()}
                             : PathPlace{last - 1, 1, path.chainage.back()});
  return places;
}

ClearanceStation ClearanceSearch::query_at(const PathPlace& place, const StopToken& stop,
                                           Cost& cost) const {
  const PlainArithmetic plain;
  ClearanceStation station{.segment = place.segment, .t = place.t, .chainage = place.chainage};
  station.pose = path_.segments() == 0
                     ? path_.poses.front()
                     : MotionSegment(path_, place.segment, bounds_).at(place.t).pose;
  const Body moving(mover_, station.pose);
  for (std::size_t k = 0; k < fixed_.size(); ++k) {
    const Distance found =
        distance(moving, fixed_[k], {.at_most = station.gap.upper}, {.stop = stop});
    cost += found.cost;
    // Brackets are neighbors or equal, so their ends order what they tell apart.
    if (!found.farther && found.triangles &&
        std::tie(found.distance.upper, found.distance.lower) <
            std::tie(station.gap.upper, station.gap.lower)) {
      station.gap = found.distance;
      station.body = k;
      station.triangles = found.triangles;
      station.point_a = found.point_a;
      station.point_b = found.point_b;
    }
  }
  return station;
}

/// Appends to `found` what is known of the places; false after a stop, when some are missing.
/// `from` and `to` are the shares of all work, for progress.
bool ClearanceSearch::query(std::span<const PathPlace> places, double from, double to,
                            std::vector<ClearanceStation>& found) {
  for (std::size_t begin = 0; begin < places.size(); begin += kPlacesAtOnce) {
    const auto block = places.subspan(begin, std::min(kPlacesAtOnce, places.size() - begin));
    std::vector<ClearanceStation> stations(block.size());
    std::vector<Cost> costs(block.size());
    try {
      for_each_chunk(block.size(), kPlacesOfAThread, limits_.silent(),
                     [&](std::size_t first, std::size_t last) {
                       for (std::size_t k = first; k < last; ++k) {
                         stations[k] = query_at(block[k], limits_.stop, costs[k]);
                       }
                     });
    } catch (const Error& error) {
      const bool stopped = error.kind() == ErrorKind::cancelled && options_.keep_on_stop;
      if (!stopped && error.kind() != ErrorKind::timed_out) {
        throw;
      }
      cut_ = true;
      return false;
    }
    std::move(stations.begin(), stations.end(), std::back_inserter(found));
    for (const Cost& cost : costs) {
      cost_ += cost;
    }
    if (limits_.progress) {
      const double share =
          static_cast<double>(begin + block.size()) / static_cast<double>(places.size());
      limits_.progress(from + share * (to - from));
    }
  }
  return true;
}

// A point of the body is at most d away from where it is at a, and at most e from where it is at b,
// with d + e <= motion (`most_motion`). The points of a triangle are means of its corners and move
// no farther; so the gap there is at least gap(a) - d and gap(b) - e, hence at least half of
// gap(a) + gap(b) - motion, and at most half of gap(a) + gap(b) + motion. What rounding adds: the
// slack of a and of b, where the gap is of rounded poses; that of the place between, whose rounded
// pose the bound holds for, too; and that of the sums here.
ClearanceSearch::Leaf ClearanceSearch::leaf_between(std::size_t segment, const Sample& a,
                                                    const Sample& b) const {
  const MotionSegment motion(path_, segment, bounds_);
  Leaf leaf{.motion = motion.most_motion(a.place(), b.place())};
  if (!std::isfinite(a.gap.lower) || !std::isfinite(b.gap.lower)) {
    leaf.at_least = leaf.at_most = a.gap.lower;
    return leaf;
  }
  const double slack = (a.slack + b.slack) / 2 + motion.slack();
  const double rounding = 0x1p-50 * (a.gap.upper + b.gap.upper + leaf.motion + slack) + 0x1p-1060;
  const double least = std::min(a.gap.lower, b.gap.lower);
  leaf.at_least =
      std::clamp((a.gap.lower + b.gap.lower - leaf.motion) / 2 - slack - rounding, 0.0, least);
  leaf.at_most = (a.gap.upper + b.gap.upper + leaf.motion) / 2 + slack + rounding;
  return leaf;
}

void ClearanceSearch::begin_stretches(const std::vector<ClearanceStation>& stations) {
  for (std::size_t k = 0; k + 1 < stations.size(); ++k) {
    const ClearanceStation& from = stations[k];
    const ClearanceStation& to = stations[k + 1];
    Stretch stretch{.segment = from.segment, .least = is_nearer(to, from) ? to : from};
    const MotionSegment motion(path_, from.segment, bounds_);
    const double end = to.segment == from.segment ? to.t : 1;
    for (const auto& [t, gap] : {std::pair(from.t, from.gap), std::pair(end, to.gap)}) {
      const MotionPlace place = motion.at(t);
      stretch.samples.push_back({place.t, place.turn, place.slack, gap});
    }
    stretch.leaves = {leaf_between(stretch.segment, stretch.samples[0], stretch.samples[1])};
    stretches_.push_back(std::move(stretch));
  }
}

/// True for a leaf that has to be halved. `least` is the least gap of all.
bool ClearanceSearch::is_open(const Leaf& leaf, const Stretch& stretch, double least,
                              bool before_contact) const {
  if (!(leaf.motion > options_.accuracy)) {
    return false;
  }
  if (before_contact && leaf.at_least <= 0) {
    return true;
  }
  if (!(options_.clearance > 0)) {
    return leaf.at_least < stretch.least.gap.lower - options_.accuracy;
  }
  const bool has_it = leaf.at_least >= options_.clearance;
  const bool lacks_it = leaf.at_most < options_.clearance;
  return (!has_it && !lacks_it) || leaf.at_least < least - options_.accuracy;
}

std::vector<ClearanceSearch::Half> ClearanceSearch::open_leaves() const {
  double least = std::numeric_limits<double>::infinity();
  bool any_contact = false;
  for (const Stretch& stretch : stretches_) {
    least = std::min(least, stretch.least.gap.lower);
    any_contact = any_contact || stretch.least.overlaps();
  }
  std::vector<Half> halves;
  bool before_contact = any_contact;
  for (std::size_t s = 0; s < stretches_.size(); ++s) {
    const Stretch& stretch = stretches_[s];
    for (std::size_t k = 0; k < stretch.leaves.size(); ++k) {
      const Sample& a = stretch.samples[k];
      const Sample& b = stretch.samples[k + 1];
      before_contact = before_contact && a.gap.upper > 0;
      if (b.t - a.t > kLeastPart && is_open(stretch.leaves[k], stretch, least, before_contact)) {
        const double t = a.t + 0.5 * (b.t - a.t);
        halves.push_back({s, k, {stretch.segment, t, chainage_at(path_, stretch.segment, t)}});
      }
    }
  }
  return halves;
}

/// Puts places in the middle of leaves; both are in order.
void ClearanceSearch::insert(std::span<const Half> halves,
                             std::span<const ClearanceStation> found) {
  for (std::size_t h = 0; h < found.size();) {
    Stretch& stretch = stretches_[halves[h].stretch];
    const MotionSegment motion(path_, stretch.segment, bounds_);
    std::vector<Sample> samples{stretch.samples.front()};
    std::vector<Leaf> leaves;
    const std::size_t s = halves[h].stretch;
    for (std::size_t k = 0; k < stretch.leaves.size(); ++k) {
      const Sample& end = stretch.samples[k + 1];
      if (h < found.size() && halves[h].stretch == s && halves[h].leaf == k) {
        const MotionPlace place = motion.at(found[h].t);
        samples.push_back({place.t, place.turn, place.slack, found[h].gap});
        leaves.push_back(leaf_between(stretch.segment, *(samples.end() - 2), samples.back()));
        leaves.push_back(leaf_between(stretch.segment, samples.back(), end));
        if (is_nearer(found[h], stretch.least)) {
          stretch.least = found[h];
        }
        ++h;
      } else {
        leaves.push_back(stretch.leaves[k]);
      }
      samples.push_back(end);
    }
    stretch.samples = std::move(samples);
    stretch.leaves = std::move(leaves);
  }
}

/// Up to where nothing touches: the first leaf that is not proved to be free begins there.
void ClearanceSearch::report_contact(Clearance& answer) const {
  const auto first =
      std::find_if(answer.stations.begin(), answer.stations.end(),
                   [](const ClearanceStation& station) { return station.overlaps(); });
  if (first == answer.stations.begin() && first != answer.stations.end()) {
    answer.first_contact = {first->chainage, *first};
    return;
  }
  std::optional<double> free_until;
  for (const Stretch& stretch : stretches_) {
    for (std::size_t k = 0; k < stretch.leaves.size(); ++k) {
      if (!free_until && stretch.leaves[k].at_least <= 0) {
        free_until = chainage_at(path_, stretch.segment, stretch.samples[k].t);
      }
      const Sample& end = stretch.samples[k + 1];
      if (end.gap.upper == 0) {
        // Its pair of triangles was dropped, as of all samples but the least of a stretch.
        const double chainage = chainage_at(path_, stretch.segment, end.t);
        Cost cost;
        answer.first_contact = {*free_until,
                                query_at({stretch.segment, end.t, chainage}, {}, cost)};
        return;
      }
    }
  }
}

void ClearanceSearch::report(Clearance& answer) const {
  answer.queries = answer.stations.size();
  answer.least = answer.stations.empty() ? ClearanceStation{} : answer.stations.front();
  answer.at_least = answer.least.gap.lower;
  for (const Stretch& stretch : stretches_) {
    ClearanceStretch known{.at_least = std::numeric_limits<double>::infinity(),
                           .least = stretch.least,
                           .queries = stretch.samples.size() - 2};
    const double length = path_.chainage[stretch.segment + 1] - path_.chainage[stretch.segment];
    for (std::size_t k = 0; k < stretch.leaves.size(); ++k) {
      const Leaf& leaf = stretch.leaves[k];
      known.at_least = std::min(known.at_least, leaf.at_least);
      const double part = (stretch.samples[k + 1].t - stretch.samples[k].t) * length;
      known.below.lower += leaf.at_most < options_.clearance ? part : 0;
      known.below.upper += leaf.at_least < options_.clearance ? part : 0;
    }
    answer.at_least = std::min(answer.at_least, known.at_least);
    answer.below.lower += known.below.lower;
    answer.below.upper += known.below.upper;
    answer.queries += known.queries;
    if (is_nearer(known.least, answer.least)) {
      answer.least = known.least;
    }
    answer.stretches.push_back(std::move(known));
  }
  report_contact(answer);
  answer.coverage = cut_ ? Coverage::cut : Coverage::complete;
  answer.cost = cost_;
}

Clearance ClearanceSearch::run() {
  constexpr double kShareOfStations = 0.3;
  Clearance answer;
  const std::vector<PathPlace> places = stations_of(path_, options_.every);
  const bool whole = query(places, 0, kShareOfStations, answer.stations);
  begin_stretches(answer.stations);
  double done = kShareOfStations;
  for (bool goes_on = whole; goes_on;) {
    const std::vector<Half> halves = open_leaves();
    std::vector<PathPlace> middles;
    for (const Half& half : halves) {
      middles.push_back(half.place);
    }
    const double next = done + 0.25 * (1 - done);  // how many rounds there will be is not known
    std::vector<ClearanceStation> found;
    goes_on = query(middles, done, next, found) && !halves.empty();
    insert(halves, found);
    done = next;
  }
  report(answer);
  return answer;
}

}  // namespace soms::detail
