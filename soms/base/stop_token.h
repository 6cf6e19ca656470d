/// \file
/// How a caller requests that a call stops: the standard's stop token, or the same where the
/// standard library has none.
#pragma once

#include <version>

#ifdef __cpp_lib_jthread
#include <stop_token>
#else
#include <atomic>
#include <memory>
#include <utility>
#endif

namespace soms {

#ifdef __cpp_lib_jthread
using StopToken = std::stop_token;
using StopSource = std::stop_source;
#else
/// Tells whether a stop was requested.
class StopToken {
 public:
  StopToken() = default;

  [[nodiscard]] bool stop_requested() const noexcept { return state_ && *state_; }

  [[nodiscard]] bool stop_possible() const noexcept { return state_ != nullptr; }

  [[nodiscard]] bool operator==(const StopToken&) const = default;

 private:
  friend class StopSource;

  explicit StopToken(std::shared_ptr<const std::atomic<bool>> state) : state_(std::move(state)) {}

  std::shared_ptr<const std::atomic<bool>> state_;
};

/// Requests a stop of all calls that hold one of its tokens.
class StopSource {
 public:
  [[nodiscard]] StopToken get_token() const noexcept { return StopToken(state_); }

  [[nodiscard]] bool stop_requested() const noexcept { return *state_; }

  /// False if it was requested before.
  bool request_stop() noexcept { return !state_->exchange(true); }

  [[nodiscard]] bool operator==(const StopSource&) const = default;

 private:
  std::shared_ptr<std::atomic<bool>> state_ = std::make_shared<std::atomic<bool>>(false);
};
#endif

}  // namespace soms
