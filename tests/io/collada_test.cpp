#include "soms/io/detail/collada/collada.h"

#include "soms/base/error.h"
#include "soms/io/read_mesh.h"

#include "tests/io/files.h"
#include "tests/support/small_stack.h"
#include "tests/support/support.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <string>
#include <vector>

namespace soms::test {
namespace {

const std::string kPoints = "0 0 0 1 0 0 1 1 0 0 1 0 0.5 0.5 2";
const std::string kTriangle = R"(<triangles count="1"><input semantic="VERTEX" source="#v"
    offset="0"/><p>0 1 2</p></triangles>)";
const std::string kInput = R"(<input semantic="VERTEX" source="#v" offset="0"/>)";

/// A geometry of the five points and some faces.
std::string geometry(const std::string& faces, const std::string& id = "g",
                     const std::string& points = kPoints) {
  return "<geometry id=\"" + id + "\" name=\"" + id + R"( shape"><mesh><source id="p">
    <float_array id="a" count="15">)" +
         points + R"(</float_array><technique_common><accessor source="#a" count="5" stride="3">
    <param name="X"/><param name="Y"/><param name="Z"/></accessor></technique_common></source>
    <vertices id="v"><input semantic="POSITION" source="#p"/></vertices>)" +
         faces + "</mesh></geometry>";
}

std::string document(const std::string& geometries, const std::string& nodes,
                     const std::string& more = {}) {
  return "<?xml version=\"1.0\"?><COLLADA version=\"1.4.1\">" + more + "<library_geometries>" +
         geometries + "</library_geometries><library_visual_scenes><visual_scene id=\"s\">" +
         nodes +
         "</visual_scene></library_visual_scenes><scene><instance_visual_scene url=\"#s\"/></scene>"
         "</COLLADA>";
}

const std::string kShow = "<instance_geometry url=\"#g\"/>";

std::string node(const std::string& inside, const std::string& name = {}) {
  return "<node" + (name.empty() ? name : " name=\"" + name + "\"") + ">" + inside + "</node>";
}

Mesh read_faces(const std::string& faces) {
  return read_text(document(geometry(faces), node(kShow)), "a.dae");
}

/// Where a node's transforms put a point.
Vec3 moved(const std::string& transforms, const Vec3& p) {
  const std::string point =
      std::to_string(p.x) + " " + std::to_string(p.y) + " " + std::to_string(p.z);
  const std::string text = document(geometry(kTriangle, "g", point + " 0 0 0 0 0 0 0 0 0 0 0 0"),
                                    node(transforms + kShow));
  return read_text(text, "a.dae").vertices[0];
}

void expect_near(const Vec3& found, const Vec3& expected) {
  EXPECT_NEAR(found.x, expected.x, 1e-12);
  EXPECT_NEAR(found.y, expected.y, 1e-12);
  EXPECT_NEAR(found.z, expected.z, 1e-12);
}

using Triangles = std::vector<std::array<std::uint32_t, 3>>;

TEST(Collada, ReportsUnitAndUpAxisAndAppliesNeither) {
  const std::string asset =
      R"(<asset><unit name="inch" meter="0.0254"/><up_axis> Y_UP </up_axis></asset>)";
  const Mesh mesh = read_text(document(geometry(kTriangle), node(kShow), asset), "a.dae");
  EXPECT_EQ(mesh.unit, 0.0254);
  EXPECT_EQ(mesh.up, UpAxis::y);
  EXPECT_EQ(mesh.vertices[4], (Vec3{0.5, 0.5, 2}));
  EXPECT_TRUE(mesh.notes.empty());
  const Mesh silent = read_text(document(geometry(kTriangle), node(kShow)), "a.dae");
  EXPECT_EQ(silent.unit, 0.0);
  EXPECT_EQ(silent.up, UpAxis::unknown);
  EXPECT_EQ(silent.vertices, mesh.vertices);
}

