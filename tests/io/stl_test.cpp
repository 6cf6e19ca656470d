#include "soms/io/detail/simple/stl.h"

#include "soms/base/error.h"
#include "soms/io/read_mesh.h"

#include "tests/io/files.h"
#include "tests/support/support.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

namespace soms::test {
namespace {

const std::string kFacet =
    "facet normal 0 0 1\nouter loop\nvertex 0 0 0.1\nvertex 1 0 0\nvertex 0 1 0\nendloop\n"
    "endfacet\n";

std::string binary(const std::string& header, std::uint64_t count, std::uint64_t held) {
  std::string text = header + std::string(80 - header.size(), ' ') + bytes_of(count, 4);
  for (std::uint64_t i = 0; i < held; ++i) {
    for (const float v : {0.0F, 0.0F, 1.0F, 0.0F, 0.0F, 0.0F, 1.0F, 0.0F, 0.0F, 0.0F, 1.0F, 0.0F}) {
      text += bytes_of(v);
    }
    text += bytes_of(0xffff, 2);
  }
  return text;
}

TEST(Stl, RefusesBytesBetweenFacetsThatAttributesCount) {
  const std::string words =
      "byte 132: each triangle is followed by as many bytes as its attribute says, but attributes "
      "of STL are no lengths";
  expect_refused([] { static_cast<void>(read_mesh(data("reports/stl_bin_attrbytes.stl"))); },
                 ErrorKind::bad_file, words);
  const std::string facet = binary("x", 1, 1).substr(84, 48);
  for (const std::size_t count : {1U, 2U, 40U}) {
    std::string text = binary("x", count, 0);
    for (std::size_t i = 0; i < count; ++i) {
      text += facet + bytes_of(i + 1, 2) + std::string(i + 1, 'a');
    }
    expect_refused(text, "a.stl", ErrorKind::bad_file, words);
  }
  // Attributes alone say nothing, nor do bytes at the end.
  EXPECT_TRUE(read_text(binary("x", 3, 3), "a.stl").notes.empty());
  EXPECT_EQ(read_text(binary("x", 3, 3) + std::string(40, 'a'), "a.stl").notes.size(), 1U);
}

TEST(Stl, KeepsSolidsAsPartsAndNumbersAsDoubles) {
  const Mesh mesh = read_text(
      "solid left facet\n" + kFacet + kFacet + "endsolid left\n\nsolid\n" + kFacet + "endsolid",
      "a.stl");
  const std::vector<Part> parts = {{"left facet", Part::kNoParent, 0, 2},
                                   {"", Part::kNoParent, 2, 1}};
  EXPECT_EQ(mesh.parts, parts);
  EXPECT_EQ(mesh.vertices[0].z, 0.1);
  EXPECT_EQ(mesh.vertices.size(), 9U);  // nothing is joined
}

TEST(Stl, PassesNormalsThatAreNoNumbers) {
  std::string text = "solid\n" + kFacet + "endsolid\n";
  text.replace(text.find("0 0 1"), 5, "-nan(ind) nan 1.#QNAN");
  EXPECT_EQ(read_text(text, "a.stl").triangles.size(), 1U);
}

TEST(Stl, RefusesATextThatEndsWithoutEndsolid) {
  // Cut between two facets, nothing else would show that the rest is missing.
  expect_refused("solid a\n" + kFacet, "a.stl", ErrorKind::bad_file,
                 "line 9: expected facet or endsolid, but the file ends");
}

TEST(Stl, ReadsABinaryFileThatBeginsWithSolid) {
  EXPECT_EQ(read_text(binary("solid facet normal outer loop", 2, 2), "a.stl").triangles.size(), 2U);
  EXPECT_EQ(read_text(binary("solid", 1, 1), "model").triangles.size(), 1U);
}

TEST(Stl, RefusesACountThatLies) {
  for (const std::string header : {"x", "solid x"}) {
    for (const std::uint64_t count :
         {std::uint64_t{1}, std::uint64_t{3}, std::uint64_t{1} << 31, std::uint64_t{0xffffffff}}) {
      // A text cannot hold the zero bytes of the second facet.
      expect_refused(
          binary(header, count, 2), "a.stl", ErrorKind::bad_file,
          "byte 80: the header states " + std::to_string(count) + " triangles, but the file has 2");
    }
  }
}

TEST(Stl, NotesAFewBytesBehindTheLastFacet) {
  const Mesh mesh = read_text(binary("x", 2, 2) + std::string(49, ' '), "a.stl");
  EXPECT_EQ(mesh.triangles.size(), 2U);
  EXPECT_EQ(mesh.notes, (std::vector<std::string>{
                            "surplus bytes after the last triangle: 49, the first at byte 184"}));
  expect_refused(binary("x", 2, 2) + std::string(50, ' '), "a.stl", ErrorKind::bad_file,
                 "but the file has 3");
}

TEST(Stl, NamesTheTriangleWhoseCoordinateIsNotFinite) {
  std::string text = binary("x", 2, 2);
  text.replace(84 + 50 + 12, 4, bytes_of(std::numeric_limits<float>::infinity()));
  expect_refused(text, "a.stl", ErrorKind::not_finite, "byte 146: triangle 1: x of a vertex");
}

}  // namespace
}  // namespace soms::test
