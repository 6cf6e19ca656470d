#include "tests/support/pipe.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <utility>

namespace soms::test {

Pipe::Pipe(std::filesystem::path path, const std::string& text) : path_(std::move(path)) {
  EXPECT_EQ(mkfifo(path_.c_str(), 0600), 0);
  writer_ = open(path_.c_str(), O_RDWR | O_CLOEXEC);  // to write alone would wait for a reader
  give(text);
}

void Pipe::give(const std::string& text) const {
  EXPECT_EQ(write(writer_, text.data(), text.size()), static_cast<ssize_t>(text.size()));
}

void Pipe::end() {
  if (writer_ >= 0) {
    close(std::exchange(writer_, -1));
  }
}

}  // namespace soms::test