TEST(Collada, ReadsPolygonsStripsAndFansAndCountsLines) {
  EXPECT_EQ(
      read_faces("<tristrips count=\"1\">" + kInput + "<p>0 1 3 2 4</p></tristrips>").triangles,
      (Triangles{{0, 1, 3}, {3, 1, 2}, {3, 2, 4}}));
  EXPECT_EQ(read_faces("<trifans count=\"2\">" + kInput + "<p>4 0 1 2</p><p>4 2 3</p></trifans>")
                .triangles,
            (Triangles{{4, 0, 1}, {4, 1, 2}, {4, 2, 3}}));
  const Mesh polygons = read_faces(
      "<polygons count=\"3\">" + kInput + "<p>0 1 2 3</p><p>0 1</p><p>0 1 4</p></polygons>" +
      "<linestrips count=\"2\"><p>0 1</p><p>1 2</p></linestrips>" + "<lines count=\"3\"/>");
  EXPECT_EQ(polygons.triangles, (Triangles{{0, 1, 2}, {0, 2, 3}, {0, 1, 4}}));
  EXPECT_EQ(polygons.faces, (std::vector<std::uint32_t>{0, 0, 2}));
  EXPECT_EQ(polygons.notes,
            (std::vector<std::string>{"faces with fewer than three corners, not read: 1, in line 1",
                                      "lines, which are not triangles: 5, the first in line 4"}));
  const Mesh list = read_faces("<polylist count=\"2\">" + kInput +
                               "<vcount>3 4</vcount><p>0 1 4 0 1 2 3</p></polylist>");
  EXPECT_EQ(list.triangles, (Triangles{{0, 1, 4}, {0, 1, 2}, {0, 2, 3}}));
  EXPECT_EQ(list.faces, (std::vector<std::uint32_t>{0, 1, 1}));
}

TEST(Collada, NotesUnknownElementsAmongFaces) {
  const Mesh mesh = read_faces("<triangles>" + kInput + "<p>0 1 2</p><P>0 2 3</P></triangles>");
  EXPECT_EQ(mesh.triangles, (Triangles{{0, 1, 2}}));
  EXPECT_EQ(mesh.notes,
            (std::vector<std::string>{"unknown elements, not read: 1, in line 4: <P>"}));
  EXPECT_TRUE(
      read_faces("<triangles><extra/>" + kInput + "<p>0 1 2</p></triangles>").notes.empty());
}

TEST(Collada, TakesCoordinatesByNameOutOfWiderRows) {
  std::string text = document(geometry(kTriangle), node(kShow));
  const auto replace = [&](const std::string& old, const std::string& by) {
    text.replace(text.find(old), old.size(), by);
  };
  replace(kPoints, "9 9 3 7 2 1 6 7 5 4 9 7 8 7");
  replace("count=\"15\"", "count=\"14\"");
  replace("count=\"5\" stride=\"3\"", "count=\"3\" offset=\"2\" stride=\"4\"");
  replace(R"(<param name="X"/><param name="Y"/><param name="Z"/>)",
          R"(<param name="Z"/><param/><param name="Y"/><param name="X"/>)");
  EXPECT_EQ(read_text(text, "a.dae").vertices,
            (std::vector<Vec3>{{1, 2, 3}, {4, 5, 6}, {7, 8, 9}}));
}

