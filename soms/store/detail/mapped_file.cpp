#include "soms/store/detail/mapped_file.h"

#include "soms/base/error.h"
#include "soms/io/detail/file.h"
#include "soms/tree/layout/detail/pages.h"

#include <sys/mman.h>
#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <system_error>
#include <utility>

namespace soms::detail {

namespace {

/// A regular file that is open, and its size.
class OpenFile {
 public:
  explicit OpenFile(const std::filesystem::path& path) : file_(open_for_reading(path)) {
    struct stat status {};

    if (fstat(file_.get(), &status) != 0 || !S_ISREG(status.st_mode)) {
      throw Error(ErrorKind::cannot_open, path.string() + ": not a regular file",
                  "name a tree file: soms build MODEL -o MODEL.somst");
    }
    size_ = static_cast<std::size_t>(status.st_size);
  }

  [[nodiscard]] int get() const { return file_.get(); }

  [[nodiscard]] std::size_t size() const { return size_; }

 private:
  Descriptor file_;
  std::size_t size_ = 0;
};

HeldBytes read_bytes(const std::filesystem::path& path, const OpenFile& file, std::size_t size) {
  auto pages = std::make_shared<layout::Pages<std::byte>>();
  pages->resize(size);
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): bytes are bytes
  auto* const to = reinterpret_cast<char*>(pages->data());
  std::size_t done = 0;
  while (done < size) {
    const std::size_t got = read_some(path, file.get(), to + done, size - done, {});
    if (got == 0) {
      break;  // it became shorter: its head says how long it was
    }
    done += got;
  }
  const std::span<const std::byte> bytes(pages->data(), done);
  return {std::move(pages), bytes};
}

}  // namespace

HeldBytes map_file(const std::filesystem::path& path) {
  const OpenFile file(path);
  if (file.size() == 0) {
    return {};
  }
  const std::size_t size = file.size();
  void* const mapped = mmap(nullptr, size, PROT_READ, MAP_SHARED, file.get(), 0);
  if (mapped == MAP_FAILED) {  // NOLINT(*-int-to-ptr,cppcoreguidelines-pro-type-cstyle-cast)
    return read_bytes(path, file, size);
  }
  std::shared_ptr<const void> owner(mapped, [size](const void* pages) {
    munmap(const_cast<void*>(pages), size);  // NOLINT(cppcoreguidelines-pro-type-const-cast)
  });
  return {std::move(owner), {static_cast<const std::byte*>(mapped), size}};
}

HeldBytes load_file(const std::filesystem::path& path) {
  const OpenFile file(path);
  return read_bytes(path, file, file.size());
}

HeldBytes first_bytes(const std::filesystem::path& path, std::size_t most) {
  const OpenFile file(path);
  return read_bytes(path, file, std::min(most, file.size()));
}

}  // namespace soms::detail
