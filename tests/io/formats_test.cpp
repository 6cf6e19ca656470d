#include "soms/io/formats.h"

#include "soms/io/read_mesh.h"
#include "soms/io/write_mesh.h"

#include "tests/io/files.h"
#include "tests/support/support.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <sstream>
#include <string>

namespace soms::test {
namespace {

TEST(Formats, SayOfEachWayToWriteWhatItKeeps) {
  Mesh mesh;
  mesh.vertices = {{0.1, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.triangles = {{0, 1, 2}};
  mesh.parts = {{"roof", Part::kNoParent, 0, 1}};
  mesh.unit = 0.5;
  mesh.up = UpAxis::x;
  for (const WritableFormat& row : writable_formats()) {
    SCOPED_TRACE(row.name);
    EXPECT_EQ(&entry(row.format), &row);
    std::ostringstream out;
    write_mesh(out, "out", mesh, row.format);
    const Mesh back = read_text(out.str(), "back");
    EXPECT_EQ(back.triangle(0).a.x == 0.1, row.doubles);
    EXPECT_EQ(rounding(mesh, row.format).count, row.doubles ? 0U : 1U);
    EXPECT_EQ(back.parts.size() == 1 && back.parts[0].name == "roof", row.names);
    EXPECT_EQ(back.unit == 0.5 && back.up == UpAxis::x, row.unit_and_axis);
  }
}

TEST(Formats, KnowTheModelsOfAFolder) {
  const TemporaryFolder folder;
  const auto is_model = [&](const std::string& name, const std::string& content) {
    write_content(folder.path() / name, content);
    return is_model_of_folder(folder.path() / name);
  };
  for (const char* const name : {"a.obj", "cube (1).OBJ", "a.glb", "a.b.stl", "a.fbx"}) {
    EXPECT_TRUE(is_model(name, "broken")) << name;
  }
  for (const char* const name :
       {"._a.obj", ".obj", ".DS_Store", "a.obj~", "a.obj.bak", "obj", "a.txt", "a.mtl", "a.csv"}) {
    EXPECT_FALSE(is_model(name, "v 0 0 0\n")) << name;
  }
  EXPECT_FALSE(is_model("notes.json", "{\"a\":1}"));
  EXPECT_FALSE(is_model("empty.json", ""));
  EXPECT_FALSE(is_model("rows.jsonl", "{\"schema\":\"soms.clash/1\"}\n"));
  EXPECT_TRUE(is_model("city.json", "{\"type\": \"CityJSON\", "));
  EXPECT_TRUE(is_model("city.jsonl", "{\"type\":\"CityJSON\"}\n{\"type\":\"CityJSONFeature\"}\n"));
  EXPECT_TRUE(
      is_model("tileset.json", R"({"asset":{"version":"1.1"},"geometricError":1,"root":{}})"));
}

TEST(Formats, AreListedInWords) {
  EXPECT_EQ(writable_names(), "PLY, 3DS, STL, OFF, OBJ or GLB");
  EXPECT_EQ(writable_extensions(), ".ply, .3ds, .stl, .off, .obj or .glb");
  EXPECT_TRUE(std::is_sorted(imported_extensions().begin(), imported_extensions().end()));
  EXPECT_EQ(readable_formats().at(0).extension, ".ply");
}

/// A page of the manual; empty where it cannot be read.
std::string page(const std::string& name) {
  return content_of(test::data("../../docs/" + name).lexically_normal());
}

TEST(Formats, StandOnTheirPage) {
  const std::string formats = page("formats.md");
  const std::string convert = page("convert.md");
  ASSERT_FALSE(formats.empty());
  for (const ReadableFormat& format : readable_formats()) {
    const std::string row =
        "| " + std::string(format.name) + " | `" + std::string(format.extension);
    EXPECT_NE(formats.find(row + "` |"), std::string::npos) << row;
  }
  std::string imported;
  for (const std::string_view extension : imported_extensions()) {
    imported.append(imported.empty() ? "" : " ").append(extension);
  }
  std::string on_page = formats;
  std::replace(on_page.begin(), on_page.end(), '\n', ' ');
  EXPECT_NE(on_page.find("`" + imported + "`"), std::string::npos) << imported;
  for (const WritableFormat& row : writable_formats()) {
    std::string text = "| ";
    text.append(row.title).append(" | `").append(row.name).append("` | ");
    text.append(row.doubles ? "every bit" : "floats").append(" | ");
    const bool cuts_names = row.format == MeshFormat::three_ds;
    text.append(!row.names ? "no" : cuts_names ? "10 characters" : "yes");
    text.append(row.unit_and_axis ? " | yes |" : " | no |");
    EXPECT_NE(convert.find(text), std::string::npos) << text;
  }
}

}  // namespace
}  // namespace soms::test