TEST(Collada, ComposesTransformsInTheirOrder) {
  EXPECT_EQ(moved("<translate>1 2 3</translate><scale>2 3 4</scale>", {1, 1, 1}), (Vec3{3, 5, 7}));
  EXPECT_EQ(moved("<scale>2 3 4</scale><translate>1 2 3</translate>", {1, 1, 1}), (Vec3{4, 9, 16}));
  EXPECT_EQ(moved("<matrix>0 0 1 5 1 0 0 6 0 1 0 7 0 0 0 1</matrix>", {1, 2, 3}), (Vec3{8, 7, 9}));
  // Right angles are exact, however many turns they are.
  EXPECT_EQ(moved("<rotate>0 0 2 450</rotate>", {1, 2, 3}), (Vec3{-2, 1, 3}));
  EXPECT_EQ(moved("<rotate>1 0 0 -90</rotate>", {1, 2, 3}), (Vec3{1, 3, -2}));
  EXPECT_EQ(moved("<rotate>0 1 0 180</rotate>", {1, 2, 3}), (Vec3{-1, 2, -3}));
  EXPECT_EQ(moved("<rotate>0 0 0 0</rotate>", {1, 2, 3}), (Vec3{1, 2, 3}));
  const double half = std::sqrt(0.5);
  expect_near(moved("<rotate>0 0 1 45</rotate>", {1, 0, 3}), {half, half, 3});
  expect_near(moved("<rotate>1 1 1 120</rotate>", {1, 2, 3}), {3, 1, 2});
  expect_near(moved("<rotate>0 0 1 -37</rotate><rotate>0 0 1 397</rotate>", {1, 2, 3}), {1, 2, 3});
  // y turns by 45 degrees toward x, whose plane stays: a shear by 1.
  expect_near(moved("<skew>45 0 1 0 1 0 0</skew>", {1, 2, 3}), {3, 2, 3});
  expect_near(moved("<skew>-45 0 1 0 1 0 0</skew>", {1, 2, 3}), {-1, 2, 3});
  // From (0, 0, 10) down to the origin, with y up: nothing turns. From x: -z becomes -x.
  expect_near(moved("<lookat>0 0 10 0 0 0 0 1 0</lookat>", {1, 2, 3}), {1, 2, 13});
  expect_near(moved("<lookat>10 0 0 0 0 0 0 0 1</lookat>", {1, 2, 3}), {13, 1, 2});
}

TEST(Collada, SkewTurnsItsFirstDirectionByItsAngle) {
  // The first direction is not square to the second, as RenderMan allows.
  const Vec3 from = {1, 2, 0};
  const Vec3 found = moved("<skew>20 1 2 0 1 0 0</skew>", from);
  const double turned = std::atan2(from.y, from.x) - std::atan2(found.y, found.x);
  EXPECT_NEAR(turned, 20 * 3.141592653589793 / 180, 1e-12);
  EXPECT_NEAR(found.y, from.y, 1e-12);
}

TEST(Collada, TurnsTheCornersOfMirroredInstances) {
  const Mesh mesh =
      read_text(document(geometry(kTriangle), node("<scale>1e-200 1e-200 -1e-200</scale>" + kShow) +
                                                  node("<scale>-1 -1 1</scale>" + kShow)),
                "a.dae");
  EXPECT_EQ(mesh.triangles, (Triangles{{0, 2, 1}, {5, 6, 7}}));
}

TEST(Collada, ShowsInstancesUnderTheTransformsAroundThem) {
  const std::string nodes = R"(<library_nodes><node id="arm"><translate>1 0 0</translate>)" +
                            kShow + R"(<node name="hand"><translate>0 1 0</translate>)" + kShow +
                            "</node></node></library_nodes>";
  const Mesh mesh =
      read_text(document(geometry(kTriangle),
                         node("<scale>2 2 2</scale><instance_node url=\"#arm\"/>", "left") +
                             node("<instance_node url=\"#arm\"/>", "right") + node("", "nothing"),
                         nodes),
                "a.dae");
  EXPECT_EQ(mesh.triangles, (Triangles{{0, 1, 2}, {5, 6, 7}, {10, 11, 12}, {15, 16, 17}}));
  EXPECT_EQ(mesh.vertices[0], (Vec3{2, 0, 0}));
  EXPECT_EQ(mesh.vertices[5], (Vec3{2, 2, 0}));
  EXPECT_EQ(mesh.vertices[10], (Vec3{1, 0, 0}));
  EXPECT_EQ(mesh.vertices[15], (Vec3{1, 1, 0}));
  const std::vector<Part> parts = {
      {"left", Part::kNoParent, 0, 2},  {"arm", 0, 0, 2}, {"hand", 1, 1, 1},
      {"right", Part::kNoParent, 2, 2}, {"arm", 3, 2, 2}, {"hand", 4, 3, 1}};
  EXPECT_EQ(mesh.parts, parts);
}

