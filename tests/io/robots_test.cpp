#include "soms/base/print.h"
#include "soms/io/print.h"
#include "soms/io/robot.h"
#include "soms/io/write_mesh.h"
#include "soms/kinematics/kinematics.h"
#include "soms/kinematics/link_pairs.h"
#include "soms/kinematics/print.h"

#include "tests/io/files.h"
#include "tests/support/bodies.h"
#include "tests/support/support.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace soms::test {
namespace {

Robot robot_of(std::string_view text, const RobotReadOptions& options = {}) {
  return read_robot(std::as_bytes(std::span(text)), "made.urdf", options);
}

std::string one_link(const std::string& shape, const std::string& origin = {}) {
  return "<robot name=\"r\"><link name=\"a\"><collision>" + origin + "<geometry>" + shape +
         "</geometry></collision></link></robot>";
}

std::string mesh_element(const std::string& file, const std::string& more = {}) {
  return "<mesh filename=\"" + file + "\"" + more + "/>";
}

TEST(ReadRobot, NamesTextInUtf16) {
  std::string text = "\xff\xfe";
  for (const char c : one_link("<box size=\"1 1 1\"/>")) {
    text += c + std::string(1, '\0');
  }
  expect_refused([&] { static_cast<void>(robot_of(text)); }, ErrorKind::unsupported,
                 "made.urdf: text in UTF-16; save it as ASCII or UTF-8");
  EXPECT_EQ(robot_of("\xef\xbb\xbf" + one_link("<box size=\"1 1 1\"/>")).links.size(), 1U);
}

TEST(ReadRobot, ReadsLinksAndJoints) {
  const Robot robot = read_robot(data("robots/arm.urdf"));
  EXPECT_EQ(robot.name, "arm");
  ASSERT_EQ(robot.links.size(), 6U);
  EXPECT_EQ(robot.links[2].name, "boom");
  EXPECT_EQ(robot.links[2].collisions.size(), 2U);
  EXPECT_EQ(bounds(robot.links[0].collisions.at(0)), (Box{{-0.5, -0.5, -0.2}, {0.5, 0.5, 0}}));
  ASSERT_EQ(robot.joints.size(), 5U);
  EXPECT_EQ(robot.joints[0].type, JointType::continuous);
  EXPECT_TRUE(std::isinf(robot.joints[0].upper));
  EXPECT_EQ(robot.joints[1].upper, 0.7);
  EXPECT_EQ(robot.joints[1].origin, Pose::translation(0, 0, 0.2));
  EXPECT_EQ(robot.joints[4].mimic, (Mimic{.joint = 3, .multiplier = 1, .offset = 0}));
  EXPECT_FALSE(robot.allowed);
  EXPECT_GT(robot.tessellation_error, 0);
  EXPECT_LE(robot.tessellation_error, 0.0005);
  EXPECT_TRUE(robot.notes.empty());
}

TEST(ReadRobot, TakesTheAxisAndLimitsOfUrdfWhereNoneAreGiven) {
  const Robot robot = robot_of(
      R"(<robot name="r"><link name="a"/><link name="b"/><joint name="j" type="revolute">
         <parent link="a"/><child link="b"/><limit effort="1" velocity="1"/></joint></robot>)");
  EXPECT_EQ(robot.joints[0].axis, (Vec3{1, 0, 0}));
  EXPECT_EQ(robot.joints[0].lower, 0);
  EXPECT_EQ(robot.joints[0].upper, 0);
}

TEST(ReadRobot, ReadsSemantics) {
  const Robot robot = read_robot(data("robots/arm.urdf"), {.srdf = data("robots/arm.srdf")});
  // column (1) with all but left (4); boom (2) with both fingers.
  EXPECT_EQ(robot.allowed, (std::vector<LinkPair>{{0, 1}, {1, 2}, {1, 3}, {1, 5}, {2, 4}, {2, 5}}));
  ASSERT_EQ(robot.states.size(), 1U);
  EXPECT_EQ(robot.states[0].name, "up");
  EXPECT_EQ(robot.states[0].values,
            (std::vector<std::pair<std::uint32_t, double>>{{1, 0.6}, {3, 0.03}}));
  EXPECT_EQ(compared_pairs(robot), (std::vector<LinkPair>{{0, 2}, {0, 4}, {0, 5}, {1, 4}, {4, 5}}));
}

TEST(ReadRobot, NotesTheSemanticsOfAnotherRobot) {
  Robot robot = read_robot(data("robots/arm.urdf"));
  const std::string_view text = "<robot name=\"leg\"/>";
  read_semantics(robot, std::as_bytes(std::span(text)), "leg.srdf");
  ASSERT_EQ(robot.notes.size(), 1U);
  EXPECT_NE(robot.notes[0].find("\"leg\""), std::string::npos);
  robot.notes.clear();
  expect_refused(
      [&] { read_semantics(robot, std::as_bytes(std::span(text)), "leg.srdf", {.strict = true}); },
      ErrorKind::bad_file, "leg");
}

TEST(ReadRobot, NotesLinksThatAreDrawnAlone) {
  const std::string text =
      "<robot name=\"r\"><link name=\"a\"><visual><geometry><sphere radius=\"1\"/></geometry>"
      "</visual></link></robot>";
  EXPECT_EQ(robot_of(text).notes,
            (std::vector<std::string>{
                "links that are drawn and have no collision geometry: 1, in line 1"}));
  expect_refused([&] { static_cast<void>(robot_of(text, {.strict = true})); }, ErrorKind::bad_file,
                 "no collision geometry");
}

/// A folder of packages: robots/arm_description/{urdf/arm.urdf, meshes/box.off}.
class Packages {
 public:
  explicit Packages(const std::string& shape) {
    std::filesystem::create_directories(package() / "urdf");
    std::filesystem::create_directories(package() / "meshes");
    write_mesh(package() / "meshes" / "box.off", box_body({0, 0, 0}, {1, 2, 4}), MeshFormat::off,
               {});
    write_content(urdf(), one_link(shape));
  }

