// Faults that other libraries had with meshes of STL, 3DS, OBJ and other files; numbers as in the
// list of regressions. The files are made here, byte by byte.
#include "soms/geometry/defects.h"
#include "soms/io/read_mesh.h"
#include "soms/io/write_mesh.h"
#include "soms/query/overlap.h"

#include "tests/io/files.h"
#include "tests/regressions/cube.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace soms::test {
namespace {

/// A `v` line of OBJ.
std::string obj_vertex(const Vec3& p) {
  std::ostringstream line;
  line.precision(17);
  line << "v " << p.x << " " << p.y << " " << p.z << "\n";
  return line.str();
}

/// The cube with four vertices of its own for each side, as where normals are split.
Mesh split_cube() {
  Mesh mesh;
  for (const auto& side : kSides) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    for (const int k : side) {
      mesh.vertices.push_back(cube_corner(k));
    }
    mesh.triangles.push_back({first, first + 1, first + 2});
    mesh.triangles.push_back({first, first + 2, first + 3});
  }
  return mesh;
}

// Where parity of orientations decided inside and outside, nothing said why it was wrong.
TEST(FileRegressions, R21TurnedTrianglesAreNamed) {
  Mesh mesh = split_cube();
  EXPECT_TRUE(find_defects(mesh).closed());
  std::swap(mesh.triangles[7][0], mesh.triangles[7][1]);
  const Defects one = find_defects(mesh);
  ASSERT_EQ(one.places.flipped_edges.size(), 3U);
  for (const EdgePlace& edge : one.places.flipped_edges) {
    EXPECT_TRUE(edge.triangle == 7 || edge.other == 7);
  }
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    if (i != 7) {
      std::swap(mesh.triangles[i][0], mesh.triangles[i][1]);
    }
  }
  EXPECT_TRUE(find_defects(mesh).closed());  // all turned inwards: consistent
}

TEST(FileRegressions, R22DoubledFacesOfOppositeSenseAreNamed) {
  Mesh mesh = cube();
  for (const TriangleId i : {0U, 3U, 4U, 9U}) {
    const auto [a, b, c] = mesh.triangles[i];
    mesh.triangles.push_back({c, b, a});
  }
  const Defects defects = find_defects(mesh);
  EXPECT_EQ(defects.doubled, 4U);
  EXPECT_EQ(defects.places.doubled,
            (std::vector<TriangleCopy>{{12, 0}, {13, 3}, {14, 4}, {15, 9}}));
  EXPECT_FALSE(defects.closed());
}

TEST(FileRegressions, R23OpenEdgesOfACubeWithoutLidAreCounted) {
  Mesh mesh = split_cube();
  mesh.triangles.erase(mesh.triangles.begin() + 2, mesh.triangles.begin() + 4);
  const Defects defects = find_defects(mesh);
  EXPECT_EQ(defects.open_edges, 4U);
  EXPECT_FALSE(defects.closed());
}

// Numbers were those of the reordered tree, or of another part.
TEST(FileRegressions, R46NumbersOfTrianglesLeadBackToFaceAndPart) {
  std::string obj;
  for (int k = 0; k < 300; ++k) {
    const double x = (k * 131) % 300;  // neighbors in the file are none in space
    obj += std::string("o part").append(std::to_string(k)).append("\n");
    for (const Vec3& corner : {Vec3{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0.5, 1.5, 0}, {0, 1, 0}}) {
      obj += obj_vertex(corner + Vec3{2 * x, 0, 0});
    }
    obj += "f -5 -4 -3 -2 -1\n";
  }
  const Mesh mesh = read_text(obj, "parts.obj");
  ASSERT_EQ(mesh.triangles.size(), 900U);
  for (int k = 0; k < 300; k += 7) {
    const double x = 2 * ((k * 131) % 300);
    Mesh needle;
    needle.vertices = {{x + 0.9, 0.1, -1}, {x + 0.9, 0.1, 1}, {x + 0.9, 0.11, 1}};
    needle.triangles = {{0, 1, 2}};
    const Overlap answer = overlap(Body(needle), Body(mesh));
    ASSERT_EQ(answer.pairs.size(), 1U);
    const TriangleId i = answer.pairs[0].b;
    EXPECT_EQ(mesh.faces.at(i), static_cast<std::uint32_t>(k));
    EXPECT_EQ(mesh.parts.at(part_of(mesh, i)).name, std::string("part").append(std::to_string(k)));
  }
}

