#include "tests/support/pipe.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/ioctl.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
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

bool Pipe::is_full() const {
  int held = 0;
  return ioctl(writer_, FIONREAD, &held) == 0 && held >= fcntl(writer_, F_GETPIPE_SZ);
}

void Pipe::end() {
  if (writer_ >= 0) {
    close(std::exchange(writer_, -1));
  }
}

EndlessPipe::EndlessPipe(std::filesystem::path path, const std::string& head,
                         const std::string& line)
    : pipe_(std::move(path), head + "\n"), writer_(fork()) {
  if (writer_ == 0) {
    const int fd = open(pipe_.path().c_str(), O_WRONLY);
    if (fd >= 0 && dup2(fd, STDOUT_FILENO) >= 0) {
      execlp("yes", "yes", line.c_str(), nullptr);
    }
    _exit(127);
  }
  EXPECT_GT(writer_, 0);
}

EndlessPipe::~EndlessPipe() {
  if (writer_ > 0) {
    kill(writer_, SIGKILL);
    waitpid(writer_, nullptr, 0);
  }
}

}  // namespace soms::test
