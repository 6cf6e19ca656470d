#include "soms/io/detail/import/import_child.h"

#include "soms/io/detail/file.h"
#include "soms/io/detail/import/import_program.h"

#include <fcntl.h>
#include <fmt/core.h>
#include <poll.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <limits>
#include <memory>
#include <optional>
#include <thread>
#include <utility>
#include <vector>

namespace soms::detail {

namespace {

using Clock = std::chrono::steady_clock;

constexpr double kMostSeconds = 1e9;
/// Exit status of soms-import that says that memory was too little.
constexpr int kNoMemory = 4;
/// One that says that the model is at fault, which the answer describes.
constexpr int kRefused = 1;

/// What the program says, as the middle of a sentence.
std::string in_words(std::string_view text) {
  const std::size_t last = text.find_last_not_of(" \t\r\n.;!");
  return printable(text.substr(0, last == std::string_view::npos ? 0 : last + 1));
}

[[noreturn]] void fail_system(const Source& source, const std::string& what, int code) {
  source.fail(ErrorKind::unsupported, what + ": " + std::strerror(code),
              "free the resource that is missing, or convert the model");
}

/// The model as a file without a name, from its first byte.
int file_of(const Source& source) {
  const int file = memfd_create("soms-import", MFD_CLOEXEC);
  if (file < 0) {
    fail_system(source, "cannot create a temporary file for soms-import", errno);
  }
  std::string_view left = source.bytes;
  while (!left.empty()) {
    const ssize_t done = write(file, left.data(), std::min(left.size(), std::size_t{1} << 26));
    if (done < 0 && errno != EINTR) {
      const int code = errno;
      close(file);
      fail_system(source, "cannot create a temporary file for soms-import", code);
    }
    left.remove_prefix(done < 0 ? 0 : static_cast<std::size_t>(done));
  }
  lseek(file, 0, SEEK_SET);
  return file;
}

/// A process group that is killed and collected when the object goes.
class Child {
 public:
  explicit Child(pid_t process) : process_(process) {}

  ~Child() {
    if (!collected_ && !ended()) {
      kill(-process_, SIGKILL);
      kill(process_, SIGKILL);
      while (waitpid(process_, nullptr, 0) < 0 && errno == EINTR) {
      }
    }
  }

  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  /// The status of a child that has ended. Where somebody else has collected it, 0: then its answer
  /// alone must be judged.
  [[nodiscard]] std::optional<int> ended() {
    siginfo_t info{};
    const int found =
        waitid(P_PID, static_cast<id_t>(process_), &info, WEXITED | WNOHANG | WNOWAIT);
    if ((found == 0 && info.si_pid == 0) || (found != 0 && errno == EINTR)) {
      return std::nullopt;
    }
    collected_ = true;
    // A number that was given back may be another's by now.
    if (found != 0) {
      return 0;
    }
    // What it started itself ends with it, while its number is still its own.
    kill(-process_, SIGKILL);
    int status = 0;
    while (waitpid(process_, &status, 0) < 0 && errno == EINTR) {
    }
    return status;
  }

  void limit(__rlimit_resource resource, std::uint64_t most) const {
    const rlim_t value = std::min<std::uint64_t>(most, std::numeric_limits<rlim_t>::max() - 1);
    const rlimit both{value, value};
    prlimit(process_, resource, &both, nullptr);
  }

 private:
  pid_t process_;
  bool collected_ = false;
};

/// Starts the program with the model as its input; its output goes to `out`.
pid_t start(const Source& source, const ImportProgram& program, std::string_view extension,
            int model, int out) {
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_adddup2(&files, model, STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&files, out, STDOUT_FILENO);
  posix_spawn_file_actions_addopen(&files, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_addclosefrom_np(&files, STDERR_FILENO + 1);
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  sigset_t signals;
  sigemptyset(&signals);
  posix_spawnattr_setsigmask(&attributes, &signals);
  sigfillset(&signals);
  posix_spawnattr_setsigdefault(&attributes, &signals);
  posix_spawnattr_setpgroup(&attributes, 0);
  posix_spawnattr_setflags(&attributes,
                           POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETPGROUP);
  std::vector<std::string> words = {program.path.string()};
  words.insert(words.end(), program.arguments.begin(), program.arguments.end());
  words.emplace_back(extension);
  std::vector<char*> arguments;
  for (std::string& word : words) {
    arguments.push_back(word.data());
  }
  arguments.push_back(nullptr);
  pid_t process = -1;
  const int fault =
      posix_spawn(&process, program.path.c_str(), &files, &attributes, arguments.data(), environ);
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&files);
  if (fault != 0) {
    fail_system(source, program.path.string() + " cannot be started", fault);
  }
  return process;
}

class ImportRun {
 public:
  ImportRun(Source& source, ImportProgram program, std::string_view extension)
      : source_(source),
        program_(std::move(program)),
        extension_(extension),
        seconds_(source.import_seconds > 0 ? std::min(source.import_seconds, kMostSeconds) : 0) {}

  std::string answer();

 private:
  void collect(int pipe);
  void grow();
  void wait_a_little(Clock::duration time) const;
  [[noreturn]] void fail_status(int status) const;