/// A binary STL file of `stored` triangles that says it has `count`.
std::string stl(const std::string& header, std::size_t count, std::size_t stored) {
  std::string bytes = header;
  bytes.resize(80, ' ');
  bytes += bytes_of(count, 4);
  for (std::size_t i = 0; i < stored; ++i) {
    const auto x = static_cast<float>(i);
    for (const float value : {0.F, 0.F, 1.F, x, 0.F, 0.F, x + 1, 0.F, 0.F, x, 1.F, 0.F}) {
      bytes += bytes_of(value);
    }
    bytes += bytes_of(0, 2);
  }
  return bytes;
}

TEST(FileRegressions, R92BinaryStlIsReportedBySizeWhateverItBeginsWith) {
  for (const char* header : {"solid cube", "solid\nfacet normal 0 0 1\nouter loop", "exported"}) {
    EXPECT_EQ(read_text(stl(header, 3, 3), "a.stl").triangles.size(), 3U);
    expect_refused(stl(header, 0, 0), "a.stl", ErrorKind::empty_mesh, "no triangles");
    EXPECT_TRUE(read_text(stl(header, 0, 0), "a.stl", {.allow_empty = true}).vertices.empty());
    EXPECT_TRUE(refusal_of([&] { static_cast<void>(read_text(stl(header, 3, 2), "a.stl")); }));
  }
  expect_refused(stl("exported", 3, 2), "a.stl", ErrorKind::bad_file, "byte 80");
  // Counts whose second byte is 0x1A, the end of a text for some.
  for (const std::size_t count : {6655U, 6656U, 6689U, 6911U, 6912U}) {
    const Mesh mesh = read_text(stl("solid", count, count), "a.stl");
    ASSERT_EQ(mesh.triangles.size(), count);
    EXPECT_EQ(mesh.triangle(static_cast<TriangleId>(count - 1)).a.x,
              static_cast<double>(count - 1));
  }
}

TEST(FileRegressions, R92TextStlGivesAllFacetsOrAnError) {
  const auto text = [](const std::string& end, const std::string& loop, const std::string& facet) {
    std::string all = "solid a" + end;
    for (int i = 0; i < 4; ++i) {
      all += std::string("facet normal 0 0 1").append(end).append("outer loop").append(end);
      for (const char* corner : {" 0 0", " 1 0", " 0 1"}) {
        all += std::string("vertex ").append(std::to_string(i)).append(corner).append(end);
      }
      all.append(loop).append(end).append(facet).append(end);
    }
    return all + "endsolid a" + end;
  };
  for (const std::string end : {"\n", "\r\n", "\r"}) {
    EXPECT_EQ(read_text(text(end, "endloop", "endfacet"), "a.stl").triangles.size(), 4U);
    for (const auto& words : std::vector<std::pair<std::string, std::string>>{
             {"end loop", "endfacet"}, {"endloop", "end facet"}, {"end loop", "end facet"}}) {
      const std::string odd = text(end, words.first, words.second);
      const auto refusal =
          refusal_of([&] { EXPECT_EQ(read_text(odd, "a.stl").triangles.size(), 4U); });
      EXPECT_TRUE(!refusal || refusal->words.find("line ") != std::string::npos) << refusal->words;
    }
  }
}

/// The mesh after it was written and read again.
Mesh through(const Mesh& mesh, MeshFormat format, const std::string& name) {
  std::ostringstream out;
  write_mesh(out, name, mesh, format);
  return read_text(out.str(), name);
}

