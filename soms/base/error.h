/// \file
/// The one exception type of the library, thrown at its doors: reading, building, posing, writing.
#pragma once

#include "soms/base/words.h"

#include <stdexcept>
#include <string>

namespace soms {

/// What went wrong, as a stable name that programs may branch on.
enum class ErrorKind {
  usage,          ///< an option or argument that makes no sense
  cannot_open,    ///< a file that is missing, unreadable, or a directory
  bad_file,       ///< content that breaks its format
  empty_mesh,     ///< a model without triangles where one is needed
  not_finite,     ///< NaN or infinity where a number is needed
  out_of_range,   ///< a coordinate beyond 2^300, a count beyond 2^31
  not_rigid,      ///< a pose that is not a rotation and a shift
  not_closed,     ///< a surface with a boundary where one without is needed
  unsupported,    ///< a format or feature that is known and not offered
  out_of_memory,  ///< a stated memory limit was reached
  timed_out,      ///< a stated time limit was reached
  cannot_write,   ///< an output that could not be written whole
  cancelled,      ///< the caller requested a stop
};

template <>
inline constexpr auto kWords<ErrorKind> = words("ErrorKind", "What went wrong.", "usage",
                                                "cannot_open", "bad_file", "empty_mesh",
                                                "not_finite", "out_of_range", "not_rigid",
                                                "not_closed", "unsupported", "out_of_memory",
                                                "timed_out", "cannot_write", "cancelled");

/// Exit status that the command uses for a kind: 2 usage, 3 bad input, 4 memory or time, 5 output,
/// 130 cancelled.
[[nodiscard]] int exit_code(ErrorKind kind);

/// An error with its place ("model.ply, line 17: vertex 90 of 88") and its remedy ("repair or drop
/// the face"). `what()` is "place; remedy".
class Error : public std::runtime_error {
 public:
  Error(ErrorKind kind, std::string place, std::string remedy);

  [[nodiscard]] ErrorKind kind() const { return kind_; }

  [[nodiscard]] const std::string& place() const { return place_; }

  [[nodiscard]] const std::string& remedy() const { return remedy_; }

  /// The same kind, place and remedy.
  [[nodiscard]] bool operator==(const Error& other) const {
    return kind_ == other.kind_ && place_ == other.place_ && remedy_ == other.remedy_;
  }

 private:
  ErrorKind kind_;
  std::string place_;
  std::string remedy_;
};

}  // namespace soms
