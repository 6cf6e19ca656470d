#include "soms/base/error.h"

#include <utility>

namespace soms {

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