TEST(Collada, NamesPartsByGeometriesWhereANodeShowsSeveral) {
  const Mesh mesh =
      read_text(document(geometry(kTriangle) + geometry(kTriangle, "h"),
                         node(kShow + "<instance_geometry url=\"#h\"/>", "both") + node(kShow)),
                "a.dae");
  const std::vector<Part> parts = {{"both", Part::kNoParent, 0, 2},
                                   {"g shape", 0, 0, 1},
                                   {"h shape", 0, 1, 1},
                                   {"g shape", Part::kNoParent, 2, 1}};
  EXPECT_EQ(mesh.parts, parts);
}

TEST(Collada, ShowsSkinsAsTheyWereBound) {
  const std::string skin = R"(<library_controllers><controller id="c"><skin source="#g">
    <bind_shape_matrix>1 0 0 7 0 1 0 0 0 0 1 0 0 0 0 1</bind_shape_matrix></skin></controller>
    <controller id="m"><morph source="#g"/></controller></library_controllers>
    <library_animations><animation/><animation/></library_animations>)";
  const Mesh mesh =
      read_text(document(geometry(kTriangle),
                         node("<translate>0 5 0</translate><instance_controller url=\"#c\"/>") +
                             node("<translate>0 5 0</translate><instance_controller url=\"#m\"/>"),
                         skin),
                "a.dae");
  EXPECT_EQ(mesh.vertices[0], (Vec3{7, 0, 0}));
  EXPECT_EQ(mesh.vertices[5], (Vec3{0, 5, 0}));
  EXPECT_EQ(mesh.notes,
            (std::vector<std::string>{"skins read in their bind shape, not posed: 1, in line 1",
                                      "morphs read in their base shape: 1, in line 3",
                                      "animations, not applied: 2, the first in line 4"}));
}

TEST(Collada, ShowsTheBaseShapeOfAMorphThatHasASkin) {
  const auto skin_of = [](const std::string& source) {
    return document(geometry(kTriangle),
                    node("<translate>0 5 0</translate><instance_controller url=\"#c\"/>"),
                    R"(<library_controllers><controller id="c"><skin source="#)" + source + R"(">
    <bind_shape_matrix>1 0 0 7 0 1 0 0 0 0 1 0 0 0 0 1</bind_shape_matrix></skin></controller>
    <controller id="m"><morph source="#g"/></controller></library_controllers>)");
  };
  const Mesh mesh = read_text(skin_of("m"), "a.dae");
  EXPECT_EQ(mesh.vertices, read_text(skin_of("g"), "a.dae").vertices);
  EXPECT_EQ(mesh.notes,
            (std::vector<std::string>{"skins read in their bind shape, not posed: 1, in line 1",
                                      "morphs read in their base shape: 1, in line 3"}));
  expect_refused(skin_of("c"), "a.dae", ErrorKind::bad_file,
                 "<controller id=\"c\"> is not a morph");
  expect_refused(skin_of("h"), "a.dae", ErrorKind::bad_file, "which does not exist");
}

TEST(Collada, ShowsEveryGeometryOfALibraryWithoutAScene) {
  const std::string text = "<COLLADA><library_geometries>" + geometry(kTriangle) +
                           geometry(kTriangle, "h") + "</library_geometries></COLLADA>";
  const Mesh mesh = read_text(text, "library");
  EXPECT_EQ(mesh.triangles.size(), 2U);
  EXPECT_EQ(mesh.parts.at(1).name, "h shape");
  EXPECT_EQ(mesh.notes,
            (std::vector<std::string>{"the file has no scene: every geometry is read once"}));
}

TEST(Collada, TellsOfGeometriesAndScenesThatAreNotShown) {
  // Those without an id, which nothing can show, count too.
  std::string text = document(
      geometry(kTriangle) + "\n" + geometry(kTriangle, "h") + "<geometry/>\n", node(kShow));
  text.replace(text.find("<visual_scene "), 0, "<visual_scene/>\n<visual_scene id=\"t\"/>");
  EXPECT_EQ(
      read_text(text, "a.dae").notes,
      (std::vector<std::string>{"scenes that were not read: 2, the first in line 11",
                                "geometries that are not in the scene: 2, the first in line 6"}));
}

