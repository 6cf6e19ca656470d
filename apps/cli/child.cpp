#include "apps/cli/child.h"

#include "soms/base/error.h"

#include "apps/cli/console.h"
#include "apps/cli/spawn.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <exception>
#include <initializer_list>
#include <sstream>
#include <string_view>
#include <system_error>
#include <thread>
#include <utility>

namespace soms::command {

namespace {

bool runs(const std::filesystem::path& program) {
  std::error_code ignored;
  return std::filesystem::is_regular_file(program, ignored) && ::access(program.c_str(), X_OK) == 0;
}

/// Folders where a program may lie, the nearest first.
std::vector<std::filesystem::path> folders() {
  std::error_code unknown;
  const auto beside = std::filesystem::read_symlink("/proc/self/exe", unknown).parent_path();
  std::vector<std::filesystem::path> all{beside, beside.parent_path() / "libexec" / "soms"};
  const char* const path = std::getenv("PATH");
  std::istringstream rest(path == nullptr ? "" : path);
  for (std::string folder; std::getline(rest, folder, ':');) {
    if (!folder.empty()) {
      all.emplace_back(folder);
    }
  }
  return all;
}

/// True once a child has ended, which stays to be collected.
bool has_ended(pid_t child) {
  siginfo_t info{};
  return ::waitid(P_PID, static_cast<id_t>(child), &info, WEXITED | WNOHANG | WNOWAIT) != 0 ||
         info.si_pid != 0;
}

/// Starts a child that reads nothing and speaks into a file of its home.
pid_t start_at_home(const std::filesystem::path& program, const std::vector<std::string>& words,
                    const ChildOptions& options) {
  const std::filesystem::path said = options.home / "said";
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_addopen(&files, 0, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&files, 1, said.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  posix_spawn_file_actions_adddup2(&files, 1, 2);
  try {
    const pid_t child = start_program(program, words, options.called, {&files, options.home});
    posix_spawn_file_actions_destroy(&files);
    return child;
  } catch (...) {
    posix_spawn_file_actions_destroy(&files);
    throw;
  }
}

/// Runs a child to its end and reads what it writes to these of its descriptors.
ChildAnswer read_child(const std::filesystem::path& program, const std::vector<std::string>& words,
                       const std::string& called, std::initializer_list<int> descriptors) {
  std::array<int, 2> ends{};
  if (::pipe(ends.data()) != 0) {
    throw not_started(program, errno);
  }
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  for (const int descriptor : descriptors) {
    posix_spawn_file_actions_adddup2(&files, ends[1], descriptor);
  }
  posix_spawn_file_actions_addclose(&files, ends[0]);
  posix_spawn_file_actions_addclose(&files, ends[1]);
  pid_t child = -1;
  std::exception_ptr fault;
  try {
    child = start_program(program, words, called, {&files});
  } catch (const Error&) {
    fault = std::current_exception();
  }
  posix_spawn_file_actions_destroy(&files);
  ::close(ends[1]);
  ChildAnswer answer;
  std::array<char, 4096> bytes{};
  for (ssize_t got = 1; child > 0 && got > 0;) {
    got = ::read(ends[0], bytes.data(), bytes.size());
    answer.text.append(bytes.data(), static_cast<std::size_t>(std::max<ssize_t>(got, 0)));
  }
  ::close(ends[0]);
  if (fault) {
    std::rethrow_exception(fault);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  answer.status = exit_status_of(status);
  return answer;
}

}  // namespace

std::filesystem::path find_program(const ChildProgram& program) {
  const char* const named = std::getenv(program.variable.c_str());
  if (named != nullptr && *named != '\0') {
    if (!runs(named)) {
      throw Error(ErrorKind::unsupported, program.variable + " does not name a program: " + named,
                  program.remedy);
    }
    return named;
  }
  std::vector<std::string> names = program.other_names;
  names.insert(names.begin(), program.name);
  for (const std::string& name : names) {
    for (const std::filesystem::path& folder : folders()) {
      if (runs(folder / name)) {
        return folder / name;
      }
    }
  }
  throw Error(ErrorKind::unsupported, "the program " + program.name + " is not installed",
              program.remedy);
}

std::filesystem::path viewer_program() {
  return find_program(
      {.name = "soms-view",
       .variable = "SOMS_VIEW",
       .remedy = "make view installs what it needs and builds it, or set SOMS_VIEW to its path; "
                 "see docs/view.md"});
}

std::string as_argument(const std::string& path) {
  return path.size() > 1 && path[0] == '-' ? "./" + path : path;
}

void become(const std::filesystem::path& program, const std::string& called,
            const std::vector<std::string>& words) {
  std::signal(SIGPIPE, SIG_DFL);
  std::signal(SIGXFSZ, SIG_DFL);
  Arguments arguments(called, words);
  ::execv(program.c_str(), arguments.get());
  throw not_started(program, errno);
}

std::string output_of(const std::filesystem::path& program, const std::vector<std::string>& words,
                      const std::string& called) {
  try {
    return read_child(program, words, called, {1}).text;
  } catch (const Error&) {
    return {};
  }
}

ChildAnswer answer_of(const std::filesystem::path& program, const std::vector<std::string>& words) {
  return read_child(program, words, {}, {1, 2});
}

int run_child(const std::filesystem::path& program, const std::vector<std::string>& words,
              const Console& console, const ChildOptions& options) {
  const bool stranger = !options.home.empty();
  const pid_t child = stranger ? start_at_home(program, words, options)
                               : start_program(program, words, options.called, {});
  int status = 0;
  bool terminated = false;
  while (!has_ended(child)) {
    if (!terminated && (console.interrupted() || (options.timed && console.out_of_time()))) {
      ::kill(stranger ? -child : child, stranger ? SIGKILL : SIGTERM);
      terminated = true;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  if (stranger) {
    ::kill(-child, SIGKILL);  // what it left running, while its number is still its own
  }
  ::waitpid(child, &status, 0);
  if (console.interrupted()) {
    throw Error(ErrorKind::cancelled, "interrupted", "");
  }
  if (terminated) {
    throw Error(ErrorKind::timed_out, "out of time while " + program.filename().string() + " ran",
                "allow more time with --timeout");
  }
  return exit_status_of(status);
}

}  // namespace soms::command