  Source& source_;
  ImportProgram program_;
  std::string_view extension_;
  double seconds_;  ///< that it may take: no NaN, and few enough to be counted
  Clock::time_point deadline_;
  std::uint64_t memory_ = 0;
  std::string answer_;
};

/// Room for more of the answer: new memory is taken before the old is given back.
void ImportRun::grow() {
  const std::uint64_t old = answer_.capacity();
  const std::uint64_t wanted = std::max<std::uint64_t>(std::uint64_t{1} << 16, 2 * old);
  if (!source_.budget.take(wanted)) {
    source_.fail_memory(wanted);
  }
  answer_.reserve(wanted);
  source_.budget.give_back(old);
}

void ImportRun::wait_a_little(Clock::duration time) const {
  check(source_.limits);
  if (Clock::now() >= deadline_) {
    source_.fail(ErrorKind::timed_out,
                 fmt::format("{} did not end within {:g} s", program_.name, seconds_),
                 "convert the model, or allow more time (import_seconds)");
  }
  std::this_thread::sleep_for(time);
}

/// Reads the pipe to its end, looking at the clock and the caller's wish to stop.
void ImportRun::collect(int pipe) {
  std::array<char, std::size_t{1} << 14> some{};
  while (true) {
    wait_a_little(Clock::duration::zero());
    pollfd ready{pipe, POLLIN, 0};
    constexpr int kMilliseconds = 20;
    if (poll(&ready, 1, kMilliseconds) <= 0) {
      continue;
    }
    const ssize_t got = read(pipe, some.data(), some.size());
    if (got == 0) {
      return;
    }
    if (got > 0) {
      const auto size = static_cast<std::size_t>(got);
      while (answer_.capacity() - answer_.size() < size) {
        grow();
      }
      answer_.append(some.data(), size);
    } else if (errno != EINTR) {
      fail_system(source_, "cannot read the answer of " + program_.name, errno);
    }
  }
}

void ImportRun::fail_status(int status) const {
  const bool read_better = extension_ == ".ifc" && program_.name != "web-ifc";
  const std::string remedy =
      std::string("check the model, ") +
      (read_better ? "install Node.js and web-ifc (npm install -g web-ifc), " : "") +
      "or convert it to a format that soms reads itself";
  if (WIFSIGNALED(status)) {
    // What a library does that gets no memory cannot be distinguished from a fault of another kind.
    source_.fail(ErrorKind::bad_file,
                 fmt::format("{} crashed (signal {}, memory limit {} MiB)", program_.name,
                             WTERMSIG(status), memory_ >> 20),
                 remedy + ", or give it more memory (max_memory)");
  }
  if (WEXITSTATUS(status) == kNoMemory) {
    source_.fail(ErrorKind::out_of_memory,
                 fmt::format("{} exceeds its memory limit of {} MiB", program_.name, memory_ >> 20),
                 "raise the limit (max_memory) if the file can be trusted");
  }
  if (WEXITSTATUS(status) == kRefused && !answer_.empty()) {
    source_.fail(
        ErrorKind::bad_file,
        fmt::format("{} cannot read it as {}: {}", program_.name, extension_, in_words(answer_)),
        remedy);
  }
  source_.fail(ErrorKind::bad_file,
               fmt::format("{} ended with status {}", program_.name, WEXITSTATUS(status)), remedy);
}

std::string ImportRun::answer() {
  const std::uint64_t copy = source_.bytes.size();
  if (!source_.budget.take(copy)) {
    source_.fail_memory(copy);
  }
  const Descriptor model(file_of(source_));
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) {
    fail_system(source_, "cannot create a pipe for soms-import", errno);
  }
  const Descriptor pipe(ends[0]);
  auto out = std::make_unique<Descriptor>(ends[1]);
  const std::chrono::duration<double> seconds(seconds_);
  deadline_ = Clock::now() + std::chrono::duration_cast<Clock::duration>(seconds);
  const std::uint64_t left = source_.budget.left();
  memory_ = program_.own_memory +
            std::min(left, std::numeric_limits<std::uint64_t>::max() - program_.own_memory);
  Child child(start(source_, program_, extension_, model.get(), out->get()));
  child.limit(program_.reserves_addresses ? RLIMIT_DATA : RLIMIT_AS, memory_);
  child.limit(RLIMIT_CPU, static_cast<std::uint64_t>(seconds_) + 1);
  child.limit(RLIMIT_CORE, 0);
  child.limit(RLIMIT_FSIZE, 0);
  out.reset();
  collect(pipe.get());
  std::optional<int> status = child.ended();
  for (; !status; status = child.ended()) {
    wait_a_little(std::chrono::milliseconds(1));
  }
  if (*status != 0) {
    fail_status(*status);
  }
  source_.budget.give_back(copy);
  return std::move(answer_);
}

}  // namespace

std::string printable(std::string_view text) {
  constexpr std::size_t kMost = 200;
  std::string result;
  for (const char c : text.substr(0, kMost)) {
    result += c >= ' ' && c <= '~' ? c : '?';
  }
  return result;
}

std::string run_import(Source& source, std::string_view extension) {
  return ImportRun(source, find_import_program(source, extension), extension).answer();
}

}  // namespace soms::detail
