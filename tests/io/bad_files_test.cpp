// Every broken or hostile file ends in a typed error or in the mesh that EXPECTED.csv allows, soon
// and in little memory.
#include "soms/base/error.h"
#include "soms/geometry/mesh.h"
#include "soms/io/read_mesh.h"

#include "tests/io/files.h"
#include "tests/support/allocation.h"
#include "tests/support/support.h"

#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <iostream>
#include <optional>
#include <string>

namespace soms::test {
namespace {

constexpr std::uint64_t kMebibyte = std::uint64_t{1} << 20;

/// What became of a file, as EXPECTED.csv words it: "error" or "mesh N".
struct Outcome {
  std::string words;
  std::optional<Refusal> refusal;
  double seconds = 0;
  std::uint64_t peak = 0;
};

Outcome read(const std::filesystem::path& path, const ReadOptions& options) {
  Outcome outcome;
  const auto begin = std::chrono::steady_clock::now();
  const AllocationWatch watch;
  outcome.refusal = refusal_of([&] {
    const Mesh mesh = read_mesh(path, options);
    check(mesh);
    outcome.words = "mesh " + std::to_string(mesh.triangles.size());
  });
  outcome.peak = watch.peak();
  const std::chrono::duration<double> time = std::chrono::steady_clock::now() - begin;
  outcome.seconds = time.count();
  if (outcome.refusal) {
    outcome.words = "error";
  }
  return outcome;
}

bool allowed(const std::string& expectation, const std::string& words) {
  return expectation == words || expectation == "error or " + words ||
         (words == "error" && expectation.starts_with("error"));
}

TEST(BadFiles, EndInTypedErrorsOrTheMeshThatIsAllowed) {
  int tried = 0;
  for (const auto& row : rows_of("bad/EXPECTED.csv", 2)) {
    const std::filesystem::path path = test::data("bad/" + row[0]);
    ASSERT_TRUE(std::filesystem::exists(path) || row[0] == "does_not_exist.ply") << row[0];
    ++tried;
    for (const bool allow_empty : {false, true}) {
      SCOPED_TRACE(row[0] + (allow_empty ? ", empty allowed" : ""));
      const Outcome outcome = read(path, {.allow_empty = allow_empty});
      std::cout << row[0] << ": " << (outcome.refusal ? outcome.refusal->words : outcome.words)
                << '\n';
      EXPECT_TRUE(allowed(row[1], outcome.words)) << row[1] << " expected, not " << outcome.words;
      EXPECT_LT(outcome.seconds, 2.0);
      EXPECT_LT(outcome.peak, 256 * kMebibyte);
      if (std::filesystem::is_regular_file(path)) {
        EXPECT_LE(outcome.peak, 64 * std::filesystem::file_size(path) + 64 * kMebibyte);
      }
      if (outcome.refusal) {
        EXPECT_NE(outcome.refusal->words.find(row[0]), std::string::npos) << "names no file";
        EXPECT_NE(outcome.refusal->words.find("; "), std::string::npos) << "says not what to do";
      }
    }
  }
  EXPECT_EQ(tried, 263);
}

TEST(BadFiles, OfFormatsThatAreNotReadNameTheFormatsThatAre) {
  int tried = 0;
  for (const auto& row : rows_of("bad/EXPECTED.csv", 1)) {
    const std::filesystem::path path = test::data("bad/" + row[0]);
    if (is_read(row[0]) || row[0] == "no_extension" || !std::filesystem::is_regular_file(path) ||
        std::filesystem::file_size(path) == 0) {
      continue;
    }
    ++tried;
    SCOPED_TRACE(row[0]);
    expect_refused([&] { static_cast<void>(read_mesh(path)); }, ErrorKind::unsupported,
                   "PLY, 3DS, STL, OFF, OBJ");
  }
  EXPECT_GE(tried, 80);
}

}  // namespace
}  // namespace soms::test
