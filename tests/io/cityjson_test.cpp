// CityJSON: documents made on the spot, each with one thing that matters.
#include "soms/geometry/closedness.h"
#include "soms/io/read_mesh.h"

#include "tests/io/files.h"
#include "tests/support/support.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace soms::test {
namespace {

/// Members of a document of version 2.0, as text.
std::string city(const std::string& objects, const std::string& vertices,
                 const std::string& more = {}) {
  return R"({"type":"CityJSON","version":"2.0","transform":{"scale":[1,1,1],"translate":[0,0,0]},)" +
         std::string(R"("CityObjects":{)") + objects + R"(},"vertices":[)" + vertices + "]" + more +
         "}";
}

constexpr const char* kCube = "[0,0,0],[2,0,0],[2,2,0],[0,2,0],[0,0,2],[2,0,2],[2,2,2],[0,2,2]";
constexpr const char* kCubeSurfaces =
    "[[0,3,2,1]],[[4,5,6,7]],[[0,1,5,4]],[[1,2,6,5]],[[2,3,7,6]],[[3,0,4,7]]";

std::string solid(const std::string& lod = "1") {
  return R"({"type":"Solid","lod":")" + lod + R"(","boundaries":[[)" + kCubeSurfaces + "]]}";
}

std::string object(const std::string& key, const std::string& geometry,
                   const std::string& more = {}) {
  return "\"" + key + R"(":{"type":"Building","geometry":[)" + geometry + "]" + more + "}";
}

Mesh read_city(const std::string& text, const std::string& name = "a.city.json") {
  return read_text(text, name);
}

TEST(CityJson, HasAPartForEachObject) {
  const Mesh mesh = read_city(
      city(object("b", solid(), R"(,"attributes":{"height":7.5,"roof":"flat","flat":true})") + "," +
               object("a", solid()),
           kCube));
  ASSERT_EQ(mesh.parts.size(), 2U);
  EXPECT_EQ(mesh.triangles.size(), 24U);
  EXPECT_EQ(mesh.parts[0].id, "a");
  EXPECT_EQ(mesh.parts[1].name, "b");
  EXPECT_EQ(mesh.parts[1].type, "Building");
  EXPECT_EQ(mesh.parts[1].attributes,
            (std::vector<Attribute>{{"flat", "true"}, {"height", "7.5"}, {"roof", "flat"}}));
  EXPECT_EQ(mesh.up, UpAxis::z);
  EXPECT_TRUE(closedness(mesh).whole.closed);
  EXPECT_TRUE(mesh.notes.empty());
}

TEST(CityJson, ScalesAndMovesVerticesInDouble) {
  std::string text = city(object("a", solid()), kCube);
  text.replace(text.find("[1,1,1]"), 7, "[0.001,0.01,1]");
  text.replace(text.find("[0,0,0]"), 7, "[84616.468,447422.999,-0.452]");
  const Mesh mesh = read_city(text);
  EXPECT_EQ(mesh.vertices[6], (Vec3{2 * 0.001 + 84616.468, 2 * 0.01 + 447422.999, 2 - 0.452}));
}

TEST(CityJson, ReadsTheMostDetailedGeometryAlone) {
  const std::string coarse = R"({"type":"MultiSurface","lod":"1.3","boundaries":[[[0,1,2,3]]]})";
  const Mesh mesh = read_city(city(object("a", coarse + "," + solid("2.2")), kCube));
  EXPECT_EQ(mesh.triangles.size(), 12U);
  ASSERT_EQ(mesh.notes.size(), 1U);
  EXPECT_NE(mesh.notes[0].find("another level of detail"), std::string::npos) << mesh.notes[0];
  // Of equally detailed ones the solid; a number is a level, too.
  EXPECT_EQ(read_city(city(object("a", R"({"type":"MultiSurface","lod":1,"boundaries":[]},)" +
                                           solid("1")),
                           kCube))
                .triangles.size(),
            12U);
}

