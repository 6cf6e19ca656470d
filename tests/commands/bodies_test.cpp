// A body is what is closed, not what a file calls a group: every verb that speaks of bodies answers
// for a solid that a file cuts into open parts as for the whole solid.
#include "soms/io/write_mesh.h"

#include "tests/commands/run.h"
#include "tests/support/bodies.h"
#include "tests/support/cut_mesh.h"
#include "tests/support/support.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace soms::test {
namespace {

/// Corners of the cube [-1, 1]^3, and its faces, seen from outside.
constexpr std::array<std::array<int, 3>, 8> kCorners{
    {{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1}, {-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1}}};
constexpr std::array<std::array<int, 4>, 6> kFaces{
    {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}};

/// The number of the part that each face is in, from 0 on.
using Cut = std::array<int, 6>;

int parts_of(const Cut& cut) {
  return 1 + *std::max_element(cut.begin(), cut.end());
}

std::string obj_corners() {
  std::string text;
  for (const auto& v : kCorners) {
    text += "v";
    for (const int x : v) {
      text += " " + std::to_string(x);
    }
    text += "\n";
  }
  return text;
}

std::string obj_face(int face) {
  std::string text = "f";
  for (const int v : kFaces[static_cast<std::size_t>(face)]) {
    text += " " + std::to_string(v + 1);
  }
  return text + "\n";
}

/// Faces by parts, each behind `head` of its number.
std::string by_part(const Cut& cut, const std::function<std::string(int)>& head,
                    const std::function<std::string(int)>& face,
                    const std::function<std::string(int)>& tail) {
  std::string text;
  for (int part = 0; part < parts_of(cut); ++part) {
    text += head(part);
    for (int k = 0; k < 6; ++k) {
      text += cut[static_cast<std::size_t>(k)] == part ? face(k) : "";
    }
    text += tail(part);
  }
  return text;
}

std::string nothing(int) {
  return {};
}

std::string obj_of(const Cut& cut, const std::string& keyword) {
  return obj_corners() +
         by_part(
             cut, [&](int part) { return keyword + " p" + std::to_string(part) + "\n"; }, obj_face,
             nothing);
}

/// Each face behind the name of its group, so that names come again.
std::string obj_with_names_again(const Cut& cut) {
  std::string text = obj_corners();
  for (int k = 0; k < 6; ++k) {
    text += "g p" + std::to_string(cut[static_cast<std::size_t>(k)]) + "\n" + obj_face(k);
  }
  return text;
}

/// The two triangles of a face, by corners.
std::vector<int> triangles_of(int face) {
  const auto& f = kFaces[static_cast<std::size_t>(face)];
  return {f[0], f[1], f[2], f[0], f[2], f[3]};
}

std::string stl_face(int face) {
  std::string text;
  const std::vector<int> corners = triangles_of(face);
  for (std::size_t k = 0; k < corners.size(); ++k) {
    text += k % 3 == 0 ? "facet normal 0 0 0\nouter loop\n" : "";
    text += "vertex";
    for (const int x : kCorners[static_cast<std::size_t>(corners[k])]) {
      text += " " + std::to_string(x);
    }
    text += k % 3 == 2 ? "\nendloop\nendfacet\n" : "\n";
  }
  return text;
}

std::string stl_of(const Cut& cut) {
  return by_part(
      cut, [](int part) { return "solid p" + std::to_string(part) + "\n"; }, stl_face,
      [](int part) { return "endsolid p" + std::to_string(part) + "\n"; });
}

std::string dae_faces(const Cut& cut, int part) {
  std::string numbers;
  int count = 0;
  for (int k = 0; k < 6; ++k) {
    if (cut[static_cast<std::size_t>(k)] == part) {
      for (const int v : triangles_of(k)) {
        numbers += std::to_string(v) + " ";
      }
      count += 2;
    }
  }
  return "<triangles material=\"m" + std::to_string(part) + "\" count=\"" + std::to_string(count) +
         "\"><input semantic=\"VERTEX\" source=\"#v\" offset=\"0\"/><p>" + numbers +
         "</p></triangles>";
}

std::string dae_geometry(const std::string& faces, int number) {
  std::string points;
  for (const auto& v : kCorners) {
    for (const int x : v) {
      points += std::to_string(x) + " ";
    }
  }
  const std::string id = std::to_string(number);
  std::string text = "<geometry id=\"g#\" name=\"g#\"><mesh><source id=\"p#\"><float_array "
                     "id=\"a#\" count=\"24\">" +
                     points +
                     "</float_array><technique_common><accessor source=\"#a#\" count=\"8\" "
                     "stride=\"3\"><param name=\"X\"/><param name=\"Y\"/><param name=\"Z\"/>"
                     "</accessor></technique_common></source><vertices id=\"v#\"><input "
                     "semantic=\"POSITION\" source=\"#p#\"/></vertices>" +
                     faces + "</mesh></geometry>";
  std::string numbered;
  for (std::size_t k = 0; k < text.size(); ++k) {
    const bool ends = text[k] == '#' && k + 1 < text.size() && text[k + 1] == '"';
    numbered += ends ? id : std::string(1, text[k]);
  }
  const std::string vertices = "source=\"#v\"";
  for (std::size_t at = numbered.find(vertices); at != std::string::npos;
       at = numbered.find(vertices, at + 1)) {
    numbered.replace(at, vertices.size(), "source=\"#v" + id + "\"");
  }
  return numbered;
}

std::string dae_of(const std::string& geometries, const std::string& nodes) {
  return "<?xml version=\"1.0\"?><COLLADA version=\"1.4.1\"><library_geometries>" + geometries +
         "</library_geometries><library_visual_scenes><visual_scene id=\"s\">" + nodes +
         "</visual_scene></library_visual_scenes><scene><instance_visual_scene url=\"#s\"/>"
         "</scene></COLLADA>";
}

std::string dae_with_materials(const Cut& cut) {
  std::string faces;
  for (int part = 0; part < parts_of(cut); ++part) {
    faces += dae_faces(cut, part);
  }
  return dae_of(dae_geometry(faces, 0),
                "<node name=\"n\"><instance_geometry url=\"#g0\"/></node>");
}

std::string dae_with_nodes(const Cut& cut) {
  std::string geometries;
  std::string nodes;
  for (int part = 0; part < parts_of(cut); ++part) {
    geometries += dae_geometry(dae_faces(cut, part), part);
    nodes += "<node name=\"n" + std::to_string(part) + "\"><instance_geometry url=\"#g" +
             std::to_string(part) + "\"/></node>";
  }
  return dae_of(geometries, nodes);
}

std::string city_of(const Cut& cut) {
  std::string vertices;
  for (const auto& v : kCorners) {
    vertices += (vertices.empty() ? "[" : ",[") + std::to_string(v[0]) + "," + std::to_string(v[1]) +
                "," + std::to_string(v[2]) + "]";
  }
  std::string objects;
  for (int part = 0; part < parts_of(cut); ++part) {
    std::string faces;
    for (int k = 0; k < 6; ++k) {
      if (cut[static_cast<std::size_t>(k)] == part) {
        const auto& f = kFaces[static_cast<std::size_t>(k)];
        faces += (faces.empty() ? "[[" : ",[[") + std::to_string(f[0]) + "," + std::to_string(f[1]) +
                 "," + std::to_string(f[2]) + "," + std::to_string(f[3]) + "]]";
      }
    }
    objects += (objects.empty() ? "\"p" : ",\"p") + std::to_string(part) +
               R"(":{"type":"Building","geometry":[{"type":"MultiSurface","lod":"1","boundaries":[)" +
               faces + "]}]}";
  }
  return R"({"type":"CityJSON","version":"2.0","transform":{"scale":[1,1,1],"translate":[0,0,0]},)"
         R"("CityObjects":{)" +
         objects + R"(},"vertices":[)" + vertices + "]}";
}

/// A glTF file, and cube.bin beside it: primitives of one mesh, or a node for each part.
std::string gltf_of(const Cut& cut, bool nodes, const std::filesystem::path& folder) {
  std::string bytes;
  for (const auto& v : kCorners) {
    for (const int x : v) {
      const auto value = static_cast<float>(x);
      std::array<char, 4> raw{};
      std::memcpy(raw.data(), &value, raw.size());
      bytes.append(raw.data(), raw.size());
    }
  }
  std::string accessors = R"({"bufferView":0,"componentType":5126,"count":8,"type":"VEC3",)"
                          R"("min":[-1,-1,-1],"max":[1,1,1]})";
  std::string views = R"({"buffer":0,"byteOffset":0,"byteLength":96})";
  std::vector<std::string> primitives;
  for (int part = 0; part < parts_of(cut); ++part) {
    const std::size_t begin = bytes.size();
    for (int k = 0; k < 6; ++k) {
      if (cut[static_cast<std::size_t>(k)] == part) {
        for (const int v : triangles_of(k)) {
          bytes.push_back(static_cast<char>(v));
          bytes.push_back('\0');
        }
      }
    }
    const std::size_t size = bytes.size() - begin;
    views += R"(,{"buffer":0,"byteOffset":)" + std::to_string(begin) + R"(,"byteLength":)" +
             std::to_string(size) + "}";
    accessors += R"(,{"bufferView":)" + std::to_string(part + 1) +
                 R"(,"componentType":5123,"count":)" + std::to_string(size / 2) +
                 R"(,"type":"SCALAR"})";
    primitives.push_back(R"({"attributes":{"POSITION":0},"indices":)" + std::to_string(part + 1) +
                         "}");
  }
  std::string meshes;
  std::string node_list;
  std::string roots;
  for (std::size_t k = 0; k < primitives.size(); ++k) {
    const std::string comma = k == 0 ? "" : ",";
    if (nodes) {
      meshes += comma + R"({"primitives":[)" + primitives[k] + "]}";
    } else {
      meshes += comma + primitives[k];
    }
    if (nodes || k == 0) {
      node_list += comma + R"({"mesh":)" + std::to_string(k) + R"(,"name":"n)" +
                   std::to_string(k) + "\"}";
      roots += comma + std::to_string(k);
    }
  }
  meshes = nodes ? meshes : R"({"primitives":[)" + meshes + "]}";
  write_text((folder / "cube.bin").string(), bytes);
  return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[)" + roots +
         R"(]}],"nodes":[)" + node_list + R"(],"meshes":[)" + meshes + R"(],"accessors":[)" +
         accessors + R"(],"bufferViews":[)" + views + R"(],"buffers":[{"uri":"cube.bin",)" +
         R"("byteLength":)" + std::to_string(bytes.size()) + "}]}";
}

/// The cube as a mesh whose parts are those of the cut.
Mesh mesh_of(const Cut& cut) {
  Mesh mesh;
  std::vector<std::uint32_t> label;
  for (const auto& v : kCorners) {
    mesh.vertices.push_back(
        {static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2])});
  }
  for (int k = 0; k < 6; ++k) {
    const std::vector<int> corners = triangles_of(k);
    for (std::size_t i = 0; i < corners.size(); i += 3) {
      mesh.triangles.push_back({static_cast<std::uint32_t>(corners[i]),
                                static_cast<std::uint32_t>(corners[i + 1]),
                                static_cast<std::uint32_t>(corners[i + 2])});
      label.push_back(static_cast<std::uint32_t>(cut[static_cast<std::size_t>(k)]));
    }
  }
  return cut_by(mesh, label, static_cast<std::uint32_t>(parts_of(cut)));
}

/// Files of the cube and of what is asked about it.
class CutFiles {
 public:
  CutFiles() {
    for (const double x : {0.0, 1.0, 3.0}) {
      write_mesh(path(probe(x)),
                 box_body({x - 0.1, -0.1, -0.1}, {x + 0.1, 0.1, 0.1}), MeshFormat::obj);
    }
    write_text(path("points.csv"), "x,y,z\n0,0,0\n0.9,0.9,-0.9\n2,0,0\n1,0,0\n");
  }