/// A scene may show the end of a file before its beginning.
TEST(Collada, PlacesNotesByTheFileAndNotByTheScene) {
  const std::string lines = "\n<lines count=\"2\"/>\n";
  const std::string text =
      document(geometry(kTriangle + lines) + geometry(kTriangle + lines, "h"),
               node("\n<odd/><instance_geometry url=\"#h\"/>" + kShow) + node("<odd/>"));
  EXPECT_EQ(
      read_text(text, "a.dae").notes,
      (std::vector<std::string>{"lines, which are not triangles: 4, the first in line 6",
                                "unknown elements, not read: 2, the first in line 14: <odd>"}));
}

TEST(Collada, TellsOfUnitsAndAxesThatAreNotApplied) {
  const std::string asset = "\n<asset><unit meter=\"0.1\"/></asset>";
  const std::string text = document(geometry(kTriangle), node(asset + kShow) + node(asset),
                                    "<asset><up_axis>\nW_UP</up_axis></asset>");
  EXPECT_EQ(read_text(text, "a.dae").notes,
            (std::vector<std::string>{
                "up axes that are not known: 1, in line 1: \"W_UP\"",
                "units and up axes of parts of the file, not applied: 2, the first in line 7"}));
}

TEST(Collada, RefusesElementsAmongNumbers) {
  const auto refuse = [](const std::string& points, const std::string& faces,
                         const std::string& words) {
    expect_refused(document(geometry(faces, "g", points), node(kShow)), "a.dae",
                   ErrorKind::bad_file, words);
  };
  const std::string words = "<q> stands among the numbers of ";
  refuse(kPoints, "<triangles>" + kInput + "<p>0 1 2 <q>0 2 3</q></p></triangles>", words + "<p>");
  refuse(kPoints, "<triangles>" + kInput + "<p><q/>0 1 2</p></triangles>", words + "<p>");
  refuse(kPoints, "<triangles>" + kInput + "<p><q>0 1 2</q></p></triangles>", words + "<p>");
  refuse(kPoints, "<polylist>" + kInput + "<vcount>3<q>3</q></vcount><p>0 1 2 0 2 3</p></polylist>",
         words + "<vcount>");
  refuse("0 0 0 <q>1 1 1</q> 1 0 0 1 1 0 0 1 0 0.5 0.5 2", kTriangle, words + "<float_array id=");
}

TEST(Collada, ReadsNumbersAroundCommentsButNotThroughThem) {
  const std::string good =
      document(geometry(kTriangle, "g", "0 0 0 <!-- a --> 1 0 0 <![CDATA[1 1 0 ]]>0 1 0 0.5 0.5 2"),
               node(kShow));
  EXPECT_EQ(read_text(good, "a.dae").vertices, read_faces(kTriangle).vertices);
  expect_refused(
      document(geometry(kTriangle, "g", "0 0 0 1 0 0 1 1 0 0 1 0 0.5 0.5<!-- -->5 2"), node(kShow)),
      "a.dae", ErrorKind::bad_file, "interrupts a number");
}

