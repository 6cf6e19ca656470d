// Poses of a command line, of CSV files, of arrays and of archives: typed errors or rigid poses,
// the same however lines end, and the same when they are written and read again. Routes through
// their places are rigid too.
#include "soms/base/error.h"
#include "soms/base/pose.h"
#include "soms/generate/routes.h"
#include "soms/io/poses.h"

#include "tests/fuzz/bytes.h"
#include "tests/fuzz/require.h"

#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace soms {
namespace {

using fuzz::require;

/// A file without a name, in memory.
class MemoryFile {
 public:
  explicit MemoryFile(std::string_view content) : descriptor_(memfd_create("poses", 0)) {
    require(descriptor_ >= 0, "a file in memory");
    while (!content.empty()) {
      const ssize_t written = write(descriptor_, content.data(), content.size());
      require(written > 0, "writing to memory");
      content.remove_prefix(static_cast<std::size_t>(written));
    }
  }

  ~MemoryFile() { close(descriptor_); }

  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;

  [[nodiscard]] std::filesystem::path path() const {
    return "/proc/self/fd/" + std::to_string(descriptor_);
  }

 private:
  int descriptor_;
};

/// What a file gives: its poses up to the first error, and that error's words.
struct Outcome {
  std::vector<Pose> poses;
  std::string words;

  bool operator==(const Outcome&) const = default;
};

Outcome read(std::string_view content) {
  Outcome outcome;
  const MemoryFile file(content);
  try {
    PoseReader reader(file.path());
    while (const auto pose = reader.next()) {
      check(*pose);
      outcome.poses.push_back(*pose);
    }
  } catch (const Error& error) {
    require(error.kind() == ErrorKind::bad_file || error.kind() == ErrorKind::not_finite ||
                error.kind() == ErrorKind::not_rigid || error.kind() == ErrorKind::unsupported,
            "the kind of a file's error");
    require(error.place().find(file.path().string()) == 0, "an error without the file");
    outcome.words = error.place().substr(file.path().string().size());
  }
  return outcome;
}

/// Lines that ended with LF end with CR LF.
std::string with_carriage_returns(std::string_view text) {
  std::string result;
  for (const char c : text) {
    result += c == '\n' ? "\r\n" : std::string(1, c);
  }
  return result;
}

void check_again(const std::vector<Pose>& poses) {
  std::string text = "r00,r01,r02,tx,r10,r11,r12,ty,r20,r21,r22,tz\n";
  for (const Pose& pose : poses) {
    for (std::size_t i = 0; i < pose.m.size(); ++i) {
      char number[32];
      std::snprintf(number, sizeof number, "%s%.17g", i == 0 ? "" : ",", pose.m[i]);
      text += number;
    }
    text += '\n';
  }
  require(read(text) == Outcome{poses, ""}, "poses that were written");
}

void check_file(std::string_view content) {
  const Outcome outcome = read(content);
  // Whose bytes are no text.
  const bool is_array = content.starts_with("\x93NUMPY") || content.starts_with("PK\x03\x04");
  if (!is_array && content.find('\r') == std::string_view::npos) {
    require(read(with_carriage_returns(content)) == outcome, "other line ends");
  }
  check_again(outcome.poses);
}

std::optional<Pose> pose_of(const std::string& text) {
  try {
    return parse_pose(text);
  } catch (const Error& error) {
    require(error.kind() == ErrorKind::usage || error.kind() == ErrorKind::not_finite ||
                error.kind() == ErrorKind::not_rigid,
            "the kind of a pose's error");
    return std::nullopt;
  }
}

void check_words(const std::string& text) {
  const std::optional<Pose> pose = pose_of(text);
  if (!pose) {
    return;
  }
  check(*pose);
  std::string commas = text;
  std::replace(commas.begin(), commas.end(), ',', ' ');
  require(pose_of(commas) == pose, "blanks for commas");
}

/// Through places as far apart as a scene's.
void check_route(std::string_view bytes) {
  fuzz::Bytes numbers({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()});
  Route route;
  route.closed = numbers.below(2) == 0;
  route.base = numbers.below(2) == 0 ? 0 : 4 * std::abs(numbers.fraction());
  route.speed = 100 * numbers.fraction();
  route.start = 1000 * numbers.fraction();
  const std::uint32_t count = numbers.below(12);
  const double unit = std::ldexp(1.0, static_cast<int>(numbers.below(40)) - 20);
  for (std::uint32_t i = 0; i < count; ++i) {
    const double x = unit * numbers.fraction();
    const double y = unit * (numbers.below(3) == 0 ? 0 : numbers.fraction());
    route.points.push_back({x, y, unit * numbers.fraction()});
  }
  for (int i = 0; i < 8; ++i) {
    const double seconds = 1e4 * numbers.fraction();
    const Pose pose = route.at(seconds);
    check(pose);
    Route measured = route;
    measured.measure();
    require(measured.at(seconds) == pose, "a route that was measured before");
    for (std::size_t axis = 0; axis < 3; ++axis) {
      require(std::abs(pose.shift()[axis]) <= 1.001 * unit, "a place beside the route");
    }
  }
}

}  // namespace
}  // namespace soms

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  soms::check_file(text);
  soms::check_words(text);
  soms::check_route(text);
  return 0;
}