  [[nodiscard]] std::string path(const std::string& name) const {
    return (folder_.path() / name).string();
  }

  [[nodiscard]] const std::filesystem::path& folder() const { return folder_.path(); }

  [[nodiscard]] static std::string probe(double x) {
    return "probe" + std::to_string(static_cast<int>(x)) + ".obj";
  }

  /// What every verb says of a model and the probes, in words.
  [[nodiscard]] std::string verdicts(const std::string& model) const {
    return "robot: " + robot(model, false) + "\ncell: " + robot(model, true) +
           "\nclash: " + clash(model) + "\ncontains: " + contains(model) +
           "\nsolid: " + solid(model) + "\n";
  }

 private:
  [[nodiscard]] std::string robot(const std::string& model, bool cell) const {
    const std::string block = cell ? ""
                                   : R"(<link name="block"><collision><geometry><mesh filename=")" +
                                         model +
                                         R"("/></geometry></collision></link><joint name="f" type="fixed"><parent link="w"/><child link="block"/></joint>)";
    write_text(path("robot.urdf"),
               R"(<robot name="r"><link name="w"/><link name="probe"><collision><geometry>)"
               R"(<box size="0.2 0.2 0.2"/></geometry></collision></link><joint name="x" )"
               R"(type="prismatic"><parent link="w"/><child link="probe"/><axis xyz="1 0 0"/>)"
               R"(<limit lower="-5" upper="5" effort="1" velocity="1"/></joint>)" +
                   block + "</robot>");
    std::vector<std::string> words{"robot", path("robot.urdf"), "--states", "-", "--json",
                                   "--verify"};
    if (cell) {
      words.insert(words.end(), {"--cell", path(model)});
    }
    const RunResult result = soms_run(words, "x\n0\n1\n3\n");
    std::string text;
    for (const Json& line : json_lines(result.out)) {
      text += line.value("verdict", "") + " ";
    }
    return text + std::to_string(result.status);
  }

  [[nodiscard]] std::string clash(const std::string& model) const {
    std::string text;
    for (const double x : {0.0, 1.0, 3.0}) {
      const RunResult result =
          soms_run({"clash", path(model), "--against", path(probe(x)), "--json", "--verify"});
      for (const Json& line : json_lines(result.out)) {
        text += line.contains("relation") ? line["relation"].get<std::string>() + " " : "";
      }
      text += std::to_string(result.status) + "; ";
    }
    return text;
  }

  [[nodiscard]] std::string contains(const std::string& model) const {
    const RunResult result = soms_run({"contains", path(model), "--by", "part", "--points",
                                       path("points.csv"), "--json", "--verify"});
    std::string text;
    for (const Json& line : json_lines(result.out)) {
      for (const Json& part : line["parts"]) {
        text += part["side"].get<std::string>() + " ";
      }
      text += "; ";
    }
    return text + std::to_string(result.status);
  }

  [[nodiscard]] std::string solid(const std::string& model) const {
    std::string text;
    for (const double x : {0.0, 1.0, 3.0}) {
      const RunResult result = soms_run(
          {"solid", path(model), path(probe(x)), "--by", "part", "--json", "--verify"});
      for (const Json& line : json_lines(result.out)) {
        for (const Json& pair : line["parts"]) {
          text += pair["relation"].get<std::string>() + " ";
        }
      }
      text += std::to_string(result.status) + "; ";
    }
    return text;
  }

  TemporaryFolder folder_;
};