const std::vector<std::pair<MeshFormat, std::string>> kFormats = {
    {MeshFormat::ply, "a.ply"},      {MeshFormat::ply_ascii, "a.ply"},
    {MeshFormat::obj, "a.obj"},      {MeshFormat::off, "a.off"},
    {MeshFormat::stl, "a.stl"},      {MeshFormat::stl_ascii, "a.stl"},
    {MeshFormat::three_ds, "a.3ds"}, {MeshFormat::glb, "a.glb"}};

TEST(FileRegressions, R93SplitCornersStayAndClosednessIsJudgedByPosition) {
  const Mesh split = split_cube();
  for (const auto& [format, name] : kFormats) {
    SCOPED_TRACE(name);
    const Mesh mesh = through(split, format, name);
    EXPECT_EQ(mesh.vertices.size(), name == "a.stl" ? 36U : 24U);
    const Defects defects = find_defects(mesh);
    EXPECT_TRUE(defects.closed());
    EXPECT_FALSE(defects.by_index.closed());
    EXPECT_EQ(defects.repeated_vertices, mesh.vertices.size() - 8);
  }
  // Normals by number split nothing that the file does not.
  std::string obj = "vn 0 0 1\n";
  for (int k = 0; k < 8; ++k) {
    const Vec3 p = cube_corner(k);
    obj += obj_vertex(p);
  }
  for (const auto& side : kSides) {
    obj += "vn 1 0 0\nf";
    for (const int k : side) {
      obj += ' ';
      obj += std::to_string(k + 1) + "//-1";
    }
    obj += "\n";
  }
  const Mesh mesh = read_text(obj, "a.obj");
  EXPECT_EQ(mesh.vertices.size(), 8U);
  EXPECT_TRUE(find_defects(mesh).by_index.closed());
}

std::string chunk(std::uint64_t name, const std::string& content) {
  return bytes_of(name, 2) + bytes_of(content.size() + 6, 4) + content;
}

/// A 3DS file of the cube with a local matrix: three axes, then an origin.
std::string three_ds_cube(const std::array<float, 12>& local, float master_scale) {
  std::string vertices = bytes_of(8, 2);
  for (int k = 0; k < 8; ++k) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      vertices += bytes_of(static_cast<float>(cube_corner(k)[axis]));
    }
  }
  std::string faces = bytes_of(12, 2);
  for (const auto& t : cube().triangles) {
    for (const std::uint32_t v : t) {
      faces += bytes_of(v, 2);
    }
    faces += bytes_of(7, 2);
  }
  std::string matrix;
  for (const float value : local) {
    matrix += bytes_of(value);
  }
  const std::string mesh =
      chunk(0x4100, chunk(0x4110, vertices) + chunk(0x4160, matrix) + chunk(0x4120, faces));
  return chunk(0x4d4d, chunk(0x3d3d, chunk(0x0100, bytes_of(master_scale)) +
                                         chunk(0x4000, std::string("cube") + '\0' + mesh)));
}

TEST(FileRegressions, R94LocalMatrixAndScaleOf3dsChangeNoVertex) {
  const std::array<float, 12> unmoved = {1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0};
  const std::array<float, 12> moved = {0, 2, 0, -2, 0, 0, 0, 0, 2, 10, 20, 30};
  for (const auto& [matrix, scale] : {std::pair(unmoved, 1.F), std::pair(moved, 1.F),
                                      std::pair(moved, 0.001F), std::pair(unmoved, 1000.F)}) {
    const Mesh mesh = read_text(three_ds_cube(matrix, scale), "cube.3ds");
    EXPECT_EQ(mesh.vertices, cube().vertices);
    EXPECT_EQ(mesh.triangles, cube().triangles);
    EXPECT_EQ(mesh.unit, 0);  // never guessed
    EXPECT_EQ(mesh.up, UpAxis::unknown);
    const bool reported = std::any_of(mesh.notes.begin(), mesh.notes.end(), [](const auto& note) {
      return note.find("master scale") != std::string::npos;
    });
    EXPECT_EQ(reported, scale != 1);
  }
}

