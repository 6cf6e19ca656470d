#include "soms/io/detail/three_ds.h"

#include "soms/base/error.h"
#include "soms/io/read_mesh.h"

#include "tests/io/files.h"

#include <gtest/gtest.h>

#include <string>

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

TEST(ThreeDs, ReportsMasterScaleAndKeyframesAndAppliesNeither) {
  const std::string editor = chunk(0x0100, bytes_of(2.5F)) + object("a", vertices(1) + faces(2));
  const Mesh mesh = read_text(file(editor, chunk(0xb000, chunk(0xb008, ""))), "a.3ds");
  EXPECT_EQ(mesh.notes, (std::vector<std::string>{"master scale 2.5 is not applied",
                                                  "keyframes are not applied"}));
  EXPECT_EQ(mesh.vertices[0].z, 1.0);
  EXPECT_EQ(mesh.unit, 0.0);
  EXPECT_EQ(mesh.up, UpAxis::unknown);
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