  [[nodiscard]] std::filesystem::path package() const { return folder_.path() / "arm_description"; }

  [[nodiscard]] std::filesystem::path urdf() const { return package() / "urdf" / "arm.urdf"; }

  [[nodiscard]] const std::filesystem::path& root() const { return folder_.path(); }

  [[nodiscard]] Box box(const RobotReadOptions& options = {}) const {
    return bounds(read_robot(urdf(), options).links[0].collisions.at(0));
  }

 private:
  TemporaryFolder folder_;
};

const Box kStoredBox{{0, 0, 0}, {1, 2, 4}};

TEST(ReadRobot, FindsMeshesBesideTheFile) {
  EXPECT_EQ(Packages(mesh_element("../meshes/box.off")).box(), kStoredBox);
  EXPECT_EQ(Packages(mesh_element("file://../meshes/box.off")).box(), kStoredBox);
}

TEST(ReadRobot, FindsMeshesByWholePaths) {
  const Packages packages("<sphere radius=\"1\"/>");
  const std::string mesh = (packages.package() / "meshes" / "box.off").string();
  for (const std::string& uri : {mesh, "file://" + mesh}) {
    EXPECT_EQ(bounds(robot_of(one_link(mesh_element(uri))).links[0].collisions.at(0)), kStoredBox);
  }
}

TEST(ReadRobot, FindsPackagesAboveTheFile) {
  EXPECT_EQ(Packages(mesh_element("package://arm_description/meshes/box.off")).box(), kStoredBox);
  // A sibling of a folder above.
  const Packages sibling(mesh_element("package://shapes/box.off"));
  std::filesystem::create_directory(sibling.root() / "shapes");
  write_mesh(sibling.root() / "shapes" / "box.off", box_body({0, 0, 0}, {1, 1, 1}), MeshFormat::off,
             {});
  EXPECT_EQ(sibling.box(), (Box{{0, 0, 0}, {1, 1, 1}}));
}

TEST(ReadRobot, FindsPackagesByTheirManifest) {
  const Packages packages(mesh_element("package://other_name/meshes/box.off"));
  expect_refused([&] { static_cast<void>(packages.box()); }, ErrorKind::cannot_open,
                 "package \"other_name\" is not found");
  write_content(packages.package() / "package.xml", "<package><name>other_name</name></package>\n");
  EXPECT_EQ(packages.box(), kStoredBox);
}

TEST(ReadRobot, FindsPackagesThatAreNamed) {
  const Packages packages(mesh_element("package://far/meshes/box.off"));
  EXPECT_EQ(packages.box({.packages = {{"far", packages.package()}}}), kStoredBox);
  expect_refused(
      [&] {
        static_cast<void>(packages.box({.packages = {{"near", packages.package()}}}));
      },
      ErrorKind::cannot_open, "\"far\"");
  std::filesystem::create_directories(packages.root() / "ws");
  std::filesystem::rename(packages.package() / "meshes", packages.root() / "ws" / "meshes");
  std::filesystem::create_directories(packages.root() / "ws" / "far");
  std::filesystem::rename(packages.root() / "ws" / "meshes",
                          packages.root() / "ws" / "far" / "meshes");
  EXPECT_EQ(packages.box({.package_path = {packages.root() / "none", packages.root() / "ws"}}),
            kStoredBox);
}

TEST(ReadRobot, NamesTheElementOfAMissingMesh) {
  const Packages packages(mesh_element("package://arm_description/meshes/none.stl"));
  expect_refused([&] { static_cast<void>(packages.box()); }, ErrorKind::cannot_open,
                 "arm.urdf, line 1: mesh \"package://arm_description/meshes/none.stl\"");
}

TEST(ReadRobot, ScalesMirrorsAndMovesMeshes) {
  EXPECT_EQ(Packages(mesh_element("../meshes/box.off", " scale=\"2 -1 0.5\"")).box(),
            (Box{{0, -2, 0}, {2, 0, 2}}));
  const Packages packages("<sphere radius=\"1\"/>");
  write_content(packages.urdf(), one_link(mesh_element("../meshes/box.off", " scale=\"2 2 2\""),
                                          "<origin xyz=\"1 0 0\"/>"));
  EXPECT_EQ(packages.box(), (Box{{1, 0, 0}, {3, 4, 8}}));
}

TEST(ReadRobot, TakesTheUnitOfAMesh) {
  const Packages packages(mesh_element("../meshes/box.dae"));
  const std::string dae =
      R"(<COLLADA version="1.4.1"><asset><unit meter="0.001"/><up_axis>Z_UP</up_axis></asset>
      <library_geometries><geometry id="g"><mesh><source id="p"><float_array id="a" count="9">
      0 0 0 1000 0 0 0 2000 0</float_array><technique_common><accessor source="#a" count="3"
      stride="3"><param name="X"/><param name="Y"/><param name="Z"/></accessor></technique_common>
      </source><vertices id="v"><input semantic="POSITION" source="#p"/></vertices><triangles
      count="1"><input semantic="VERTEX" source="#v" offset="0"/><p>0 1 2</p></triangles></mesh>
      </geometry></library_geometries><library_visual_scenes><visual_scene id="s"><node>
      <instance_geometry url="#g"/></node></visual_scene></library_visual_scenes><scene>
      <instance_visual_scene url="#s"/></scene></COLLADA>)";
  write_content(packages.package() / "meshes" / "box.dae", dae);
  EXPECT_EQ(packages.box(), (Box{{0, 0, 0}, {1, 2, 0}}));
}