TEST(FileRegressions, R94AxesAreThoseOfTheFileInEveryFormatAndTurnOnlyWhenRequested) {
  // Arms of length 3, 2 and 1 along x, y and z.
  Mesh gizmo;
  gizmo.vertices = {{0, 0, 0}, {3, 0, 0}, {0, 2, 0}, {0, 0, 1}, {0.25, 0.25, 0.25}};
  gizmo.triangles = {{0, 1, 4}, {0, 2, 4}, {0, 3, 4}};
  for (const auto& [format, name] : kFormats) {
    SCOPED_TRACE(name);
    const Mesh mesh = through(gizmo, format, name);
    ASSERT_EQ(mesh.triangles.size(), 3U);
    for (TriangleId i = 0; i < 3; ++i) {
      EXPECT_EQ(mesh.triangle(i), gizmo.triangle(i));
    }
    // Neither unit nor axis was reported, and no format makes them up, not even GLB, which has its
    // own.
    EXPECT_EQ(mesh.unit, 0);
    EXPECT_EQ(mesh.up, UpAxis::unknown);
    const Mesh turned = transformed(mesh, 1, UpAxis::y);
    EXPECT_EQ(turned.triangle(0).b, (Vec3{3, 0, 0}));
    EXPECT_EQ(turned.triangle(1).b, (Vec3{0, 0, 2}));
    EXPECT_EQ(turned.triangle(2).b, (Vec3{0, -1, 0}));
  }
}

/// Arms of length 3, 2 and 1 along x, y and z.
constexpr std::array<std::array<float, 3>, 5> kArms = {
    {{0, 0, 0}, {3, 0, 0}, {0, 2, 0}, {0, 0, 1}, {0.25, 0.25, 0.25}}};

/// Expects the arms as they were written, in the order of the file.
void expect_arms(const Mesh& mesh) {
  ASSERT_EQ(mesh.triangles.size(), 3U);
  for (TriangleId i = 0; i < 3; ++i) {
    const auto& tip = kArms[i + 1];
    EXPECT_EQ(mesh.triangle(i),
              (Triangle{{0, 0, 0}, {tip[0], tip[1], tip[2]}, {0.25, 0.25, 0.25}}));
  }
}

TEST(FileRegressions, R94AxesAndUnitOfColladaAreReportedAndNotApplied) {
  for (const auto& [word, up] :
       {std::pair("X_UP", UpAxis::x), std::pair("Y_UP", UpAxis::y), std::pair("Z_UP", UpAxis::z)}) {
    std::ostringstream dae;
    dae << "<COLLADA version=\"1.4.1\"><asset><unit meter=\"0.01\"/><up_axis>" << word
        << "</up_axis></asset><library_geometries><geometry id=\"g\"><mesh><source id=\"p\">"
           "<float_array id=\"a\" count=\"15\">";
    for (const auto& arm : kArms) {
      dae << arm[0] << " " << arm[1] << " " << arm[2] << " ";
    }
    dae << "</float_array><technique_common><accessor source=\"#a\" count=\"5\" stride=\"3\">"
           "<param name=\"X\" type=\"float\"/><param name=\"Y\" type=\"float\"/>"
           "<param name=\"Z\" type=\"float\"/></accessor></technique_common></source>"
           "<vertices id=\"v\"><input semantic=\"POSITION\" source=\"#p\"/></vertices>"
           "<triangles count=\"3\"><input semantic=\"VERTEX\" source=\"#v\" offset=\"0\"/>"
           "<p>0 1 4 0 2 4 0 3 4</p></triangles></mesh></geometry></library_geometries>"
           "<library_visual_scenes><visual_scene id=\"s\"><node><instance_geometry url=\"#g\"/>"
           "</node></visual_scene></library_visual_scenes>"
           "<scene><instance_visual_scene url=\"#s\"/></scene></COLLADA>";
    const Mesh mesh = read_text(dae.str(), "arms.dae");
    expect_arms(mesh);
    EXPECT_EQ(mesh.unit, 0.01);
    EXPECT_EQ(mesh.up, up);
  }
}

