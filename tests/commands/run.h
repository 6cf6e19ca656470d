/// \file
/// Runs the built command and takes its answers apart.
#pragma once

#include "tests/support/support.h"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace soms::test {

using Json = nlohmann::json;

/// Runs `soms` with these words.
[[nodiscard]] RunResult soms_run(std::vector<std::string> words, const std::string& input = {});

/// Runs `soms` on a terminal of its own; what it shows, on either stream, is `out`.
[[nodiscard]] RunResult soms_on_terminal(std::vector<std::string> words);

/// Runs a line of the shell; `$soms` is the command.
[[nodiscard]] RunResult shell(const std::string& line);

/// Runs `words` with a --timeout that is doubled until it is long enough for the machine, so that
/// the run has come to what the test is about. What is run must not end by itself.
[[nodiscard]] RunResult run_with_time(
    const std::function<RunResult(const std::string& seconds)>& run,
    const std::function<bool(const RunResult&)>& enough);

/// The objects of JSON Lines.
[[nodiscard]] std::vector<Json> json_lines(const std::string& text);

/// A child that is running, and what it needed in the end.
class Child {
 public:
  /// Starts `words` with standard output and error in files of `folder`.
  Child(const std::vector<std::string>& words, const std::filesystem::path& folder);

  /// Its process number.
  [[nodiscard]] int id() const { return pid_; }

  void send(int signal) const;

  /// Sends signals so that the child finds them together.
  void send_together(const std::vector<int>& signals) const;

  /// Waits for an event; false if the child ended before.
  [[nodiscard]] bool wait_until(const std::function<bool()>& happened);

  /// Waits until standard output holds `size` bytes; false if the child ended before.
  [[nodiscard]] bool wait_for_output(std::uintmax_t size);

  /// The same for `count` whole lines.
  [[nodiscard]] bool wait_for_lines(std::ptrdiff_t count);

  /// Waits until it read or wrote `size` bytes, wherever; false if it ended before.
  [[nodiscard]] bool wait_for_reading(std::uintmax_t size);
  [[nodiscard]] bool wait_for_writing(std::uintmax_t size);

  /// Waits until the command takes signals as requests to stop; false if it ended before.
  [[nodiscard]] bool wait_for_interrupts();

  /// Sends a signal again and again until the child ends.
  void send_until_it_ends(int signal);

  /// Waits for the end. The status is as in RunResult.
  RunResult wait();

  /// Most resident memory in KiB; after `wait`.
  [[nodiscard]] long max_resident() const { return max_resident_; }

 private:
  bool reap(int flags);
  [[nodiscard]] std::uintmax_t count_of(const std::string& name) const;

  std::filesystem::path folder_;
  int pid_ = -1;
  bool ended_ = false;
  int status_ = 0;
  long max_resident_ = 0;
};

/// Path of a model, the box [-1, 1]^3.
[[nodiscard]] std::string box();

/// Content of a file.
[[nodiscard]] std::string read_text(const std::filesystem::path& path);

void write_text(const std::filesystem::path& path, const std::string& text);

/// Files of a folder, hidden ones too, sorted by name.
[[nodiscard]] std::vector<std::string> files_in(const std::filesystem::path& folder);

/// An OFF file of one triangle with these corners ("x y z").
[[nodiscard]] std::string triangle_off(const std::string& a, const std::string& b,
                                       const std::string& c);

}  // namespace soms::test
