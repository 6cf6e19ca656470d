// Every broken or hostile file ends in a typed error or in the mesh that EXPECTED.csv allows, soon
// and in little memory.
#include "soms/base/error.h"
#include "soms/geometry/mesh.h"
#include "soms/io/read_mesh.h"

#include "tests/io/files.h"
#include "tests/support/allocation.h"
#include "tests/support/effort.h"
#include "tests/support/support.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <iostream>
#include <optional>
#include <string>

namespace soms::test {
namespace {

/// In the unit of `effort_of`, about two seconds of a usual machine.
constexpr double kMostEffort = 20;

constexpr std::uint64_t kMebibyte = std::uint64_t{1} << 20;

/// What became of a file, as EXPECTED.csv words it: "error" or "mesh N".
struct Outcome {
  std::string words;
  Mesh mesh;
  std::optional<Refusal> refusal;
  double effort = 0;
  std::uint64_t peak = 0;
};

Outcome read(const std::filesystem::path& path, const ReadOptions& options) {
  Outcome outcome;
  outcome.effort = effort_of([&] {
    const AllocationWatch watch;
    outcome.refusal = refusal_of([&] {
      outcome.mesh = read_mesh(path, options);
      check(outcome.mesh);
      outcome.words = "mesh " + std::to_string(outcome.mesh.triangles.size());
    });
    outcome.peak = watch.peak();
  });
  if (outcome.refusal) {
    outcome.words = "error";
  }
  return outcome;
}

bool allowed(const std::string& expectation, const std::string& words) {
  return expectation == words || expectation == "error or " + words ||
         (words == "error" && expectation.starts_with("error"));
}

/// True for formats without transformations of their own, whose triangles stand as they were made.
bool is_flat_format(const std::string& file) {
  return is_read(file) && !file.ends_with(".gltf") && !file.ends_with(".glb") &&
         !file.ends_with(".dae");
}

/// Every bad file of a few triangles was made of this tetrahedron: what is read of it is right, or
/// an error, never another mesh.
void expect_tetrahedron(const Mesh& mesh) {
  const Vec3 a{0, 0, 0};
  const Vec3 b{2, 0, 0};
  const Vec3 c{0, 3, 0};
  const Vec3 d{0.5, 0.5, 4};
  const std::array<Triangle, 4> expected = {{{a, c, b}, {a, b, d}, {b, c, d}, {c, a, d}}};
  for (TriangleId i = 0; i < std::min<std::size_t>(4, mesh.triangles.size()); ++i) {
    EXPECT_EQ(mesh.triangle(i), expected[i]) << "triangle " << i;
  }
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
      if (is_flat_format(row[0]) && outcome.mesh.triangles.size() <= 5) {
        expect_tetrahedron(outcome.mesh);
      }
      EXPECT_LT(outcome.effort, kMostEffort);
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
  EXPECT_EQ(tried, 332);
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
                   "PLY, 3DS, STL, OFF, OBJ, GLB, glTF");
  }
  EXPECT_GE(tried, 1);
}

}  // namespace
}  // namespace soms::test
