// IFC by web-ifc: where it is looked for, how its child is started, and, where it is installed,
// what it reads. Scripts stand for Node.js elsewhere.
#include "soms/base/error.h"
#include "soms/geometry/mesh.h"
#include "soms/io/detail/import/import_program.h"
#include "soms/io/detail/source.h"
#include "soms/io/read_mesh.h"

#include "tests/io/files.h"
#include "tests/support/support.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace soms::test {
namespace {

namespace fs = std::filesystem;

/// An environment variable while the object lives.
class Variable {
 public:
  Variable(const char* name, const std::string& value) : name_(name) {
    const char* const before = std::getenv(name);
    before_ = before == nullptr ? "" : before;
    setenv(name, value.c_str(), 1);
  }

  ~Variable() { setenv(name_, before_.c_str(), 1); }

  Variable(const Variable&) = delete;
  Variable& operator=(const Variable&) = delete;

 private:
  const char* name_;
  std::string before_;
};

/// A folder that looks like the npm package, and a script in the place of Node.js.
class FakeIfc : public testing::Test {
 protected:
  FakeIfc() {
    fs::create_directory(package());
    write_content(package() / "package.json", "{}");
    write_content(package() / "web-ifc-api-node.js", "");
  }

  [[nodiscard]] fs::path package() const { return folder_.path() / "web-ifc"; }

  [[nodiscard]] fs::path node() const { return folder_.path() / "node"; }

  void make_node(const std::string& script) const {
    write_content(node(), "#!/bin/sh\n" + script + "\n");
    fs::permissions(node(), fs::perms::owner_all);
  }

