#include "web/bridge/failure.h"

#include "web/bridge/export.h"

#include <string>

namespace soms::web {

namespace {

struct Kept {
  std::string kind;
  std::string place;
  std::string remedy;
} kept;

}  // namespace

void keep(const Error& error) {
  kept = {std::string(name(error.kind())), error.place(), error.remedy()};
}

}  // namespace soms::web

/// Of the last error: its kind, as `name(ErrorKind)` has it, in UTF-8, ended by 0.
SOMS_EXPORT(soms_error_kind) const char* soms_error_kind() {
  return soms::web::kept.kind.c_str();
}

SOMS_EXPORT(soms_error_place) const char* soms_error_place() {
  return soms::web::kept.place.c_str();
}

SOMS_EXPORT(soms_error_remedy) const char* soms_error_remedy() {
  return soms::web::kept.remedy.c_str();
}
