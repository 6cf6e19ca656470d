// Every broken URDF or SRDF file ends in the typed error that EXPECTED.tsv names, with its file.
#include "soms/base/error.h"
#include "soms/io/robot.h"

#include "tests/io/files.h"
#include "tests/support/allocation.h"
#include "tests/support/support.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <optional>
#include <set>
#include <span>
#include <sstream>
#include <string>
#include <string_view>

namespace soms::test {
namespace {

void read_bad_robot(const std::filesystem::path& file) {
  if (file.extension() == ".urdf") {
    static_cast<void>(read_robot(file));
    return;
  }
  Robot robot = read_robot(data("robots/arm.urdf"));
  read_semantics(robot, file);
}

TEST(BadRobots, EndInTypedErrorsThatNameTheFile) {
  std::ifstream list(data("robots/bad/EXPECTED.tsv"));
  std::string line;
  std::getline(list, line);
  std::set<std::string> seen{"EXPECTED.tsv"};
  while (std::getline(list, line)) {
    SCOPED_TRACE(line);
    std::istringstream cells(line);
    std::string file;
    std::string kind;
    std::string words;
    std::getline(cells, file, '\t');
    std::getline(cells, kind, '\t');
    std::getline(cells, words, '\t');
    seen.insert(file);
    const std::filesystem::path path = test::data("robots/bad/" + file);
    std::optional<Refusal> refusal;
    {
      const AllocationWatch watch;
      refusal = refusal_of([&] { read_bad_robot(path); });
      EXPECT_LT(watch.peak(), std::uint64_t{64} << 20);
    }
    ASSERT_TRUE(refusal) << "it was read";
    EXPECT_NE(refusal->words.find(words), std::string::npos) << refusal->words;
    EXPECT_NE(refusal->words.find(path.string()), std::string::npos) << refusal->words;
    if (kind != "*") {
      EXPECT_EQ(name(refusal->kind), kind) << refusal->words;
    }
  }
  EXPECT_GE(seen.size(), 87U);
  for (const auto& entry : std::filesystem::directory_iterator(data("robots/bad"))) {
    EXPECT_TRUE(seen.contains(entry.path().filename().string())) << entry.path();
  }
}

TEST(BadRobots, CutAnywhereAreTypedErrors) {
  const std::string urdf = content_of(data("robots/arm.urdf"));
  int read = 0;
  for (std::size_t size = 0; size < urdf.size() - 10; size += 7) {
    const std::string_view part = std::string_view(urdf).substr(0, size);
    const auto refusal = refusal_of(
        [&] { static_cast<void>(read_robot(std::as_bytes(std::span(part)), "cut.urdf")); });
    read += refusal ? 0 : 1;
  }
  EXPECT_EQ(read, 0);
}

}  // namespace
}  // namespace soms::test
