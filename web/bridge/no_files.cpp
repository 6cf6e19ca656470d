// In the place of soms/io/detail/file.cpp: a browser has no files to open.
#include "soms/base/error.h"
#include "soms/io/detail/file.h"

#include <utility>

namespace soms::detail {

namespace {

[[noreturn]] void fail_no_files(const std::filesystem::path& path) {
  throw Error(ErrorKind::unsupported, path.string() + ": this build opens no files",
              "hand in the bytes of one file that holds all, such as GLB");
}

}  // namespace

Descriptor::~Descriptor() = default;

FileBytes read_file(const std::filesystem::path& path, std::uint64_t /*most*/,
                    const Limits& /*limits*/) {
  fail_no_files(path);
}

int open_for_reading(const std::filesystem::path& path) {
  fail_no_files(path);
}

std::size_t read_some(const std::filesystem::path& path, int /*fd*/, char* /*to*/,
                      std::size_t /*wanted*/, const Limits& /*limits*/) {
  fail_no_files(path);
}

bool is_readable(int /*fd*/) {
  return false;
}

RegularFile::RegularFile(std::filesystem::path path) : path_(std::move(path)), file_(-1) {
  fail_no_files(path_);
}

FileBytes RegularFile::read() const {
  fail_no_files(path_);
}

}  // namespace soms::detail
