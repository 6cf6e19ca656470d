#include "soms/io/detail/simple/obj_groups.h"

#include "soms/geometry/parts_of.h"
#include "soms/io/read_mesh.h"
#include "soms/io/write_mesh.h"

#include "tests/io/files.h"
#include "tests/support/support.h"

#include <gtest/gtest.h>

#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace soms::test {
namespace {

constexpr std::uint32_t kNone = Part::kNoParent;

/// A model of triangles between these lines of names, `f` standing for one.
Mesh model(const std::string& lines) {
  std::string text = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  std::istringstream in(lines);
  for (std::string line; std::getline(in, line);) {
    text += line == "f" ? "f 1 2 3\n" : line + "\n";
  }
  return read_text(text, "a.obj");
}

Mesh written(const Mesh& mesh, MeshFormat format, const std::string& name) {
  std::ostringstream out;
  write_mesh(out, name, mesh, format);
  return read_text(out.str(), name);
}

/// Which triangles are of one part, by the first of each.
std::vector<TriangleId> partition(const Mesh& mesh) {
  const PartsOf part_of(mesh);
  std::map<std::uint32_t, TriangleId> first;
  std::vector<TriangleId> firsts;
  for (TriangleId i = 0; i < mesh.triangles.size(); ++i) {
    firsts.push_back(first.try_emplace(part_of(i), i).first->second);
  }
  return firsts;
}

TEST(ObjGroups, OfOneNameAreOnePartInRuns) {
  EXPECT_EQ(model("g wall\nf\ng pipe\nf\nf\ng wall\nf\ng pipe\nf").parts,
            (std::vector<Part>{
                {"wall", kNone, 0, 1},
                {"pipe", kNone, 1, 2},
                {.name = "wall", .parent = kNone, .first = 3, .count = 1, .continues = 0},
                {.name = "pipe", .parent = kNone, .first = 4, .count = 1, .continues = 1}}));
  // A group that is named again while it is open goes on.
  EXPECT_EQ(model("g wall\nf\nusemtl a\ng wall\nf\ng wall \nf").parts,
            (std::vector<Part>{{"wall", kNone, 0, 3}}));
}

TEST(ObjGroups, StandInTheirObject) {
  EXPECT_EQ(
      model("o house\nf\ng brick\nf\ng plaster\nf\ng brick\nf\no barn\ng brick\nf").parts,
      (std::vector<Part>{{"house", kNone, 0, 4},
                         {"brick", 0, 1, 1},
                         {"plaster", 0, 2, 1},
                         {.name = "brick", .parent = 0, .first = 3, .count = 1, .continues = 1},
                         {"barn", kNone, 4, 1},
                         {"brick", 4, 4, 1}}));
}

TEST(ObjGroups, ObjectsOfOneNameStayTwo) {
  EXPECT_EQ(model("o door\nf\no door\nf\ng pane\nf\no door\ng pane\nf").parts,
            (std::vector<Part>{{"door", kNone, 0, 1},
                               {"door", kNone, 1, 2},
                               {"pane", 1, 2, 1},
                               {"door", kNone, 3, 1},
                               {"pane", 3, 3, 1}}));
}

TEST(ObjGroups, WithoutANameAreTheObjectItself) {
  EXPECT_EQ(model("f\no car\ng body left\nf\nf\ng empty\ng\nf\ng body left\nf\n").parts,
            (std::vector<Part>{
                {"", kNone, 0, 1},
                {"car", kNone, 1, 4},
                {"body left", 1, 1, 2},
                {.name = "body left", .parent = 1, .first = 4, .count = 1, .continues = 2}}));
}

TEST(ObjGroups, WithoutANameAndWithoutAnObjectAreOnePart) {
  EXPECT_EQ(
      model("f\ng a\nf\ng\nf\ng a\nf\ng\nf").parts,
      (std::vector<Part>{{"", kNone, 0, 1},
                         {"a", kNone, 1, 1},
                         {.name = "", .parent = kNone, .first = 2, .count = 1, .continues = 0},
                         {.name = "a", .parent = kNone, .first = 3, .count = 1, .continues = 1},
                         {.name = "", .parent = kNone, .first = 4, .count = 1, .continues = 0}}));
}

TEST(ObjGroups, ThatWereEmptyAreNotKnown) {
  EXPECT_EQ(model("g a\ng b\nf\ng a\nf\no c\ng a\ng b\nf\ng a\nf").parts,
            (std::vector<Part>{{"b", kNone, 0, 1},
                               {"a", kNone, 1, 1},
                               {"c", kNone, 2, 2},
                               {"b", 2, 2, 1},
                               {"a", 2, 3, 1}}));
}

TEST(ObjGroups, OfSeveralNamesArePartsByTheWholeLine) {
  EXPECT_EQ(partition(model("g a b\nf\ng a\nf\ng b a\nf\ng a b\nf")),
            (std::vector<TriangleId>{0, 1, 2, 0}));
}

TEST(ObjGroups, MaterialsMakeNone) {
  EXPECT_TRUE(model("usemtl a\nf\nusemtl b\nf\nusemtl a\nf").parts.empty());
}

TEST(ObjGroups, AreReadBackEqual) {
  for (const std::string lines :
       {"f", "g a\nf\ng b\nf", "f\ng a\nf\ng\nf", "g a\nf\ng b\nf\ng a\nf",
        "o a\nf\no a\nf\ng b\nf", "o a\ng b\nf\ng c\nf\ng b\nf\ng\nf\no b\ng b\nf",
        "f\no a\nf\ng b\nf\no\nf\no\nf"}) {
    SCOPED_TRACE(lines);
    const Mesh mesh = model(lines);
    EXPECT_EQ(written(mesh, MeshFormat::obj, "a.obj").parts, mesh.parts);
    EXPECT_EQ(count_renamed(mesh, MeshFormat::obj), 0U);
  }
}

TEST(ObjGroups, OfOneNameAreNumbered) {
  Mesh mesh = model("o house\ng a\nf\ng b\nf\ng c\nf\ng a\nf");
  mesh.parts[2].name = "a";
  mesh.parts[3].name = "";
  EXPECT_EQ(count_renamed(mesh, MeshFormat::obj), 2U);
  const Mesh back = written(mesh, MeshFormat::obj, "a.obj");
  EXPECT_EQ(partition(back), partition(mesh));
  EXPECT_EQ(back.parts[2].name, "a_2");
  EXPECT_EQ(back.parts[3].name, "group");
  // Outermost parts of several runs are in no object, so that all names of the file must differ.
  mesh = model("g a\nf\ng b\nf\ng a\nf\ng b\nf");
  mesh.parts[1].name = mesh.parts[3].name = "a";
  EXPECT_EQ(count_renamed(mesh, MeshFormat::obj), 1U);
  EXPECT_EQ(partition(written(mesh, MeshFormat::obj, "a.obj")),
            (std::vector<TriangleId>{0, 1, 0, 1}));
}

/// Parts that nest up to four deep and have few names, some of them in several runs.
class RandomParts {
 public:
  explicit RandomParts(Rng& rng) : rng_(rng) { mesh_.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}; }

