#include "apps/cli/standard_input.h"

#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstddef>
#include <string>

namespace soms::command {

void check_standard_input(std::string_view what) {
  struct stat status {};

  struct stat nothing {};

  const bool is_null = ::fstat(0, &status) == 0 && S_ISCHR(status.st_mode) &&
                       ::stat("/dev/null", &nothing) == 0 && status.st_rdev == nothing.st_rdev;
  const std::string remedy = fmt::format("pipe {} into it, or name a file", what);
  if (::isatty(0) == 1) {
    throw Error(ErrorKind::cannot_open, fmt::format("{} is a terminal", kStandardInputName),
                remedy);
  }
  if (is_null) {
    throw Error(ErrorKind::bad_file, fmt::format("{} is empty", kStandardInputName), remedy);
  }
}

Error of_standard_input(const Error& error) {
  std::string place = error.place();
  for (std::size_t at = place.find(kStandardInput); at != std::string::npos;
       at = place.find(kStandardInput)) {
    place.replace(at, kStandardInput.size(), kStandardInputName);
  }
  return Error(error.kind(), place, error.remedy());
}

}  // namespace soms::command
