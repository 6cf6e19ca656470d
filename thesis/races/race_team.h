/// \file
/// How the processes of a run take turns at its races. One leads: it counts, decides, times its
/// share and has the results. The others follow: they run the same experiments up to their last
/// race, skip what is only counted, and time their share when the leader says so. Only one process
/// works at a time.
///
/// They speak in lines. The leader says
///
///     item ITEM              before the first race of an experiment
///     decision LABEL<TAB>N N ...
///     go                     up to and including the next race, then wait
///     over                   leave the experiment
///
/// and a follower says
///
///     ready                  once, with its models read
///     race LABEL<TAB>SECONDS<TAB>N N ...
///     end                    the experiment has no further race
#pragma once

#include "thesis/races/race_process.h"

#include <cstddef>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace soms::reproduce {

/// Lines to another process and from it.
class LineChannel {
 public:
  LineChannel() = default;
  virtual ~LineChannel() = default;
  LineChannel(const LineChannel&) = delete;
  LineChannel& operator=(const LineChannel&) = delete;

  /// \errors Error if the other one is gone.
  virtual void send(std::string_view line) = 0;

  /// The next line, without its end. \errors Error if the other one is gone; cancelled.
  [[nodiscard]] virtual std::string receive() = 0;
};

/// Processes behind the rounds of a claim.
inline constexpr int kTimingProcesses = 5;

/// The process that counts and has the results.
class RaceLeader : public RaceProcess {
 public:
  using Followers = std::vector<std::unique_ptr<LineChannel>>;

  /// `start` makes the followers, before the first race; there are `processes` - 1 of them.
  RaceLeader(int processes, std::function<Followers()> start);

  [[nodiscard]] int processes() const override { return processes_; }

  Decision decide(const std::string& label, const std::function<Decision()>& count) override;

  RoundsByWork gather(const std::string& label, const std::function<RoundsByWork()>& time) override;

  /// An experiment begins; the one before is over.
  void begin(std::string_view item);

  /// Processor time that followers have reported.
  [[nodiscard]] double processor_seconds() const { return processor_seconds_; }

 private:
  void start_followers();

  int processes_;
  std::function<Followers()> start_;
  std::optional<Followers> followers_ = {};
  std::string item_ = {};
  bool begun_ = false;  ///< followers are in the experiment
  std::vector<std::pair<std::string, Decision>> decisions_ =
      {};  ///< that followers do not know yet
  double processor_seconds_ = 0;
};

/// A process that times for a leader.
class RaceFollower : public RaceProcess {
 public:
  /// `leader` must outlive the object.
  RaceFollower(int processes, LineChannel& leader) : processes_(processes), leader_(&leader) {}

  [[nodiscard]] int processes() const override { return processes_; }

  [[nodiscard]] bool times_only() const override { return true; }

  Decision decide(const std::string& label, const std::function<Decision()>& count) override;

  RoundsByWork gather(const std::string& label, const std::function<RoundsByWork()>& time) override;

  /// Runs experiments as the leader names them, for ever.
  /// \errors Error when the leader is gone; std::logic_error if it says what is not understood.
  [[noreturn]] void serve(const std::function<void(std::string_view item)>& run);

 private:
  void wait_for_turn();

  int processes_;
  LineChannel* leader_;
  std::deque<std::pair<std::string, Decision>> decisions_ = {};
  double reported_seconds_ = 0;
};

}  // namespace soms::reproduce
