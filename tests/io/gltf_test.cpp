// glTF and GLB: documents made on the spot, each with one thing that matters.
#include "soms/base/error.h"
#include "soms/io/read_mesh.h"

#include "tests/io/files.h"
#include "tests/support/allocation.h"
#include "tests/support/small_stack.h"
#include "tests/support/support.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <limits>
#include <stop_token>
#include <string>
#include <vector>

namespace soms::test {
namespace {

using Triangles = std::vector<std::array<std::uint32_t, 3>>;

constexpr const char* kOneNode = R"("nodes":[{"mesh":0}])";

std::string floats(const std::vector<float>& values) {
  std::string bytes;
  for (const float value : values) {
    bytes += bytes_of(value);
  }
  return bytes;
}

/// Four corners of a square of side 1.
const std::string kSquare = floats({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0});

/// A GLB file of these members of the document, and these bytes as buffer 0.
std::string glb(const std::string& members, const std::string& binary, bool has_scene = true) {
  std::string json = R"({"asset":{"version":"2.0"},)" + members +
                     (has_scene ? R"(,"scenes":[{"nodes":[0]}])" : "") +
                     R"(,"buffers":[{"byteLength":)" + std::to_string(binary.size()) + "}]}";
  json.resize((json.size() + 3) / 4 * 4, ' ');
  const std::string chunks = bytes_of(json.size(), 4) + "JSON" + json + bytes_of(binary.size(), 4) +
                             std::string("BIN\0", 4) + binary;
  return "glTF" + bytes_of(2, 4) + bytes_of(12 + chunks.size(), 4) + chunks;
}

/// Members for a square of four positions and what draws on it; view 1 holds what follows them.
std::string square(const std::string& primitives, const std::string& accessors,
                   const std::string& nodes = kOneNode) {
  return nodes + R"(,"meshes":[{"primitives":[)" + primitives +
         R"(]}],"accessors":[{"bufferView":0,"componentType":5126,"type":"VEC3","count":4})" +
         accessors +
         R"(],"bufferViews":[{"buffer":0,"byteLength":48},{"buffer":0,"byteOffset":48,"byteLength":24}])";
}

constexpr const char* kPlain = R"({"attributes":{"POSITION":0},"indices":1})";
constexpr const char* kBytes =
    R"(,{"bufferView":1,"componentType":5121,"type":"SCALAR","count":6})";

/// A square of two triangles under these nodes.
std::string placed(const std::string& nodes, const std::string& scenes = {}) {
  const std::string members = square(kPlain, kBytes, nodes) + scenes;
  return glb(members, kSquare + std::string("\0\1\2\0\2\3", 6) + std::string(18, '\0'),
             scenes.empty());
}

/// Primitives of the square by a mode, with these indices of 16 bits.
Mesh drawn(int mode, const std::vector<std::uint16_t>& indices) {
  std::string binary = kSquare;
  for (const std::uint16_t i : indices) {
    binary += bytes_of(i, 2);
  }
  binary.resize(72, '\0');
  return read_text(
      glb(square(R"({"attributes":{"POSITION":0},"indices":1,"mode":)" + std::to_string(mode) + "}",
                 R"(,{"bufferView":1,"componentType":5123,"type":"SCALAR","count":)" +
                     std::to_string(indices.size()) + "}"),
          binary),
      "a.glb");
}

TEST(Gltf, DrawsListsStripsAndFansInTheirOrder) {
  EXPECT_EQ(drawn(4, {0, 1, 2, 0, 2, 3}).triangles, (Triangles{{0, 1, 2}, {0, 2, 3}}));
  EXPECT_EQ(drawn(5, {0, 1, 3, 2, 2}).triangles, (Triangles{{0, 1, 3}, {1, 2, 3}, {3, 2, 2}}));
  EXPECT_EQ(drawn(6, {0, 1, 2, 3}).triangles, (Triangles{{0, 1, 2}, {0, 2, 3}}));
  expect_refused(
      [] {
        static_cast<void>(drawn(4, {0, 1, 2, 0, 2}));
      },
      ErrorKind::bad_file,
      "a.glb, meshes[0].primitives[0]: 5 corners are no whole number of triangles");
  expect_refused([] { static_cast<void>(drawn(6, {0, 1})); }, ErrorKind::bad_file, "2 corners");
  expect_refused(
      [] {
        static_cast<void>(drawn(4, {0, 1, 4}));
      },
      ErrorKind::bad_file,
      "meshes[0].primitives[0].indices: index 2 is 4, but positions are 0 to 3");
}

TEST(Gltf, CountsPointsAndLinesAndPrimitivesWithoutPositions) {
  const Mesh mesh = read_text(
      glb(square(std::string(R"({"attributes":{"POSITION":0},"mode":0},)") +
                     R"({"attributes":{"POSITION":0},"mode":3},{"attributes":{}},)" + kPlain,
                 kBytes),
          kSquare + std::string(24, '\0')),
      "a.glb");
  EXPECT_EQ(mesh.triangles.size(), 2U);
  EXPECT_EQ(mesh.notes,
            (std::vector<std::string>{
                "primitives of points or lines, which are not triangles: 2, the first in "
                "meshes[0].primitives[0]",
                "primitives without positions, not read: 1, in meshes[0].primitives[2]"}));
}

TEST(Gltf, SharesPositionsThatPrimitivesOfAMeshShare) {
  const Mesh mesh = read_text(glb(square(std::string(kPlain) + "," + kPlain, kBytes),
                                  kSquare + std::string("\0\1\2\0\2\3", 6) + std::string(18, '\0')),
                              "a.glb");
  EXPECT_EQ(mesh.vertices.size(), 4U);
  EXPECT_EQ(mesh.triangles, (Triangles{{0, 1, 2}, {0, 2, 3}, {0, 1, 2}, {0, 2, 3}}));
}

TEST(Gltf, ReplacesElementsOfSparseAccessorsWithAndWithoutAView) {
  // Indices 1 and 3 at byte 48, their places at byte 52.
  const std::string binary = kSquare + std::string("\1\3\0\0", 4) + floats({9, 0, 0, 0, 9, 0});
  const auto read = [&](const std::string& view, const std::string& bytes) {
    return read_text(
        glb(std::string(kOneNode) +
                R"(,"meshes":[{"primitives":[{"attributes":{"POSITION":0},"mode":6}]}],"accessors":[{)" +
                view +
                R"("componentType":5126,"type":"VEC3","count":4,"sparse":{"count":2,"indices":{"bufferView":1,"componentType":5121},"values":{"bufferView":1,"byteOffset":4}}}],"bufferViews":[{"buffer":0,"byteLength":48},{"buffer":0,"byteOffset":48,"byteLength":28}])",
            bytes),
        "a.glb");
  };
  EXPECT_EQ(read(R"("bufferView":0,)", binary).vertices,
            (std::vector<Vec3>{{0, 0, 0}, {9, 0, 0}, {1, 1, 0}, {0, 9, 0}}));
  EXPECT_EQ(read("", binary).vertices,
            (std::vector<Vec3>{{0, 0, 0}, {9, 0, 0}, {0, 0, 0}, {0, 9, 0}}));
  std::string falling = binary;
  falling[48] = 3;
  expect_refused([&] { static_cast<void>(read("", falling)); }, ErrorKind::bad_file,
                 "accessors[0].sparse.indices: index 1 is 3; sparse indices must ascend");
}

TEST(Gltf, ReadsIntegersAsPositionsWhereTheExtensionIsNamed) {
  // Signed bytes, normalized, four bytes apart.
  const std::string binary("\x7f\0\0\0\0\x81\0\0\x80\0\x40\0", 12);
  const auto document = [&](const std::string& used) {
    return glb(
        std::string(kOneNode) + used +
            R"(,"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],"accessors":[{"bufferView":0,"componentType":5120,"normalized":true,"type":"VEC3","count":3}],"bufferViews":[{"buffer":0,"byteLength":12,"byteStride":4}])",
        binary);
  };
  const Mesh mesh =
      read_text(document(R"(,"extensionsRequired":["KHR_mesh_quantization"])"), "a.glb");
  EXPECT_EQ(mesh.vertices, (std::vector<Vec3>{{1, 0, 0}, {0, -1, 0}, {-1, 0, 64.0 / 127}}));
  expect_refused(document(""), "a.glb", ErrorKind::bad_file, "KHR_mesh_quantization");
}

