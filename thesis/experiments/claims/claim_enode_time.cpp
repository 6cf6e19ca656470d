// E-Node's time to detect an overlap in an urban scene, beside the 0.2 ms of the thesis.
#include "apps/draw/interval_chart.h"
#include "thesis/claims/thesis_claims.h"
#include "thesis/experiments/experiments.h"
#include "thesis/races/enode_racers.h"
#include "thesis/races/until_hit.h"
#include "thesis/run/steps.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

namespace soms::reproduce {

namespace {

constexpr Demand kClaimed = demand_of("enode_time");

constexpr std::string_view kThesisUnavailable =
    "a time of a program on a machine of its time, and neither is available";

/// E-Node in two readings.
struct EnodeReading {
  std::string_view words;
  RacerPlace place;
};

constexpr std::array<EnodeReading, 2> kEnodeReadings{
    {{"family test, both nodes", RacerPlace::e_node},
     {"ours: family test, larger node", RacerPlace::e_node_larger}}};

/// What is timed, in words.
struct QuestionWords {
  Question question;
  std::string_view words;
};

constexpr std::array<QuestionWords, 2> kQuestions{
    {{Question::leaf_pairs, "traversal"}, {Question::contacts, "traversal and triangles"}}};

/// Mean time of a frame on one trip.
struct Mean {
  std::string subject;
  std::string metric;
  std::string reading;
  Estimate milliseconds;
};

std::vector<TripRacer> racers_of_readings() {
  std::vector<TripRacer> racers;
  racers.reserve(kEnodeReadings.size());
  for (const EnodeReading& reading : kEnodeReadings) {
    racers.push_back(enode_racers()[static_cast<std::size_t>(reading.place)]);
  }
  return racers;
}

Estimate mean_of_frames(std::vector<double> rounds, std::size_t frames, int processes) {
  for (double& round : rounds) {
    round /= static_cast<double>(frames);
  }
  return estimate(rounds, processes);
}

/// Frames with contact and the others are timed apart; all frames are the sum of both.
void add_means(std::vector<Mean>& means, const std::string& subject, const MovedTrip& moved,
               const Context& context, const Limits& quiet) {
  const std::vector<TripRacer> racers = racers_of_readings();
  std::vector<std::size_t> all = moved.all_frames();
  if (context.quick) {
    std::erase_if(all, [](std::size_t frame) { return frame % 8 != 0; });
  }
  const Decision decision = context.races->decide("frames with contact", [&] {
    const std::vector<std::size_t> frames =
        until_hit(moved, racers.back(), Hit::contact, true, all, quiet).frames;
    return Decision(frames.begin(), frames.end());
  });
  const std::vector<std::size_t> contact(decision.begin(), decision.end());
  std::vector<std::size_t> others;
  std::set_difference(all.begin(), all.end(), contact.begin(), contact.end(),
                      std::back_inserter(others));
  for (const QuestionWords& question : kQuestions) {
    const auto time = [&](const std::vector<std::size_t>& frames) {
      return race(*context.races, moved,
                  {.racers = racers,
                   .question = question.question,
                   .frames = frames,
                   .rounds = enode_rounds(context)},
                  quiet);
    };
    const std::vector<Timing> with = time(contact);
    const std::vector<Timing> without = time(others);
    for (std::size_t i = 0; i < racers.size(); ++i) {
      const auto add = [&](std::string_view which, const std::vector<double>& rounds,
                           std::size_t frames) {
        means.push_back({subject, fmt::format("mean time of {}, {}", question.words, which),
                         std::string(kEnodeReadings[i].words),
                         mean_of_frames(rounds, frames, with[i].processes)});
      };
      if (!contact.empty()) {
        add("frames with contact", with[i].rounds, contact.size());
      }
      std::vector<double> sum = with[i].rounds;
      add_rounds(sum, without[i].rounds);
      add("all frames", sum, all.size());
    }
  }
}

Claim claim_of(const std::vector<Mean>& means) {
  std::vector<ClaimRow> rows;
  for (const Mean& mean : means) {
    rows.push_back(
        measured_row(mean.reading, mean.metric, mean.subject, "ms", kClaimed, mean.milliseconds));
    rows.back().unjudged = kThesisUnavailable;
  }
  Claim claim = judged(thesis_claim("enode_time"), std::move(rows));
  claim.why =
      "A time belongs to its scene, program and machine, and in a city to which of two nodes is "
      "descended. Boxes are moved beforehand.";
  return claim;
}

Figure figure_of(const std::vector<Mean>& means) {
  IntervalChart chart{.title = "E-Node's mean time of a frame, SOMS trees",
                      .x_label = "ms a frame, traversal and triangles; shaded: within the claim",
                      .scale = Scale::log,
                      .below = kClaimed.below};
  for (const Mean& mean : means) {
    const std::string_view triangles = "mean time of traversal and triangles, ";
    if (mean.metric.starts_with(triangles)) {
      chart.marks.push_back({mean.metric.substr(triangles.size()), mean.subject, mean.reading,
                             mean.milliseconds.value, mean.milliseconds.interval});
    }
  }
  return {.id = "claim_enode_time",
          .caption =
              "Mean time in which E-Node finds all contacts of a frame on drives through our "
              "scenes on this machine, beside the 0.2 ms of the thesis, which were measured "
              "on another machine and scene.",
          .svg = draw(chart),
          .timed = true};
}

}  // namespace

Result claim_enode_time(const Context& context) {
  EnodeTrips trips = enode_trips(context);
  std::erase_if(trips.kinds, [](const TripKind& kind) {
    return kind.tests == "orientation tests" || kind.rule != kEnodeRule;
  });
  Steps steps(context.limits, trips.trips());
  std::vector<Mean> means;
  for (const TripKind& kind : trips.kinds) {
    for (const Trip& trip : kind.trips) {
      const MovedTrip moved(trip, steps.quiet());
      add_means(means, fmt::format("{}, {}", kind.subject(), label_in_kind(trip)), moved, context,
                steps.quiet());
      steps.done_one();
    }
  }
  Result result;
  result.claims = {claim_of(means)};
  if (!means.empty()) {
    result.figures = {figure_of(means)};
  }
  result.remarks = std::move(trips.remarks);
  return result;
}

}  // namespace soms::reproduce
