/// \file
/// Where a verb's answers and remarks go, and how it is stopped.
#pragma once

#include "soms/base/error.h"
#include "soms/base/limits.h"

#include "apps/cli/interrupts.h"
#include "apps/cli/progress.h"
#include "apps/cli/shared.h"
#include "apps/cli/terminal.h"
#include "apps/output/output.h"

#include <chrono>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <string_view>

namespace soms::command {

/// Answers on standard output, remarks and progress on standard error, Ctrl-C and --timeout as
/// stop tokens.
class Console {
 public:
  explicit Console(const Shared& shared);

  [[nodiscard]] const Shared& shared() const { return shared_; }

  /// Adds to the answers, which are written when there are many and by `flush`.
  /// \errors ErrorKind::cannot_write; ClosedPipe, unless the work goes on without a reader.
  void print(std::string_view text);

  /// From now on the reader of standard output may go away without ending the work: files, or the
  /// exit status, are wanted whether or not anybody reads the answers.
  void go_on_without_reader() { goes_on_ = true; }

  /// \errors As `print`.
  void flush();

  /// A line on standard error, once, however often it is reported; none with --quiet.
  void note(std::string_view line) const;

  /// True if answers go to a terminal, whose reader may be glad of a hint; not with --quiet.
  [[nodiscard]] bool talks_to_a_person() const;

  /// Where answers go.
  [[nodiscard]] const Terminal& terminal() const { return terminal_; }

  /// True once Ctrl-C was pressed.
  [[nodiscard]] bool interrupted() const { return interrupts_.signalled().stop_requested(); }

  /// True once --timeout passed.
  [[nodiscard]] bool out_of_time() const;

  /// Threads of --threads, stopped by Ctrl-C, with --timeout as the deadline: for queries, which
  /// answer what they have by then.
  [[nodiscard]] Limits limits() const;

  /// The same, stopped by --timeout, too: for what must be complete.
  [[nodiscard]] Limits limited() const;

  /// A bar named `doing`, for work that reports by itself.
  [[nodiscard]] Progress progress(const std::string& doing) const;

  /// Runs `work(const Parallel&)` with a progress bar named `doing`; Ctrl-C and --timeout stop it.
  /// \errors Those of `work`; ErrorKind::timed_out.
  template <class Work>
  auto run(const std::string& doing, const Work& work) const {
    if (out_of_time()) {
      throw_out_of_time(doing);
    }
    Progress bar = progress(doing);
    Limits limits = limited();
    limits.progress = [&bar](double share) { bar.show(share); };
    try {
      return work(limits);
    } catch (const Error& error) {
      if (error.kind() == ErrorKind::cancelled && !interrupted()) {
        throw_out_of_time(doing);
      }
      throw;
    }
  }

 private:
  void write(std::string_view text, bool all);
  [[noreturn]] static void throw_out_of_time(const std::string& doing);

  Shared shared_;
  mutable std::set<std::string, std::less<>> noted_;
  std::optional<std::chrono::steady_clock::time_point> deadline_;
  Interrupts interrupts_;
  FileStream out_;
  Terminal terminal_;
  Terminal remarks_;  ///< standard error
  bool goes_on_ = false;
  bool unread_ = false;  ///< the reader went away
};

/// \errors ErrorKind::usage with --json, which a verb without answers would ignore, for this
/// reason.
void refuse_json(const Console& console, const std::string& reason);

}  // namespace soms::command