TEST(Gltf, KeepsNodesAsPartsThatNest) {
  const Mesh mesh = read_text(placed(R"("nodes":[{"name":"car","children":[1,2,3]},)"
                                     R"({"name":"left","mesh":0},{"name":"lamp"},{"children":[4]},)"
                                     R"({"mesh":0,"translation":[10,0,0]}])"),
                              "a.glb");
  EXPECT_EQ(mesh.parts,
            (std::vector<Part>{{"car", Part::kNoParent, 0, 4}, {"left", 0, 0, 2}, {"", 0, 2, 2}}));
  EXPECT_EQ(mesh.vertices[4], (Vec3{10, 0, 0}));
  EXPECT_EQ(mesh.unit, 1.0);
  EXPECT_EQ(mesh.up, UpAxis::y);
}

TEST(Gltf, AppliesScaleThenRotationThenTranslationFromTheInsideOut) {
  const std::string half = "0.7071067811865476";
  const Mesh mesh =
      read_text(placed(R"("nodes":[{"children":[1],"matrix":[0,1,0,0,-1,0,0,0,0,0,1,0,100,0,0,1]},)"
                       R"({"mesh":0,"translation":[5,0,0],"scale":[2,3,4],"rotation":[0,0,)" +
                       half + "," + half + "]}]"),
                "a.glb");
  // (1, 1, 0) becomes (2, 3, 0), turned (-3, 2, 0), shifted (2, 2, 0), turned and shifted again.
  EXPECT_NEAR(mesh.vertices[2].x, 98, 1e-12);
  EXPECT_NEAR(mesh.vertices[2].y, 2, 1e-12);
  expect_refused(placed(R"("nodes":[{"mesh":0,"rotation":[0,0,0,2]}])"), "a.glb",
                 ErrorKind::bad_file, "nodes[0].rotation: the quaternion does not have length 1");
  expect_refused(placed(R"("nodes":[{"mesh":0,"matrix":[1,0,0,1,0,1,0,0,0,0,1,0,0,0,0,1]}])"),
                 "a.glb", ErrorKind::bad_file, "nodes[0].matrix: the last row");
}