TEST(CityJson, ReadsTheLevelThatIsRequestedAlone) {
  const std::string coarse = R"({"type":"MultiSurface","lod":"1.30","boundaries":[[[0,1,2,3]]]})";
  const std::string text =
      city(object("a", coarse + "," + solid("2.2")) + "," + object("b", solid("2.2")), kCube);
  const Mesh mesh = read_text(text, "a.city.json", {.lod = 1.3});
  EXPECT_EQ(mesh.triangles.size(), 2U);
  ASSERT_EQ(mesh.notes.size(), 2U);
  EXPECT_NE(
      mesh.notes[0].find("geometries of another level of detail, not read: 1, at CityObjects.a"),
      std::string::npos)
      << mesh.notes[0];
  EXPECT_NE(mesh.notes[1].find("objects without a geometry of the level of detail that is "
                               "requested, not read: 1"),
            std::string::npos)
      << mesh.notes[1];
  EXPECT_EQ(read_text(text, "a.city.json", {.lod = 2.2}).triangles.size(), 24U);
  expect_refused([&] { static_cast<void>(read_text(text, "a.city.json", {.lod = 1})); },
                 ErrorKind::usage, R"(request one of those that the file has: "1.30", "2.2")");
  expect_refused(
      [&] {
        static_cast<void>(
            read_text("solid a\nendsolid a\n", "a.stl", {.allow_empty = true, .lod = 1}));
      },
      ErrorKind::usage, "it is no CityJSON");
}

/// A cube of which surfaces 0 and 2 are one floor, 1 the roof, and the last ones nothing.
std::string solid_with(const std::string& values) {
  return R"({"type":"Solid","lod":"2","boundaries":[[)" + std::string(kCubeSurfaces) +
         R"(]],"semantics":{"surfaces":[{"type":"RoofSurface","slope":12.5},{"type":"GroundSurface"}],)" +
         R"("values":)" + values + "}}";
}

TEST(CityJson, MakesSemanticSurfacesParts) {
  const std::string text = city(object("a", solid_with("[[1,0,1,null,null,null]]")), kCube);
  EXPECT_EQ(read_city(text).parts.size(), 1U);
  const Mesh mesh = read_text(text, "a.city.json", {.surfaces = true});
  ASSERT_EQ(mesh.parts.size(), 3U);
  EXPECT_EQ(mesh.parts[0].count, 12U);
  EXPECT_EQ(mesh.parts[1],
            (Part{"RoofSurface 0", 0, 6, 2, "", "RoofSurface", {{"slope", "12.5"}}}));
  EXPECT_EQ(mesh.parts[2], (Part{"GroundSurface 1", 0, 8, 4, "", "GroundSurface"}));
  for (TriangleId i = 6; i < 8; ++i) {
    EXPECT_EQ(bounds(mesh.triangle(i)).lower.z, 2) << i;
  }
  EXPECT_TRUE(closedness(mesh).whole.closed);
  // The same triangles, in another order.
  EXPECT_EQ(mesh.triangles.size(), read_city(text).triangles.size());
  // Null stands for all below it.
  EXPECT_EQ(
      read_text(city(object("a", solid_with("[null]")), kCube), "a.city.json", {.surfaces = true})
          .parts.size(),
      1U);
  EXPECT_EQ(
      read_text(city(object("a", solid()), kCube), "a.city.json", {.surfaces = true}).parts.size(),
      1U);
}

TEST(CityJson, NamesWhatIsWrongWithSemantics) {
  const auto refuse = [](const std::string& values, const std::string& words) {
    expect_refused(
        [&] {
          static_cast<void>(read_text(city(object("a", solid_with(values)), kCube), "a.city.json",
                                      {.surfaces = true}));
        },
        ErrorKind::bad_file, words);
  };
  refuse("[[0,0,0,0,0,2]]", "number 2, but surfaces are 0 to 1");
  refuse("[[0,0,0,0,0]]", "there are 6 surfaces or lists of them, but 5 values");
  refuse("[]", "but 0 values");
  refuse("[0]", "a.city.json");
  refuse("[[0,0,0,0,0,-1]]", "a.city.json");
  refuse("[[0,0,0,0,0,\"x\"]]", "a.city.json");
}

