#include "soms/io/detail/file.h"

#include "soms/base/error.h"

#include "tests/io/files.h"
#include "tests/support/support.h"
#include "tests/support/wait.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <stop_token>
#include <string>
#include <thread>

namespace soms::test {
namespace {

void expect_not_read(const std::filesystem::path& path, ErrorKind kind, const std::string& words) {
  expect_refused([&] { static_cast<void>(detail::read_file(path, 0)); }, kind, words);
}

TEST(ReadFile, NamesWhatCannotBeRead) {
  const TemporaryFolder folder;
  expect_not_read(folder.path() / "missing.ply", ErrorKind::cannot_open,
                  "missing.ply: No such file");
  expect_not_read(folder.path(), ErrorKind::cannot_open, "a folder, not a file");
  expect_not_read("/dev/zero", ErrorKind::cannot_open, "a device, not a file");
  expect_not_read("", ErrorKind::cannot_open, "No such file");
  const std::filesystem::path locked = folder.path() / "locked.ply";
  write_content(locked, "ply\n");
  ASSERT_EQ(chmod(locked.c_str(), 0), 0);
  if (geteuid() != 0) {  // the superuser may read everything
    expect_not_read(locked, ErrorKind::cannot_open, "Permission denied");
  }
}

TEST(ReadFile, ReadsAFileWhole) {
  const TemporaryFolder folder;
  std::string content(3 * 65536 + 1, '\0');
  for (std::size_t i = 0; i < content.size(); ++i) {
    content[i] = static_cast<char>(i * 7 % 251);
  }
  write_content(folder.path() / "file", content);
  EXPECT_EQ(detail::read_file(folder.path() / "file", 0).view(), content);
  EXPECT_EQ(detail::read_file(folder.path() / "file", content.size()).view(), content);
  write_content(folder.path() / "empty", "");
  EXPECT_EQ(detail::read_file(folder.path() / "empty", 0).view(), "");
}

TEST(ReadFile, KeepsToItsLimit) {
  const TemporaryFolder folder;
  write_content(folder.path() / "file", std::string(1000, 'x'));
  expect_refused([&] { static_cast<void>(detail::read_file(folder.path() / "file", 999)); },
                 ErrorKind::out_of_memory, "the file exceeds the memory limit of 999 bytes");
}

TEST(RegularFile, IsOneFileByEachOfItsNamesAndNoLinkOrPipe) {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "file";
  write_content(file, "bytes");
  std::filesystem::create_hard_link(file, folder.path() / "same");
  write_content(folder.path() / "other", "bytes");
  const detail::RegularFile opened(file);
  EXPECT_EQ(opened.size(), 5U);
  EXPECT_EQ(opened.read().view(), "bytes");
  EXPECT_EQ(opened.id(), detail::RegularFile(folder.path() / "same").id());
  EXPECT_NE(opened.id(), detail::RegularFile(folder.path() / "other").id());
  std::filesystem::create_symlink("file", folder.path() / "link");
  ASSERT_EQ(mkfifo((folder.path() / "pipe").c_str(), 0600), 0);
  const auto refuse = [&](const std::string& name, const std::string& words) {
    expect_refused([&] { const detail::RegularFile refused(folder.path() / name); },
                   ErrorKind::cannot_open, words);
  };
  refuse("link", "link: ");
  refuse("pipe", "pipe: not a regular file");  // at once, though nobody writes into it
  refuse(".", "not a regular file");
  refuse("missing", "No such file");
}

/// Reads what a thread writes into a pipe.
std::string through_pipe(const std::string& content, std::uint64_t most) {
  const TemporaryFolder folder;
  const std::filesystem::path pipe = folder.path() / "pipe";
  EXPECT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  std::thread writer([&] { write_content(pipe, content); });
  const detail::FileBytes bytes = detail::read_file(pipe, most);
  writer.join();
  return std::string(bytes.view());
}

TEST(ReadFile, ReadsAPipeToItsEnd) {
  const std::string content(300000, 'x');
  EXPECT_EQ(through_pipe(content, 0), content);
  EXPECT_EQ(through_pipe(content, 300001), content);
  EXPECT_EQ(through_pipe("", 0), "");
}

TEST(ReadFile, OfAPipeThatStallsEndsByAStop) {
  const TemporaryFolder folder;
  const std::filesystem::path pipe = folder.path() / "pipe";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  const auto expect_stopped = [&](std::size_t descriptors) {
    std::stop_source stop;
    const std::jthread stopping([&] {
      wait_until([&] { return has_open(0, pipe, descriptors); });
      stop.request_stop();
    });
    expect_refused(
        [&] { static_cast<void>(detail::read_file(pipe, 0, {.stop = stop.get_token()})); },
        ErrorKind::cancelled, "stopped on request");
  };
  expect_stopped(1);  // nobody has come to write
  const detail::Descriptor writer(open(pipe.c_str(), O_RDWR | O_CLOEXEC));
  ASSERT_EQ(write(writer.get(), "ply\n", 4), 4);
  expect_stopped(2);  // somebody has, and pauses
}

}  // namespace
}  // namespace soms::test