TEST(Gltf, TurnsTrianglesOfNodesThatMirror) {
  EXPECT_EQ(read_text(placed(R"("nodes":[{"mesh":0,"scale":[1,-1e-200,1]}])"), "a.glb").triangles,
            (Triangles{{0, 2, 1}, {0, 3, 2}}));
  EXPECT_EQ(read_text(placed(R"("nodes":[{"mesh":0,"scale":[1,-1,-1]}])"), "a.glb").triangles,
            (Triangles{{0, 1, 2}, {0, 2, 3}}));
}

TEST(Gltf, ReadsTheDefaultSceneAndSaysWhichWasRead) {
  const std::string nodes = R"("nodes":[{"mesh":0},{"mesh":0,"translation":[7,0,0]}])";
  const std::string scenes = R"(,"scenes":[{"nodes":[0]},{"nodes":[1]}])";
  const Mesh second = read_text(placed(nodes, scenes + R"(,"scene":1)"), "a.glb");
  EXPECT_EQ(second.vertices[0].x, 7);
  EXPECT_EQ(second.notes[0], "the file has 2 scenes; only scene 1, the default, was read");
  const Mesh first = read_text(placed(nodes, scenes), "a.glb");
  EXPECT_EQ(first.vertices[0].x, 0);
  EXPECT_EQ(first.notes[0],
            "the file has 2 scenes; only scene 0 was read, because none is the default");
  const Mesh all = read_text(placed(nodes, R"(,"scenes":[])"), "a.glb");
  EXPECT_EQ(all.triangles.size(), 4U);
  EXPECT_EQ(all.notes[0], "the file has no scene: all nodes were read");
}

