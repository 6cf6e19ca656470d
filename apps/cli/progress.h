/// \file
/// A progress bar on standard error.
#pragma once

#include <chrono>
#include <string>
#include <utility>

namespace soms::command {

/// A line on a terminal that tells how far work has come. It appears after one second, changes at
/// most ten times a second, and goes when the object does.
class Progress {
 public:
  Progress(std::string doing, bool visible);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Names what is done from here on.
  void rename(std::string doing) { doing_ = std::move(doing); }

  /// Shows a share from 0 to 1 as a bar.
  void show(double share);

  /// Shows words, where no share is known.
  void show(const std::string& words);

 private:
  [[nodiscard]] bool is_due();
  void draw(const std::string& rest);

  std::string doing_;
  bool visible_;
  bool drawn_ = false;
  std::chrono::steady_clock::time_point next_;
};

}  // namespace soms::command
