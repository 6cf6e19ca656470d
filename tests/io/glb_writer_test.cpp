// GLB that is written: what is read back, and what other programs will find in it.
#include "soms/base/error.h"
#include "soms/io/write_mesh.h"

#include "tests/io/files.h"
#include "tests/support/support.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <sstream>
#include <stop_token>
#include <string>
#include <vector>

namespace soms::test {
namespace {

std::string as_glb(const Mesh& mesh, const Limits& limits = {}) {
  std::ostringstream out;
  write_mesh(out, "out", mesh, MeshFormat::glb, limits);
  return out.str();
}

Mesh read_glb_back(const Mesh& mesh) {
  return read_text(as_glb(mesh), "out.glb", {.allow_empty = true});
}

/// Triangles between vertices whose coordinates are `step` times whole numbers below 2^20.
Mesh random_mesh(Rng& rng, std::size_t vertices, std::size_t triangles, double step) {
  Mesh mesh;
  for (std::size_t i = 0; i < vertices; ++i) {
    Vec3 v;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      v[axis] = step * static_cast<double>(rng.below(1 << 20));
    }
    mesh.vertices.push_back(v);
  }
  const auto vertex = [&] { return static_cast<std::uint32_t>(rng.below(vertices)); };
  for (std::size_t i = 0; i < triangles; ++i) {
    mesh.triangles.push_back({vertex(), vertex(), vertex()});
  }
  return mesh;
}

TEST(GlbWriter, WritesExactlyThis) {
  Mesh mesh;
  mesh.vertices = {{0, 0, 0}, {2, 0, 0}, {0, 0.5, -1}};
  mesh.triangles = {{0, 1, 2}};
  mesh.parts = {{"a \"b\"\xff", Part::kNoParent, 0, 1}};
  std::string json =
      R"({"asset":{"version":"2.0","generator":"soms","extras":{"soms":{"unit":0,"up":"unknown"}}},)"
      R"("scene":0,"scenes":[{"nodes":[0]}],)"
      R"("nodes":[{"name":"a \"b\"\ufffd","mesh":0}],)"
      R"("meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}],)"
      R"("accessors":[{"bufferView":0,"byteOffset":0,"componentType":5126,"type":"VEC3","count":3,)"
      R"("min":[0,0,-1],"max":[2,0.5,0]},)"
      R"({"bufferView":1,"byteOffset":0,"componentType":5123,"type":"SCALAR","count":3}],)"
      R"("bufferViews":[{"buffer":0,"target":34962,"byteStride":12,"byteLength":36},)"
      R"({"buffer":0,"target":34963,"byteOffset":36,"byteLength":8}],"buffers":[{"byteLength":44}]})";
  json.resize((json.size() + 3) / 4 * 4, ' ');
  std::string binary;
  for (const float x : {0.0F, 0.0F, 0.0F, 2.0F, 0.0F, 0.0F, 0.0F, 0.5F, -1.0F}) {
    binary += bytes_of(x);
  }
  binary += bytes_of(0, 2) + bytes_of(1, 2) + bytes_of(2, 2) + bytes_of(0, 2);
  const std::string chunks =
      bytes_of(json.size(), 4) + "JSON" + json + bytes_of(44, 4) + std::string("BIN\0", 4) + binary;
  EXPECT_EQ(as_glb(mesh), "glTF" + bytes_of(2, 4) + bytes_of(12 + chunks.size(), 4) + chunks);
}

TEST(GlbWriter, IsReadBackEqual) {
  for_each_case("io/glb", 100, [](Rng& rng) {
    const std::size_t vertices = 1 + rng.below(60);
    const Mesh mesh = random_mesh(rng, vertices, 1 + rng.below(100), 1.0 / 64);
    const Mesh back = read_glb_back(mesh);
    EXPECT_EQ(back.vertices, mesh.vertices);
    EXPECT_EQ(back.triangles, mesh.triangles);
    EXPECT_TRUE(back.parts.empty());
    EXPECT_TRUE(back.notes.empty());
    EXPECT_EQ(back.up, UpAxis::unknown);
  });
}

TEST(GlbWriter, KeepsUnitAndAxis) {
  Rng rng(4);
  Mesh mesh = random_mesh(rng, 3, 1, 1);
  for (const UpAxis up : {UpAxis::unknown, UpAxis::x, UpAxis::y, UpAxis::z}) {
    for (const double unit : {0.0, 1.0, 0.01, 0.3048}) {
      mesh.up = up;
      mesh.unit = unit;
      EXPECT_EQ(read_glb_back(mesh).up, up);
      EXPECT_EQ(read_glb_back(mesh).unit, unit);
    }
  }
}

