#include "apps/cli/temporary_folder.h"

#include "soms/base/error.h"

#include <fmt/format.h>

#include <cstdlib>
#include <string>
#include <system_error>

namespace soms::command {

TemporaryFolder::TemporaryFolder(std::string_view what) {
  std::error_code unknown;
  const std::filesystem::path base = std::filesystem::temp_directory_path(unknown);
  const std::filesystem::path parent = std::filesystem::absolute(unknown ? "/tmp" : base);
  std::string pattern = (parent / "soms-XXXXXX").string();
  if (::mkdtemp(pattern.data()) == nullptr) {
    throw Error(ErrorKind::cannot_write,
                fmt::format("{}: cannot create a temporary {}", pattern, what),
                "set TMPDIR to another folder");
  }
  path_ = pattern;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

}  // namespace soms::command