  Mesh make() {
    for (std::uint64_t i = 1 + rng_.below(4); i > 0; --i) {
      add(kNone, 0);
    }
    if (mesh_.triangles.empty()) {
      mesh_.triangles.push_back({0, 1, 2});
    }
    return std::move(mesh_);
  }

 private:
  void add(std::uint32_t parent, int depth) {
    const auto number = static_cast<std::uint32_t>(mesh_.parts.size());
    const auto first = static_cast<std::uint32_t>(mesh_.triangles.size());
    const std::vector<std::string> names{"", "a", "b", "a_2", "group"};
    mesh_.parts.push_back({names[rng_.below(names.size())], parent, first, 0});
    for (std::uint32_t other = 0; other < number; ++other) {
      if (mesh_.parts[other].parent == parent && mesh_.parts[other].continues == kNone &&
          mesh_.parts[other].count > 0 && rng_.below(4) == 0) {
        mesh_.parts[number].continues = other;
        mesh_.parts[number].name = mesh_.parts[other].name;
        break;
      }
    }
    for (std::uint64_t i = 1 + rng_.below(3); i > 0; --i) {
      mesh_.triangles.push_back({0, 1, 2});
      if (depth < 3 && rng_.below(2) == 0) {
        add(number, depth + 1);
      }
    }
    mesh_.parts[number].count = static_cast<std::uint32_t>(mesh_.triangles.size()) - first;
  }

