/// \file
/// Ctrl-C and time limits as stop tokens.
#pragma once

#include <pthread.h>

#include <atomic>
#include <chrono>
#include <csignal>
#include <optional>
#include <stop_token>
#include <thread>

namespace soms::command {

/// While it lives, SIGINT, SIGTERM and SIGHUP (unless they are ignored, as under nohup) request a
/// stop, and one half a second or more after the first ends the program at once. A thread waits for
/// them, so no handler runs in the middle of anything. Make it before any other thread.
class Interrupts {
 public:
  explicit Interrupts(std::optional<std::chrono::steady_clock::time_point> deadline);
  ~Interrupts();
  Interrupts(const Interrupts&) = delete;
  Interrupts& operator=(const Interrupts&) = delete;

  /// Stops when a signal came.
  [[nodiscard]] std::stop_token signalled() const { return signalled_.get_token(); }

  /// Stops when a signal came or the deadline passed.
  [[nodiscard]] std::stop_token stopped() const { return stopped_.get_token(); }

 private:
  void wait();
  int next_signal();

  std::optional<std::chrono::steady_clock::time_point> deadline_;
  sigset_t signals_;
  sigset_t mask_before_;
  std::stop_source signalled_;
  std::stop_source stopped_;
  std::atomic<bool> over_ = false;
  std::thread thread_;
};

}  // namespace soms::command
