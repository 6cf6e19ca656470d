#include "apps/draw/axis.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace soms::reproduce {

namespace {

/// Least of 1, 2 and 5 times a power of ten that is not below `step`.
double round_step(double step) {
  const double power = std::pow(10, std::floor(std::log10(step)));
  for (const double digit : {1.0, 2.0, 5.0}) {
    if (digit * power >= step * (1 - 1e-9)) {
      return digit * power;
    }
  }
  return 10 * power;
}

std::string with_commas(double value) {
  const std::string digits = fmt::format("{:.0f}", std::abs(value));
  std::string text = value < 0 ? "-" : "";
  for (std::size_t k = 0; k < digits.size(); ++k) {
    if (k > 0 && (digits.size() - k) % 3 == 0) {
      text += ',';
    }
    text += digits[k];
  }
  return text;
}

/// `digit` times ten to the power of `exponent`, rounded once.
double decimal(int digit, int exponent) {
  return exponent < 0 ? digit / std::pow(10, -exponent) : digit * std::pow(10, exponent);
}

}  // namespace

std::string number_label(double value) {
  const double size = std::abs(value);
  if (size >= 1e9) {
    return fmt::format("{:g} G", value / 1e9);
  }
  if (size >= 1e6) {
    return fmt::format("{:g} M", value / 1e6);
  }
  // Ticks are multiples of a decimal step: nine digits hide what adding steps up has rounded.
  const std::string text = fmt::format("{:.9g}", value);
  return size >= 1000 && text.find('.') == std::string::npos ? with_commas(value) : text;
}

std::string value_label(double value) {
  const double size = std::abs(value);
  if (size >= 1e9) {
    return fmt::format("{:.3g} G", value / 1e9);
  }
  return size >= 999.5 || value == std::floor(value) ? with_commas(value)
                                                     : fmt::format("{:.3g}", value);
}

Axis::Axis(const AxisRange& range) : low_(range.low), high_(range.high), scale_(range.scale) {
  if (scale_ == Scale::log) {
    mark_log(range);
  } else {
    mark_linear(range);
  }
}

double Axis::share(double value) const {
  return scale_ == Scale::log
             ? (std::log10(value) - std::log10(low_)) / (std::log10(high_) - std::log10(low_))
             : (value - low_) / (high_ - low_);
}

void Axis::mark_linear(const AxisRange& range) {
  if (range.rounded && low_ > 0 && low_ <= 0.6 * high_) {
    low_ = 0;
  }
  if (range.rounded && high_ < 0 && high_ >= 0.6 * low_) {
    high_ = 0;
  }
  if (!(high_ > low_)) {
    const double rim = low_ == 0 ? 0.5 : 0.5 * std::abs(low_);
    low_ -= range.whole ? 0.5 : rim;
    high_ += range.whole ? 0.5 : rim;
  }
  double step = round_step((high_ - low_) / range.most_ticks);
  step = range.whole ? std::max(1.0, step) : step;
  if (range.rounded) {
    low_ = step * std::floor(low_ / step + 1e-9);
    high_ = step * std::ceil(high_ / step - 1e-9);
  }
  const double first = std::ceil(low_ / step - 1e-9);
  const double last = std::floor(high_ / step + 1e-9);
  const auto count = static_cast<int>(last - first) + 1;
  for (int i = 0; i < count; ++i) {
    const double k = first + i;
    const double value = k == 0 ? 0 : k * step;
    ticks_.push_back({value, number_label(value)});
  }
}

void Axis::mark_log(const AxisRange& range) {
  if (!(high_ > low_)) {
    low_ /= 2;
    high_ *= 2;
  }
  const double decades = std::log10(high_ / low_);
  std::vector<int> digits{1};
  if (3 * decades <= range.most_ticks) {
    digits = {1, 2, 5};
  }
  const int stride = std::max(1, static_cast<int>(std::ceil(decades / range.most_ticks)));
  std::vector<double> marks;
  const auto begin = static_cast<int>(std::floor(std::log10(low_))) - stride;
  const auto end = static_cast<int>(std::ceil(std::log10(high_))) + stride;
  for (int exponent = begin; exponent <= end; ++exponent) {
    if (exponent % stride == 0) {
      for (const int digit : digits) {
        marks.push_back(decimal(digit, exponent));
      }
    }
  }
  const auto above = std::upper_bound(marks.begin(), marks.end(), low_ * (1 + 1e-9));
  const auto below = std::lower_bound(marks.begin(), marks.end(), high_ * (1 - 1e-9));
  // With fewer than two marks inside, the range must reach out to have a scale at all.
  const bool reach = range.rounded || below - above < 2;
  if (reach && above != marks.begin()) {
    low_ = *(above - 1);
  }
  if (reach && below != marks.end()) {
    high_ = *below;
  }
  for (const double mark : marks) {
    if (mark >= low_ * (1 - 1e-9) && mark <= high_ * (1 + 1e-9)) {
      ticks_.push_back({mark, number_label(mark)});
    }
  }
}

}  // namespace soms::reproduce
