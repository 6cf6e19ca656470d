#include "apps/support/point_source.h"

#include "soms/base/pose.h"

#include "apps/support/console.h"
#include "apps/support/standard_input.h"

namespace soms::command {

PointSource::PointSource(const std::string& path, const Console& console)
    : name_(path == "-" ? kStandardInputName : path), console_(console) {
  if (path == "-") {
    check_standard_input("points");
  }
  constexpr const char* kRemedy = "begin with the header x,y,z";
  try {
    reader_.emplace(path == "-" ? kStandardInput : path, console.limited());
  } catch (const Error& error) {
    // The reader of poses knows more headers.
    fail(error.kind() == ErrorKind::bad_file ? Error(error.kind(), error.place(), kRemedy) : error);
  }
  if (!reader_->shifts_only()) {
    throw Error(ErrorKind::bad_file, name_ + ": the header is that of poses, not of points",
                kRemedy);
  }
}

std::optional<Vec3> PointSource::next() {
  try {
    const std::optional<Pose> row = reader_->next();
    if (!row && !any_) {
      throw Error(ErrorKind::bad_file, name_ + ": no rows",
                  "give at least one point below the header");
    }
    any_ = true;
    return row ? std::optional(row->shift()) : std::nullopt;
  } catch (const Error& error) {
    fail(error);
  }
}

/// Throws what the reader threw, in the words of --points.
void PointSource::fail(const Error& error) const {
  if (error.kind() == ErrorKind::cancelled && !console_.interrupted()) {
    throw Error(ErrorKind::timed_out, "out of time while reading points from " + name_,
                "allow more time with --timeout");
  }
  if (name_ == kStandardInputName) {
    throw of_standard_input(error);
  }
  if (error.kind() == ErrorKind::cannot_open) {
    throw Error(error.kind(), error.place(), "name a CSV file of points, or - for standard input");
  }
  throw error;
}

}  // namespace soms::command