TEST(FileRegressions, R94AxesOfGltfAreThoseOfTheFile) {
  std::string buffer;
  for (const auto& arm : kArms) {
    buffer += bytes_of(arm[0]) + bytes_of(arm[1]) + bytes_of(arm[2]);
  }
  for (const std::uint32_t v : {0U, 1U, 4U, 0U, 2U, 4U, 0U, 3U, 4U}) {
    buffer += bytes_of(v, 4);
  }
  std::string json = R"({"asset":{"version":"2.0"},"buffers":[{"byteLength":96}],"bufferViews":[
    {"buffer":0,"byteLength":60},{"buffer":0,"byteOffset":60,"byteLength":36}],"accessors":[
    {"bufferView":0,"componentType":5126,"count":5,"type":"VEC3","min":[0,0,0],"max":[3,2,1]},
    {"bufferView":1,"componentType":5125,"count":9,"type":"SCALAR"}],
    "meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}],
    "nodes":[{"mesh":0}],"scenes":[{"nodes":[0]}],"scene":0})";
  json.resize((json.size() + 3) / 4 * 4, ' ');
  const auto glb_chunk = [](const std::string& type, const std::string& content) {
    return bytes_of(content.size(), 4) + type + content;
  };
  const std::string chunks = glb_chunk("JSON", json) + glb_chunk(std::string("BIN\0", 4), buffer);
  const std::string glb =
      std::string("glTF") + bytes_of(2, 4) + bytes_of(chunks.size() + 12, 4) + chunks;
  const Mesh mesh = read_text(glb, "arms.glb");
  expect_arms(mesh);
  EXPECT_EQ(mesh.unit, 1);  // the format's own, as its up axis
  EXPECT_EQ(mesh.up, UpAxis::y);
}

TEST(FileRegressions, R95NegativeIndicesOfObjCountFromTheVerticesSoFar) {
  std::string obj;
  Mesh expected;
  for (std::uint32_t block = 0; block < 50; ++block) {
    for (std::uint32_t i = 0; i < 3; ++i) {
      const Vec3 p{static_cast<double>(block), static_cast<double>(i == 1),
                   static_cast<double>(i == 2)};
      obj += obj_vertex(p);
      expected.vertices.push_back(p);
    }
    obj += block % 2 == 0 ? "f -3 -2 -1\n" : "vt 0 0\nvn 0 0 1\nf -3/-1/-1 -2/-1/-1 -1/-1/-1\n";
    expected.triangles.push_back({3 * block, 3 * block + 1, 3 * block + 2});
  }
  const Mesh mesh = read_text(obj, "blocks.obj");
  EXPECT_EQ(mesh.vertices, expected.vertices);
  EXPECT_EQ(mesh.triangles, expected.triangles);
  expect_refused("v 0 0 0\nv 1 0 0\nf -3 -2 -1\nv 0 1 0\n", "a.obj", ErrorKind::bad_file, "line 3");
}

/// A polygon, then a triangle, in three formats.
std::vector<std::pair<std::string, std::string>> polygon_files(const std::vector<Vec3>& corners) {
  std::string points;
  std::string obj;
  for (const Vec3& p : corners) {
    obj += obj_vertex(p);
    points += obj_vertex(p).substr(2);
  }
  const std::string n = std::to_string(corners.size());
  std::string face = n;
  std::string from_one;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    face += ' ';
    face += std::to_string(i);
    from_one += ' ';
    from_one += std::to_string(i + 1);
  }
  const std::string faces = face + "\n3 0 1 2\n";
  return {{obj + "f" + from_one + "\nf 1 2 3\n", "a.obj"},
          {"OFF\n" + n + " 2 0\n" + points + faces, "a.off"},
          {"ply\nformat ascii 1.0\nelement vertex " + n +
               "\nproperty double x\nproperty double y\nproperty double z\nelement face 2\n"
               "property list uchar int vertex_indices\nend_header\n" +
               points + faces,
           "a.ply"}};
}

