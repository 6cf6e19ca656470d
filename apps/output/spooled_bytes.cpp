#include "apps/output/spooled_bytes.h"

#include <unistd.h>

#include <cerrno>
#include <vector>

namespace soms::command {

void SpooledBytes::spool() {
  if (!file_) {
    file_.emplace("answers");
  }
  file_->add(bytes_);
  spooled_ += bytes_.size();
  bytes_.clear();
}

void SpooledBytes::read(const std::function<void(std::string_view)>& take) const {
  std::vector<char> piece(spooled_ == 0 ? 0 : kInMemory);
  for (std::uint64_t at = 0; at < spooled_;) {
    const ssize_t got =
        ::pread(file_->descriptor(), piece.data(), piece.size(), static_cast<off_t>(at));
    if (got == 0 || (got < 0 && errno != EINTR)) {
      file_->refuse("read it back", got == 0 ? EIO : errno);
    }
    if (got > 0) {
      take({piece.data(), static_cast<std::size_t>(got)});
      at += static_cast<std::uint64_t>(got);
    }
  }
  take(bytes_);
}

}  // namespace soms::command