  Rng& rng_;
  Mesh mesh_;
};

TEST(ObjGroups, KeepTwoPartsTwoAndOnePartOne) {
  for_each_case("io/obj-groups", 2000, [](Rng& rng) {
    const Mesh mesh = RandomParts(rng).make();
    ASSERT_NO_THROW(check(mesh));
    const Mesh back = written(mesh, MeshFormat::obj, "a.obj");
    EXPECT_EQ(partition(back), partition(mesh));
  });
}

/// A COLLADA file whose scene shows a triangle by two nodes.
std::string two_nodes_of_one_name() {
  const std::string node = R"(<node name="a"><instance_geometry url="#g"/></node>)";
  return R"(<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">)"
         R"(<library_geometries><geometry id="g"><mesh><source id="p">)"
         R"(<float_array id="n" count="9">0 0 0 1 0 0 0 1 0</float_array><technique_common>)"
         R"(<accessor source="#n" count="3" stride="3"><param name="X" type="float"/>)"
         R"(<param name="Y" type="float"/><param name="Z" type="float"/></accessor>)"
         R"(</technique_common></source><vertices id="v">)"
         R"(<input semantic="POSITION" source="#p"/></vertices><triangles count="1">)"
         R"(<input semantic="VERTEX" source="#v" offset="0"/><p>0 1 2</p></triangles></mesh>)"
         R"(</geometry></library_geometries><library_visual_scenes><visual_scene id="s">)" +
         node + node +
         R"(</visual_scene></library_visual_scenes><scene><instance_visual_scene url="#s"/>)"
         R"(</scene></COLLADA>)";
}

TEST(ObjGroups, OfOtherFormatsAreKnownByTheirPlace) {
  const auto solids = [](const std::string& before, const std::string& between) {
    const std::string facet =
        "facet normal 0 0 0\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\n"
        "endfacet\n";
    return before + facet + between + facet + "endsolid\n";
  };
  // Two solids of one name stay two, as programs call all of theirs alike.
  EXPECT_EQ(read_text(solids("solid a\n", "endsolid a\nsolid a\n"), "a.stl").parts,
            (std::vector<Part>{{"a", kNone, 0, 1}, {"a", kNone, 1, 1}}));
  // So do objects of 3DS, which its writer gives names that differ.
  EXPECT_EQ(written(model("o a\nf\no a\nf"), MeshFormat::three_ds, "a.3ds").parts,
            (std::vector<Part>{{"a", kNone, 0, 1}, {"a_2", kNone, 1, 1}}));
  // And nodes of COLLADA and glTF.
  EXPECT_EQ(read_text(two_nodes_of_one_name(), "a.dae").parts,
            (std::vector<Part>{{"a", kNone, 0, 1}, {"a", kNone, 1, 1}}));
  EXPECT_EQ(written(model("o a\nf\no a\nf"), MeshFormat::glb, "a.glb").parts,
            (std::vector<Part>{{"a", kNone, 0, 1}, {"a", kNone, 1, 1}}));
}

TEST(ObjGroups, TakeMemoryThatIsCounted) {
  std::string text = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  for (int i = 0; i < 2000; ++i) {
    text += "g " + std::to_string(i) + std::string(40, 'x') + "\nf 1 2 3\n";
  }
  expect_refused(
      [&] {
        static_cast<void>(read_text(text, "a.obj", {.max_memory = std::uint64_t{700} << 10}));
      },
      ErrorKind::out_of_memory, "memory");
  EXPECT_EQ(read_text(text, "a.obj").parts.size(), 2000U);
}

}  // namespace
}  // namespace soms::test
