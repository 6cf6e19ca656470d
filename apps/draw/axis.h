/// \file
/// Axes of charts: round ticks over a range, linear or by powers of ten.
#pragma once

#include "apps/draw/chart.h"

#include <string>
#include <vector>

namespace soms::reproduce {

/// A marked value of an axis.
struct Tick {
  double value = 0;
  std::string label;
};

/// What an axis must show, and how.
struct AxisRange {
  double low = 0;
  double high = 1;
  Scale scale = Scale::linear;
  bool rounded = false;  ///< reach out to ticks at both ends, and to 0 where that is near
  bool whole = false;    ///< values are whole numbers: no ticks between
  int most_ticks = 7;
};

/// A range of values and its ticks.
class Axis {
 public:
  /// \pre low <= high, both finite; above 0 on a log axis.
  explicit Axis(const AxisRange& range);

  /// Place of a value: 0 at the low end, 1 at the high end.
  [[nodiscard]] double share(double value) const;

  [[nodiscard]] double low() const { return low_; }

  [[nodiscard]] const std::vector<Tick>& ticks() const { return ticks_; }

 private:
  void mark_linear(const AxisRange& range);
  void mark_log(const AxisRange& range);

  double low_;
  double high_;
  Scale scale_;
  std::vector<Tick> ticks_;
};

/// A number as short as it reads well: "0.05", "1,500", "2.5 M".
[[nodiscard]] std::string number_label(double value);

/// A value beside its bar: whole numbers in full ("12,345"), others with three digits ("0.0432").
[[nodiscard]] std::string value_label(double value);

}  // namespace soms::reproduce
