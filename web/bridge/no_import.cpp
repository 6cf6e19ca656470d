// In the place of soms/io/detail/import/import_child.cpp: a browser starts no programs.
#include "soms/io/detail/import/import_child.h"

namespace soms::detail {

std::string run_import(Source& source, std::string_view extension) {
  source.fail(ErrorKind::unsupported,
              "files of " + std::string(extension) + " are read by soms-import, a program",
              "convert it first: soms convert IN OUT.glb");
}

std::string printable(std::string_view text) {
  return std::string(text);
}

}  // namespace soms::detail
