#include "apps/cli/console.h"

#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>

namespace soms::command {

namespace {

std::optional<std::chrono::steady_clock::time_point> deadline_of(const Shared& shared) {
  if (!shared.timeout) {
    return std::nullopt;
  }
  return std::chrono::steady_clock::now() +
         std::chrono::duration_cast<std::chrono::steady_clock::duration>(
             std::chrono::duration<double>(*shared.timeout));
}

/// Below so much memory one thread must do: a thread that cannot be made for want of memory would
/// end the program instead of the work.
constexpr std::uint64_t kMemoryForThreads = std::uint64_t{512} << 20;

/// Private writable memory beyond the limit is refused by the system, which `new` reports.
void limit_memory(std::uint64_t bytes) {
  rlimit limit{};
  if (bytes == 0 || ::getrlimit(RLIMIT_DATA, &limit) != 0) {
    return;
  }
  limit.rlim_cur = std::min<rlim_t>(bytes, limit.rlim_max);
  if (::setrlimit(RLIMIT_DATA, &limit) != 0) {
    throw Error(ErrorKind::usage, "--max-memory: the system rejects this limit", "leave it out");
  }
}

}  // namespace

Console::Console(const Shared& shared)
    : shared_(shared),
      deadline_(deadline_of(shared)),
      interrupts_(deadline_),
      out_(1, "standard output"),
      terminal_(terminal_of(1)),
      remarks_(terminal_of(2)) {
  limit_memory(shared.max_memory);
}

void Console::print(std::string_view text) {
  write(text, false);
}

void Console::flush() {
  write({}, true);
}

void Console::write(std::string_view text, bool all) {
  if (unread_) {
    return;
  }
  try {
    out_ << text;
    if (all || !out_.good()) {
      out_.finish();
    }
  } catch (const ClosedPipe&) {
    if (!goes_on_) {
      throw;
    }
    unread_ = true;
  }
}

void Console::note(std::string_view line) const {
  if (!shared_.quiet && noted_.emplace(line).second) {
    constexpr std::string_view kWarning = "warning:";
    constexpr std::size_t kIndent = 2;
    std::string text = wrap_words(printable(line), remarks_.width, kIndent) + "\n";
    if (text.starts_with(kWarning)) {
      text.replace(0, kWarning.size(), remarks_.paint(kWarning, Ink::open));
    }
    (void)!::write(2, text.data(), text.size());
  }
}

bool Console::talks_to_a_person() const {
  return !shared_.quiet && terminal_.person;
}

bool Console::out_of_time() const {
  return deadline_ && std::chrono::steady_clock::now() >= *deadline_;
}

Limits Console::limits() const {
  const bool narrow = shared_.max_memory != 0 && shared_.max_memory < kMemoryForThreads;
  return {.threads = narrow ? 1 : shared_.threads,
          .stop = interrupts_.signalled(),
          .deadline = deadline_};
}

Limits Console::limited() const {
  Limits stopped = limits().without_deadline();
  stopped.stop = interrupts_.stopped();
  return stopped;
}

Progress Console::progress(const std::string& doing) const {
  return Progress(doing, !shared_.quiet && remarks_.person);
}

void refuse_json(const Console& console, const std::string& reason) {
  if (console.shared().json) {
    throw Error(ErrorKind::usage, "--json has no effect: " + reason, "leave it out");
  }
}

void Console::throw_out_of_time(const std::string& doing) {
  throw Error(ErrorKind::timed_out, fmt::format("out of time while {}", doing),
              "allow more time with --timeout");
}

}  // namespace soms::command