TEST(Bodies, AreWholeHoweverAFileCutsThem) {
  const CutFiles files;
  write_mesh(files.path("whole.off"), mesh_of({0, 0, 0, 0, 0, 0}), MeshFormat::off);
  const std::string whole = files.verdicts("whole.off");
  EXPECT_NE(whole.find("robot: contact contact free"), std::string::npos) << whole;
  EXPECT_NE(whole.find("clash: b_in_a"), std::string::npos) << whole;
  EXPECT_NE(whole.find("contains: inside"), std::string::npos) << whole;
  EXPECT_NE(whole.find("solid: b_in_a"), std::string::npos) << whole;
  for (const Cut& cut : {Cut{0, 0, 0, 1, 1, 1}, Cut{0, 1, 0, 1, 2, 2}, Cut{0, 1, 2, 3, 4, 5}}) {
    const std::vector<std::pair<std::string, std::string>> texts{
        {"g.obj", obj_of(cut, "g")},
        {"o.obj", obj_of(cut, "o")},
        {"usemtl.obj", obj_of(cut, "usemtl")},
        {"g_in_o.obj", "o block\n" + obj_of(cut, "g")},
        {"again.obj", obj_with_names_again(cut)},
        {"solids.stl", stl_of(cut)},
        {"materials.dae", dae_with_materials(cut)},
        {"nodes.dae", dae_with_nodes(cut)},
        {"objects.city.json", city_of(cut)}};
    for (const auto& [name, text] : texts) {
      write_text(files.path(name), text);
      EXPECT_EQ(files.verdicts(name), whole) << name << " in " << parts_of(cut);
    }
    for (const bool nodes : {false, true}) {
      const std::string name = nodes ? "nodes.gltf" : "primitives.gltf";
      write_text(files.path(name), gltf_of(cut, nodes, files.folder()));
      EXPECT_EQ(files.verdicts(name), whole) << name << " in " << parts_of(cut);
    }
    for (const std::string name : {"objects.3ds", "objects.glb", "groups.obj"}) {
      write_mesh(files.path(name), mesh_of(cut), format_for(name));
      EXPECT_EQ(files.verdicts(name), whole) << name << " in " << parts_of(cut);
    }
  }
}

