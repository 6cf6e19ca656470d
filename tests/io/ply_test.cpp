#include "soms/io/detail/ply/ply.h"

#include "soms/base/error.h"
#include "soms/io/read_mesh.h"

#include "tests/io/files.h"
#include "tests/support/allocation.h"
#include "tests/support/support.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace soms::test {
namespace {

const std::string kHead =
    "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
    "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n";
const std::string kVertexRows = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n";

/// A header of `count` vertices of three `type`s and `faces` faces in little endian.
std::string binary_head(const std::string& count, const std::string& type, const std::string& faces,
                        const std::string& list) {
  return "ply\nformat binary_little_endian 1.0\nelement vertex " + count + "\nproperty " + type +
         " x\nproperty " + type + " y\nproperty " + type + " z\nelement face " + faces +
         "\nproperty list " + list + " vertex_indices\nend_header\n";
}

TEST(Ply, ReadsAFloatAsAFloatAndADoubleAsADouble) {
  const std::string body = "0.1 0 0\n0 1e-46 0\n0 0 1\n0 0 0\n3 0 1 2\n";
  const Mesh floats = read_text(kHead + body, "a.ply");
  EXPECT_EQ(floats.vertices[0].x, static_cast<double>(0.1F));
  EXPECT_EQ(floats.vertices[1].y, 0.0);  // less than half of the least float
  std::string head = kHead;
  for (std::size_t at = head.find("float"); at != std::string::npos; at = head.find("float")) {
    head.replace(at, 5, "double");
  }
  const Mesh doubles = read_text(head + body, "a.ply");
  EXPECT_EQ(doubles.vertices[0].x, 0.1);
  EXPECT_EQ(doubles.vertices[1].y, 1e-46);
}

TEST(Ply, KeepsTheSignOfZeroAndNumbersWithPlus) {
  const Mesh mesh = read_text(kHead + "-0.0 +1 -1e-99\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n", "a.ply");
  EXPECT_TRUE(std::signbit(mesh.vertices[0].x));
  EXPECT_EQ(mesh.vertices[0].y, 1.0);
  EXPECT_TRUE(std::signbit(mesh.vertices[0].z));
  EXPECT_EQ(mesh.vertices[0].z, 0.0);
}

TEST(Ply, MapsTrianglesToFacesWherePolygonsAre) {
  std::string head = kHead;
  head.replace(head.find("face 1"), 6, "face 4");
  const Mesh mesh = read_text(head + kVertexRows + "3 0 1 2\n4 0 1 2 3\n2 0 1\n3 0 2 3\n", "a.ply");
  EXPECT_EQ(mesh.triangles.size(), 4U);
  EXPECT_EQ(mesh.faces, (std::vector<std::uint32_t>{0, 1, 1, 3}));
  ASSERT_EQ(mesh.notes.size(), 1U);
  EXPECT_EQ(mesh.notes[0], "faces with fewer than three corners, not read: 1, at face 2");
  EXPECT_NO_THROW(check(mesh));
}

TEST(Ply, TurnsEverySecondTriangleOfAStripAndBeginsAnewAtMinusOne) {
  std::string head = kHead;
  head.replace(head.find("element face"), 12, "element tristrips");
  const Mesh mesh = read_text(head + kVertexRows + "9 0 1 2 3 -1 3 2 1 -1\n", "a.ply");
  const std::vector<std::array<std::uint32_t, 3>> expected = {{0, 1, 2}, {2, 1, 3}, {3, 2, 1}};
  EXPECT_EQ(mesh.triangles, expected);
}

TEST(Ply, NotesStripsOfFewerThanThreeCorners) {
  std::string head = kHead;
  head.replace(head.find("element face 1"), 14, "element tristrips 4");
  const Mesh mesh =
      read_text(head + kVertexRows + "6 0 1 2 3 -1 -1\n2 0 1\n8 0 1 -1 1 2 3 -1 3\n0\n", "a.ply");
  EXPECT_EQ(mesh.triangles.size(), 3U);
  EXPECT_EQ(mesh.notes,
            (std::vector<std::string>{"strips with fewer than three corners, not read: "
                                      "3, the first in row 1 of element \"tristrips\""}));
}

TEST(Ply, ReadsFacesInTheOrderOfTheFileWhereSomeStandBeforeTheVertices) {
  const std::string text =
      "ply\nformat ascii 1.0\nelement face 1\nproperty list uchar int vertex_index\n"
      "element vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
      "element tristrips 1\nproperty list int int vertex_indices\nend_header\n"
      "4 0 1 2 3\n" +
      kVertexRows + "3 1 2 3\n";
  const Mesh mesh = read_text(text, "a.ply");
  const std::vector<std::array<std::uint32_t, 3>> expected = {{0, 1, 2}, {0, 2, 3}, {1, 2, 3}};
  EXPECT_EQ(mesh.triangles, expected);
}

TEST(Ply, ReadsCornersOfEveryType) {
  const std::string vertices = bytes_of(0.0F) + bytes_of(0.0F) + bytes_of(0.0F) + bytes_of(1.0F) +
                               bytes_of(0.0F) + bytes_of(0.0F) + bytes_of(0.0F) + bytes_of(1.0F) +
                               bytes_of(0.0F);
  const auto integers = [](std::size_t size) {
    return bytes_of(0, size) + bytes_of(1, size) + bytes_of(2, size);
  };
  for (const std::string count : {"char", "uchar", "short", "ushort", "int", "uint"}) {
    const std::size_t count_size = count.ends_with("char") ? 1 : count.ends_with("short") ? 2 : 4;
    for (const std::string item :
         {"char", "uchar", "short", "ushort", "int", "uint", "float", "double"}) {
      SCOPED_TRACE(count + " " + item);
      const std::size_t size = item.ends_with("char") ? 1 : item.ends_with("short") ? 2 : 4;
      const std::string corners = item == "float" ? bytes_of(0.0F) + bytes_of(1.0F) + bytes_of(2.0F)
                                  : item == "double" ? bytes_of(0.0) + bytes_of(1.0) + bytes_of(2.0)
                                                     : integers(size);
      const std::string text = binary_head("3", "float", "1", count + " " + item) + vertices +
                               bytes_of(3, count_size) + corners;
      const Mesh mesh = read_text(text, "a.ply");
      const std::vector<std::array<std::uint32_t, 3>> expected = {{0, 1, 2}};
      EXPECT_EQ(mesh.triangles, expected);
    }
  }
}

TEST(Ply, RefusesCornersThatAreNoWholeNumbers) {
  const std::string head = binary_head("1", "float", "1", "uchar float");
  const std::string vertex = bytes_of(0.0F) + bytes_of(0.0F) + bytes_of(0.0F);
  for (const float corner : {0.5F, -1.0F, 1.0F, 1e30F, std::nanf("")}) {
    expect_refused(
        head + vertex + bytes_of(3, 1) + bytes_of(0.0F) + bytes_of(0.0F) + bytes_of(corner),
        "a.ply", ErrorKind::bad_file,
        std::trunc(corner) == corner ? "the only one is 0" : "is not a whole number");
  }
}

TEST(Ply, ReadsCoordinatesOfWholeTypes) {
  const std::string text = binary_head("3", "short", "1", "uchar uchar") + bytes_of(0, 2) +
                           bytes_of(0, 2) + bytes_of(0, 2) + bytes_of(0xfffe, 2) + bytes_of(7, 2) +
                           bytes_of(0, 2) + bytes_of(1, 2) + bytes_of(0x7fff, 2) + bytes_of(0, 2) +
                           bytes_of(0x02010003, 4);
  const Mesh mesh = read_text(text, "a.ply");
  EXPECT_EQ(mesh.vertices[1], (Vec3{-2, 7, 0}));
  EXPECT_EQ(mesh.vertices[2], (Vec3{1, 32767, 0}));
}

TEST(Ply, RefusesTextNumbersBeyondTheirType) {
  std::string head = kHead;
  head.replace(head.find("float x"), 7, "uchar x");
  expect_refused(head + "256 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n", "a.ply", ErrorKind::bad_file,
                 "line 10: \"x\" is 256, out of range for its type");
  expect_refused(head + "1.5 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n", "a.ply", ErrorKind::bad_file,
                 "not a whole number");
}

TEST(Ply, KeepsABodyThatBeginsWithALineEndByte) {
  // A float whose least byte is LF, behind headers of each line end.
  const std::string vertex =
      bytes_of(std::uint64_t{0x3f80000a}, 4) + bytes_of(0.0F) + bytes_of(0.0F);
  const std::string body = vertex + bytes_of(0x00000003, 4);
  for (const std::string end : {"\n", "\r\n", "\r"}) {
    std::string text;
    for (const char c : binary_head("1", "float", "1", "uchar uchar")) {
      text += c == '\n' ? end : std::string(1, c);
    }
    const Mesh mesh = read_text(text + body, "a.ply");
    EXPECT_EQ(mesh.vertices[0].x, static_cast<double>(std::bit_cast<float>(0x3f80000aU)));
    EXPECT_EQ(mesh.triangles.size(), 1U);
  }
}

TEST(Ply, RefusesHugeCountsBeforeAllocating) {
  const std::string vertex = bytes_of(0.0) + bytes_of(0.0) + bytes_of(0.0);
  for (const std::string count :
       {"2147483648", "4294967296", "768614336404564651", "18446744073709551615"}) {
    SCOPED_TRACE(count);
    const AllocationWatch watch;
    expect_refused(binary_head(count, "double", "1", "uchar int") + vertex, "a.ply",
                   ErrorKind::bad_file, "do not fit");
    expect_refused(binary_head("1", "double", count, "uchar int") + vertex, "a.ply",
                   ErrorKind::bad_file, "do not fit");
    std::string text = kHead;
    text.replace(text.find("vertex 4"), 8, "vertex " + count);
    expect_refused(text + kVertexRows, "a.ply", ErrorKind::bad_file, "do not fit");
    EXPECT_LT(watch.peak(), std::uint64_t{1} << 20);
  }
}

/// What follows the only row of an element in its line is a row of the next one.
TEST(Ply, RefusesWhatFollowsARowUnlessItIsAnotherRow) {
  std::string two = kHead;
  two.replace(two.find("face 1"), 6, "face 2");
  expect_refused(two + kVertexRows + "3 0 1 2 3\n3 0 1 3\n", "a.ply", ErrorKind::bad_file,
                 "line 14: \"3\" follows the last value of the row");
  EXPECT_EQ(read_text(two + kVertexRows + "3 0 1 2 3 0 1 3\n", "a.ply").triangles.size(), 2U);
  expect_refused(kHead + kVertexRows + "3 0 1 2 3\n", "a.ply", ErrorKind::bad_file,
                 "line 14: \"3\" follows the last row that the header declares");
  std::string strips = kHead;
  strips.insert(strips.find("end_header"),
                "element tristrips 1\nproperty list uchar int vertex_indices\n");
  EXPECT_EQ(read_text(strips + kVertexRows + "3 0 1 2 3\n0 1 3\n", "a.ply").triangles.size(), 2U);
}

TEST(Ply, NamesTheLineOrTheByte) {
  expect_refused(kHead + "0 0 0\n1 zero 0\n1 1 0\n0 1 0\n3 0 1 2\n", "a.ply", ErrorKind::bad_file,
                 "a.ply, line 11: y is \"zero\", not a number");
  const std::string head = binary_head("1", "float", "1", "uchar uchar");
  const std::string body =
      bytes_of(0.0F) + bytes_of(0.0F) + bytes_of(0.0F) + bytes_of(0x00000903, 4);
  expect_refused(
      head + body, "a.ply", ErrorKind::bad_file,
      "a.ply, byte " + std::to_string(head.size() + 13) + ": vertex 9, but the only one is 0");
  // The byte order mark counts.
  expect_refused("\xef\xbb\xbf" + head + body, "a.ply", ErrorKind::bad_file,
                 "byte " + std::to_string(head.size() + 16) + ": vertex 9, but the only one is 0");
}

TEST(Ply, RefusesCoordinatesThatAreNoNumbersOrTooLarge) {
  const std::string rest = " 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n";
  expect_refused(kHead + "nan" + rest, "a.ply", ErrorKind::not_finite, "line 10: vertex 0: x");
  expect_refused(kHead + "-inf" + rest, "a.ply", ErrorKind::not_finite, "line 10");
  expect_refused(kHead + "1e39" + rest, "a.ply", ErrorKind::not_finite, "too large for a float");
  std::string head = kHead;
  head.replace(head.find("float x"), 7, "double x");
  expect_refused(head + "1e91" + rest, "a.ply", ErrorKind::out_of_range, "exceeds 2^300");
  EXPECT_NO_THROW(static_cast<void>(read_text(head + "2e90" + rest, "a.ply")));
}

}  // namespace
}  // namespace soms::test