TEST(Collada, RefusesWhatItCannotShowRightly) {
  const auto refuse_faces = [](const std::string& faces, ErrorKind kind, const std::string& words) {
    expect_refused(document(geometry(faces), node(kShow)), "a.dae", kind, words);
  };
  refuse_faces("<polygons count=\"1\">" + kInput + "<ph><p>0 1 2 3</p><h>0 1 4</h></ph></polygons>",
               ErrorKind::unsupported, "a polygon with holes");
  for (const std::string list : {"triangles", "polylist", "tristrips", "trifans"}) {
    const std::string sizes = list == "polylist" ? "<vcount>3</vcount>" : "";
    refuse_faces("<" + list + " count=\"1\">" + kInput + sizes +
                     "<p>0 1 2</p><ph><p>0 2 3</p></ph></" + list + ">",
                 ErrorKind::unsupported, "a polygon with holes");
  }
  for (const std::string list : {"triangles", "polygons", "tristrips", "trifans"}) {
    refuse_faces("<" + list + " count=\"1\">" + kInput +
                     "<vcount>3 3</vcount><p>0 1 2 0 2 3</p></" + list + ">",
                 ErrorKind::bad_file, "has a <vcount>, which only <polylist> has");
  }
  refuse_faces("<polylist count=\"1\">" + kInput +
                   "<vcount>3</vcount><vcount>3</vcount><p>0 1 2</p></polylist>",
               ErrorKind::bad_file, "a second <vcount>");
  refuse_faces("<triangles count=\"2\">" + kInput + "<p>0 1 2</p></triangles>", ErrorKind::bad_file,
               "line 4: <triangles> states 2 and holds 1");
  refuse_faces("<triangles count=\"1\"><p>0 1 2</p></triangles>", ErrorKind::bad_file,
               "no input VERTEX");
  refuse_faces("<triangles count=\"1\">" + kInput + "<p>0 1 5</p></triangles>", ErrorKind::bad_file,
               "line 4: vertex 5, but vertices are 0 to 4");
  refuse_faces("<triangles count=\"1\">" + kInput + "<p>0 1 2.5</p></triangles>",
               ErrorKind::bad_file, "\"2.5\" instead of a whole number");
  const auto refuse_node = [](const std::string& inside, ErrorKind kind, const std::string& words) {
    expect_refused(document(geometry(kTriangle), node(inside + kShow)), "a.dae", kind, words);
  };
  refuse_node("<matrix>1 0 0 0 0 1 0 0 0 0 1 0 1 2 3 1</matrix>", ErrorKind::unsupported,
              "the last row of <matrix> is not 0 0 0 1");
  refuse_node("<rotate>0 0 0 30</rotate>", ErrorKind::bad_file, "a direction of length 0");
  refuse_node("<skew>140 0 1 0 1 -1 0</skew>", ErrorKind::bad_file, "beyond its second");
  refuse_node("<scale>1e200 1 1</scale><scale>1e200 1 1</scale>", ErrorKind::not_finite,
              "<geometry id=\"g\"> under its transforms: x of a vertex");
  refuse_node("<instance_geometry url=\"file:///tmp/b.dae#g\"/>", ErrorKind::unsupported,
              "other files are not opened");
  expect_refused(document(geometry(kTriangle) + geometry(kTriangle), node(kShow)), "a.dae",
                 ErrorKind::bad_file, "which is defined twice");
  expect_refused(document("", node("")), "a.dae", ErrorKind::empty_mesh, "no triangles");
}

TEST(Collada, RefusesReferencesToTheCharacterZero) {
  const auto joined = [](const std::vector<std::string>& words) {
    return std::accumulate(words.begin(), words.end(), std::string());
  };
  const auto with = [](const std::string& reference) {
    return "<triangles>" + kInput + "<p>0 1 2 " + reference + " 0 2 3 0 3 1</p></triangles>";
  };
  for (const std::string zero : {"&#0;", "&#x0;", "&#000;", "&#4294967296;", "&#x100000000;"}) {
    SCOPED_TRACE(zero);
    const auto refuse = [](const std::string& text) {
      expect_refused(text, "a.dae", ErrorKind::bad_file, "line 4: not well-formed XML");
    };
    refuse(document(geometry(with(zero)), node(kShow)));
    refuse(document(geometry(with(joined({"<!-- \" -->", zero}))), node(kShow)));
    refuse(document(geometry(joined({"<lines a='<!--\"' b=\"", zero, "\"/>", kTriangle})),
                    node(kShow)));
    // Where nothing is decoded it is plain text.
    EXPECT_EQ(read_faces(with(joined({"<!-- ", zero, " -->"}))).triangles.size(), 3U);
    EXPECT_EQ(
        read_faces(joined({"<extra><![CDATA[<a ", zero, "]]></extra><?a ", zero, "?>", kTriangle}))
            .triangles.size(),
        1U);
  }
  EXPECT_EQ(read_faces(with("&#48; 1 2")).triangles.size(), 4U);
  EXPECT_EQ(read_faces("<lines name=\"&#; &#x; &#0 &#g0; &#1;\"/>" + kTriangle).triangles.size(),
            1U);
}

