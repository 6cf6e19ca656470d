// Batched models and composites of 3D Tiles, and features of glTF: files made on the spot.
#include "soms/io/read_mesh.h"

#include "tests/io/files.h"
#include "tests/io/tile_files.h"
#include "tests/support/support.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace soms::test {
namespace {

Mesh read_b3dm(const std::string& bytes) {
  return read_text(bytes, "a.b3dm");
}

TEST(B3dm, HasAPartForEachBatch) {
  const Mesh mesh = read_b3dm(b3dm_of(
      {1, 1, 0}, 3,
      R"({"gml:id":["k0","k1","k2"],"Name":["barn",null,"shed"],"class":["farm","farm",""],"height":[7,8.5,1]})"));
  ASSERT_EQ(mesh.triangles.size(), 3U);
  ASSERT_EQ(mesh.parts.size(), 2U);  // nothing is of batch 2
  EXPECT_EQ(mesh.parts[0].name, "k1");
  EXPECT_EQ(mesh.parts[0].id, "k1");
  EXPECT_EQ(mesh.parts[0].type, "farm");
  EXPECT_EQ(mesh.parts[0].count, 2U);
  EXPECT_EQ(mesh.parts[1].name, "barn");
  EXPECT_EQ(mesh.parts[1].id, "k0");
  EXPECT_EQ(mesh.parts[1].attributes,
            (std::vector<Attribute>{
                {"Name", "barn"}, {"class", "farm"}, {"gml:id", "k0"}, {"height", "7"}}));
  EXPECT_EQ(mesh.unit, 1);
  EXPECT_EQ(mesh.up, UpAxis::z);
  EXPECT_TRUE(mesh.notes.empty());
}

TEST(B3dm, ContinuesBatchesThatAreInterrupted) {
  const Mesh mesh = read_b3dm(b3dm_of({4, 2, 4, 4, 2}, 5));
  ASSERT_EQ(mesh.parts.size(), 4U);
  EXPECT_EQ(mesh.parts[0].id, "4");
  EXPECT_EQ(mesh.parts[1].name, "2");
  EXPECT_EQ(mesh.parts[2].continues, 0U);
  EXPECT_EQ(mesh.parts[2].count, 2U);
  EXPECT_EQ(mesh.parts[3].continues, 1U);
  EXPECT_EQ(part_of(mesh, 3), 0U);
  EXPECT_EQ(part_of(mesh, 4), 1U);
}

TEST(B3dm, TurnsItsGltfToZUpAndAddsItsCenterInDouble) {
  const Mesh mesh =
      read_b3dm(b3dm_of({0}, 1, {}, R"(,"RTC_CENTER":[1215107.7,-4736682.9,4081926.1])"));
  ASSERT_EQ(mesh.vertices.size(), 3U);
  EXPECT_EQ(mesh.vertices[0], (Vec3{1215107.7, -4736682.9, 4081926.1}));
  EXPECT_EQ(mesh.vertices[1], (Vec3{1215107.7 + 1, -4736682.9, 4081926.1}));
  EXPECT_EQ(mesh.vertices[2], (Vec3{1215107.7, -4736682.9, 4081926.1 + 1}));  // y was up
  EXPECT_EQ(mesh.up, UpAxis::unknown);  // in Earth-centered coordinates no axis is
}

TEST(B3dm, ReadsCentersOfFloatsAndLengthsAmongTheNumbers) {
  const Mesh mesh = read_b3dm(b3dm_of(
      {.feature_json = R"({"BATCH_LENGTH":{"byteOffset":0},"RTC_CENTER":{"byteOffset":4}})",
       .feature_numbers = bytes_of(1, 4) + bytes_of(10.0F) + bytes_of(20.0F) + bytes_of(30.0F),
       .glb = numbered_glb({0})}));
  EXPECT_EQ(mesh.vertices[0], (Vec3{10, 20, 30}));
  EXPECT_EQ(mesh.parts.size(), 1U);
}

TEST(B3dm, AddsTheCenterThatItsGltfStates) {
  const Mesh mesh = read_b3dm(b3dm_of(
      {.glb = numbered_glb(
           {0}, "_BATCHID", {},
           R"(,"extensionsRequired":["CESIUM_RTC"],"extensions":{"CESIUM_RTC":{"center":[100,200,300]}})")}));
  EXPECT_EQ(mesh.vertices[2], (Vec3{100, 200, 301}));
}

TEST(B3dm, KeepsNumbersOfItsBinaryTable) {
  const std::string json =
      R"({"a":{"byteOffset":0,"componentType":"DOUBLE","type":"SCALAR"},)"
      R"("b":{"byteOffset":16,"componentType":"SHORT","type":"VEC2"},)"
      R"("id":{"byteOffset":24,"componentType":"UNSIGNED_INT","type":"SCALAR"}})";
  const Mesh mesh =
      read_b3dm(b3dm_of({.batch_json = json,
                         .batch_numbers = bytes_of(0.1) + bytes_of(-7.25) + bytes_of(65535, 2) +
                                          bytes_of(3, 2) + bytes_of(32768, 2) + bytes_of(9, 2) +
                                          bytes_of(4000000000, 4) + bytes_of(5, 4),
                         .glb = numbered_glb({0, 1})}));
  ASSERT_EQ(mesh.parts.size(), 2U);
  EXPECT_EQ(mesh.parts[0].id, "4000000000");
  EXPECT_EQ(mesh.parts[0].attributes,
            (std::vector<Attribute>{{"a", "0.1"}, {"b", "[-1,3]"}, {"id", "4000000000"}}));
  EXPECT_EQ(mesh.parts[1].attributes,
            (std::vector<Attribute>{{"a", "-7.25"}, {"b", "[-32768,9]"}, {"id", "5"}}));
}

TEST(B3dm, HasNodesAsPartsWhereNothingIsBatched) {
  const std::string glb = numbered_glb({0, 0}, "_OTHER");
  EXPECT_TRUE(
      read_b3dm(b3dm_of({.feature_json = R"({"BATCH_LENGTH":0})", .glb = glb})).parts.empty());
  const Mesh noted = read_b3dm(b3dm_of({.glb = glb}));
  ASSERT_EQ(noted.notes.size(), 1U);
  EXPECT_NE(noted.notes[0].find("primitives without batch ids"), std::string::npos);
  EXPECT_EQ(noted.triangles.size(), 2U);
}

TEST(B3dm, PutsNoTriangleBetweenBatchesIntoAny) {
  std::string glb = numbered_glb({0, 1, 1});
  // The last number of the second triangle.
  glb.replace(glb.size() - 16, 4, bytes_of(0.0F));
  const Mesh mesh = read_b3dm(b3dm_of({.glb = glb}));
  ASSERT_EQ(mesh.parts.size(), 2U);
  EXPECT_EQ(part_of(mesh, 1), Part::kNoParent);
  EXPECT_EQ(part_of(mesh, 2), 1U);
  ASSERT_EQ(mesh.notes.size(), 1U);
  EXPECT_NE(mesh.notes[0].find("triangles between features, in no part of a feature: 1"),
            std::string::npos)
      << mesh.notes[0];
}

TEST(B3dm, NamesIdsThatAreThereTwiceApart) {
  const Mesh mesh = read_b3dm(b3dm_of({0, 1, 2}, 3, R"({"id":["a","a","b"]})"));
  ASSERT_EQ(mesh.parts.size(), 3U);
  EXPECT_EQ(mesh.parts[0].id, "a");
  EXPECT_EQ(mesh.parts[1].id, "a#2");
  EXPECT_EQ(mesh.parts[1].name, "a");
  EXPECT_EQ(mesh.parts[2].id, "b");
}

TEST(Composite, ReadsTheTilesInIt) {
  const std::string i3dm = "i3dm" + bytes_of(1, 4) + bytes_of(16, 4) + bytes_of(0, 4);
  const std::string bytes =
      composite_of({b3dm_of({0, 1}, 2), i3dm, composite_of({b3dm_of({1}, 2)})});
  const Mesh mesh = read_text(bytes, "a.cmpt");
  EXPECT_EQ(mesh.triangles.size(), 3U);
  ASSERT_EQ(mesh.parts.size(), 6U);
  EXPECT_EQ(mesh.parts[0].name, "0");
  EXPECT_EQ(mesh.parts[1].id, "0");
  EXPECT_EQ(mesh.parts[1].parent, 0U);
  EXPECT_EQ(mesh.parts[2].id, "0/1");
  EXPECT_EQ(mesh.parts[3].name, "2");
  EXPECT_EQ(mesh.parts[4].parent, 3U);
  EXPECT_EQ(mesh.parts[5].id, "2/0/1");
  EXPECT_EQ(mesh.notes,
            (std::vector<std::string>{"instanced models (i3dm), not read: 1, in the file"}));
}

/// A GLB of numbered triangles with a table: texts, an enumeration, scaled numbers, truth values.
std::string with_table(const std::vector<float>& numbers, const std::string& set) {
  const std::string texts = "firsecond";
  const std::string offsets = bytes_of(0, 4) + bytes_of(3, 4) + bytes_of(9, 4);
  const std::string table = texts + std::string(3, ' ') + offsets + bytes_of(2, 2) +
                            bytes_of(7, 2) + bytes_of(255, 1) + bytes_of(51, 1) + bytes_of(2, 1) +
                            " ";
  std::string views;
  for (const auto& [begin, size] : std::vector<std::pair<std::size_t, std::size_t>>{
           {0, 9}, {12, 12}, {24, 4}, {28, 2}, {30, 1}}) {
    views += R"(,{"buffer":0,"byteOffset":)" + std::to_string(48 * numbers.size() + begin) +
             R"(,"byteLength":)" + std::to_string(size) + "}";
  }
  return numbered_glb(
      numbers, "_FEATURE_ID_0",
      R"(,"extensions":{"EXT_mesh_features":{"featureIds":[)" + set + "]}}",
      R"(,"extensionsUsed":["EXT_mesh_features"],"extensions":{"EXT_structural_metadata":{"schema":{"classes":{"tree":{"properties":{)"
      R"("name":{"type":"STRING"},"class":{"type":"ENUM","enumType":"kinds"},"share":{"type":"SCALAR","componentType":"UINT8","normalized":true,"offset":1},)"
      R"("old":{"type":"BOOLEAN"},"place":{"type":"VEC3","componentType":"FLOAT32"}}}},)"
      R"("enums":{"kinds":{"values":[{"name":"oak","value":2},{"name":"elm","value":3}]}}},)"
      R"("propertyTables":[{"class":"tree","count":2,"properties":{"name":{"values":2,"stringOffsets":3},"class":{"values":4},"share":{"values":5},"old":{"values":6},"place":{"values":6}}}]}})",
      views, table);
}

TEST(GltfFeatures, AreNamedByTheirTable) {
  const Mesh mesh = read_text(
      with_table({1, 0, 1}, R"({"featureCount":2,"attribute":0,"propertyTable":0})"), "a.glb");
  ASSERT_EQ(mesh.parts.size(), 3U);
  EXPECT_EQ(mesh.parts[0].name, "second");
  EXPECT_EQ(mesh.parts[0].id, "1");
  EXPECT_EQ(mesh.parts[0].type, "7");  // of which the enumeration has no name
  EXPECT_EQ(mesh.parts[0].attributes,
            (std::vector<Attribute>{
                {"class", "7"}, {"name", "second"}, {"old", "true"}, {"share", "1.2"}}));
  EXPECT_EQ(mesh.parts[1].name, "fir");
  EXPECT_EQ(mesh.parts[1].type, "oak");
  EXPECT_EQ(mesh.parts[1].attributes[3].value, "2");
  EXPECT_EQ(mesh.parts[2].continues, 0U);
  EXPECT_EQ(mesh.up, UpAxis::y);  // it stands alone
  ASSERT_EQ(mesh.notes.size(), 1U);
  EXPECT_NE(mesh.notes[0].find("lists, vectors or matrices, not read: 1"), std::string::npos);
}

TEST(GltfFeatures, MayBeNone) {
  const Mesh mesh = read_text(
      with_table({0, 9, 1},
                 R"({"featureCount":2,"nullFeatureId":9,"attribute":0,"propertyTable":0})"),
      "a.glb");
  ASSERT_EQ(mesh.parts.size(), 2U);
  EXPECT_EQ(part_of(mesh, 1), Part::kNoParent);
}

TEST(GltfFeatures, AreNodesWithoutATable) {
  EXPECT_TRUE(read_text(with_table({0, 9, 1}, R"({"featureCount":2,"attribute":0})"), "a.glb")
                  .parts.empty());
  const Mesh mesh = read_text(
      with_table({0, 9, 1}, R"({"featureCount":2,"texture":{"index":0},"propertyTable":0})"),
      "a.glb");
  EXPECT_TRUE(mesh.parts.empty());
  ASSERT_EQ(mesh.notes.size(), 1U);
  EXPECT_NE(mesh.notes[0].find("feature ids in textures or by position"), std::string::npos);
}

TEST(GltfFeatures, AreTypedErrorsOrSoundWhereBytesChange) {
  const std::string table =
      with_table({1, 0, 1}, R"({"featureCount":2,"attribute":0,"propertyTable":0})");
  const std::string batched = b3dm_of({1, 1, 0}, 2, R"({"id":["a","b"],"h":[1,2]})");
  for_each_case("b3dm/damaged", 2000, [&](Rng& rng) {
    expect_typed_or_sound([&] { return read_text(damaged(table, rng), "a.glb"); });
    expect_typed_or_sound([&] { return read_text(damaged(batched, rng), "a.b3dm"); });
  });
}

TEST(GltfFeatures, ThatDoNotFitTheirTableAreRefused) {
  const auto refuse = [](const std::vector<float>& numbers, const std::string& set,
                         const std::string& words) {
    expect_refused(with_table(numbers, set), "a.glb", ErrorKind::bad_file, words);
  };
  const std::string set = R"({"featureCount":2,"attribute":0,"propertyTable":0})";
  refuse({0, 2}, set, "accessors[1]: element 3 is feature 2");
  refuse({0, 0.5F}, set, "element 3 is not a whole number from 0");
  refuse({0, -1}, set, "element 3 is not a whole number from 0");
  refuse({0}, R"({"featureCount":2,"attribute":1,"propertyTable":0})",
         "\"_FEATURE_ID_1\" is missing");
  refuse({0}, R"({"featureCount":2,"attribute":0,"propertyTable":1})",
         "propertyTable: number 1, but the only one is 0");
}

}  // namespace
}  // namespace soms::test
