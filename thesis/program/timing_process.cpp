#include "thesis/program/timing_process.h"

#include "soms/base/error.h"

#include "apps/cli/console.h"
#include "apps/cli/exit_status.h"
#include "apps/cli/parser.h"
#include "apps/cli/spawn.h"
#include "thesis/run/experiment.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <memory>
#include <system_error>
#include <thread>
#include <utility>

namespace soms::command {

namespace {

namespace fs = std::filesystem;

/// A stop is seen so soon.
constexpr int kPollMilliseconds = 50;

fs::path this_program() {
  std::error_code unknown;
  return fs::read_symlink("/proc/self/exe", unknown);
}

/// Lines over two descriptors.
class PipeChannel : public reproduce::LineChannel {
 public:
  PipeChannel(int from, int to, Limits limits) : from_(from), to_(to), limits_(std::move(limits)) {}

  void send(std::string_view line) override {
    std::string rest = fmt::format("{}\n", line);
    while (!rest.empty()) {
      const ssize_t written = ::write(to_, rest.data(), rest.size());
      if (written < 0 && errno != EINTR) {
        gone();
      }
      rest.erase(0, static_cast<std::size_t>(std::max<ssize_t>(0, written)));
    }
  }

  [[nodiscard]] std::string receive() override {
    std::size_t end = buffer_.find('\n');
    for (std::size_t seen = 0; end == std::string::npos; end = buffer_.find('\n', seen)) {
      seen = buffer_.size();
      read_some();
    }
    std::string line = buffer_.substr(0, end);
    buffer_.erase(0, end + 1);
    return line;
  }

 protected:
  /// The other one does not read or has closed its end. Throws.
  [[noreturn]] virtual void gone() {
    throw Error(ErrorKind::cancelled, "the run that this process timed for has ended", "");
  }

 private:
  void read_some() {
    pollfd readable{from_, POLLIN, 0};
    while (::poll(&readable, 1, kPollMilliseconds) <= 0) {
      check_stop(limits_);
    }
    std::array<char, 65536> bytes;
    const ssize_t got = ::read(from_, bytes.data(), bytes.size());
    if (got == 0 || (got < 0 && errno != EINTR)) {
      check_stop(limits_);
      gone();
    }
    buffer_.append(bytes.data(), static_cast<std::size_t>(std::max<ssize_t>(0, got)));
  }

  int from_;
  int to_;
  Limits limits_;
  std::string buffer_ = {};
};

/// A pipe whose ends no other child gets.
class Pipe {
 public:
  Pipe() {
    if (::pipe2(ends_.data(), O_CLOEXEC) != 0) {
      throw not_started(this_program(), errno);
    }
  }

  ~Pipe() {
    close(0);
    close(1);
  }

  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;

  [[nodiscard]] int end(std::size_t which) const { return ends_[which]; }

  void close(std::size_t which) {
    if (const int end = std::exchange(ends_[which], -1); end >= 0) {
      ::close(end);
    }
  }

 private:
  std::array<int, 2> ends_ = {-1, -1};
};

/// Pipes and process of a `TimingChild`, which must be there before its channel.
class ChildProcess {
 public:
  explicit ChildProcess(const std::vector<std::string>& words) {
    posix_spawn_file_actions_t files;
    posix_spawn_file_actions_init(&files);
    posix_spawn_file_actions_adddup2(&files, to_.end(0), 0);
    posix_spawn_file_actions_adddup2(&files, from_.end(1), 1);
    try {
      pid_ = start_program(this_program(), words, {}, {.files = &files, .apart = true});
    } catch (...) {
      posix_spawn_file_actions_destroy(&files);
      throw;
    }
    posix_spawn_file_actions_destroy(&files);
    to_.close(0);
    from_.close(1);
  }

  /// It has written nothing that it would have to put in order.
  ~ChildProcess() { (void)finish(0); }

  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

 protected:
  [[nodiscard]] int from() const { return from_.end(0); }

  [[nodiscard]] int to() const { return to_.end(1); }

  /// Ends it, unless it ends by itself within so many polls, and returns its exit status.
  int finish(int patience) {
    const pid_t child = std::exchange(pid_, -1);
    int status = 0;
    for (int i = 0; child > 0 && i < patience; ++i) {
      if (::waitpid(child, &status, WNOHANG) == child) {
        return exit_status_of(status);
      }
      std::this_thread::sleep_for(std::chrono::milliseconds(kPollMilliseconds));
    }
    if (child > 0) {
      ::kill(child, SIGKILL);
      while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
      }
    }
    return exit_status_of(status);
  }

 private:
  Pipe to_;
  Pipe from_;
  pid_t pid_ = -1;
};

/// A process that times for this one.
class TimingChild : private ChildProcess, public PipeChannel {
 public:
  TimingChild(const std::vector<std::string>& words, const Limits& limits)
      : ChildProcess(words), PipeChannel(from(), to(), limits) {}

 protected:
  [[noreturn]] void gone() override {
    constexpr int kPatience = 40;  // it closes its pipes a little before its end
    const int status = finish(kPatience);
    if (status == kOutOfTime) {
      throw Error(ErrorKind::out_of_memory, "a process that times races ran out of memory",
                  "allow more with --max-memory, or free some");
    }
    throw Error(ErrorKind::unsupported,
                fmt::format("a process that times races ended with status {}", status),
                "run it again; if it said why, see above");
  }
};

std::vector<std::string> words_for(const TimingOptions& options, const Shared& shared) {
  std::vector<std::string> words{kTimingVerb, "--quiet"};
  if (options.quick) {
    words.emplace_back("--quick");
  }
  if (!options.models.empty()) {
    words.insert(words.end(), {"--models", options.models});
  }
  if (shared.max_memory > 0) {
    words.insert(words.end(), {"--max-memory", std::to_string(shared.max_memory)});
  }
  return words;
}

/// Times until the run has ended.
int time_for_a_run(const TimingOptions& options, const Console& console) {
  const Limits one_thread{.threads = 1, .stop = console.limits().stop};
  PipeChannel leader(0, 1, one_thread);
  try {
    const reproduce::Models models =
        reproduce::find_models(options.models, {.objects = true, .scenes = true}, one_thread);
    reproduce::RaceFollower follower(reproduce::kTimingProcesses, leader);
    follower.serve([&](std::string_view item) {
      const reproduce::Context context{
          .models = models, .quick = options.quick, .limits = one_thread, .races = &follower};
      (void)reproduce::experiments_named({&item, 1}).front()->run(context);
    });
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::cancelled) {
      throw;
    }
    return kInterrupted;
  }
}

}  // namespace

int possible_timing_processes() {
  return this_program().empty() ? 1 : reproduce::kTimingProcesses;
}

reproduce::RaceLeader::Followers start_timing_processes(int count, const TimingOptions& options,
                                                        const Shared& shared,
                                                        const Limits& limits) {
  reproduce::RaceLeader::Followers followers;
  for (int i = 0; i < count; ++i) {
    followers.push_back(std::make_unique<TimingChild>(words_for(options, shared), limits));
  }
  return followers;
}

Action add_timing_process(Parser& parser, Shared&) {
  const auto options = std::make_shared<TimingOptions>();
  parser.add_option("--models", options->models, "as of soms reproduce")->option_text("DIR");
  parser.add_flag("--quick", options->quick, "as of soms reproduce");
  return [options](Console& console) { return time_for_a_run(*options, console); };
}

}  // namespace soms::command
