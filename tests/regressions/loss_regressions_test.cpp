// Faults of the first release of soms: files of which something was left out without a word. The
// files are made here; numbers as in the list of regressions.
#include "soms/base/error.h"
#include "soms/io/read_mesh.h"

#include "tests/io/files.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace soms::test {
namespace {

using Notes = std::vector<std::string>;

/// A PLY file of float vertices and `faces` faces.
std::string ply_of(const std::string& format, int vertices, int faces, const std::string& body) {
  return "ply\nformat " + format + " 1.0\nelement vertex " + std::to_string(vertices) +
         "\nproperty float x\nproperty float y\nproperty float z\nelement face " +
         std::to_string(faces) + "\nproperty list uchar int vertex_indices\nend_header\n" + body;
}

const std::string kThreeRows = "0 0 0\n1 0 0\n0 1 0\n";

/// Expects notes, and with `strict` an error with their text.
void expect_noted(const std::string& content, const std::string& name, const Notes& notes) {
  SCOPED_TRACE(name);
  const Mesh mesh = read_text(content, name);
  EXPECT_EQ(mesh.triangles.size(), 1U);
  EXPECT_EQ(mesh.notes, notes);
  for (const std::string& note : notes) {
    expect_refused([&] { static_cast<void>(read_text(content, name, {.strict = true})); },
                   ErrorKind::bad_file, note);
  }
}

TEST(FileRegressions, R114RowsBehindTheLastOfAPlyOrOffTextAreErrors) {
  const std::string more = "3 0 1 2\n3 0 1 2\n3 2 1 0\n";
  expect_refused(ply_of("ascii", 3, 1, kThreeRows + more), "trail.ply", ErrorKind::bad_file,
                 "trail.ply, line 14: \"3\" follows the last row that the header declares");
  expect_refused("OFF\n3 1 0\n" + kThreeRows + more, "trail.off", ErrorKind::bad_file,
                 "trail.off, line 7: \"3\" follows the last declared face");
  for (const std::string blank : {"", "\n", " \t\r\n\n"}) {
    EXPECT_EQ(read_text(ply_of("ascii", 3, 1, kThreeRows + "3 0 1 2" + blank), "a.ply").notes,
              Notes());
    EXPECT_EQ(read_text("OFF\n3 1 0\n" + kThreeRows + "3 0 1 2" + blank, "a.off").notes, Notes());
  }
}

TEST(FileRegressions, R114BytesBehindTheLastRowOfABinaryPlyAreNoted) {
  std::string body;
  for (const float v : {0.F, 0.F, 0.F, 1.F, 0.F, 0.F, 0.F, 1.F, 0.F}) {
    body += bytes_of(v);
  }
  const std::string face = bytes_of(3, 1) + bytes_of(0, 4) + bytes_of(1, 4) + bytes_of(2, 4);
  const std::string whole = ply_of("binary_little_endian", 3, 1, body + face);
  expect_noted(whole, "whole.ply", {});
  expect_noted(whole + face + face, "trail.ply",
               {"surplus bytes after the last declared row: 26, the first at byte " +
                std::to_string(whole.size())});
  expect_noted(
      whole + "\n", "end.ply",
      {"surplus bytes after the last declared row: 1, at byte " + std::to_string(whole.size())});
}

// Numbers of all rows behind it moved up, and the mesh was another.
TEST(FileRegressions, R114AShortVertexRowOfAPlyTextIsAnErrorInItsLine) {
  const std::string filled = "0 0\n0 1 0\n0 0 1\n0 3 0 1 2\n3 0 1 2\n";
  expect_refused(ply_of("ascii", 4, 1, filled), "a.ply", ErrorKind::bad_file,
                 "a.ply, line 10: z is missing: the line ends");
  expect_refused(ply_of("ascii", 3, 1, "0 0 0\n1 0\n0 1 0\n3 0 1 2\n"), "a.ply",
                 ErrorKind::bad_file, "a.ply, line 11: z is missing: the line ends");
}

TEST(FileRegressions, R114ALongRowOfAPlyTextIsAnErrorInItsLine) {
  expect_refused(ply_of("ascii", 3, 1, kThreeRows + "3 0 1 2 9\n"), "p1.ply", ErrorKind::bad_file,
                 "p1.ply, line 13: \"9\" follows the last row");
  expect_refused(ply_of("ascii", 3, 2, kThreeRows + "3 0 1 2 9\n3 0 1 2\n"), "p1.ply",
                 ErrorKind::bad_file, "p1.ply, line 13: \"9\" follows the last value of the row");
  expect_refused(ply_of("ascii", 3, 1, "0 0 0 7\n1 0 0\n0 1 0\n3 0 1 2\n"), "p1.ply",
                 ErrorKind::bad_file, "p1.ply, line 10: \"7\" follows the last value of the row");
  // The other fault hides none: as many numbers are there as in a good file.
  expect_refused(ply_of("ascii", 3, 1, "0 0 0\n1 0 0 0\n1 0\n3 0 1 2\n"), "p1.ply",
                 ErrorKind::bad_file, "p1.ply, line 11: \"0\" follows the last value");
  expect_refused(ply_of("ascii", 3, 1, "0 0 0\n1 0\n0 0 1 0\n3 0 1 2\n"), "p1.ply",
                 ErrorKind::bad_file, "p1.ply, line 11: z is missing");
  // Where the first line of an element holds several rows, lines mean nothing.
  for (const std::string body : {"0 0 0 1 0 0 0 1 0 3 0 1 2\n", "0 0 0 1 0 0 0\n1 0\n3 0 1 2\n",
                                 "0 0 0 1 0 0\n0 1 0 3 0\n1 2"}) {
    EXPECT_EQ(read_text(ply_of("ascii", 3, 1, body), "a.ply").triangles.size(), 1U) << body;
  }
}

TEST(FileRegressions, R115LinesOfObjThatAreNotReadAreCountedAndPlaced) {
  const std::string triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
  expect_noted(
      triangle + "n 1 2 3\nF 3 2 1\ncall more.obj\n\xc2\xa0 f 1 2 3\n", "lost.obj",
      {"calls of other files or programs, not followed: 1, in line 7: "
       "\"call\"",
       "lines that start with an unknown keyword, not read: 3, the first in line 5: \"n\""});
  expect_noted(triangle + "l 1 2\np 3\n", "lines.obj",
               {"lines and points, which are not triangles: 2, the first in line 5"});
  expect_noted(triangle + "curv 0 1 1 2\nbsp 1 2 3\n", "curves.obj",
               {"free-form curves and surfaces, not read: 2, the first in line 5"});
  expect_noted("# c\nmtllib a.mtl\n" + triangle +
                   "vn 0 0 1\nvt 0 0\ns off\nusemtl m\ng a\nlod 1\nbevel on\n",
               "whole.obj", {});
}

/// A chunk of 3DS.
std::string chunk_of(std::uint64_t name, const std::string& body) {
  return bytes_of(name, 2) + bytes_of(body.size() + 6, 4) + body;
}

/// A 3DS file with one triangle; `behind` stands behind the faces of its list.
std::string three_ds_of(const std::string& behind) {
  std::string vertices = bytes_of(3, 2);
  for (const float v : {0.F, 0.F, 0.F, 1.F, 0.F, 0.F, 0.F, 1.F, 0.F}) {
    vertices += bytes_of(v);
  }
  const std::string faces =
      bytes_of(1, 2) + bytes_of(0, 2) + bytes_of(1, 2) + bytes_of(2, 2) + bytes_of(7, 2);
  return chunk_of(
      0x4d4d,
      chunk_of(0x3d3d,
               chunk_of(0x4000, std::string("a") + '\0' +
                                    chunk_of(0x4100, chunk_of(0x4110, vertices) +
                                                         chunk_of(0x4120, faces + behind)))));
}

TEST(FileRegressions, R115BytesBehindAListOf3dsAreNoted) {
  const std::string face = bytes_of(0, 2) + bytes_of(1, 2) + bytes_of(2, 2) + bytes_of(0, 2);
  expect_noted(
      three_ds_of(face), "t6.3ds",
      {"surplus bytes after the vertices or faces that a list counts: 8, the first at byte 86"});
  // Smoothing groups and materials of the faces stand there.
  expect_noted(three_ds_of(chunk_of(0x4150, bytes_of(1, 4)) +
                           chunk_of(0x4130, std::string("m") + '\0' + bytes_of(0, 2))),
               "whole.3ds", {});
}

TEST(FileRegressions, R115ASecondMainChunkOf3dsIsNoted) {
  const std::string file = three_ds_of("");
  ASSERT_EQ(file.size(), 86U);
  expect_noted(file + file, "t2.3ds",
               {"bytes after the main chunk, which begin a second one, not read: 86, the first at "
                "byte 86"});
  expect_noted(file + std::string(4, '\0'), "zeros.3ds",
               {"bytes after the main chunk, not read: 4, the first at byte 86"});
}

}  // namespace
}  // namespace soms::test
