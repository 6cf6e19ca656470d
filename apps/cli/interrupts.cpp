#include "apps/cli/interrupts.h"

#include "apps/cli/exit_status.h"

#include <unistd.h>

#include <algorithm>

namespace soms::command {

namespace {

constexpr int kWakeUp = SIGUSR1;  // ends the waiting thread

/// A signal sooner after the first is the same request: `timeout` signals its child, then its
/// process group.
constexpr std::chrono::milliseconds kSameRequest(500);

bool is_ignored(int signal) {
  struct sigaction action {};

  return sigaction(signal, nullptr, &action) == 0 && action.sa_handler == SIG_IGN;
}

timespec time_until(std::chrono::steady_clock::time_point deadline) {
  const auto left = std::max(deadline - std::chrono::steady_clock::now(),
                             std::chrono::steady_clock::duration::zero());
  const auto seconds = std::chrono::floor<std::chrono::seconds>(left);
  const auto rest = std::chrono::duration_cast<std::chrono::nanoseconds>(left - seconds);
  return {.tv_sec = static_cast<time_t>(seconds.count()),
          .tv_nsec = static_cast<long>(rest.count())};
}

}  // namespace

Interrupts::Interrupts(std::optional<std::chrono::steady_clock::time_point> deadline)
    : deadline_(deadline) {
  sigemptyset(&signals_);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    if (!is_ignored(signal)) {
      sigaddset(&signals_, signal);
    }
  }
  sigaddset(&signals_, kWakeUp);
  pthread_sigmask(SIG_BLOCK, &signals_, &mask_before_);
  thread_ = std::thread([this] { wait(); });
}

Interrupts::~Interrupts() {
  over_ = true;
  pthread_kill(thread_.native_handle(), kWakeUp);
  thread_.join();
  // Once requested, the program is on its way out: a repeated signal must not cut its last words
  // short.
  if (!signalled_.stop_requested()) {
    pthread_sigmask(SIG_SETMASK, &mask_before_, nullptr);
  }
}

int Interrupts::next_signal() {
  int signal = 0;
  if (!deadline_ || stopped_.stop_requested()) {
    return sigwait(&signals_, &signal) == 0 ? signal : -1;
  }
  const timespec left = time_until(*deadline_);
  return sigtimedwait(&signals_, nullptr, &left);
}

void Interrupts::wait() {
  std::chrono::steady_clock::time_point first_signal;
  while (!over_) {
    const int signal = next_signal();
    if (over_ || signal == kWakeUp) {
      continue;
    }
    if (signal > 0) {
      const auto now = std::chrono::steady_clock::now();
      if (signalled_.request_stop()) {
        first_signal = now;
      } else if (now - first_signal >= kSameRequest) {
        _exit(kInterrupted);  // requested twice: the first request is being worked on
      }
      stopped_.request_stop();
    } else if (deadline_ && std::chrono::steady_clock::now() >= *deadline_) {
      stopped_.request_stop();
    }
  }
}

}  // namespace soms::command
