// First contacts of motions beside `distance` of their starts, 32 sampled overlaps, and FCL. One
// process, one thread, in turns; processor time. Every answer is checked by samples first.
#include "soms/motion/first_contact.h"
#include "soms/query/distance.h"
#include "soms/query/overlap.h"

#include "bench/measure.h"
#include "bench/motion/motion_cases.h"
#include "bench/motion/motion_peers.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <limits>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

namespace soms::bench {
namespace {

constexpr std::size_t kMotions = 60;
constexpr std::size_t kPasses = 5;
constexpr int kSamples = 32;
constexpr int kSamplesOfCheck = 256;

/// Peers take long: they answer the first motions of a set, once.
constexpr std::size_t kMotionsOfPeers = 12;

/// Peers are called so often for a motion, and get this much processor time for it.
constexpr int kCallsOfPeers = 3;
constexpr rlim_t kMostSeconds = 4;

/// Larger bodies are not given to peers: conservative advancement takes up to seconds for a motion.
constexpr std::uint64_t kMostOfPeers = 10'000;

bool in_contact(const MotionSet& set, const RigidMotion& motion, double t) {
  return overlap(Body(set.mover, motion.pose_at(t)), set.fixed, {.mode = OverlapMode::any}).any;
}

/// The time of the first of equally spaced samples in contact, or 2.
double first_sampled(const MotionSet& set, const RigidMotion& motion, int samples) {
  for (int k = 0; k <= samples; ++k) {
    const double t = static_cast<double>(k) / samples;
    if (in_contact(set, motion, t)) {
      return t;
    }
  }
  return 2;
}

/// An answer that samples contradict.
bool is_wrong(const MotionSet& set, const RigidMotion& motion, const FirstContact& answer) {
  const bool is_contact = answer.verdict == ContactVerdict::contact;
  return answer.verdict == ContactVerdict::started ||
         first_sampled(set, motion, kSamplesOfCheck) < answer.t.lower ||
         (is_contact && !in_contact(set, motion, answer.t.upper));
}

/// Times of one motion, pass by pass.
struct Times {
  std::vector<double> motion;
  std::vector<double> distance;
  std::vector<double> samples;
};

template <class Work>
double seconds_of(const Work& work) {
  const double begin = processor_seconds();
  work();
  return processor_seconds() - begin;
}

/// The median over the motions of the median over the passes, in microseconds.
double median_of(const std::vector<Times>& times, std::vector<double> Times::*column) {
  std::vector<double> medians;
  for (const Times& of_motion : times) {
    medians.push_back(1e6 * median(of_motion.*column));
  }
  return median(medians);
}

struct Answers {
  std::vector<FirstContact> found;
  std::size_t contacts = 0;
  std::size_t grazing = 0;
  std::size_t wrong = 0;
  std::size_t missed_by_samples = 0;
  Cost cost;
};

Answers answers_of(const MotionSet& set) {
  Answers answers;
  for (const RigidMotion& motion : set.motions) {
    const FirstContact& found =
        answers.found.emplace_back(first_contact(set.mover, motion, set.fixed));
    const bool contact = found.verdict == ContactVerdict::contact;
    answers.contacts += contact ? 1U : 0U;
    answers.grazing += found.verdict == ContactVerdict::grazing ? 1U : 0U;
    answers.wrong += is_wrong(set, motion, found) ? 1U : 0U;
    answers.missed_by_samples += contact && first_sampled(set, motion, kSamples) > 1 ? 1U : 0U;
    answers.cost += found.cost;
  }
  return answers;
}

std::vector<Times> times_of(const MotionSet& set) {
  std::vector<Times> times(set.motions.size());
  for (std::size_t pass = 0; pass < kPasses; ++pass) {
    for (std::size_t k = 0; k < times.size(); ++k) {
      const RigidMotion& motion = set.motions[k];
      times[k].motion.push_back(
          seconds_of([&] { static_cast<void>(first_contact(set.mover, motion, set.fixed)); }));
      times[k].distance.push_back(seconds_of(
          [&] { static_cast<void>(distance(Body(set.mover, motion.start()), set.fixed)); }));
      times[k].samples.push_back(
          seconds_of([&] { static_cast<void>(first_sampled(set, motion, kSamples)); }));
    }
  }
  return times;
}

/// What a peer says, and how long it takes.
struct PeerAnswer {
  PeerContact found;
  double seconds = 0;
};

/// The clock: a new process knows too little of its own processor time.
double clock_seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// In a process of its own: FCL's conservative advancement reads memory that it has not written,
/// and then may not end. The least time of some calls; nothing after kMostSeconds.
std::optional<PeerAnswer> answer_apart(const MotionPeer& peer, const RigidMotion& motion,
                                       const Pose& fixed) {
  int ends[2];
  if (pipe(ends) != 0) {
    return std::nullopt;
  }
  PeerAnswer answer;
  const pid_t child = fork();
  if (child == 0) {
    const rlimit most{kMostSeconds, kMostSeconds};
    setrlimit(RLIMIT_CPU, &most);
    const int nowhere = open("/dev/null", O_WRONLY);
    dup2(nowhere, STDOUT_FILENO);
    dup2(nowhere, STDERR_FILENO);
    answer.seconds = std::numeric_limits<double>::infinity();
    for (int k = 0; k < kCallsOfPeers; ++k) {
      const double begin = clock_seconds();
      answer.found = peer.find(motion.start(), motion.end(), fixed);
      answer.seconds = std::min(answer.seconds, clock_seconds() - begin);
    }
    _exit(write(ends[1], &answer, sizeof answer) == sizeof answer ? 0 : 1);
  }
  close(ends[1]);
  const bool answered = read(ends[0], &answer, sizeof answer) == sizeof answer;
  close(ends[0]);
  waitpid(child, nullptr, 0);
  return answered ? std::optional(answer) : std::nullopt;
}

/// How long a peer takes beside us for the same motions, and which contacts it misses.
void compare(const MotionSet& set, const MotionPeerMaker& maker, const Answers& answers,
             const std::vector<Times>& times) {
  const std::unique_ptr<MotionPeer> peer = maker.make(set.mover_mesh, set.fixed_mesh);
  std::vector<double> ours;
  std::vector<double> theirs;
  std::size_t contacts = 0;
  std::size_t missed = 0;
  std::size_t more = 0;
  std::size_t stuck = 0;
  double latest = 0;
  double apart = 0;
  for (std::size_t k = 0; k < std::min(kMotionsOfPeers, set.motions.size()); ++k) {
    const auto answer = answer_apart(*peer, set.motions[k], set.fixed.pose);
    if (!answer) {
      ++stuck;
      continue;
    }
    const PeerContact& found = answer->found;
    theirs.push_back(1e6 * answer->seconds);
    ours.push_back(1e6 * median(times[k].motion));
    const bool contact = answers.found[k].verdict == ContactVerdict::contact;
    contacts += contact ? 1U : 0U;
    missed += contact && !found.contact ? 1U : 0U;
    if (!contact && found.contact) {
      ++more;
      const Body then(set.mover, set.motions[k].pose_at(found.at));
      apart = std::max(apart, distance(then, set.fixed).distance.lower);
    }
    if (contact && found.contact) {
      latest = std::max(latest, found.at - answers.found[k].t.upper);
    }
  }
  if (theirs.empty()) {
    std::printf("  %-17s does not end\n", maker.name.c_str());
    return;
  }
  std::printf(
      "  %-17s %10.0f us, %7.1f times ours; of %zu contacts %zu missed, found late by up to "
      "%.2g; %zu more, up to %.2g apart; %zu without an end\n",
      maker.name.c_str(), median(theirs), median(theirs) / median(ours), contacts, missed, latest,
      more, apart, stuck);
}

void run(const MotionSet& set, std::uint64_t triangles) {
  const Answers answers = answers_of(set);
  const std::vector<Times> times = times_of(set);
  const double motion = median_of(times, &Times::motion);
  const double start = median_of(times, &Times::distance);
  const double samples = median_of(times, &Times::samples);
  const auto n = static_cast<double>(set.motions.size());
  std::printf(
      "%-36s %3zu %8zu %7zu %5zu %9.1f %9.1f %6.2f %9.0f %9.0f %9.1f %6zu\n", set.name.c_str(),
      set.motions.size(), answers.contacts, answers.grazing, answers.wrong, motion, start,
      motion / start, static_cast<double>(answers.cost.node_tests) / n,
      static_cast<double>(answers.cost.triangle_tests) / n, samples, answers.missed_by_samples);
  std::vector<MotionPeerMaker> makers;
  soms_bench_motion_peers(makers);
  if (triangles <= kMostOfPeers && !makers.empty()) {
    for (const MotionPeerMaker& maker : makers) {
      compare(set, maker, answers, times);
    }
  }
  std::fflush(stdout);
}

struct Family {
  std::string_view name;
  std::uint64_t triangles;
  std::vector<MotionSet> (*make)(std::uint64_t triangles, std::size_t count);
};

constexpr Family kFamilies[] = {
    {"city-5672", 5672, &city_motions},         {"city-100000", 100'000, &city_motions},
    {"city-1000000", 1'000'000, &city_motions}, {"knot-1000", 1000, &knot_motions},
    {"knot-10000", 10'000, &knot_motions},      {"knot-100000", 100'000, &knot_motions}};

/// \param wanted Names of families; all if there is none.
void run_all(const std::vector<std::string_view>& wanted) {
  std::printf("%-36s %3s %8s %7s %5s %9s %9s %6s %9s %9s %9s %6s\n", "set", "n", "contacts",
              "grazing", "wrong", "motion us", "start us", "ratio", "nodes", "triangles",
              "samples us", "missed");
  for (const Family& family : kFamilies) {
    if (wanted.empty() || std::find(wanted.begin(), wanted.end(), family.name) != wanted.end()) {
      for (const MotionSet& set : family.make(family.triangles, kMotions)) {
        run(set, family.triangles);
      }
    }
  }
}

}  // namespace
}  // namespace soms::bench

int main(int count, char** arguments) {
  soms::bench::run_all({arguments + 1, arguments + count});
  return 0;
}