TEST(Collada, RefusesTwoColumnsOfOneCoordinate) {
  std::string text = document(geometry(kTriangle), node(kShow));
  const std::string z = R"(<param name="Z"/>)";
  text.replace(text.find(z), 0, R"(<param name="X"/>)");
  text.replace(text.find("count=\"5\" stride=\"3\""), 20, "count=\"3\" stride=\"4\"");
  expect_refused(text, "a.dae", ErrorKind::bad_file, "<source id=\"p\"> have two columns X");
}

TEST(Collada, BoundsScenesThatGrowWithoutShowingAnything) {
  std::string nodes = "<library_nodes>";
  for (int i = 0; i < 60; ++i) {
    const std::string next = "<instance_node url=\"#n" + std::to_string(i + 1) + "\"/>";
    nodes.append("<node id=\"n").append(std::to_string(i)).append("\">");
    nodes.append(next).append(next).append("</node>");
  }
  nodes += "<node id=\"n60\"/></library_nodes>";
  expect_refused(document("", node("<instance_node url=\"#n0\"/>"), nodes), "a.dae",
                 ErrorKind::out_of_range, "too large");
}

TEST(Collada, ReadsDeepFilesOnASmallStack) {
  on_small_stack([] {
    const Mesh mesh = read_mesh(data("bad/dae_deep.dae"));
    EXPECT_EQ(mesh.triangles.size(), 4U);
    // Elements and the brackets of a document type that nest without end.
    std::string deep = "<COLLADA>";
    std::string brackets = "<!DOCTYPE a ";
    for (int i = 0; i < 100'000; ++i) {
      deep += "<a>";
      brackets += "[<!x ";
    }
    expect_refused(deep, "deep.dae", ErrorKind::bad_file, "not well-formed XML");
    expect_refused(brackets, "brackets.dae", ErrorKind::unsupported, "an XML file");
  });
}

TEST(Collada, IsReportedByItsContent) {
  const std::string text = document(geometry(kTriangle), node(kShow));
  EXPECT_EQ(read_text("\xef\xbb\xbf<!-- a > b -->\n" + text.substr(21), "model").triangles.size(),
            1U);
  EXPECT_TRUE(detail::is_collada("<?xml?><!DOCTYPE x [<!ENTITY y \"]>\">]> <COLLADA>"));
  EXPECT_FALSE(detail::is_collada("<?xml?><x3d>"));
  EXPECT_FALSE(detail::is_collada("<COLLADAS>"));
  EXPECT_FALSE(detail::is_collada("<!-- <COLLADA>"));
  expect_refused(text, "model.stl", ErrorKind::bad_file,
                 "the content is COLLADA, but the extension says STL");
}

/// A reading of one file by hand, with nothing in common with the reader: numbers of the arrays,
/// triangulated quads counted by vcount.
TEST(Collada, ReadsTheDuckOfOthers) {
  SOMS_NEEDS_OUTSIDE_DATA("other/duck.dae");
  const Mesh mesh = read_mesh(*outside_data("other/duck.dae"));
  EXPECT_EQ(mesh.triangles.size(), 4212U);
  EXPECT_EQ(mesh.vertices.size(), 2108U);
  EXPECT_EQ(mesh.unit, 0.01);
  EXPECT_EQ(mesh.up, UpAxis::y);
  // Duck.glb is the same model in meters; COUNTS.csv holds its bounds.
  const Box box = bounds(mesh);
  const Vec3 lower = {-69.2984985, 9.9293697, -61.3281961};
  const Vec3 upper = {96.1798990, 163.9699980, 53.9251964};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(box.lower[axis], lower[axis], 1e-4);
    EXPECT_NEAR(box.upper[axis], upper[axis], 1e-4);
  }
}

}  // namespace
}  // namespace soms::test
