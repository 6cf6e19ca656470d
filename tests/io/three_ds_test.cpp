#include "soms/io/detail/simple/three_ds.h"

#include "soms/base/error.h"
#include "soms/io/read_mesh.h"

#include "tests/io/files.h"
#include "tests/support/support.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace soms::test {
namespace {

std::string chunk(std::uint64_t name, const std::string& body) {
  return bytes_of(name, 2) + bytes_of(body.size() + 6, 4) + body;
}

std::string vertices(float z) {
  std::string list = bytes_of(3, 2);
  for (const float v : {0.0F, 0.0F, z, 1.0F, 0.0F, z, 0.0F, 1.0F, z}) {
    list += bytes_of(v);
  }
  return chunk(0x4110, list);
}

std::string faces(std::uint64_t last) {
  return chunk(0x4120, bytes_of(1, 2) + bytes_of(0, 2) + bytes_of(1, 2) + bytes_of(last, 2) +
                           bytes_of(7, 2));
}

std::string object(const std::string& name, const std::string& inside) {
  return chunk(0x4000, name + '\0' + chunk(0x4100, inside));
}

std::string file(const std::string& editor, const std::string& more = {}) {
  return chunk(0x4d4d, chunk(0x3d3d, editor) + more);
}

TEST(ThreeDs, KeepsObjectsAsPartsInTheOrderOfTheFile) {
  const Mesh mesh =
      read_text(file(object("body", vertices(0) + faces(2)) + object("empty", vertices(5)) +
                     object("wheel", faces(2) + vertices(1))),
                "car.3ds");
  EXPECT_EQ(mesh.vertices.size(), 9U);
  const std::vector<std::array<std::uint32_t, 3>> expected = {{0, 1, 2}, {6, 7, 8}};
  EXPECT_EQ(mesh.triangles, expected);
  const std::vector<Part> parts = {{"body", Part::kNoParent, 0, 1},
                                   {"wheel", Part::kNoParent, 1, 1}};
  EXPECT_EQ(mesh.parts, parts);
  EXPECT_EQ(mesh.triangle(1).a, (Vec3{0, 0, 1}));
  EXPECT_EQ(mesh.source, "car.3ds");
  EXPECT_TRUE(mesh.notes.empty());
}

TEST(ThreeDs, ReportsMasterScalesAndKeyframesAndAppliesNeither) {
  const std::string editor = chunk(0x0100, bytes_of(2.5F)) + object("a", vertices(1) + faces(2)) +
                             chunk(0x0100, bytes_of(1.0F)) + chunk(0x0100, bytes_of(3.0F));
  const Mesh mesh = read_text(file(editor, chunk(0xb000, chunk(0xb008, ""))), "a.3ds");
  EXPECT_EQ(mesh.notes,
            (std::vector<std::string>{
                "master scales other than 1, not applied: 2, the first at byte 12: 2.5",
                "keyframes, not applied: 1, at byte " + std::to_string(12 + editor.size())}));
  EXPECT_EQ(mesh.vertices[0].z, 1.0);
  EXPECT_EQ(mesh.unit, 0.0);
  EXPECT_EQ(mesh.up, UpAxis::unknown);
}

/// A mesh chunk whose name is damaged holds triangles that nothing else would tell of.
TEST(ThreeDs, NotesChunksOfUnknownNamesAtEachDepth) {
  const std::string good = object("a", vertices(0) + faces(2));
  const std::string lost = chunk(0x4101, vertices(0) + faces(2));
  const std::string lost_object = chunk(0x4000, std::string("b") + '\0' + lost);
  const std::string lost_faces =
      chunk(0x4000, std::string("b") + '\0' + chunk(0x4100, vertices(0) + chunk(0x4121, "faces")));
  const auto at = [&](std::size_t inside) {
    return ", at byte " + std::to_string(12 + good.size() + inside);
  };
  for (const auto& [text, place] : std::vector<std::pair<std::string, std::string>>{
           {file(good + lost), at(0)},
           {file(good + lost_object), at(8)},
           {file(good + lost_faces), at(14 + vertices(0).size())},
           {file(good, chunk(0x3d3f, lost_object)), at(0)}}) {
    const Mesh mesh = read_text(text, "a.3ds");
    EXPECT_EQ(mesh.triangles.size(), 1U);
    EXPECT_EQ(mesh.notes, (std::vector<std::string>{"unknown chunks, not read: 1" + place}));
    expect_refused(
        [&text = text] { static_cast<void>(read_text(text, "a.3ds", {.strict = true})); },
        ErrorKind::bad_file, "unknown chunks, not read: 1" + place);
  }
}

TEST(ThreeDs, PassesOverWhatAddsNoShape) {
  std::string editor = chunk(0x3d3e, bytes_of(3, 4)) + chunk(0xafff, "") + chunk(0x2100, "") +
                       chunk(0x1400, "") + chunk(0x7001, "");
  editor += chunk(0x4000,
                  std::string("a") + '\0' + chunk(0x4010, "") +
                      chunk(0x4100, vertices(0) + faces(2) + chunk(0x4111, "") + chunk(0x4140, "") +
                                        chunk(0x4160, "") + chunk(0x4165, "")));
  editor += chunk(0x4000, std::string("lamp") + '\0' + chunk(0x4600, ""));
  editor += chunk(0x4000, std::string("camera") + '\0' + chunk(0x4700, ""));
  const Mesh mesh = read_text(file(editor, chunk(0x0002, bytes_of(3, 4))), "a.3ds");
  EXPECT_EQ(mesh.notes, std::vector<std::string>());
}

/// Two mesh chunks with lists of their own are two parts; two lists in one are an error.
TEST(ThreeDs, ReadsEachMeshOfAnObjectAndOneListInEach) {
  const std::string twice =
      chunk(0x4000, std::string("a") + '\0' + chunk(0x4100, vertices(0) + faces(2)) +
                        chunk(0x4100, vertices(1) + faces(2)));
  const Mesh mesh = read_text(file(twice), "a.3ds");
  EXPECT_EQ(mesh.triangles.size(), 2U);
  const std::vector<Part> parts = {{"a", Part::kNoParent, 0, 1}, {"a", Part::kNoParent, 1, 1}};
  EXPECT_EQ(mesh.parts, parts);
  expect_refused(file(object("a", vertices(0) + faces(2) + faces(1))), "a.3ds", ErrorKind::bad_file,
                 "a second list of vertices or faces");
}

TEST(ThreeDs, OfOthersHasNoUnknownChunks) {
  SOMS_NEEDS_OUTSIDE_DATA("files of 3ds/");
  for (const auto& entry : std::filesystem::directory_iterator(*outside_data("3ds"))) {
    const std::string file = entry.path().filename().string();
    if (!is_read(file)) {
      continue;
    }
    EXPECT_EQ(testing::PrintToString(read_mesh(entry.path(), {.allow_empty = true}).notes)
                  .find("unknown chunks"),
              std::string::npos)
        << file;
  }
}

TEST(ThreeDs, RefusesAnIndexBeyondItsOwnObject) {
  expect_refused(file(object("a", vertices(0) + faces(2)) + object("b", vertices(0) + faces(3))),
                 "a.3ds", ErrorKind::bad_file, "vertex 3, but vertices are 0 to 2");
}

TEST(ThreeDs, RefusesAMainChunkThatIsLongerThanTheFile) {
  std::string text = file(object("a", vertices(0) + faces(2)));
  text.pop_back();
  expect_refused(text, "a.3ds", ErrorKind::bad_file, "byte 0");
}

TEST(ThreeDs, IsReportedByItsContent) {
  const std::string text = file(object("a", vertices(0) + faces(2)));
  EXPECT_EQ(read_text(text, "model").triangles.size(), 1U);
  expect_refused(text, "model.stl", ErrorKind::bad_file,
                 "the content is 3DS, but the extension says STL");
}

}  // namespace
}  // namespace soms::test