/// The mesh of a node that no scene reaches may be shown by another node.
TEST(Gltf, NotesNodesWithMeshesThatNoSceneReaches) {
  const Mesh mesh = read_text(
      placed(R"("nodes":[{"mesh":0},{"name":"empty"},{"children":[3]},{"mesh":0},{"mesh":0}])"),
      "a.glb");
  EXPECT_EQ(mesh.triangles.size(), 2U);
  EXPECT_EQ(mesh.notes,
            (std::vector<std::string>{
                "nodes with a mesh that are not in the scene: 2, the first at nodes[3]"}));
}

TEST(Gltf, CountsAndPlacesAnimations) {
  const Mesh mesh = read_text(placed(std::string(kOneNode) + R"(,"animations":[{},{}])"), "a.glb");
  EXPECT_EQ(mesh.notes,
            (std::vector<std::string>{"animations, not applied: 2, the first at animations[0]"}));
}

TEST(Gltf, RefusesNodesThatAreNoTrees) {
  const auto refuse = [](const std::string& nodes, const std::string& words,
                         const std::string& scenes = {}) {
    expect_refused(placed(nodes, scenes), "a.glb", ErrorKind::bad_file, words);
  };
  refuse(R"("nodes":[{"children":[1,2]},{"children":[2]},{"mesh":0}])", "is a child of nodes[0]");
  refuse(R"("nodes":[{"children":[1]},{"mesh":0,"children":[0]}])", "scenes[0].nodes[0]");
  refuse(R"("nodes":[{"mesh":0}])", "listed twice", R"(,"scenes":[{"nodes":[0,0]}])");
  refuse(R"("nodes":[{"mesh":0},{"children":[1]}])", "form a cycle", R"(,"scenes":[])");
}

