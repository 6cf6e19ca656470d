#include "bench/peers/core/race.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace soms::bench {

namespace {

constexpr std::size_t kFirstQuestions = 8;
constexpr std::size_t kFewestQuestions = 20;
constexpr double kRoughShare = 0.2;  // of the budget, for a first look at a lane
constexpr double kSlow = 3;          // times the pass of the fastest peer, or the budget
constexpr int kSlowRounds = 3;

double run(const Lane& lane, std::span<double> answers, std::size_t repeats,
           const RaceOptions& options) {
  const double start = options.clock();
  for (std::size_t i = 0; i < repeats; ++i) {
    lane.run(answers);
  }
  return (options.clock() - start) / static_cast<double>(repeats * answers.size());
}

std::size_t affordable(double seconds, double each) {
  return static_cast<std::size_t>(std::clamp(seconds / each, 1.0, 1e9));
}

/// Seconds an answer, roughly: the second of two passes over the first questions, of which there
/// are more the faster they are, since some take far longer than others.
double rough(const Lane& lane, std::size_t questions, const RaceOptions& options) {
  std::vector<double> answers(std::min(questions, kFirstQuestions));
  double each = std::max(1e-9, run(lane, answers, 1, options));
  while (answers.size() < questions &&
         each * static_cast<double>(answers.size()) < kRoughShare * options.budget) {
    answers.resize(std::min(questions, 2 * answers.size()));
    each = std::max(1e-9, run(lane, answers, 1, options));
  }
  return std::max(1e-9, run(lane, answers, 1, options));
}

/// Answers as many questions as fit into `most` seconds at `each` a question, at most `common`; and
/// more if these took less. Returns the seconds of the last pass.
double answer_in(const Lane& lane, double most, double each, std::size_t common,
                 std::vector<double>& answers, const RaceOptions& options) {
  double pass = 0;
  for (std::size_t done = std::min(common, affordable(most, each)); done > answers.size();
       done = std::min(common, affordable(most, each))) {
    answers.resize(done);
    each = std::max(1e-9, run(lane, answers, 1, options));
    pass = each * static_cast<double>(done);
  }
  return pass;
}

/// Seconds an answer of the fastest peer; of the fastest at all where there is none.
double seconds_per_answer(std::span<const Lane> lanes, std::span<const double> each) {
  double fastest = std::numeric_limits<double>::infinity();
  double peer = fastest;
  for (std::size_t i = 0; i < lanes.size(); ++i) {
    fastest = std::min(fastest, each[i]);
    if (!is_ours(lanes[i].library)) {
      peer = std::min(peer, each[i]);
    }
  }
  return std::isfinite(peer) ? peer : fastest;
}

}  // namespace

bool is_ours(const std::string& library) {
  return library == "soms" || library.starts_with("soms-");
}

std::vector<Outcome> race(std::span<const Lane> lanes, std::size_t questions,
                          const RaceOptions& options) {
  std::vector<double> each;
  for (const Lane& lane : lanes) {
    each.push_back(rough(lane, questions, options));
  }
  const double rate = seconds_per_answer(lanes, each);
  const std::size_t common =
      std::min(questions, std::max(kFewestQuestions, affordable(options.budget, rate)));
  const double most = kSlow * std::max(options.budget, rate * static_cast<double>(common));
  std::vector<Outcome> outcomes(lanes.size());
  std::vector<std::size_t> repeats(lanes.size());
  std::vector<std::vector<double>> seconds(lanes.size());
  for (std::size_t i = 0; i < lanes.size(); ++i) {
    const double pass = answer_in(lanes[i], most, each[i], common, outcomes[i].answers, options);
    repeats[i] = static_cast<std::size_t>(
        std::ceil(std::clamp(options.least_pass / std::max(pass, 1e-9), 1.0, 1e4)));
  }
  for (int round = 0; round < options.rounds; ++round) {
    for (std::size_t k = 0; k < lanes.size(); ++k) {
      const std::size_t i = (k + static_cast<std::size_t>(round)) % lanes.size();
      if (outcomes[i].answers.size() == common || round < kSlowRounds) {
        std::vector<double> again(outcomes[i].answers.size());
        seconds[i].push_back(run(lanes[i], again, repeats[i], options));
      }
    }
  }
  for (std::size_t i = 0; i < lanes.size(); ++i) {
    std::sort(seconds[i].begin(), seconds[i].end());
    outcomes[i].timing = {seconds[i][seconds[i].size() / 2], seconds[i].front(), seconds[i].back()};
  }
  return outcomes;
}

}  // namespace soms::bench