  TemporaryFolder folder_;
};

std::string text(char kind, const std::string& words) {
  return std::string(1, kind) + bytes_of(words.size(), 4) + words;
}

std::string plain(const std::string& words) {
  return bytes_of(words.size(), 4) + words;
}

/// One triangle.
std::string triangle() {
  std::string bytes;
  for (const auto& [x, y] : {std::array{0.0, 0.0}, std::array{1.0, 0.0}, std::array{0.0, 1.0}}) {
    bytes += "v" + bytes_of(x) + bytes_of(y) + bytes_of(0.0);
  }
  return bytes + "f" + bytes_of(3, 4) + bytes_of(0, 4) + bytes_of(1, 4) + bytes_of(2, 4);
}

const std::string kAnswer = "soms-import 1\n" + text('b', "level 1") + "d" + plain("storey id") +
                            plain("IfcBuildingStorey") + bytes_of(0, 4) + text('b', "wall") + "d" +
                            plain("2O2Fr$t4X7Zf8NOew3FLOH") + plain("IfcWall") + bytes_of(2, 4) +
                            plain("Tag") + plain("7") + plain("Description") + plain("") +
                            triangle() + "ee.";

TEST_F(FakeIfc, GivesPartsTheirIdsTypesAndAttributes) {
  // The script checks its words: what it runs, the package, the extension.
  make_node(
      "case \"$1\" in */soms-import-ifc.mjs) ;; *) exit 10;; esac\n[ -f \"$1\" ] || exit 11\n"
      "[ \"$2\" = '" +
      package().string() +
      "' ] || exit 12\n[ \"$3\" = .ifc ] || exit 13\n"
      "[ \"$#\" = 3 ] || exit 14\n[ \"$(cat)\" = 'a model' ] || exit 15\ncat \"$0.answer\"");
  write_content(node().string() + ".answer", kAnswer);
  const Variable by_package("SOMS_WEB_IFC", package());
  const Variable by_node("SOMS_NODE", node());
  const Mesh mesh = read_text("a model", "house.IFC");
  ASSERT_EQ(mesh.parts.size(), 2U);
  EXPECT_EQ(mesh.parts[0].id, "storey id");
  EXPECT_EQ(mesh.parts[1], (Part{"wall",
                                 0,
                                 0,
                                 1,
                                 "2O2Fr$t4X7Zf8NOew3FLOH",
                                 "IfcWall",
                                 {{"Tag", "7"}, {"Description", ""}}}));
}

TEST_F(FakeIfc, RefusesADescriptionThatIsDamaged) {
  const Variable by_package("SOMS_WEB_IFC", package());
  const Variable by_node("SOMS_NODE", node());
  make_node("cat \"$0.answer\"");
  const auto refuse = [&](const std::string& records, const std::string& words) {
    write_content(node().string() + ".answer", "soms-import 1\n" + records);
    expect_refused("a model", "house.ifc", ErrorKind::bad_file, words);
  };
  refuse("d" + plain("") + plain("") + bytes_of(0, 4), "a part is described that has not begun");
  const std::string begun = text('b', "wall") + "d" + plain("id") + plain("IfcWall");
  refuse(begun + bytes_of(0xffffffff, 4) + ".", "cut off");
  refuse(begun + bytes_of(1, 4) + plain("Tag"), "cut off");
  for (std::size_t size = kAnswer.size() - 1; size > 20; --size) {
    write_content(node().string() + ".answer", kAnswer.substr(0, size));
    EXPECT_TRUE(refusal_of([] { static_cast<void>(read_text("a model", "house.ifc")); })) << size;
  }
}

TEST_F(FakeIfc, NamesWebIfcWhereItFails) {
  const Variable by_package("SOMS_WEB_IFC", package());
  const Variable by_node("SOMS_NODE", node());
  make_node("echo 'it is cut off'; exit 1");
  expect_refused("a model", "house.ifc", ErrorKind::bad_file,
                 "web-ifc cannot read it as .ifc: it is cut off");
  make_node("exit 4");
  expect_refused("a model", "house.ifc", ErrorKind::out_of_memory, "web-ifc exceeds its memory");
  make_node("kill -ABRT $$");
  expect_refused("a model", "house.ifc", ErrorKind::bad_file, "web-ifc crashed (signal 6");
}

TEST_F(FakeIfc, BoundsTheDataOfTheChildNotItsAddresses) {
  const Variable by_package("SOMS_WEB_IFC", package());
  const Variable by_node("SOMS_NODE", node());
  make_node(
      "while [ \"$(ulimit -d)\" = unlimited ]; do :; done\n"
      "echo \"$(ulimit -d) $(ulimit -v)\"; exit 1");
  const auto refusal = refusal_of(
      [] { static_cast<void>(read_text("a model", "house.ifc", {.max_memory = 64 << 20})); });
  ASSERT_TRUE(refusal);
  // KiB: 512 MiB of its own, and what the model left.
  EXPECT_NE(refusal->words.find(": 5898"), std::string::npos) << refusal->words;
  EXPECT_NE(refusal->words.find(" unlimited"), std::string::npos) << refusal->words;
}

TEST_F(FakeIfc, SaysWhatAVariableDoesNotName) {
  const Variable by_package("SOMS_WEB_IFC", folder_.path());
  expect_refused("a model", "house.ifc", ErrorKind::unsupported,
                 "SOMS_WEB_IFC does not name the npm package web-ifc");
  const Variable right("SOMS_WEB_IFC", package());
  const Variable by_node("SOMS_NODE", "/nonexistent/node");
  expect_refused("a model", "house.ifc", ErrorKind::unsupported,
                 "SOMS_NODE does not name a program");
}

TEST_F(FakeIfc, LeavesOtherFormatsAndANamedProgramAlone) {
  const Variable by_node("SOMS_NODE", node());
  const Variable by_program("SOMS_IMPORT", node());
  make_node("echo \"$*\"; exit 1");
  expect_refused("a model", "house.ifc", ErrorKind::bad_file,
                 "soms-import cannot read it as .ifc: .ifc");
  expect_refused("a model", "house.ifc", ErrorKind::bad_file, "npm install -g web-ifc");
  const Variable by_package("SOMS_WEB_IFC", package());
  expect_refused("a model", "house.step", ErrorKind::bad_file,
                 "soms-import cannot read it as .step: .step");
}

/// The same package, to be found: the script says which it was given.
class FoundIfc : public FakeIfc {
 protected:
  FoundIfc() { fs::create_directory(programs()); }

  [[nodiscard]] fs::path programs() const { return folder_.path() / "bin"; }

  void make_program(const std::string& name, const std::string& script) const {
    write_content(programs() / name, "#!/bin/sh\n" + script + "\n");
    fs::permissions(programs() / name, fs::perms::owner_all);
  }

  void move_package(const fs::path& modules) const {
    fs::create_directories(folder_.path() / modules);
    fs::rename(package(), folder_.path() / modules / "web-ifc");
  }