TEST(CityJson, CutsOutHoles) {
  const Mesh mesh = read_city(
      city(object("a", R"({"type":"MultiSurface","lod":"2","boundaries":[[[0,1,2,3],[4,5,6,7]]]})"),
           "[0,0,0],[9,0,0],[9,9,0],[0,9,0],[3,3,0],[6,3,0],[6,6,0],[3,6,0]"));
  double area = 0;
  for (TriangleId i = 0; i < mesh.triangles.size(); ++i) {
    const Triangle t = mesh.triangle(i);
    area += cross(t.b - t.a, t.c - t.a).z / 2;
  }
  EXPECT_EQ(area, 72);
  EXPECT_EQ(mesh.faces, std::vector<std::uint32_t>(8, 0));
  EXPECT_TRUE(mesh.notes.empty());
}

TEST(CityJson, NotesHolesThatLieOutside) {
  const Mesh mesh = read_city(
      city(object("a", R"({"type":"MultiSurface","lod":"2","boundaries":[[[0,1,2,3],[4,5,6,7]]]})"),
           "[0,0,0],[9,0,0],[9,9,0],[0,9,0],[33,3,0],[36,3,0],[36,6,0],[33,6,0]"));
  ASSERT_EQ(mesh.notes.size(), 1U);
  EXPECT_NE(mesh.notes[0].find("not cut out"), std::string::npos) << mesh.notes[0];
}

TEST(CityJson, PutsPartsIntoTheirParents) {
  const Mesh mesh = read_city(city(R"("whole":{"type":"Building","children":["wing","attic"]},)" +
                                       object("attic", solid(), R"(,"parents":["whole"])") + "," +
                                       object("wing", solid(), R"(,"parents":["whole"])"),
                                   kCube));
  ASSERT_EQ(mesh.parts.size(), 3U);
  EXPECT_EQ(mesh.parts[0].name, "whole");
  EXPECT_EQ(mesh.parts[0].count, 24U);
  EXPECT_EQ(mesh.parts[1].name, "wing");
  EXPECT_EQ(mesh.parts[1].parent, 0U);
  EXPECT_EQ(mesh.parts[2].name, "attic");
  EXPECT_EQ(mesh.parts[2].parent, 0U);
}

TEST(CityJson, PlacesTemplates) {
  const std::string instance = R"({"type":"GeometryInstance","template":0,"boundaries":[1],)"
                               R"("transformationMatrix":[-1,0,0,5,0,1,0,0,0,0,1,0,0,0,0,1]})";
  const Mesh mesh = read_city(city(object("tree", instance), "[0,0,0],[10,0,0]",
                                   std::string(R"(,"geometry-templates":{"templates":[)") +
                                       solid() + R"(],"vertices-templates":[)" + kCube + "]}"));
  EXPECT_EQ(mesh.triangles.size(), 12U);
  EXPECT_EQ(bounds(mesh), (Box{{13, 0, 0}, {15, 2, 2}}));
  // Mirrored, and turned around for it: outward all the same.
  double volume = 0;
  for (TriangleId i = 0; i < mesh.triangles.size(); ++i) {
    const Triangle t = mesh.triangle(i);
    volume += dot(t.a, cross(t.b, t.c)) / 6;
  }
  EXPECT_NEAR(volume, 8, 1e-9);
}

/// A cube whose metadata state this reference system, as JSON.
Mesh city_in(const std::string& system) {
  return read_city(
      city(object("a", solid()), kCube, R"(,"metadata":{"referenceSystem":)" + system + "}"));
}