TEST(ReadRobot, ReadsAMeshOnceForManyLinks) {
  const Packages packages("<sphere radius=\"1\"/>");
  std::string text = "<robot name=\"r\"><link name=\"root\"/>";
  for (int k = 0; k < 300; ++k) {
    const std::string number = std::to_string(k);
    text += "<link name=\"l" + number + "\"><collision><geometry>" +
            mesh_element("../meshes/box.off") + "</geometry></collision></link><joint name=\"j" +
            number + "\" type=\"fixed\"><parent link=\"root\"/><child link=\"l" + number +
            "\"/></joint>";
  }
  write_content(packages.urdf(), text + "</robot>");
  EXPECT_EQ(read_robot(packages.urdf()).links.back().collisions.size(), 1U);
}

TEST(ReadRobot, KeepsToItsLimitOfMemory) {
  std::string text = "<robot name=\"r\"><link name=\"a\">";
  for (int k = 0; k < 200; ++k) {
    text += "<collision><geometry><sphere radius=\"1\"/></geometry></collision>";
  }
  text += "</link></robot>";
  expect_refused([&] { static_cast<void>(robot_of(text, {.max_memory = std::uint64_t{8} << 20})); },
                 ErrorKind::out_of_memory, "made.urdf");
}

TEST(ReadRobot, RefusesXacroFilesByName) {
  expect_refused([] { static_cast<void>(read_robot("arm.urdf.xacro")); }, ErrorKind::unsupported,
                 "run xacro");
  expect_refused([] { static_cast<void>(read_robot("none.urdf")); }, ErrorKind::cannot_open,
                 "none.urdf");
}

TEST(ReadRobot, RefusesErrorsOfRoundShapesThatAreNone) {
  for (const double error : {0.0, -1.0, std::nan("")}) {
    expect_refused([&] { static_cast<void>(robot_of("<robot/>", {.tessellation_error = error})); },
                   ErrorKind::usage, "round shapes");
  }
}

}  // namespace
}  // namespace soms::test
