#include "apps/soms/thesis/thesis_run.h"

#include "thesis/trips/interactive_rates.h"
#include "thesis/trips/statistics.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace soms::command {

namespace {

using reproduce::Frame;

template <class Property>
std::optional<std::size_t> first_with(const std::vector<Frame>& frames, const Property& property) {
  const auto found = std::find_if(frames.begin(), frames.end(), property);
  return found == frames.end() ? std::nullopt
                               : std::optional(static_cast<std::size_t>(found - frames.begin()));
}

bool has_contact(const Frame& frame) {
  return !frame.contacts.empty();
}

ThesisSummary summary_of(const std::vector<Frame>& frames, const std::vector<double>& ms) {
  ThesisSummary summary{
      .sums = reproduce::totals(frames),
      .first_root = first_with(frames, [](const Frame& frame) { return frame.roots_overlap; }),
      .first_leaf =
          first_with(frames, [](const Frame& frame) { return frame.counts.leaf_pairs > 0; }),
      .first_contact = first_with(frames, has_contact),
      .contact_frames =
          static_cast<std::size_t>(std::count_if(frames.begin(), frames.end(), has_contact)),
      .last_contacts = frames.empty() ? 0 : frames.back().contacts.size()};
  std::vector<double> times;
  for (std::size_t k = 0; k < frames.size(); ++k) {
    if (frames[k].roots_overlap) {
      times.push_back(ms[k]);
    }
  }
  if (!times.empty()) {
    summary.mean_ms =
        std::accumulate(times.begin(), times.end(), 0.0) / static_cast<double>(times.size());
    summary.max_ms = *std::max_element(times.begin(), times.end());
    summary.median_ms = reproduce::median(std::move(times));
  }
  return summary;
}

}  // namespace

std::string_view interactive_word(double fps) {
  return fps < reproduce::kLeastInteractive  ? "below"
         : fps > reproduce::kMostInteractive ? "above"
                                             : "within";
}

ThesisResult run_trip(ThesisTrip what, const TraversalOptions& traversal, int repetitions,
                      const Limits& limits) {
  const reproduce::NamedTraversal named{"", traversal};
  ThesisResult result{.what = std::move(what)};
  result.frames = reproduce::answer_frames(result.what.trip, named, limits);
  const std::vector<reproduce::FrameTimes> times =
      reproduce::time_frames(result.what.trip, std::span(&named, 1), repetitions, limits);
  for (const reproduce::Timing& frame : times.front().collision) {
    result.ms.push_back(frame.median);
  }
  result.summary = summary_of(result.frames, result.ms);
  return result;
}

}  // namespace soms::command
