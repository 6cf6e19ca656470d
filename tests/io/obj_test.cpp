#include "soms/io/detail/simple/obj.h"

#include "soms/base/error.h"
#include "soms/io/read_mesh.h"

#include "tests/io/files.h"

#include <gtest/gtest.h>

#include <array>
#include <string>
#include <vector>

namespace soms::test {
namespace {

using Triangles = std::vector<std::array<std::uint32_t, 3>>;

const std::string kVertexLines = "v 0 0 0.1\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

TEST(Obj, CountsNegativeIndicesFromTheVerticesSoFar) {
  const Mesh mesh =
      read_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\nv 9 9 9\nf -4 -1 1\n", "a.obj");
  EXPECT_EQ(mesh.triangles, (Triangles{{0, 1, 2}, {0, 3, 0}}));
  expect_refused("v 0 0 0\nf 1 1 -2\n", "a.obj", ErrorKind::bad_file,
                 "line 2: vertex -2, but 1 vertex is defined before this line");
  expect_refused(kVertexLines + "f 1 2 5\n", "a.obj", ErrorKind::bad_file,
                 "line 5: vertex 5, but vertices are 1 to 4");
  expect_refused(kVertexLines + "f 1 2 0\n", "a.obj", ErrorKind::bad_file,
                 "vertex 0, but vertices are 1 to 4; vertices are numbered from 1");
}

TEST(Obj, LetsAFaceNameVerticesBehindIt) {
  EXPECT_EQ(read_text("f 1 2 3\n" + kVertexLines, "a.obj").triangles, (Triangles{{0, 1, 2}}));
}

TEST(Obj, PassesTextureAndNormalNumbers) {
  const Mesh mesh =
      read_text(kVertexLines + "f 1/7 2/8/9 3//-1\nf 1/ 2// 4/1/\nf +1 2 3\n", "a.obj");
  EXPECT_EQ(mesh.triangles, (Triangles{{0, 1, 2}, {0, 1, 3}, {0, 1, 2}}));
  for (const std::string corner : {"3/", "3//", "3/1/2/3", "3/x", "3/1.5", "/3", "3x", "3/ /1"}) {
    SCOPED_TRACE(corner);
    const std::string text = kVertexLines + "f 1 2 " + corner + "\n";
    if (corner == "3/" || corner == "3//") {
      EXPECT_NO_THROW(static_cast<void>(read_text(text, "a.obj")));
    } else {
      expect_refused(text, "a.obj", ErrorKind::bad_file, "line 5: a corner is");
    }
  }
}

TEST(Obj, JoinsLinesAtABackslashWhateverTheLineEnd) {
  for (const std::string end : {"\n", "\r\n", "\r"}) {
    const std::string text = "v 0 \\" + end + " 0 0" + end + "v 1 0 0" + end + "v 1 1 0" + end +
                             "v 0 1 0" + end + "f 1 2\\" + end + "3 \\" + end + "4" + end +
                             "f 1 2 3" + end + "usemtl a\\" + end + "f 4 4 4" + end;
    const Mesh mesh = read_text(text, "a.obj");
    EXPECT_EQ(mesh.triangles, (Triangles{{0, 1, 2}, {0, 2, 3}, {0, 1, 2}}));
    EXPECT_EQ(mesh.faces, (std::vector<std::uint32_t>{0, 0, 1}));
  }
}

TEST(Obj, DoesNotJoinAtABackslashThatEndsAComment) {
  const Mesh mesh =
      read_text("# C:\\models\\\n" + kVertexLines + "f 1 2 3 # in C:\\\nf 1 3 4\n", "a.obj");
  EXPECT_EQ(mesh.vertices.size(), 4U);
  EXPECT_EQ(mesh.triangles.size(), 2U);
}

TEST(Obj, KeepsVerticesBehindACommentThatEndsWithABackslash) {
  for (const std::string end : {"\n", "\r\n", "\r"}) {
    const std::string tail = " # from C:\\models\\" + end;
    const Mesh mesh =
        read_text("v 0 0 0" + tail + "v 1 0 0 1" + tail + "v 0 1 0" + end + "g a b" + tail +
                      "vt 0 0\\" + end + tail + "f 1 2 3" + tail + "f 3 2 1" + end,
                  "a.obj");
    EXPECT_EQ(mesh.vertices, (std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
    EXPECT_EQ(mesh.triangles, (Triangles{{0, 1, 2}, {2, 1, 0}}));
  }
  // Within a word # begins no comment.
  EXPECT_EQ(
      read_text("usemtl a#b\\\nv 9 9 9\n" + kVertexLines + "f 1 2 3\n", "a.obj").vertices[0].z,
      0.1);
}

TEST(Obj, JoinsLinesAtANameInBothPasses) {
  for (const std::string word : {"g", "o"}) {
    const Mesh mesh = read_text(
        "v 0 0 0\n" + word + " a\\\nv 9 9 9\nv 1 0 0\nv 0 1 0\nf -1 -2 -3\nv 5 5 5\n", "a.obj");
    EXPECT_EQ(mesh.triangles, (Triangles{{2, 1, 0}}));
    EXPECT_EQ(mesh.vertices.size(), 4U);
  }
}

TEST(Obj, ReadsNumbersAsDoublesAndPassesColorsAndWeights) {
  const Mesh mesh =
      read_text("v 0.1 0 0 0.5 0.5 0.5\nv 1 0 0 1.0\nv 0 1e-320 0\nf 1 2 3\n", "a.obj");
  EXPECT_EQ(mesh.vertices[0].x, 0.1);
  EXPECT_EQ(mesh.vertices[1], (Vec3{1, 0, 0}));
  EXPECT_EQ(mesh.vertices[2].y, 1e-320);
}

TEST(Obj, NotesWhatIsNotRead) {
  const Mesh mesh = read_text(kVertexLines + "f 1 2 3\nl 1 2\np 1\ncurv 0 1 1 2\n", "a.obj");
  EXPECT_EQ(mesh.notes, (std::vector<std::string>{
                            "lines and points, which are not triangles: 2, the first in line 6",
                            "free-form curves and surfaces, not read: 1, in line 8"}));
}

TEST(Obj, RefusesIndicesThatWrap) {
  for (const std::string index : {"0", "5", "4294967297", "18446744073709551617",
                                  "-18446744073709551615", "-9223372036854775808"}) {
    expect_refused(kVertexLines + "f 1 2 " + index + "\n", "a.obj", ErrorKind::bad_file, "line 5");
  }
}

TEST(Obj, TellsAFileOfOtherWordsFromAnEmptyModel) {
  expect_refused("this is\nno model\n", "a.obj", ErrorKind::bad_file,
                 "no line begins with an OBJ keyword");
  for (const std::string text : {"# nothing\n", "# nothing\nmtllib a.mtl\n", "g nothing\n"}) {
    expect_refused(text, "a.obj", ErrorKind::empty_mesh, "");
  }
}

}  // namespace
}  // namespace soms::test
