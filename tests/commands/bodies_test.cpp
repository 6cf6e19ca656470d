// A body is what is closed, not what a file calls a group: every verb that speaks of bodies answers
// for a solid that a file cuts into open parts as for the whole solid.
#include "tests/support/bodies.h"

#include "soms/io/write_mesh.h"

#include "tests/commands/clash/cut_cube.h"
#include "tests/commands/run.h"
#include "tests/support/support.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace soms::test {
namespace {

/// Files of the cube and of what verbs are run with.
class CutFiles {
 public:
  CutFiles() {
    for (const double x : {0.0, 1.0, 3.0}) {
      write_mesh(path(probe(x)), box_body({x - 0.1, -0.1, -0.1}, {x + 0.1, 0.1, 0.1}),
                 MeshFormat::obj);
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
    const std::string block =
        cell
            ? ""
            : R"(<link name="block"><collision><geometry><mesh filename=")" + model +
                  R"("/></geometry></collision></link><joint name="f" type="fixed"><parent link="w"/><child link="block"/></joint>)";
    write_text(path("robot.urdf"),
               R"(<robot name="r"><link name="w"/><link name="probe"><collision><geometry>)"
               R"(<box size="0.2 0.2 0.2"/></geometry></collision></link><joint name="x" )"
               R"(type="prismatic"><parent link="w"/><child link="probe"/><axis xyz="1 0 0"/>)"
               R"(<limit lower="-5" upper="5" effort="1" velocity="1"/></joint>)" +
                   block + "</robot>");
    std::vector<std::string> words{"robot", path("robot.urdf"), "--states",
                                   "-",     "--json",           "--verify"};
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
      text += line.contains("open_parts") ? "open; " : "; ";
    }
    return text + std::to_string(result.status);
  }

  [[nodiscard]] std::string solid(const std::string& model) const {
    std::string text;
    for (const double x : {0.0, 1.0, 3.0}) {
      const RunResult result =
          soms_run({"solid", path(model), path(probe(x)), "--by", "part", "--json", "--verify"});
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

// The cube without a face. One part reaches around the probe at most, the first.
TEST(Bodies, ThatAreOpenAreUndecidedHoweverAFileCutsThem) {
  const CutFiles files;
  write_mesh(files.path("whole.off"), mesh_of({0, 0, 0, 0, 0, -1}), MeshFormat::off);
  const std::string whole = files.verdicts("whole.off");
  EXPECT_NE(whole.find("robot: undecided contact free"), std::string::npos) << whole;
  EXPECT_NE(whole.find("clash: undecided 0; crossing 0; 0"), std::string::npos) << whole;
  EXPECT_NE(whole.find("contains: open"), std::string::npos) << whole;
  EXPECT_NE(whole.find("solid: undecided 0; undecided 0; 0"), std::string::npos) << whole;
  for (const Cut& cut : {Cut{0, 0, 1, 2, 3, -1}, Cut{0, 1, 2, 3, 4, -1}}) {
    const std::vector<std::pair<std::string, std::string>> texts{
        {"g.obj", obj_of(cut, "g")},
        {"o.obj", obj_of(cut, "o")},
        {"usemtl.obj", obj_of(cut, "usemtl")},
        {"solids.stl", stl_of(cut)},
        {"materials.dae", dae_with_materials(cut)},
        {"nodes.dae", dae_with_nodes(cut)},
        {"objects.city.json", city_of(cut)},
        {"nodes.gltf", gltf_of(cut, true, files.folder())}};
    for (const auto& [name, text] : texts) {
      write_text(files.path(name), text);
      EXPECT_EQ(files.verdicts(name), whole) << name << " in " << parts_of(cut);
    }
  }
}

TEST(Bodies, ThatStayOpenTogetherAreARowOfClash) {
  TemporaryFolder folder;
  const std::string open = (folder.path() / "open.obj").string();
  write_text(open, obj_of({0, 1, 2, 3, 4, -1}, "g"));
  const std::string probe = data("bodies/probe.obj").string();
  const RunResult result = soms_run({"clash", open, "--against", probe, "--json", "--verify"});
  const std::vector<Json> lines = json_lines(result.out);
  ASSERT_EQ(lines.size(), 2U) << result.out << result.err;
  EXPECT_EQ(lines[0]["class"], "undecided");
  EXPECT_EQ(lines[0]["why"], "open");
  EXPECT_EQ(lines[0]["open"], Json({"a"}));
  EXPECT_EQ(lines[0]["a"]["part"], "p0");
  ASSERT_EQ(lines[0]["a"]["joined"].size(), 4U);
  EXPECT_EQ(lines[0]["a"]["joined"][3]["part"], "p4");
  EXPECT_EQ(lines[0]["a"]["odd_edges"], 4);
  EXPECT_FALSE(lines[0]["b"].contains("joined"));
  EXPECT_EQ(lines[1]["verified"], true);
  const RunResult text = soms_run({"clash", open, "--against", probe});
  EXPECT_NE(text.out.find("  undecided  p0 + p1 + 3 more and probe at "), std::string::npos)
      << text.out;
  EXPECT_NE(text.out.find(", the first is open at 4 edges\n"), std::string::npos) << text.out;
  // In one set, too, where rows between its parts stay.
  const RunResult one = soms_run({"clash", open, probe, "--json", "--verify"});
  std::size_t of_probe = 0;
  std::size_t of_faces = 0;
  for (const Json& line : json_lines(one.out)) {
    const bool is_row = line.contains("a");
    const bool has_probe = is_row && line["b"]["part"] == "probe";
    of_probe += has_probe ? 1 : 0;
    of_faces += is_row && !has_probe ? 1 : 0;
    EXPECT_TRUE(!is_row || line["a"].contains("joined") == has_probe) << line;
  }
  EXPECT_EQ(of_probe, 1U) << one.out;
  EXPECT_EQ(of_faces, 8U) << one.out;
}

TEST(Bodies, ThatStayOpenTogetherAreIgnoredWithAllTheirParts) {
  TemporaryFolder folder;
  const std::string open = (folder.path() / "open.obj").string();
  write_text(open, obj_of({0, 1, 2, 3, 4, -1}, "g"));
  const std::string probe = data("bodies/probe.obj").string();
  const std::string list = (folder.path() / "pairs.csv").string();
  const auto rows = [&](const std::string& pairs) {
    write_text(list, pairs);
    const RunResult result =
        soms_run({"clash", open, "--against", probe, "--json", "--ignore-pairs", list});
    return json_lines(result.out).size() - 1;
  };
  EXPECT_EQ(rows("p0,probe\n"), 1U);
  EXPECT_EQ(rows("p1,probe\n"), 1U);
  EXPECT_EQ(rows("p0,probe\np1,probe\np2,probe\np3,probe\n"), 1U);
  EXPECT_EQ(rows("p0,probe\np1,probe\np2,probe\np3,probe\nprobe,p4\n"), 0U);
  EXPECT_EQ(rows("p?,probe\n"), 0U);
}

// So that a list does not grow with the square of the parts.
TEST(Bodies, OfManyOpenPartsNameAHundred) {
  TemporaryFolder folder;
  const std::string strip = (folder.path() / "strip.obj").string();
  std::string text = "v 0 0 0\nv 0 9 0\n";
  for (int k = 1; k <= 150; ++k) {
    const std::string x = std::to_string(k);
    const std::string z = k == 150 ? "9" : "0";
    text += "v " + x + " 0 " + z + "\nv " + x + " 9 " + z + "\ng q" + x + "\nf -4 -2 -1 -3\n";
  }
  write_text(strip, text);
  const Mesh mesh = box_body({10.5, 4, 1}, {11, 5, 2});
  const std::string box = (folder.path() / "box.obj").string();
  write_mesh(box, mesh, MeshFormat::obj);
  const RunResult result = soms_run({"clash", strip, "--against", box, "--json"});
  const std::vector<Json> lines = json_lines(result.out);
  ASSERT_EQ(lines.size(), 2U) << result.out << result.err;
  EXPECT_EQ(lines[0]["a"]["part"], "q1");
  EXPECT_EQ(lines[0]["a"]["joined"].size(), 100U);
  EXPECT_EQ(lines[0]["a"]["joined_more"], 49);
}

/// The classes of the rows, and the parts of the first set.
std::string rows_between(const std::vector<std::string>& files,
                         const std::vector<std::string>& sets) {
  std::vector<std::string> words{"clash"};
  words.insert(words.end(), files.begin(), files.end());
  words.insert(words.end(), sets.begin(), sets.end());
  words.insert(words.end(), {"--set", "p=probe", "--between", "w,p", "--json", "--verify"});
  const RunResult result = soms_run(words);
  std::string text;
  for (const Json& line : json_lines(result.out)) {
    text += line.contains("a")
                ? line.value("class", "") + " " + line["a"].value("part", std::string()) + " "
                : std::string();
  }
  return text + std::to_string(result.status);
}

// Whichever part of the group is of the set, the group is looked at, but no other part is.
TEST(Bodies, ThatStayOpenTogetherAreOfTheSetsOfTheirParts) {
  TemporaryFolder folder;
  const std::string open = (folder.path() / "open.obj").string();
  write_text(open, obj_of({0, 1, 2, 3, 4, -1}, "g"));
  const std::string inside = data("bodies/probe.obj").string();
  for (const std::string part : {"p0", "p3"}) {
    EXPECT_EQ(rows_between({open, inside}, {"--set", "w=" + part}), "undecided p0 0");
  }
  Mesh mesh = box_body({-0.1, -0.1, -1.1}, {0.1, 0.1, -0.9});
  mesh.parts = {{.name = "probe", .first = 0, .count = 12}};
  const std::string through = (folder.path() / "through.obj").string();
  write_mesh(through, mesh, MeshFormat::obj);
  EXPECT_EQ(rows_between({open, through}, {"--set", "w=p0"}), "crossing p0 0");
  EXPECT_EQ(rows_between({open, through}, {"--set", "w=p3"}), "0");
}

/// Of a robot of reports, the verdicts of the states of probe.csv, and the status.
std::string reported(const std::vector<std::string>& words) {
  std::vector<std::string> all{"robot"};
  all.insert(all.end(), words.begin(), words.end());
  all.insert(all.end(),
             {"--states", data("bodies/probe.csv").string(), "--distance", "--json", "--strict"});
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
