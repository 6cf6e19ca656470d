#include "apps/support/child.h"

#include "soms/base/error.h"

#include "apps/support/console.h"

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <initializer_list>
#include <sstream>
#include <system_error>
#include <thread>

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

/// Words as a program takes them; pointers last as long as the object.
class Arguments {
 public:
  Arguments(const std::string& first, const std::vector<std::string>& words) : words_(words) {
    words_.insert(words_.begin(), first);
    for (std::string& word : words_) {
      pointers_.push_back(word.data());
    }
    pointers_.push_back(nullptr);
  }

  [[nodiscard]] char* const* get() { return pointers_.data(); }

 private:
  std::vector<std::string> words_;
  std::vector<char*> pointers_;
};

Error not_started(const std::filesystem::path& program, int fault) {
  if (fault == ENOMEM) {
    return Error(ErrorKind::out_of_memory,
                 program.string() + " cannot be started: " + std::strerror(fault),
                 "allow more with --max-memory, or free some");
  }
  return Error(ErrorKind::unsupported,
               program.string() + " cannot be started: " + std::strerror(fault),
               "rebuild or reinstall it");
}

/// Starts a child to which signals mean what they usually do.
pid_t start(const std::filesystem::path& program, const std::vector<std::string>& words,
            const std::string& called, const posix_spawn_file_actions_t* files) {
  Arguments arguments(called.empty() ? program.string() : called, words);
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  sigset_t none;
  sigemptyset(&none);
  sigset_t usual;
  sigemptyset(&usual);
  sigaddset(&usual, SIGPIPE);
  sigaddset(&usual, SIGXFSZ);
  posix_spawnattr_setsigmask(&attributes, &none);
  posix_spawnattr_setsigdefault(&attributes, &usual);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
  pid_t child = -1;
  const int fault =
      posix_spawn(&child, program.c_str(), files, &attributes, arguments.get(), environ);
  posix_spawnattr_destroy(&attributes);
  if (fault != 0) {
    throw not_started(program, fault);
  }
  return child;
}

int exit_status_of(int status) {
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
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
    child = start(program, words, called, &files);
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
  for (const std::filesystem::path& folder : folders()) {
    if (runs(folder / program.name)) {
      return folder / program.name;
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
  const pid_t child = start(program, words, options.called, nullptr);
  int status = 0;
  bool terminated = false;
  while (::waitpid(child, &status, WNOHANG) == 0) {
    if (!terminated && (console.interrupted() || (options.timed && console.out_of_time()))) {
      ::kill(child, SIGTERM);
      terminated = true;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
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