/// A glTF document of one triangle whose extras have this georeference, as JSON.
Mesh placed_by(const std::string& georeference) {
  return read_text(
      R"({"asset":{"version":"2.0","extras":{"soms":{"georeference":)" + georeference +
          R"(}}},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],"meshes":[{"primitives":)"
          R"([{"attributes":{"POSITION":0}}]}],"accessors":[{"bufferView":0,"componentType":5126,)"
          R"("count":3,"type":"VEC3","min":[0,0,0],"max":[1,1,0]}],"bufferViews":[{"buffer":0,)"
          R"("byteLength":36}],"buffers":[{"byteLength":36,"uri":"data:;base64,)"
          R"(AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}]})",
      "a.gltf");
}

TEST(GlbWriter, ReadsAGeoreferenceThatSomebodyChanged) {
  EXPECT_TRUE(placed_by("null").georeference.empty());
  EXPECT_EQ(placed_by(R"({"crs":"urn:ogc:def:crs:EPSG::7415","vertical_datum":null,)"
                      R"("map_conversion":null})")
                .georeference,
            (Georeference{.crs = "EPSG:7415"}));
  EXPECT_EQ(placed_by(R"({"map_conversion":{"eastings":2,"unit":null,"factors":null}})")
                .georeference.map_conversion,
            MapConversion{.eastings = 2});
  EXPECT_EQ(placed_by(R"({"crs":"EPSG:4326"})").notes.size(), 1U) << "angles";
  for (const char* const factors : {"[1,1]", "[1,1,1,1]", "[]"}) {
    expect_refused(
        [&] {
          static_cast<void>(
              placed_by(R"({"map_conversion":{"factors":)" + std::string(factors) + "}}"));
        },
        ErrorKind::bad_file, "asset.extras.soms.georeference.map_conversion.factors");
  }
  expect_refused([] { static_cast<void>(placed_by(R"({"crs":7415})")); }, ErrorKind::bad_file,
                 "asset.extras.soms.georeference.crs");
}

TEST(GlbWriter, KeepsTheGeoreference) {
  Rng rng(5);
  Mesh mesh = random_mesh(rng, 3, 1, 1);
  mesh.unit = 1;
  for (const UpAxis up : {UpAxis::y, UpAxis::z}) {
    mesh.up = up;
    for (const Georeference& georeference :
         {Georeference{}, Georeference{.crs = "EPSG:7415"},
          Georeference{.crs = "a \"b\"", .vertical_datum = "NAP"},
          Georeference{.map_conversion = MapConversion{}},
          Georeference{.crs = "EPSG:25833",
          .map_conversion = MapConversion{.eastings = 311988.1,
                            .northings = -5996148.2,
                            .height = 10.3,
                            .abscissa = 0.6,
                            .ordinate = -0.8,
                            .scale = 1e-3,
                            .factors = {0.9996, 1.0004, 1},
                            .unit = 0.3048}}}) {
      mesh.georeference = georeference;
      EXPECT_EQ(read_glb_back(mesh).georeference, georeference);
      EXPECT_EQ(read_glb_back(mesh).up, up);
    }
  }
}

TEST(GlbWriter, KeepsLargeIndices) {
  Rng rng(3);
  const Mesh mesh = random_mesh(rng, 65'536, 1000, 1);
  EXPECT_EQ(read_glb_back(mesh).triangles, mesh.triangles);
  EXPECT_EQ(read_glb_back(mesh).vertices, mesh.vertices);
}

TEST(GlbWriter, KeepsPartsThatNestAndVerticesThatTheyDoNotShare) {
  Mesh mesh;
  for (int i = 0; i < 12; ++i) {
    mesh.vertices.push_back({static_cast<double>(i), 0, 0});
  }
  // Vertices 0, 4 and 11 are used by no triangle.
  mesh.triangles = {{1, 2, 3}, {5, 6, 7}, {7, 6, 5}, {8, 9, 10}};
  mesh.parts = {{"car", Part::kNoParent, 0, 3}, {"wheel", 0, 1, 2}, {"none", 0, 3, 0}};
  mesh.parts.push_back({"tree", Part::kNoParent, 3, 1});
  const Mesh back = read_glb_back(mesh);
  EXPECT_EQ(back.vertices, mesh.vertices);
  EXPECT_EQ(back.triangles, mesh.triangles);
  mesh.parts.erase(mesh.parts.begin() + 2);
  EXPECT_EQ(back.parts, mesh.parts);
}

TEST(GlbWriter, GivesPartsThatShareVerticesTheirOwn) {
  Mesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {9, 9, 9}};
  mesh.triangles = {{3, 1, 2}, {0, 1, 2}};
  mesh.parts = {{"a", Part::kNoParent, 0, 1}, {"b", Part::kNoParent, 1, 1}};
  const Mesh back = read_glb_back(mesh);
  EXPECT_EQ(corner_hash(back), corner_hash(mesh));
  EXPECT_EQ(back.parts, mesh.parts);
  EXPECT_EQ(back.vertices.size(), 6U);
}

