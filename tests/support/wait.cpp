#include "tests/support/wait.h"

#include <sys/stat.h>

#include <chrono>
#include <fstream>
#include <string>
#include <system_error>
#include <thread>

namespace soms::test {

namespace fs = std::filesystem;

void wait_until(const std::function<bool()>& happened) {
  while (!happened()) {
    std::this_thread::sleep_for(std::chrono::milliseconds(3));
  }
}

bool has_open(int process, const fs::path& path, std::size_t descriptors) {
  struct stat wanted {};

  if (::stat(path.c_str(), &wanted) != 0) {
    return false;
  }
  const std::string owner = process == 0 ? "self" : std::to_string(process);
  std::error_code gone;
  std::size_t found = 0;
  for (const fs::directory_entry& entry : fs::directory_iterator("/proc/" + owner + "/fd", gone)) {
    struct stat open {};

    found += ::stat(entry.path().c_str(), &open) == 0 && open.st_dev == wanted.st_dev &&
                     open.st_ino == wanted.st_ino
                 ? 1U
                 : 0U;
  }
  return found >= descriptors;
}

void wait_for_a_later_date(const fs::path& folder) {
  const fs::path probe = folder / "date.probe";
  const auto date = [&] {
    std::ofstream(probe) << "x";
    return fs::last_write_time(probe);
  };
  const auto before = date();
  wait_until([&] { return date() > before; });
  fs::remove(probe);
}

void wait_at_least(double seconds) {
  std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
}

}  // namespace soms::test