  void expect_found(const fs::path& modules) const {
    make_program("node", "echo \"given $2\"; exit 1");
    expect_refused("a model", "house.ifc", ErrorKind::bad_file,
                   "web-ifc cannot read it as .ifc: given " +
                       (fs::canonical(folder_.path()) / modules / "web-ifc").string());
  }

  const Variable no_package_{"SOMS_WEB_IFC", ""};
  const Variable no_node_{"SOMS_NODE", ""};
  const Variable no_list_{"NODE_PATH", ""};
  const Variable path_{"PATH", "relative:" + programs().string() + ":/usr/bin:/bin"};
};

TEST_F(FoundIfc, BesideTheNodeThatPathNames) {
  move_package("lib/node_modules");
  expect_found("lib/node_modules");
}

TEST_F(FoundIfc, ByNodePath) {
  move_package("elsewhere");
  const Variable list("NODE_PATH", "relative:" + (folder_.path() / "elsewhere").string());
  expect_found("elsewhere");
}

TEST_F(FoundIfc, InTheCurrentFolder) {
  move_package("project/node_modules");
  const fs::path before = fs::current_path();
  fs::current_path(folder_.path() / "project");
  expect_found("project/node_modules");
  fs::current_path(before);
}

TEST_F(FoundIfc, ByWhatNpmSays) {
  for (const char* const place : {"/usr/local/lib", "/usr/lib"}) {
    if (fs::exists(fs::path(place) / "node_modules/web-ifc")) {
      GTEST_SKIP() << "web-ifc in " << place << " is found first";
    }
  }
  move_package("configured");
  make_program("npm",
               "[ \"$*\" = 'root -g' ] && echo '" + (folder_.path() / "configured").string() + "'");
  expect_found("configured");
}

/// web-ifc as `make test` installs it.
class WebIfc : public testing::Test {
 protected:
  void SetUp() override {
    if (!fs::exists(fs::path(SOMS_TEST_WEB_IFC) / "package.json")) {
      GTEST_SKIP() << "web-ifc is not in the build: tools/install_web_ifc.sh installs it by npm";
    }
  }

  const Variable package_{"SOMS_WEB_IFC", SOMS_TEST_WEB_IFC};
};

using Names = std::vector<std::string>;

Names names_of(const Mesh& mesh) {
  Names all;
  for (const Part& part : mesh.parts) {
    all.push_back(part.name);
  }
  return all;
}

/// The wall of voiding.ifc with a door in its hole, the hole made by `line` of this schema.
Mesh with_hole(const std::string& line, const std::string& schema) {
  std::string text = content_of(data("ifc/voiding.ifc"));
  const auto replace = [&](const std::string& old, const std::string& now) {
    const auto at = text.find(old);
    ASSERT_NE(at, std::string::npos) << old;
    text.replace(at, old.size(), now);
  };
  replace("IFCVOIDINGFEATURE('0000000000000000000003',$,'V',$,$,#20,#24,$,.CUTOUT.)", line);
  replace("'IFC4'", "'" + schema + "'");
  return read_text(text, "hole.ifc");
}

TEST_F(WebIfc, MakesNoBodyOfAHole) {
  EXPECT_EQ(names_of(read_mesh(data("ifc/opening.ifc"))), (Names{"W", "D"}));
  const Mesh mesh = read_mesh(data("ifc/voiding.ifc"));
  EXPECT_EQ(names_of(mesh), (Names{"W", "D"}));
  EXPECT_EQ(mesh.parts[0].count, 28U);  // the hole is cut
  EXPECT_EQ(mesh.notes.size(), 1U);
}

TEST_F(WebIfc, MakesNoBodyOfWhatIsNone) {
  const std::string begun = "('0000000000000000000003',$,'V',$,$,#20,#24,$";
  for (const auto& [line, schema] : std::vector<std::pair<std::string, std::string>>{
           {"IFCOPENINGELEMENT" + begun + ")", "IFC2X3"},
           {"IFCOPENINGSTANDARDCASE" + begun + ",.OPENING.)", "IFC4"},
           {"IFCEARTHWORKSCUT" + begun + ",.CUT.)", "IFC4X3"},
           {"IFCVIRTUALELEMENT" + begun + ")", "IFC2X3"},
           {"IFCVIRTUALELEMENT" + begun + ")", "IFC4"},
           {"IFCSPACE" + begun + ",.ELEMENT.,.INTERNAL.,$)", "IFC2X3"},
           {"IFCSPACE" + begun + ",.ELEMENT.,.SPACE.,$)", "IFC4"},
           {"IFCBUILDING" + begun + ",.ELEMENT.,$,$,$)", "IFC2X3"},
           {"IFCSPATIALZONE" + begun + ",.FIRESAFETY.)", "IFC4"},
           {"IFCEXTERNALSPATIALELEMENT" + begun + ",.EXTERNAL.)", "IFC4"}}) {
    const Mesh mesh = with_hole(line, schema);
    EXPECT_EQ(names_of(mesh), (Names{"W", "D"})) << line << " " << schema;
    EXPECT_EQ(mesh.notes.size(), 1U) << line << " " << schema;
  }
}

TEST_F(WebIfc, KeepsWhatIsABody) {
  const std::string begun = "('0000000000000000000003',$,'V',$,$,#20,#24,$";
  for (const std::string& line :
       {"IFCBEAM" + begun + ",$)", "IFCSITE" + begun + ",.ELEMENT.,$,$,$,$,$)"}) {
    Names names = names_of(with_hole(line, "IFC4"));
    std::sort(names.begin(), names.end());
    EXPECT_EQ(names, (Names{"D", "V", "W"})) << line;
  }
}

TEST_F(WebIfc, CountsAnElementThatAHoleTakesWhole) {
  const Mesh mesh = read_mesh(data("ifc/lost_void.ifc"));
  EXPECT_EQ(names_of(mesh), Names{"A"});
  ASSERT_EQ(mesh.notes.size(), 2U);
  EXPECT_EQ(mesh.notes[1],
            "elements with a shape of which web-ifc makes no triangles, not read: 1, the first "
            "IfcBeam 'B' (0000000000000000000003)");
}

/// The house of assimp-testmodels, if it is installed.
class WebIfcHouse : public WebIfc {
 protected:
  void SetUp() override {
    WebIfc::SetUp();
    if (!fs::exists(kHouse)) {
      GTEST_SKIP() << kHouse << " is not there: it is of the package assimp-testmodels";
    }
  }