TEST(Gltf, NeedsLittleStackForDeepNodesAndJson) {
  std::string nodes = R"("nodes":[)";
  for (int i = 1; i <= 20'000; ++i) {
    nodes += R"({"children":[)" + std::to_string(i) + "]},";
  }
  const std::string chain = placed(nodes + R"({"mesh":0}])");
  const std::string deep = "{\"asset\":[\"[[\\\"\",[]],\n\"b\":" + std::string(100'000, '[');
  on_small_stack([&] {
    EXPECT_EQ(read_text(chain, "a.glb").triangles.size(), 2U);
    expect_refused(deep, "a.gltf", ErrorKind::bad_file,
                   "line 2: JSON is nested more than 128 levels deep");
  });
}

TEST(Gltf, CountsABombOfInstancesBeforeItTakesMemory) {
  // 3000 nodes of a mesh of a million triangles, whose indices stand nowhere: zeros.
  std::string children;
  std::string nodes;
  for (int i = 1; i <= 3000; ++i) {
    children.append(i > 1 ? "," : "").append(std::to_string(i));
    nodes += R"(,{"mesh":0})";
  }
  const std::string bomb =
      glb(square(kPlain, R"(,{"componentType":5121,"type":"SCALAR","count":3000000})",
                 R"("nodes":[{"children":[)" + children + "]}" + nodes + "]"),
          kSquare + std::string(24, '\0'));
  const AllocationWatch watch;
  expect_refused(bomb, "a.glb", ErrorKind::out_of_range, "more than 2^31 - 1");
  EXPECT_LT(watch.peak(), std::uint64_t{64} << 20);
  const std::string half =
      glb(square(kPlain, R"(,{"componentType":5121,"type":"SCALAR","count":300000000})"),
          kSquare + std::string(24, '\0'));
  expect_refused(half, "a.glb", ErrorKind::out_of_memory, "max_memory");
  EXPECT_LT(watch.peak(), std::uint64_t{64} << 20);
}

TEST(Gltf, KeepsJsonOfManySmallValuesWithinItsMemory) {
  for (const std::string item : {"0,", "[],", "{},", R"({"a":0},)", R"("",)", R"({"":{}},)"}) {
    SCOPED_TRACE(item);
    std::string text = R"({"asset":{"version":"2.0"},"extras":[)";
    while (text.size() < 300'000) {
      text += item;
    }
    text += "0]}";
    const AllocationWatch watch;
    expect_refused(text, "a.gltf", ErrorKind::empty_mesh, "no triangles");
    EXPECT_LE(watch.peak(), 64 * text.size());
    expect_refused(
        [&] { static_cast<void>(read_text(text, "a.gltf", {.max_memory = 7 * text.size()})); },
        ErrorKind::out_of_memory, "max_memory");
  }
}

TEST(Gltf, NamesTheLineOrByteWhereJsonEnds) {
  expect_refused("{\"asset\":\n\n  }", "a.gltf", ErrorKind::bad_file, "a.gltf, line 3");
  expect_refused("{\"asset\":{\"version\":\"2.0\"},\n\"scene\":1e999}", "a.gltf",
                 ErrorKind::not_finite, "line 2: a number is too large");
  expect_refused(R"({"asset":{"version":"2.0","version":"2.0"}})", "a.gltf", ErrorKind::bad_file,
                 "asset.version: this name occurs twice");
  expect_refused(glb("#", ""), "a.glb", ErrorKind::bad_file, "byte 47");
}

TEST(Gltf, OpensFilesOfItsFolderOnly) {
  const TemporaryFolder outer;
  const std::filesystem::path folder = outer.path() / "model";
  std::filesystem::create_directories(folder / "deeper");
  const auto read = [&](const std::string& uri) {
    const std::string text =
        R"({"asset":{"version":"2.0"},"nodes":[{"mesh":0}],"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],"accessors":[{"bufferView":0,"componentType":5126,"type":"VEC3","count":3}],"bufferViews":[{"buffer":0,"byteLength":36}],"buffers":[{"byteLength":36,"uri":")" +
        uri + R"("},{"byteLength":1,"uri":"not needed.bin"}]})";
    write_content(folder / "a.gltf", text);
    return read_mesh(folder / "a.gltf").triangles.size();
  };
  write_content(outer.path() / "out.bin", kSquare);
  write_content(folder / "deeper" / "a b.bin", kSquare);
  std::filesystem::create_symlink("deeper/a b.bin", folder / "inside.bin");
  std::filesystem::create_symlink("../out.bin", folder / "outside.bin");
  EXPECT_EQ(read("deeper/a%20b.bin"), 1U);
  EXPECT_EQ(read("./deeper/a b.bin"), 1U);
  EXPECT_EQ(read("inside.bin"), 1U);
  const auto refuse = [&](const std::string& uri, ErrorKind kind, const std::string& words) {
    expect_refused([&] { read(uri); }, kind, words);
  };
  refuse("outside.bin", ErrorKind::bad_file, "buffers[0].uri: \"outside.bin\" is a link out of");
  refuse("../out.bin", ErrorKind::bad_file, "outside the folder");
  refuse("deeper/%2e%2e/../out.bin", ErrorKind::bad_file, "outside the folder");
  refuse((outer.path() / "out.bin").string(), ErrorKind::bad_file, "outside the folder");
  refuse("FILE:out.bin", ErrorKind::unsupported, "not a file in the folder");
  refuse("deeper", ErrorKind::cannot_open, "not a regular file");
  refuse("missing.bin", ErrorKind::cannot_open, "No such file");
  expect_refused(content_of(folder / "a.gltf"), (folder / "a.gltf").string(),
                 ErrorKind::cannot_open, "cannot be found for a model from memory");
}

TEST(Gltf, CountsFilesBesideItTowardsTheMemoryThatItMayTake) {
  const TemporaryFolder folder;
  constexpr std::size_t kCorners = 1'800'000;  // more than 64 MiB and 64 times the text
  write_content(folder.path() / "a.bin", "");
  std::filesystem::resize_file(folder.path() / "a.bin", 12 * kCorners);
  write_content(
      folder.path() / "a.gltf",
      R"({"asset":{"version":"2.0"},"nodes":[{"mesh":0}],"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],"accessors":[{"bufferView":0,"componentType":5126,"type":"VEC3","count":1800000}],"bufferViews":[{"buffer":0,"byteLength":21600000}],"buffers":[{"byteLength":21600000,"uri":"a.bin"}]})");
  EXPECT_EQ(read_mesh(folder.path() / "a.gltf").triangles.size(), kCorners / 3);
  expect_refused(
      [&] { static_cast<void>(read_mesh(folder.path() / "a.gltf", {.max_memory = 60'000'000})); },
      ErrorKind::out_of_memory, "max_memory");
  std::stop_source stop;
  const auto begun = [&](double share) { EXPECT_TRUE(share >= 0 && stop.request_stop()); };
  expect_refused(
      [&] {
        static_cast<void>(
            read_mesh(folder.path() / "a.gltf", {}, {.stop = stop.get_token(), .progress = begun}));
      },
      ErrorKind::cancelled, "stopped");
}

