#include "soms/base/error.h"

#include <utility>

namespace soms {

std::string_view name(ErrorKind kind) {
  switch (kind) {
    case ErrorKind::usage:
      return "usage";
    case ErrorKind::cannot_open:
      return "cannot_open";
    case ErrorKind::bad_file:
      return "bad_file";
    case ErrorKind::empty_mesh:
      return "empty_mesh";
    case ErrorKind::not_finite:
      return "not_finite";
    case ErrorKind::out_of_range:
      return "out_of_range";
    case ErrorKind::not_rigid:
      return "not_rigid";
    case ErrorKind::not_closed:
      return "not_closed";
    case ErrorKind::unsupported:
      return "unsupported";
    case ErrorKind::out_of_memory:
      return "out_of_memory";
    case ErrorKind::timed_out:
      return "timed_out";
    case ErrorKind::cannot_write:
      return "cannot_write";
    case ErrorKind::cancelled:
      return "cancelled";
  }
  return "unknown";
}

int exit_code(ErrorKind kind) {
  switch (kind) {
    case ErrorKind::usage:
      return 2;
    case ErrorKind::out_of_memory:
    case ErrorKind::timed_out:
      return 4;
    case ErrorKind::cannot_write:
      return 5;
    case ErrorKind::cancelled:
      return 130;
    default:
      return 3;
  }
}

Error::Error(ErrorKind kind, std::string place, std::string remedy)
    : std::runtime_error(remedy.empty() ? place : place + "; " + remedy),
      kind_(kind),
      place_(std::move(place)),
      remedy_(std::move(remedy)) {
}

}  // namespace soms