TEST(CityJson, StatesItsReferenceSystemAndTheUnitOfThat) {
  const Mesh meters = city_in(R"("https://www.opengis.net/def/crs/EPSG/0/7415")");
  EXPECT_EQ(meters.georeference, (Georeference{.crs = "EPSG:7415"}));
  EXPECT_EQ(meters.unit, 1);
  EXPECT_TRUE(meters.notes.empty());
  EXPECT_DOUBLE_EQ(city_in(R"("urn:ogc:def:crs:EPSG::2263")").unit, 1200.0 / 3937);
  const Mesh unknown = city_in(R"("local")");
  EXPECT_EQ(unknown.georeference, (Georeference{.crs = "local"}));
  EXPECT_EQ(unknown.unit, 0);
  EXPECT_TRUE(city_in("null").georeference.empty());
  const Mesh angles = city_in(R"("https://www.opengis.net/def/crs/EPSG/0/4979")");
  EXPECT_EQ(angles.unit, 0);
  ASSERT_EQ(angles.notes.size(), 1U);
  EXPECT_EQ(angles.notes[0],
            "longitude and latitude are angles (EPSG:4979), so lengths and distances have no "
            "meaning");
  const Mesh longest = city_in("\"" + std::string(1000, 'x') + "\"");
  EXPECT_EQ(longest.georeference.crs.size(), 1000U);
  const Mesh longer = city_in("\"" + std::string(1001, 'x') + "\"");
  EXPECT_TRUE(longer.georeference.empty());
  EXPECT_EQ(longer.notes,
            std::vector<std::string>{"a reference system with a name of 1001 bytes, not read"});
  const Mesh number = city_in("7415");
  EXPECT_TRUE(number.georeference.empty());
  EXPECT_EQ(number.notes, std::vector<std::string>{"a reference system that is no text, not read"});
}

TEST(CityJson, StatesTheReferenceSystemOfASequence) {
  const std::string head =
      R"({"type":"CityJSON","version":"2.0","transform":{"scale":[1,1,1],"translate":[0,0,0]},)"
      R"("metadata":{"referenceSystem":"urn:ogc:def:crs:EPSG::28992"},"CityObjects":{},)"
      R"("vertices":[]})";
  const Mesh mesh =
      read_city(head + "\n" + R"({"type":"CityJSONFeature","id":"a","CityObjects":{)" +
                    object("a", solid()) + R"(},"vertices":[)" + kCube + "]}",
                "a.city.jsonl");
  EXPECT_EQ(mesh.georeference.crs, "EPSG:28992");
  EXPECT_EQ(mesh.unit, 1);
}

TEST(CityJson, ReadsSequencesLineByLine) {
  const std::string head =
      R"({"type":"CityJSON","version":"2.0","transform":{"scale":[2,2,2],"translate":[1,0,0]},)"
      R"("CityObjects":{},"vertices":[]})";
  const auto feature = [](const std::string& key) {
    return R"({"type":"CityJSONFeature","id":")" + key + R"(","CityObjects":{)" +
           object(key, solid()) + R"(},"vertices":[)" + kCube + "]}";
  };
  const Mesh mesh =
      read_city(head + "\n" + feature("a") + "\r\n\n" + feature("b") + "\n", "a.city.jsonl");
  ASSERT_EQ(mesh.parts.size(), 2U);
  EXPECT_EQ(mesh.parts[1].id, "b");
  EXPECT_EQ(mesh.parts[1].first, 12U);
  EXPECT_EQ(bounds(mesh), (Box{{1, 0, 0}, {5, 4, 4}}));

  std::string broken = feature("b");
  broken.replace(broken.find("[4,5,6,7]"), 9, "[4,5,6,99]");
  expect_refused(head + "\n" + feature("a") + "\n" + broken, "a.city.jsonl", ErrorKind::bad_file,
                 "line 3, CityObjects.b.geometry[0]");
  expect_refused(feature("a") + "\n" + head, "a.city.jsonl", ErrorKind::bad_file, "begins the");
}

TEST(CityJson, RefusesAChildWithoutParents) {
  expect_refused([] { static_cast<void>(read_mesh(data("reports/orphan_child.json"))); },
                 ErrorKind::bad_file,
                 "CityObjects.p.children[0]: the object \"c\" has no \"parents\", where this one "
                 "must be named");
  // Whichever comes first: once it was read twice where its parent did.
  for (const std::string parents : {"", R"(,"parents":[])"}) {
    expect_refused(
        city(object("a", "", R"(,"children":["b"])") + "," + object("b", solid(), parents), kCube),
        "a.json", ErrorKind::bad_file, "the object \"b\" has no \"parents\"");
  }
}

TEST(CityJson, RefusesPartsThatGoInCircles) {
  expect_refused(city(R"("a":{"type":"Building","children":["b"]},)"
                      R"("b":{"type":"Building","children":["b"],"parents":["a"]})",
                      ""),
                 "a.json", ErrorKind::bad_file, "part of itself");
  expect_refused(city(R"("a":{"type":"Building","parents":["a"]})", ""), "a.json",
                 ErrorKind::bad_file, "do not have them as children");
  expect_refused(city(R"("a":{"type":"Building","children":["c"]})", ""), "a.json",
                 ErrorKind::bad_file, "there is no object \"c\"");
}

TEST(CityJson, NamesWhatIsWrong) {
  const auto refused = [&](const std::string& from, const std::string& to, const std::string& words,
                           ErrorKind kind = ErrorKind::bad_file) {
    std::string text = city(object("a", solid()), kCube);
    ASSERT_NE(text.find(from), std::string::npos) << from;
    text.replace(text.find(from), from.size(), to);
    expect_refused(text, "a.json", kind, words);
  };
  refused("\"2.0\"", "\"3.0\"", "only 1.0, 1.1 and 2.x", ErrorKind::unsupported);
  refused("[0,3,2,1]", "[0,3,2,8]", "vertex 8");
  refused("[0,3,2,1]", "[0,3,2,-1]", "whole number");
  refused("[0,3,2,1]", "[0,3,2,1.5]", "whole number");
  refused("[0,3,2,1]", "7", "expected a list");
  refused("[2,2,2]", "[2,2]", "expected three numbers");
  refused("[2,2,2]", "[2,2,1e300]", "", ErrorKind::out_of_range);
  refused("\"Solid\"", "\"Blob\"", "no type of geometry");
  refused("\"scale\":[1,1,1]", "\"scale\":[1,1]", "expected three numbers");
  refused("\"vertices\"", "\"points\"", "\"vertices\" is missing");
  refused("\"CityObjects\"", "\"Things\"", "\"CityObjects\" is missing");
}

TEST(CityJson, IsKnownByItsTypeAlone) {
  expect_refused(R"({"type":"FeatureCollection","features":[]})", "a.json", ErrorKind::unsupported,
                 "a JSON file");
  // glTF that names CityJSON somewhere is glTF.
  expect_refused(R"({"asset":{"version":"2.0","generator":"CityJSON"}})", "a.gltf",
                 ErrorKind::empty_mesh, "");
}

TEST(CityJson, KeepsTheObjectsOfRealCities) {
  SOMS_NEEDS_OUTSIDE_DATA("three cities");

  struct City {
    const char* file;
    std::size_t objects;
    std::size_t with_surfaces;
  };

  for (const City& one :
       {City{"delft.city.json", 570, 570}, City{"rotterdam_delfshaven.city.json", 853, 853},
        City{"zurich_subset_lod2.city.json", 210, 210}}) {
    SCOPED_TRACE(one.file);
    const auto path = outside_data(std::string("cities/original/") + one.file);
    if (!path || !std::filesystem::exists(*path)) {
      ADD_FAILURE() << "is not there";
      continue;
    }
    const Mesh mesh = read_mesh(*path);
    EXPECT_EQ(mesh.parts.size(), one.with_surfaces);
    EXPECT_LE(mesh.parts.size(), one.objects);
    for (const Part& part : mesh.parts) {
      EXPECT_FALSE(part.id.empty());
      EXPECT_FALSE(part.type.empty());
    }
    for (const std::string& note : mesh.notes) {
      EXPECT_EQ(note.find("not cut out"), std::string::npos) << note;
    }
  }
}

}  // namespace
}  // namespace soms::test
