#include "apps/cli/progress.h"

#include "apps/output/output.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <utility>

namespace soms::command {

namespace {

constexpr auto kFirst = std::chrono::seconds(1);
constexpr auto kPause = std::chrono::milliseconds(100);
constexpr int kWidth = 30;

void write_text(const std::string& text) {
  (void)!::write(2, text.data(), text.size());
}

}  // namespace

Progress::Progress(std::string doing, bool visible)
    : doing_(printable(doing)),
      visible_(visible),
      next_(std::chrono::steady_clock::now() + kFirst) {
}

Progress::~Progress() {
  if (drawn_) {
    write_text("\r\x1b[K");
  }
}

bool Progress::is_due() {
  if (!visible_) {
    return false;
  }
  const auto now = std::chrono::steady_clock::now();
  if (now < next_) {
    return false;
  }
  next_ = now + kPause;
  return true;
}

void Progress::draw(const std::string& rest) {
  write_text(fmt::format("\r{} {}\x1b[K", doing_, rest));
  drawn_ = true;
}

void Progress::show(double share) {
  if (is_due()) {
    const double part = std::clamp(share, 0.0, 1.0);
    const auto filled = static_cast<std::size_t>(part * kWidth);
    draw(fmt::format("[{}{}] {:3.0f} %", std::string(filled, '#'),
                     std::string(kWidth - filled, '.'), 100 * part));
  }
}

void Progress::show(const std::string& words) {
  if (is_due()) {
    draw(words);
  }
}

}  // namespace soms::command
