// Nothing is left out of a file in silence: an error names the place, or a note counts and places
// it.
#include "soms/base/error.h"
#include "soms/geometry/mesh.h"
#include "soms/io/formats.h"
#include "soms/io/read_mesh.h"
#include "soms/io/write_mesh.h"

#include "tests/io/files.h"
#include "tests/support/support.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace soms::test {
namespace {

/// What must be said of a file: a row of losses/EXPECTED.csv, where semicolons stand for commas.
struct Loss {
  std::string file;
  bool is_error = false;
  std::string triangles;
  std::string what;
  std::string place;
};

std::vector<Loss> losses() {
  std::vector<Loss> all;
  for (const auto& row : rows_of("losses/EXPECTED.csv", 5)) {
    std::string what = row[3];
    std::replace(what.begin(), what.end(), ';', ',');
    all.push_back({row[0], row[1] == "error", row[2], what, row[4]});
  }
  return all;
}

bool holds(const std::string& text, const Loss& loss) {
  return text.find(loss.what) != std::string::npos && text.find(loss.place) != std::string::npos;
}

void expect_error(const std::filesystem::path& path, const ReadOptions& options, const Loss& loss) {
  const auto refusal = refusal_of([&] { static_cast<void>(read_mesh(path, options)); });
  ASSERT_TRUE(refusal) << "nothing was refused";
  EXPECT_EQ(name(refusal->kind), name(ErrorKind::bad_file));
  EXPECT_TRUE(holds(refusal->words, loss)) << refusal->words;
}

TEST(Losses, EachIsAnErrorOrANoteThatCountsAndPlacesIt) {
  for (const Loss& loss : losses()) {
    SCOPED_TRACE(loss.file);
    const std::filesystem::path path = test::data("losses/" + loss.file);
    expect_error(path, {.strict = true}, loss);
    if (loss.is_error) {
      expect_error(path, {}, loss);
      continue;
    }
    const Mesh mesh = read_mesh(path);
    EXPECT_EQ(std::to_string(mesh.triangles.size()), loss.triangles);
    EXPECT_TRUE(std::any_of(mesh.notes.begin(), mesh.notes.end(), [&](const std::string& note) {
      return holds(note, loss);
    })) << testing::PrintToString(mesh.notes);
  }
}

TEST(Losses, AreAllExpectedAndNoOtherNotesComeWithThem) {
  std::map<std::string, std::size_t> notes;
  for (const Loss& loss : losses()) {
    notes[loss.file] += loss.is_error ? 0U : 1U;
  }
  std::set<std::string> files;
  for (const auto& entry : std::filesystem::directory_iterator(test::data("losses"))) {
    const std::string file = entry.path().filename().string();
    if (is_read(file)) {
      files.insert(file);
      EXPECT_EQ(notes.count(file), 1U) << file;
      if (notes[file] > 0) {
        EXPECT_EQ(read_mesh(entry.path()).notes.size(), notes[file]) << file;
      }
    }
  }
  EXPECT_EQ(files.size(), notes.size());
}

/// Notes of good files: what they hold beside triangles.
TEST(Losses, OfGoodFilesOnlyThoseWithMoreThanTrianglesHaveNotes) {
  const std::string edges =
      "rows of elements other than vertex, face and tristrips, not read: 3,"
      " the first of element \"edge\"";
  const std::map<std::string, std::vector<std::string>> expected = {
      {"extra_ascii.ply", {edges}},
      {"extra_le.ply", {edges}},
      {"extra_be.ply", {edges}},
      {"face_colours.off",
       {"face rows with one value after their corners, assumed to be a color: 15, the first in "
        "line "
        "61"}},
      {"two_scenes.gltf",
       {"the file has 2 scenes; only scene 1, the default, was read",
        "nodes with a mesh that are not in the scene: 1, at nodes[0]"}},
      {"full.3ds", {"unknown chunks, not read: 1, at byte 2293"}},
      {"groups.obj", {"lines and points, which are not triangles: 2, the first in line 137"}},
  };
  for (const auto& row : rows_of("formats/FORMATS.csv", 1)) {
    if (is_read(row[0])) {
      const auto found = expected.find(row[0]);
      EXPECT_EQ(read_mesh(test::data("formats/" + row[0])).notes,
                found == expected.end() ? std::vector<std::string>() : found->second)
          << row[0];
    }
  }
}

TEST(Losses, AreNoneInWhatIsWritten) {
  Mesh mesh;
  mesh.vertices = {{0, 0, 0}, {3, 0, 0}, {0, 2, 0.1}, {0, 0, 1}, {9, 9, 9}};
  mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  mesh.parts = {{"a b", Part::kNoParent, 0, 3}, {"F 1 2 3", Part::kNoParent, 3, 1}};
  mesh.unit = 0.01;
  mesh.up = UpAxis::y;
  for (const WritableFormat& format : writable_formats()) {
    SCOPED_TRACE(format.name);
    std::ostringstream out;
    write_mesh(out, "out", mesh, format.format);
    EXPECT_EQ(read_text(out.str(), "out", {.strict = true}).triangles.size(), 4U);
  }
}

TEST(Losses, OfOthersAreRefusedByStrictAndNeverPassedInSilence) {
  SOMS_NEEDS_OUTSIDE_DATA("7 files of losses/");
  const std::map<std::string, std::string> refused = {
      {"trail.ply", "line 14"}, {"trail.off", "line 7"}, {"p1.ply", "line 13"}};
  const std::map<std::string, std::string> noted = {
      {"trail_bin.ply", "the first at byte 218"},
      {"t6.3ds", "the first at byte 86"},
      {"t2.3ds", "which begin a second one, not read: 86, the first at byte 86"},
      {"lost.obj", "lines that start with an unknown keyword, not read: 3, the first in line 5"}};
  int tried = 0;
  for (const auto& entry : std::filesystem::directory_iterator(*outside_data("losses"))) {
    const std::string file = entry.path().filename().string();
    if (!is_read(file)) {
      continue;
    }
    SCOPED_TRACE(file);
    ++tried;
    const bool is_error = refused.count(file) > 0;
    const std::string words = is_error ? refused.at(file) : noted.at(file);
    for (const bool strict : {false, true}) {
      if (strict || is_error) {
        expect_refused([&] { static_cast<void>(read_mesh(entry.path(), {.strict = strict})); },
                       ErrorKind::bad_file, words);
      }
    }
    if (!is_error) {
      EXPECT_NE(testing::PrintToString(read_mesh(entry.path()).notes).find(words),
                std::string::npos);
    }
  }
  EXPECT_EQ(tried, 7);
}

}  // namespace
}  // namespace soms::test
