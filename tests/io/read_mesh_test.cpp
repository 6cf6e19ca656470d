#include "soms/io/read_mesh.h"

#include "soms/base/error.h"

#include "tests/io/files.h"
#include "tests/support/allocation.h"
#include "tests/support/support.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

namespace soms::test {
namespace {

const std::string kPly =
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
    "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
    "0 0 0 1 0 0 0 1 0 3 0 1 2\n";

TEST(ReadMesh, TellsTheFormatByContentThenByName) {
  for (const std::string name : {"a.ply", "A.PLY", "a", "a.b/c", "a.dat", "model.ply.bak"}) {
    EXPECT_EQ(read_text(kPly, name).triangles.size(), 1U) << name;
  }
  EXPECT_EQ(read_text("v 0 0 0\nf 1 1 1\n", "noname").triangles.size(), 1U);
  EXPECT_EQ(read_text("OFF\n1 1 0\n0 0 0\n3 0 0 0\n", "noname").triangles.size(), 1U);
  EXPECT_EQ(read_text("\xef\xbb\xbfsolid\nendsolid\n", "noname", {.allow_empty = true}), [] {
    Mesh mesh;
    mesh.source = "noname";
    return mesh;
  }());
}

TEST(ReadMesh, RefusesANameThatContradictsTheContent) {
  expect_refused(
      kPly, "a.obj", ErrorKind::bad_file,
      "the content is PLY, but the extension says OBJ; rename it with the extension .ply");
  expect_refused("OFF\n0 0 0\n", "a.stl", ErrorKind::bad_file,
                 "the content is OFF, but the extension says STL");
}

TEST(ReadMesh, NamesWhatOtherContentIs) {
  const std::vector<std::pair<std::string, std::string>> cases = {
      {" {\"type\":", "a JSON file"},
      {"<?xml version=", "an XML file"},
      {"<?xml version=\"1.0\"?>\n<robot name=\"arm\">", "give the meshes that it names"},
      {"<!DOCTYPE html>", "a web page"},
      {"version https://git-lfs.github.com", "git lfs pull"},
      {"\x1f\x8b\x08", "a gzip file; unpack it first"},
      {"PK\x03\x04", "a zip file"},
      {"\xfd"
       "7zXZ",
       "an xz file"},
      {"\xff\xfe"
       "p",
       "UTF-16"},
      {"hello", "format \".xyz\" is not read"},
  };
  for (const auto& [content, words] : cases) {
    expect_refused(content, "a.xyz", ErrorKind::unsupported, words);
  }
  for (const std::string content : {" {\"type\":", "<?xml version=", "hello"}) {  // to be converted
    expect_refused(content, "a.xyz", ErrorKind::unsupported, "PLY, 3DS, STL, OFF, OBJ, GLB, glTF");
  }
  expect_refused("hello", "a", ErrorKind::unsupported, "no file extension");
  expect_refused("hello", "a", ErrorKind::unsupported, "and by soms-import .3d .3mf");
}

TEST(ReadMesh, NamesTextInUtf16WhateverItsFormat) {
  for (const bool big : {false, true}) {
    for (const std::string name :
         {"a.obj", "a.off", "a.ply", "a.stl", "a.dae", "a.gltf", "a.json", "a.txt", "a"}) {
      std::string text = big ? "\xfe\xff" : "\xff\xfe";
      for (const char c : std::string("v 0 0 0\n")) {
        text += big ? std::string(1, '\0') + c : c + std::string(1, '\0');
      }
      SCOPED_TRACE(name);
      expect_refused(text, name, ErrorKind::unsupported,
                     "text in UTF-16; save it as ASCII or UTF-8");
    }
  }
}

TEST(ReadMesh, PassesTheMarkOfUtf8WhateverTheFormat) {
  const std::string mark = "\xef\xbb\xbf";
  const std::string vertices = "0 0 0\n1 0 0\n0 1 0\n";
  EXPECT_EQ(read_text(mark + "OFF\n3 1 0\n" + vertices + "3 0 1 2\n", "a.off").triangles.size(),
            1U);
  EXPECT_EQ(read_text(mark + "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "a.obj").triangles.size(), 1U);
}

TEST(ReadMesh, NamesContentThatNoExtensionMakesAModel) {
  const std::string recording("\x89SOMS\r\n\x1a\x01\0\0\0", 12);
  for (const std::string name : {"run.somsrec", "run.ply", "run", "run.fbx"}) {
    expect_refused(recording, name, ErrorKind::unsupported,
                   name + ": a recording of soms simulate, not a model; play it with soms view");
    expect_refused("<html>", name, ErrorKind::unsupported, "a web page; download the model file");
  }
  for (const std::string name : {"a.3ds", "a.GLB"}) {
    expect_refused("Dear all,\r\n\tthe model\f", name, ErrorKind::bad_file,
                   "the file is text, not ");
  }
  expect_refused("MM", "a.3ds", ErrorKind::bad_file, "a.3ds, byte");
  expect_refused("glTF", "a.glb", ErrorKind::bad_file, "a.glb, byte");
}

TEST(ReadMesh, TellsStepOfMachinesFromStepOfBuildings) {
  const auto step = [](const std::string& schema) {
    return "ISO-10303-21;\nHEADER;\nFILE_SCHEMA (('" + schema + "'));\nENDSEC;\n";
  };
  for (const std::string name : {"part.step", "part.STP", "part.ifc", "part"}) {
    expect_refused(
        step("AUTOMOTIVE_DESIGN { 1 0 10303 }"), name, ErrorKind::unsupported,
        "a STEP file of the schema \"AUTOMOTIVE_DESIGN\": exact surfaces, not triangles; "
        "of STEP only IFC is read; convert it: export STL");
  }
  expect_refused(step("IFC4"), "house", ErrorKind::unsupported,
                 "rename it with the extension .ifc");
  expect_refused("ISO-10303-21;\nFILE_SCHEMA", "a", ErrorKind::unsupported, "no file extension");
}

TEST(ReadMesh, IsNeverSilentlyEmpty) {
  for (const std::string name :
       {"a.ply", "a.3ds", "a.stl", "a.off", "a.obj", "a.glb", "a.gltf", "a"}) {
    expect_refused("", name, ErrorKind::bad_file, "the file is empty");
  }
  expect_refused("v 0 0 0\n", "a.obj", ErrorKind::empty_mesh, "no triangles (1 vertices)");
  const Mesh mesh = read_text("v 0 0 0\n", "a.obj", {.allow_empty = true});
  EXPECT_EQ(mesh.vertices.size(), 1U);
  EXPECT_TRUE(mesh.triangles.empty());
}

TEST(ReadMesh, KeepsToAStatedLimitOfMemory) {
  std::string text;
  for (int i = 0; i < 10000; ++i) {
    text += "v 0 0 0\nf 1 1 1\n";
  }
  const AllocationWatch watch;
  const auto refusal =
      refusal_of([&] { static_cast<void>(read_text(text, "a.obj", {.max_memory = 200000})); });
  ASSERT_TRUE(refusal);
  EXPECT_EQ(refusal->kind, ErrorKind::out_of_memory);
  EXPECT_NE(refusal->words.find("max_memory"), std::string::npos);
  EXPECT_LE(watch.peak(), 200000U + 10000U);
  EXPECT_EQ(read_text(text, "a.obj", {.max_memory = 2000000}).triangles.size(), 10000U);
}

TEST(ReadMesh, KeepsSmallFilesWithinTheBound) {
  // What grows most for its bytes: empty groups, polygons of single bytes, tiny vertices.
  std::string groups;
  std::string faces = "v 0 0 0\n";
  for (int i = 0; i < 300000; ++i) {
    groups += "g\n";
    faces += "g\nf 1 1 1\n";
  }
  std::string polygon =
      "ply\nformat binary_little_endian 1.0\nelement vertex 1\nproperty uchar x\nproperty uchar y\n"
      "property uchar z\nelement face 1\nproperty list uint uchar vertex_indices\nend_header\n";
  polygon += std::string(3, '\0') + bytes_of(3000000, 4) + std::string(3000000, '\0');
  for (const auto& [name, text] : {std::pair<std::string, std::string>("a.obj", groups),
                                   {"b.obj", faces},
                                   {"c.ply", polygon}}) {
    SCOPED_TRACE(name);
    const AllocationWatch watch;
    static_cast<void>(refusal_of(
        [&, &n = name, &t = text] { static_cast<void>(read_text(t, n, {.allow_empty = true})); }));
    EXPECT_LE(watch.peak(), 64 * text.size() + (std::uint64_t{64} << 20));
  }
}

TEST(ReadMesh, ReportsProgressAndStopsOnRequest) {
  const std::filesystem::path path = test::data("formats/ascii.ply");
  std::vector<double> shares;
  static_cast<void>(
      read_mesh(path, {}, {.progress = [&](double share) { shares.push_back(share); }}));
  ASSERT_FALSE(shares.empty());
  EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
  EXPECT_EQ(shares.back(), 1.0);
  std::stop_source stop;
  stop.request_stop();
  expect_refused([&] { static_cast<void>(read_mesh(path, {}, {.stop = stop.get_token()})); },
                 ErrorKind::cancelled, "stopped");
}

TEST(ReadMesh, StrictMakesAnErrorOfEveryNote) {
  const std::string noted = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nl 1 2\nf 1 2\ncurv 0 1 1 2\n";
  const std::vector<std::string> notes = read_text(noted, "a.obj").notes;
  ASSERT_EQ(notes.size(), 3U);
  for (const std::string& note : notes) {
    expect_refused([&] { static_cast<void>(read_text(noted, "a.obj", {.strict = true})); },
                   ErrorKind::bad_file, note);
  }
  EXPECT_EQ(read_text(kPly, "a.ply", {.strict = true}), read_text(kPly, "a.ply"));
  for (const auto& row : rows_of("formats/FORMATS.csv", 1)) {
    if (is_read(row[0])) {
      const std::filesystem::path path = test::data("formats/" + row[0]);
      const auto refusal =
          refusal_of([&] { static_cast<void>(read_mesh(path, {.strict = true})); });
      EXPECT_EQ(!refusal, read_mesh(path).notes.empty()) << path;
    }
  }
}

TEST(ReadMesh, GivesTheSameFromAFileAndFromMemory) {
  const std::filesystem::path path = test::data("formats/polygons_le.ply");
  EXPECT_EQ(read_mesh(path), read_text(content_of(path), path.string()));
  EXPECT_EQ(read_mesh(path).source, path.string());
}

TEST(ReadMesh, LooksForFilesOfAModelNowhereWhereADescriptorNamesIt) {
  const TemporaryFolder folder;
  const std::filesystem::path model = folder.path() / "a.gltf";
  write_content(
      model,
      R"({"asset":{"version":"2.0"},"nodes":[{"mesh":0}],"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],"accessors":[{"bufferView":0,"componentType":5126,"type":"VEC3","count":3}],"bufferViews":[{"buffer":0,"byteLength":36}],"buffers":[{"byteLength":36,"uri":"shm/a.bin"}]})");
  const int input = dup(STDIN_FILENO);
  const int opened = open(model.c_str(), O_RDONLY | O_CLOEXEC);
  ASSERT_TRUE(input >= 0 && opened >= 0);
  EXPECT_EQ(dup2(opened, STDIN_FILENO), STDIN_FILENO);
  for (const std::string& name : {std::string("/dev/stdin"), "/dev/fd/" + std::to_string(opened),
                                  std::string("/proc/self/fd/0")}) {
    expect_refused([&] { static_cast<void>(read_mesh(name)); }, ErrorKind::cannot_open,
                   "cannot be found for a model from memory");
  }
  dup2(input, STDIN_FILENO);
  close(input);
  close(opened);
  expect_refused([&] { static_cast<void>(read_mesh(model)); }, ErrorKind::cannot_open,
                 "No such file");
}

/// Texts of more rows than are read between two calls that give memory back.
std::vector<std::pair<std::string, std::string>> long_texts() {
  constexpr std::size_t kRows = 150000;
  const auto rows = [](const std::string& row) {
    std::string text;
    for (std::size_t i = 0; i < kRows; ++i) {
      text += row;
    }
    return text;
  };
  const std::string count = std::to_string(kRows);
  const std::string header = "ply\nformat ascii 1.0\nelement ";
  const std::string vertices = "vertex " + count +
                               "\nproperty float x\nproperty float y\nproperty float z\n"
                               "element ";
  const std::string faces = "face " + count + "\nproperty list uchar int vertex_indices\n";
  return {
      {"a.ply", header + vertices + faces + "end_header\n" + rows("0.5 1 2\n") + rows("3 0 1 2\n")},
      {"first.ply", header + faces + "element " + vertices + "spare 0\nend_header\n" +
                        rows("3 0 1 2\r\n") + rows("0.5 1 2\r\n")},
      {"a.obj", rows("v 0.5 1 2\n") + rows("f 1 2 3\n")},
      {"a.off", "OFF\r" + count + " " + count + " 0\r" + rows("0.5 1 2\r") + rows("3 0 1 2\r")},
      {"a.stl", "solid s\n" +
                    rows("facet normal 0 0 0\nouter loop\nvertex 1 2 3\nvertex 1 2 4\n"
                         "vertex 1 3 4\nendloop\nendfacet\n") +
                    "endsolid\n"},
  };
}

// From a file, text that was passed is given back while the rest is read.
TEST(ReadMesh, GivesTheSameFromALongFileAndFromMemoryAndNamesTheSameLine) {
  const TemporaryFolder folder;
  for (const auto& [name, text] : long_texts()) {
    SCOPED_TRACE(name);
    const std::filesystem::path path = folder.path() / name;
    write_content(path, text);
    const Mesh mesh = read_mesh(path);
    EXPECT_EQ(mesh.triangles.size(), 150000U);
    EXPECT_EQ(mesh, read_text(text, path.string()));
    std::string broken = text;
    broken[broken.size() - 5] = '?';
    write_content(path, broken);
    const auto from_file = refusal_of([&] { static_cast<void>(read_mesh(path)); });
    const auto from_memory =
        refusal_of([&] { static_cast<void>(read_text(broken, path.string())); });
    ASSERT_TRUE(from_file && from_memory);
    EXPECT_EQ(from_file->words, from_memory->words);
    EXPECT_NE(from_file->words.find(", line "), std::string::npos) << from_file->words;
  }
}

}  // namespace
}  // namespace soms::test