/// Expects triangles of the polygon that keep its area (times two, as a vector) and its sense.
void expect_polygon(const std::vector<Vec3>& corners, double tolerance) {
  Vec3 area;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    area = area + cross(corners[i], corners[(i + 1) % corners.size()]);
  }
  for (const auto& [content, name] : polygon_files(corners)) {
    SCOPED_TRACE(name);
    const Mesh mesh = read_text(content, name);
    const std::size_t pieces = corners.size() - 2;
    ASSERT_EQ(mesh.triangles.size(), pieces + 1);
    Vec3 sum;
    double size = 0;
    for (TriangleId i = 0; i < pieces; ++i) {
      const Triangle t = mesh.triangle(i);
      const Vec3 normal = cross(t.b - t.a, t.c - t.a);
      EXPECT_GT(dot(normal, area), 0) << "triangle " << i << " is turned over";
      sum = sum + normal;
      size += std::sqrt(dot(normal, normal));
      EXPECT_EQ(mesh.faces.at(i), 0U);
    }
    EXPECT_EQ(mesh.faces.at(pieces), 1U);
    EXPECT_NEAR(sum.x, area.x, tolerance);
    EXPECT_NEAR(sum.y, area.y, tolerance);
    EXPECT_NEAR(sum.z, area.z, tolerance);
    // Nothing is covered twice: sizes add up to the polygon's.
    EXPECT_NEAR(size, std::sqrt(dot(area, area)), tolerance);
  }
}

TEST(FileRegressions, R96ConcavePolygonsKeepAreaNormalAndFace) {
  // An L, a dart and a comb, from each corner on, both ways round, in each coordinate plane.
  const std::vector<std::vector<Vec3>> outlines = {
      {{0, 0, 0}, {3, 0, 0}, {3, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}},
      {{0, 0, 0}, {4, -2, 0}, {1, 0, 0}, {4, 2, 0}},
      {{0, 0, 0},
       {5, 0, 0},
       {5, 3, 0},
       {4, 3, 0},
       {4, 1, 0},
       {3, 1, 0},
       {3, 3, 0},
       {2, 3, 0},
       {2, 1, 0},
       {1, 1, 0},
       {1, 3, 0},
       {0, 3, 0}}};
  for (const std::vector<Vec3>& outline : outlines) {
    std::vector<Vec3> corners = outline;
    for (std::size_t turn = 0; turn < outline.size(); ++turn) {
      std::rotate(corners.begin(), corners.begin() + 1, corners.end());
      std::vector<Vec3> other = corners;
      for (int plane = 0; plane < 3; ++plane) {
        expect_polygon(other, 0);
        expect_polygon({other.rbegin(), other.rend()}, 0);
        for (Vec3& p : other) {
          p = {p.z, p.x, p.y};
        }
      }
    }
  }
}

TEST(FileRegressions, R96SlightlyBentQuadsKeepAreaNormalAndFace) {
  for (const double bend : {0x1p-20, -0x1p-20, 0x1p-40, 1e-7}) {
    for (std::size_t corner = 0; corner < 4; ++corner) {
      for (const bool dart : {false, true}) {
        std::vector<Vec3> corners = {{0, 0, 0}, {4, -2, 0}, {dart ? 1.0 : 5.0, 0, 0}, {4, 2, 0}};
        corners[corner].z += bend;
        expect_polygon(corners, 1e-5);
      }
    }
  }
}

}  // namespace
}  // namespace soms::test
