// Small files that state something once and use it many thousand times: reading them must not take
// the time or the memory of what they would unfold to.
#include "soms/base/error.h"
#include "soms/io/read_mesh.h"

#include "tests/io/files.h"
#include "tests/support/effort.h"
#include "tests/support/support.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

namespace soms::test {
namespace {

std::string repeated(const std::string& text, int times) {
  std::string all;
  for (int i = 0; i < times; ++i) {
    all += text;
  }
  return all;
}

/// A list of so many elements, each with its number in place of #.
std::string json_list(const std::string& element, int count) {
  std::string list = "[";
  for (int i = 0; i < count; ++i) {
    std::string one = element;
    for (std::size_t at = one.find('#'); at != one.npos; at = one.find('#')) {
      one.replace(at, 1, std::to_string(i));
    }
    list += (i > 0 ? "," : "") + one;
  }
  return list + "]";
}

TEST(CostlyFiles, AFileThatManyBuffersNameIsReadAndCountedOnce) {
  constexpr int kBuffers = 100;
  const TemporaryFolder folder;
  write_content(folder.path() / "b0.bin", "");
  std::filesystem::resize_file(folder.path() / "b0.bin", std::size_t{1} << 20);
  for (int i = 1; i < kBuffers; ++i) {  // names and links of one file
    const std::filesystem::path link = folder.path() / ("b" + std::to_string(i) + ".bin");
    if (i % 2 == 0) {
      std::filesystem::create_hard_link(folder.path() / "b0.bin", link);
    } else {
      std::filesystem::create_symlink("b0.bin", link);
    }
  }
  write_content(
      folder.path() / "a.gltf",
      R"({"asset":{"version":"2.0"},"nodes":[{"mesh":0}],"meshes":[{"primitives":)" +
          json_list(R"({"attributes":{"POSITION":#}})", kBuffers) + R"(}],"accessors":)" +
          json_list(R"({"bufferView":#,"componentType":5126,"type":"VEC3","count":3})", kBuffers) +
          R"(,"bufferViews":)" + json_list(R"({"buffer":#,"byteLength":36})", kBuffers) +
          R"(,"buffers":)" + json_list(R"({"uri":"b#.bin","byteLength":36})", kBuffers) + "}");
  EXPECT_EQ(read_mesh(folder.path() / "a.gltf", {.max_memory = 4 << 20}).triangles.size(),
            std::size_t{kBuffers});
}

TEST(CostlyFiles, ALongNameOfAMeshIsNotCopiedForEveryNode) {
  const std::string text = R"({"asset":{"version":"2.0"},"meshes":[{"primitives":[],"name":")" +
                           std::string(100'000, 'n') + R"("}],"nodes":)" +
                           json_list(R"({"mesh":0})", 10'000) + "}";
  expect_refused(text, "a.gltf", ErrorKind::out_of_memory, "max_memory");
}

/// A scene that shows node a so many times, and this library before it.
std::string shown_often(const std::string& library, int times) {
  return "<COLLADA>" + library + "<library_visual_scenes><visual_scene id=\"s\"><node>" +
         repeated("<instance_node url=\"#a\"/>", times) +
         "</node></visual_scene></library_visual_scenes></COLLADA>";
}

TEST(CostlyFiles, ALongNameOfANodeIsNotCopiedForEveryInstance) {
  const std::string name(10'000, 'n');
  expect_refused(
      shown_often("<library_nodes><node id=\"a\" name=\"" + name + "\"/></library_nodes>", 30'000),
      "a.dae", ErrorKind::out_of_memory, "max_memory");
}

TEST(CostlyFiles, WhatAnInstanceIsMadeOfCountsByItsBytes) {
  const std::string matrix = "1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1" + std::string(50'000, ' ');
  const auto refuse = [](const std::string& library) {
    expect_refused(shown_often(library, 5'000), "a.dae", ErrorKind::out_of_range, "too large");
  };
  refuse("<library_nodes><node id=\"a\"><matrix>" + matrix + "</matrix></node></library_nodes>");
  refuse("<library_nodes><node id=\"a\"><scale" + repeated(" a=\"\"", 10'000) +
         ">1 1 1</scale></node></library_nodes>");
  const std::string geometry =
      "<library_geometries><geometry id=\"g\"/></library_geometries><library_nodes><node "
      "id=\"a\"><instance_controller url=\"#c\"/></node></library_nodes><library_controllers>"
      "<controller id=\"c\">";
  refuse(geometry + "<skin source=\"#g\"><bind_shape_matrix>" + matrix +
         "</bind_shape_matrix></skin></controller></library_controllers>");
  refuse(geometry + repeated("<a/>", 10'000) +
         "<skin source=\"#g\"/></controller></library_controllers>");
}

TEST(CostlyFiles, ManyListsOfFacesAreNotEachSearchedForTheirVertices) {
  constexpr int kLists = 60'000;
  const std::string text =
      R"(<COLLADA><library_geometries><geometry id="g"><mesh><source id="p">
    <float_array id="a" count="9">0 0 0 1 0 0 1 1 0</float_array><technique_common>
    <accessor source="#a" count="3" stride="3"><param name="X"/><param name="Y"/><param name="Z"/>
    </accessor></technique_common></source>
    <vertices id="v"><input semantic="POSITION" source="#p"/></vertices>)" +
      repeated(R"(<triangles><input semantic="VERTEX" source="#v" offset="0"/></triangles>)",
               kLists) +
      "</mesh></geometry></library_geometries></COLLADA>";
  const double effort = effort_of(
      [&] { expect_refused(text, "a.dae", ErrorKind::empty_mesh, "no triangles (3 vertices"); });
  EXPECT_LT(effort, 20);
}

}  // namespace
}  // namespace soms::test