/// Of a robot of reports, the verdicts of the states of probe.csv, and the status.
std::string reported(const std::vector<std::string>& words) {
  std::vector<std::string> all{"robot"};
  all.insert(all.end(), words.begin(), words.end());
  all.insert(all.end(), {"--states", data("bodies/probe.csv").string(), "--distance", "--json",
                         "--strict"});
  const RunResult result = soms_run(all);
  std::string text;
  for (const Json& line : json_lines(result.out)) {
    text += line.value("verdict", "") + " ";
  }
  return text + std::to_string(result.status);
}

TEST(Bodies, OfTwoGroupsHoldAProbe) {
  EXPECT_EQ(reported({data("bodies/two_groups.urdf").string()}), "contact contact free  0");
}

TEST(Bodies, OfTwoGroupsInACellHoldAProbe) {
  EXPECT_EQ(reported({data("bodies/probe_only.urdf").string(), "--cell",
                      data("bodies/two_groups.obj").string()}),
            "contact contact free  0");
}

TEST(Bodies, OfOneGroupHoldAProbe) {
  EXPECT_EQ(reported({data("bodies/one_group.urdf").string()}), "contact contact free  0");
}

TEST(Bodies, OfTwoGroupsAreOneRowOfClash) {
  const RunResult result = soms_run({"clash", data("bodies/two_groups.obj").string(), "--against",
                                     data("bodies/probe.obj").string(), "--json"});
  const std::vector<Json> lines = json_lines(result.out);
  ASSERT_EQ(lines.size(), 2U) << result.out << result.err;
  EXPECT_EQ(lines[0]["class"], "inside");
  EXPECT_EQ(lines[0]["a"]["part"], "painted");
  ASSERT_EQ(lines[0]["a"]["joined"].size(), 1U);
  EXPECT_EQ(lines[0]["a"]["joined"][0]["part"], "raw");
  const RunResult alone = soms_run({"clash", data("bodies/two_groups.obj").string(), "--json"});
  EXPECT_EQ(json_lines(alone.out).size(), 1U) << "parts of one body are no clash: " << alone.out;
  // Either name fits.
  for (const std::string name : {"painted", "raw", "painted + raw"}) {
    TemporaryFolder folder;
    const std::string list = (folder.path() / "ignore.txt").string();
    write_text(list, "\"" + name + "\",probe\n");
    const RunResult ignored =
        soms_run({"clash", data("bodies/two_groups.obj").string(), "--against",
                  data("bodies/probe.obj").string(), "--json", "--ignore-pairs", list});
    EXPECT_EQ(json_lines(ignored.out).size(), 1U) << name << ignored.out << ignored.err;
  }
}