TEST(GlbWriter, NamesTrianglesAsPartOfDoesHoweverPartsLie) {
  for_each_case("io/glb-parts", 200, [](Rng& rng) {
    Mesh mesh = random_mesh(rng, 5, 12, 1);
    for (std::uint32_t i = 0; i < rng.below(6); ++i) {
      const auto first = static_cast<std::uint32_t>(rng.below(12));
      const auto count = static_cast<std::uint32_t>(rng.below(13 - first));
      // Parents are anything, themselves and one another too.
      const auto parent =
          rng.below(2) == 0 ? Part::kNoParent : static_cast<std::uint32_t>(rng.below(i + 1));
      mesh.parts.push_back({std::to_string(i), parent, first, count});
    }
    const Mesh back = read_glb_back(mesh);
    EXPECT_EQ(corner_hash(back), corner_hash(mesh));
    for (TriangleId i = 0; i < 12; ++i) {
      const std::uint32_t wanted = part_of(mesh, i);
      std::uint32_t found = part_of(back, i);
      while (found != Part::kNoParent && back.parts[found].name.empty() &&
             back.parts[found].parent != Part::kNoParent) {
        found = back.parts[found].parent;  // triangles behind those of inner parts
      }
      EXPECT_EQ(found == Part::kNoParent ? "" : back.parts[found].name,
                wanted == Part::kNoParent ? "" : mesh.parts[wanted].name);
    }
  });
}

TEST(GlbWriter, KeepsCoordinatesFarFromTheOriginByTheMiddleOfTheMesh) {
  Rng rng(5);
  // A town of 4 km in steps of 1/256 m, 2,678 km from the origin: no float holds one of these.
  Mesh mesh = random_mesh(rng, 200, 300, 1.0 / 256);
  for (Vec3& v : mesh.vertices) {
    v = v + Vec3{2'678'219, 1'243'078, 1e8 + 1.0 / 3};
    v.z = 1e8 + 1.0 / 3;
  }
  EXPECT_EQ(count_rounded(mesh, MeshFormat::stl), 198U);  // two are in no triangle
  EXPECT_EQ(count_rounded(mesh, MeshFormat::glb), 0U);
  EXPECT_EQ(read_glb_back(mesh).vertices, mesh.vertices);
  // Near the origin doubles are rounded once, to floats.
  mesh.vertices[0] = {0.1, 0, 0};
  EXPECT_EQ(count_rounded(mesh, MeshFormat::glb), 200U);
  mesh.vertices.assign(5, {0.1, 0.25, 0});
  mesh.triangles = {{0, 1, 2}};
  mesh.vertices[1].x = -1;
  EXPECT_EQ(count_rounded(mesh, MeshFormat::glb), 4U);
  EXPECT_EQ(rounding(mesh, MeshFormat::glb).most, double{0.1F} - 0.1);
  EXPECT_EQ(read_glb_back(mesh).vertices[0].x, 0.1F);
}

TEST(GlbWriter, WritesTheSameBytesEveryTimeAndStopsOnRequest) {
  Rng rng(7);
  const Mesh mesh = random_mesh(rng, 100, 200, 0.1);
  EXPECT_EQ(as_glb(mesh), as_glb(mesh));
  std::stop_source stop;
  stop.request_stop();
  expect_refused([&] { static_cast<void>(as_glb(mesh, {.stop = stop.get_token()})); },
                 ErrorKind::cancelled, "stopped");
}

TEST(GlbWriter, RefusesWhatAFloatCannotHold) {
  Mesh mesh;
  mesh.vertices = {{0, 0, 0}, {1e39, 0, 0}, {0, std::nan(""), 0}};
  mesh.triangles = {{0, 1, 0}};
  expect_refused([&] { static_cast<void>(as_glb(mesh)); }, ErrorKind::out_of_range,
                 "out: vertex 1 has a coordinate that a float cannot hold");
  mesh.triangles = {{0, 0, 0}};
  mesh.vertices[1].x = 1;
  expect_refused([&] { static_cast<void>(as_glb(mesh)); }, ErrorKind::not_finite,
                 "vertex 2 is not finite");
}

TEST(GlbWriter, WritesAMeshWithoutTriangles) {
  Mesh mesh;
  mesh.vertices = {{1, 2, 3}};
  EXPECT_TRUE(read_glb_back(mesh).triangles.empty());
}

}  // namespace
}  // namespace soms::test