  static constexpr const char* kHouse = "/usr/share/assimp/models/IFC/AC14-FZK-Haus.ifc";
};

TEST_F(WebIfcHouse, ReadsElementsInTheirStoreys) {
  const Mesh mesh = read_mesh(kHouse);
  check(mesh);
  EXPECT_EQ(mesh.up, UpAxis::z);
  EXPECT_EQ(mesh.unit, 1);
  ASSERT_FALSE(mesh.notes.empty());
  EXPECT_EQ(mesh.notes[0].substr(0, 15), "read by web-ifc");
  const auto slab = std::find_if(mesh.parts.begin(), mesh.parts.end(), [](const Part& part) {
    return part.id == "1pPHnf7cXCpPsNEnQf8_6B";
  });
  ASSERT_NE(slab, mesh.parts.end());
  EXPECT_EQ(slab->name, "Bodenplatte");
  EXPECT_EQ(slab->type, "IfcSlab");
  EXPECT_EQ(slab->count, 12U);
  ASSERT_NE(slab->parent, Part::kNoParent);
  EXPECT_EQ(mesh.parts[slab->parent].name, "0. Erdgeschoss");
  EXPECT_EQ(mesh.parts[slab->parent].type, "IfcBuildingStorey");
  // The slab is the ground of the house, z up.
  Box box;
  for (TriangleId t = slab->first; t < slab->first + slab->count; ++t) {
    box.grow(bounds(mesh.triangle(t)));
  }
  EXPECT_NEAR(box.lower.z, -0.2, 1e-6);
  EXPECT_NEAR(box.upper.z, 0, 1e-6);
  EXPECT_NEAR(box.upper.x, 12, 1e-6);
  EXPECT_NEAR(box.upper.y, 10, 1e-6);
}

TEST_F(WebIfcHouse, RefusesAFileThatIsCutOffOrNone) {
  const std::string whole = content_of(kHouse);
  expect_refused(whole.substr(0, whole.size() / 2), "house.ifc", ErrorKind::bad_file,
                 "it is cut off: END-ISO-10303-21 is missing");
  expect_refused("no model", "house.ifc", ErrorKind::bad_file,
                 "does not begin as an IFC file does");
}

}  // namespace
}  // namespace soms::test