TEST(Gltf, RefusesExtensionsThatChangeWhatIsThere) {
  const auto with = [](const std::string& members) {
    return glb(square(kPlain, kBytes) + members, kSquare + std::string(24, '\0'));
  };
  EXPECT_EQ(
      read_text(with(R"(,"extensionsRequired":["KHR_materials_unlit"])"), "a.glb").triangles.size(),
      2U);
  expect_refused(with(R"(,"extensionsRequired":["EXT_meshopt_compression"])"), "a.glb",
                 ErrorKind::unsupported, "extensionsRequired[0]: the extension \"EXT_meshopt");
  expect_refused(placed(R"("nodes":[{"mesh":0,"extensions":{"EXT_mesh_gpu_instancing":{}}}])"),
                 "a.glb", ErrorKind::unsupported, "nodes[0]: the extension \"EXT_mesh_gpu");
  // Compressed positions that nothing requires to be unpacked would read as zeros.
  expect_refused(
      glb(std::string(kOneNode) +
              R"(,"meshes":[{"primitives":[{"attributes":{"POSITION":0},"extensions":{"KHR_draco_mesh_compression":{}}}]}],"accessors":[{"componentType":5126,"type":"VEC3","count":3}])",
          ""),
      "a.glb", ErrorKind::unsupported, "KHR_draco_mesh_compression");
}

TEST(Gltf, RefusesNumbersThatStandNowhereWhereAnExtensionMaySayWhere) {
  const auto with = [](const std::string& primitive, const std::string& indices) {
    return glb(square(R"({"attributes":{"POSITION":0},"indices":1)" + primitive + "}",
                      R"(,{"componentType":5121,"type":"SCALAR","count":6)" + indices + "}"),
               kSquare + std::string("\1\2\0\2", 4) + std::string(20, '\0'));
  };
  const auto refuse = [](const std::string& text, const std::string& words) {
    expect_refused(text, "a.glb", ErrorKind::unsupported, words);
  };
  const std::string draco = R"(,"extensions":{"A":{},"KHR_draco_mesh_compression":{}})";
  const std::string other = R"(,"extensions":{"EXT_other_compression":{}})";
  const std::string view = R"(,"bufferView":1)";
  const std::string sparse =
      R"(,"sparse":{"count":2,"indices":{"bufferView":1,"componentType":5121},"values":{"bufferView":1,"byteOffset":2}})";
  refuse(with(draco, ""), "meshes[0].primitives[0]: the extension \"KHR_draco_mesh_compression\"");
  refuse(with(draco, sparse), "KHR_draco_mesh_compression");
  refuse(with(other, ""), "meshes[0].primitives[0]: the extension \"EXT_other_compression\"");
  refuse(with("", other), "accessors[1]: the extension \"EXT_other_compression\"");
  for (const std::string& good : {with(draco, view), with(other, view), with(other, sparse),
                                  with(R"(,"extensions":{})", ""), with("", "")}) {
    EXPECT_EQ(read_text(good, "a.glb").triangles.size(), 2U);
  }
}

TEST(Gltf, LeavesSkinsWhereTheirPositionsAre) {
  const Mesh mesh = read_text(
      placed(
          R"("nodes":[{"mesh":0,"skin":0,"scale":[-1,1,1],"translation":[5,0,0],"children":[1]},)"
          R"({"mesh":0}],"skins":[{"joints":[1]}])"),
      "a.glb");
  // The node's transform is none of the skin's, but still that of the nodes within it.
  EXPECT_EQ(mesh.vertices[1], (Vec3{1, 0, 0}));
  EXPECT_EQ(mesh.vertices[5], (Vec3{4, 0, 0}));
  EXPECT_EQ(mesh.triangles, (Triangles{{0, 1, 2}, {0, 2, 3}, {4, 6, 5}, {4, 7, 6}}));
  EXPECT_EQ(mesh.notes,
            (std::vector<std::string>{"skins read in their bind shape, not posed by their "
                                      "joints: 1, in nodes[0]"}));
}

