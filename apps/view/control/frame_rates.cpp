#include "apps/view/control/frame_rates.h"

#include "apps/cli/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace soms::view {

namespace {

/// What of a choice changes the times that are measured.
Choice measured_by(const ViewState& state) {
  Choice now = choice(state);
  now.learn_step = 0;
  now.level = 1;
  return now;
}

/// Three digits, as of a length of time that is measured once.
std::string in_ms(double ms) {
  return fmt::format("{:.3g} ms", ms);
}

std::string per_second(double ms) {
  if (!(ms > 0)) {
    return "-";
  }
  const double fps = 1000 / ms;
  return (fps < 10 ? fmt::format("{:.1f}", fps)
                   : command::with_commas(static_cast<std::uint64_t>(std::llround(fps)))) +
         " FPS";
}

}  // namespace

void FrameRates::add(const ViewState& state, const Facts& facts, double whole_ms) {
  const Choice now = measured_by(state);
  const bool other = choice_ != now;
  const bool moved = facts.frame != frame_ || facts.object != object_;
  choice_ = now;
  frame_ = facts.frame;
  object_ = facts.object;
  if (other) {
    count_ = next_ = 0;
  }
  moving_ = moved && !other;
  if (!moving_) {
    return;
  }
  samples_[next_] = {facts.collision_ms, whole_ms};
  next_ = (next_ + 1) % kKept;
  count_ = std::min(count_ + 1, kKept);
}

Rates FrameRates::rates() const {
  Rates rates;
  rates.frames = count_;
  rates.moving = moving_;
  for (std::size_t k = 0; k < count_; ++k) {  // those kept are the first ones until all are
    rates.collision_ms += samples_[k].collision_ms / static_cast<double>(count_);
    rates.whole_ms += samples_[k].whole_ms / static_cast<double>(count_);
  }
  return rates;
}

std::vector<RateRow> rate_rows(const Rates& rates, const Facts& facts) {
  const double alone = rates.frames > 0 ? rates.collision_ms : facts.collision_ms;
  std::vector<RateRow> rows{{"Collision alone", in_ms(alone), per_second(alone)}};
  if (rates.frames > 0) {
    rows.push_back({"With drawing", in_ms(rates.whole_ms), per_second(rates.whole_ms)});
  } else {
    rows.push_back({"With drawing", "-", "-"});
  }
  return rows;
}

std::string rate_line(const Rates& rates) {
  if (rates.frames == 0) {
    return "this frame; nothing has moved yet";
  }
  return fmt::format("{}mean of the last {}", rates.moving ? "" : "at rest; ",
                     command::counted(rates.frames, "frame"));
}

}  // namespace soms::view