/// A box without a face: what may lie in it is undecided.
TEST(Bodies, ThatStayOpenAreUndecidedByRobot) {
  TemporaryFolder folder;
  const std::string cell = (folder.path() / "open.obj").string();
  std::string text = obj_corners();
  for (int k = 0; k < 5; ++k) {
    text += "g p" + std::to_string(k) + "\n" + obj_face(k);
  }
  write_text(cell, text);
  const std::vector<std::string> words{"robot",    data("bodies/probe_only.urdf").string(),
                                       "--cell",   cell,
                                       "--states", data("bodies/probe.csv").string()};
  const auto with = [&](const std::vector<std::string>& more) {
    std::vector<std::string> all = words;
    all.insert(all.end(), more.begin(), more.end());
    return soms_run(all);
  };
  const RunResult json = with({"--json", "--distance", "--verify"});
  EXPECT_EQ(json.status, 0);
  const std::vector<Json> lines = json_lines(json.out);
  ASSERT_EQ(lines.size(), 4U);
  EXPECT_EQ(lines[0]["verdict"], "undecided");
  EXPECT_EQ(lines[0]["undecided_pairs"], 1);
  EXPECT_EQ(lines[0]["coverage"], "complete");
  EXPECT_EQ(lines[1]["verdict"], "contact");
  EXPECT_EQ(lines[2]["verdict"], "free");
  EXPECT_EQ(lines[3]["undecided"], 1);
  EXPECT_EQ(lines[3]["coverage"], "complete");
  ASSERT_EQ(lines[3]["warnings"].size(), 1U);
  EXPECT_EQ(lines[3]["warnings"][0]["kind"], "open");
  EXPECT_NE(json.err.find("warning: 1 state undecided"), std::string::npos) << json.err;
  EXPECT_NE(with({"--distance"}).out.find("state 0: undecided, surfaces 0.9 apart"),
            std::string::npos);
  EXPECT_EQ(with({"--strict"}).status, 3);
  EXPECT_EQ(with({"--fail-if", "contact"}).status, 1);
  // Where nothing touches, an undecided state is no proof.
  write_text((folder.path() / "q.csv").string(), "x\n0\n3\n");
  std::vector<std::string> free = words;
  free.back() = (folder.path() / "q.csv").string();
  free.insert(free.end(), {"--fail-if", "contact"});
  EXPECT_EQ(soms_run(free).status, 4);
}

}  // namespace
}  // namespace soms::test