TEST(Gltf, NotesChunksThatItDoesNotKnowAndBytesBehindThem) {
  std::string file = placed(kOneNode);
  const std::string more = bytes_of(4, 4) + "MORE" + "1234";
  file += more;
  file.replace(8, 4, bytes_of(file.size(), 4));
  const std::string at = std::to_string(file.size() - more.size());
  const std::string end = std::to_string(file.size());
  std::vector<std::string> notes = {"chunks other than JSON and BIN, not read: 1, at byte " + at};
  EXPECT_EQ(read_text(file, "a").notes, notes);
  file += "behind its end";
  const Mesh mesh = read_text(file, "a");
  EXPECT_EQ(mesh.triangles.size(), 2U);
  notes.push_back("surplus bytes after the stated length of the file: 14, the first at byte " +
                  end);
  EXPECT_EQ(mesh.notes, notes);
}

/// Of a node that KHR_node_visibility hides or shows.
std::string visible(const char* value) {
  return std::string(R"("extensions":{"KHR_node_visibility":{"visible":)") + value + "}}";
}

TEST(Gltf, ReadsHiddenNodesAndSaysSo) {
  const std::vector<std::string> note{
      "nodes with a mesh that the file hides (KHR_node_visibility), read all the same: 1, in "
      "nodes[0]"};
  const Mesh hidden = read_mesh(data("reports/hidden.gltf"));
  EXPECT_EQ(hidden.triangles.size(), 12U);
  EXPECT_EQ(hidden.notes, note);
  expect_refused(
      [] { static_cast<void>(read_mesh(data("reports/hidden.gltf"), {.strict = true})); },
      ErrorKind::bad_file, "that the file hides");
  // A node that hides itself hides all within it, even those that say they are visible.
  const auto notes_of = [](const std::string& outer, const std::string& inner) {
    return read_text(
               placed(R"("nodes":[{"children":[1],)" + visible(outer.c_str()) +
                      R"(},{"mesh":0,"children":[2]},{"mesh":0,)" + visible(inner.c_str()) + "}]"),
               "a.glb")
        .notes;
  };
  EXPECT_EQ(notes_of("false", "true"),
            (std::vector<std::string>{"nodes with a mesh that the file hides "
                                      "(KHR_node_visibility), read all the same: 2, the first in "
                                      "nodes[1]"}));
  EXPECT_EQ(notes_of("true", "false").size(), 1U);
  EXPECT_TRUE(notes_of("true", "true").empty());
  expect_refused(placed(R"("nodes":[{"mesh":0,)" + visible("1") + "}]"), "a.glb",
                 ErrorKind::bad_file, "visible");
  // It changes no shape, so that a file may require it.
  EXPECT_EQ(
      read_text(placed(R"("extensionsRequired":["KHR_node_visibility"],)" + std::string(kOneNode)),
                "a.glb")
          .triangles.size(),
      2U);
}

TEST(Gltf, SaysOfAnExtensionWhetherItIsRequiredOrUsed) {
  const std::string instanced =
      R"("nodes":[{"mesh":0,"extensions":{"EXT_mesh_gpu_instancing":{}}}])";
  expect_refused(placed(R"("extensionsUsed":["EXT_mesh_gpu_instancing"],)" + instanced), "a.glb",
                 ErrorKind::unsupported,
                 "nodes[0]: the extension \"EXT_mesh_gpu_instancing\" is used here and changes the "
                 "geometry, but is not supported");
  expect_refused(placed(R"("extensionsRequired":["EXT_mesh_gpu_instancing"],)" + instanced),
                 "a.glb", ErrorKind::unsupported,
                 "extensionsRequired[0]: the extension \"EXT_mesh_gpu_instancing\" is required");
}

}  // namespace
}  // namespace soms::test
