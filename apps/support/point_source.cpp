#include "apps/support/point_source.h"

#include "soms/base/pose.h"

#include "apps/support/console.h"
#include "apps/support/standard_input.h"

#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <string_view>

namespace soms::command {

PointSource::PointSource(const std::string& path, const Console& console)
    : name_(path == "-" ? kStandardInputName : path), console_(&console) {
  if (path == "-") {
    check_standard_input("points");
  }
  try {
    reader_.emplace(path == "-" ? std::string(kStandardInput) : path, console_->limited());
    if (!reader_->shifts_only()) {
      throw Error(ErrorKind::bad_file, name_ + ": the header is that of poses, not of points",
                  "begin with the header x,y,z");
    }
  } catch (const Error& error) {
    fail(error);
  }
}

std::optional<Vec3> PointSource::read() {
  try {
    const std::optional<Pose> row = reader_->next();
    if (!row && rows_ == 0) {
      throw Error(ErrorKind::bad_file, name_ + ": no rows",
                  "give at least one point below the header");
    }
    if (!row) {
      return std::nullopt;
    }
    const Vec3 point{row->m[3], row->m[7], row->m[11]};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (std::abs(point[axis]) > kMaxCoordinate) {
        throw Error(ErrorKind::out_of_range,
                    fmt::format("{}: point {}: {} exceeds 2^300", name_, rows_, "xyz"[axis]),
                    "scale the model and the points");
      }
    }
    ++rows_;
    return point;
  } catch (const Error& error) {
    fail(error);
  }
}

/// Throws what the reader threw, in the words of points.
void PointSource::fail(const Error& error) const {
  if (error.kind() == ErrorKind::cancelled && !console_->interrupted()) {
    throw Error(ErrorKind::timed_out, "out of time while reading points from " + name_,
                "allow more time with --timeout");
  }
  // The reader of poses knows more headers.
  const bool of_header = error.kind() == ErrorKind::bad_file && rows_ == 0 &&
                         error.remedy().find("r00") != std::string::npos;
  const std::string place = error.place().substr(0, error.place().find(" and no poses"));
  const Error shown = of_header ? Error(error.kind(), place, "begin with the header x,y,z") : error;
  if (name_ == kStandardInputName) {
    throw of_standard_input(shown);
  }
  if (error.kind() == ErrorKind::cannot_open) {
    throw Error(error.kind(), error.place(), "name a CSV file of points, or - for standard input");
  }
  throw shown;
}

std::optional<Vec3> PointSource::next() {
  if (!ahead_.empty()) {
    const Vec3 point = ahead_.front();
    ahead_.pop_front();
    return point;
  }
  if (error_) {
    std::rethrow_exception(error_);
  }
  return single_.value_or(false) ? std::nullopt : read();
}

bool PointSource::ready() {
  return !ahead_.empty() || error_ || single_.value_or(false) || reader_->ready();
}

bool PointSource::is_single() {
  if (!single_) {
    try {
      while (ahead_.size() < 2) {
        const std::optional<Vec3> point = read();
        if (!point) {
          break;
        }
        ahead_.push_back(*point);
      }
      single_ = ahead_.size() < 2;
    } catch (const Error& error) {
      if (error.kind() == ErrorKind::cancelled) {
        throw;
      }
      error_ = std::current_exception();
      single_ = false;
    }
  }
  return *single_;
}

}  // namespace soms::command
