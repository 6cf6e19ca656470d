// Files that people reported elsewhere, each as a user meets it.
#include "tests/commands/run.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

namespace soms::test {
namespace {

std::string reported(const std::string& name) {
  return test::data("reports/" + name).string();
}

/// The rows of `clash`, and the totals last.
std::vector<Json> clashes_of(const std::vector<std::string>& models) {
  std::vector<std::string> words{"clash", "--json", "--verify"};
  words.insert(words.end(), models.begin(), models.end());
  const RunResult result = soms_run(words);
  EXPECT_EQ(result.status, 0) << result.err;
  return json_lines(result.out);
}

TEST(ReportedFiles, GroupTwiceIsOnePart) {
  const std::vector<Json> twice = clashes_of({reported("group_twice.obj")});
  const std::vector<Json> once = clashes_of({reported("group_once.obj")});
  ASSERT_EQ(twice.size(), 2U);
  ASSERT_EQ(once.size(), 2U);
  for (const char* const key : {"class", "triangle_pairs", "box", "key"}) {
    EXPECT_EQ(twice[0].at(key), once[0].at(key)) << key;
  }
  EXPECT_EQ(twice[0].at("a").at("part"), "wall");
  EXPECT_EQ(twice[0].at("b").at("part"), "pipe");
  EXPECT_EQ(twice[1].at("parts"), Json::array({2, 0}));
}

TEST(ReportedFiles, GroupTwiceStaysOnePartWhenItIsConverted) {
  const TemporaryFolder folder;
  const std::string copy = (folder.path() / "copy.obj").string();
  const RunResult result = soms_run({"convert", reported("group_twice.obj"), copy});
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(result.err.find("does not keep"), std::string::npos) << result.err;
  EXPECT_EQ(clashes_of({copy}).front().at("key"),
            clashes_of({reported("group_twice.obj")}).front().at("key"));
  // Other formats have no object of several pieces.
  for (const char* const name : {"copy.glb", "copy.3ds"}) {
    const RunResult other =
        soms_run({"convert", reported("group_twice.obj"), (folder.path() / name).string()});
    EXPECT_NE(other.err.find("1 part in one piece"), std::string::npos) << other.err;
  }
}

TEST(ReportedFiles, ObjectsHoldTheirGroups) {
  const std::vector<Json> lines = clashes_of({reported("o_and_g.obj")});
  EXPECT_TRUE(std::any_of(lines.begin(), lines.end() - 1, [](const Json& row) {
    return row.at("a").at("path").front() == "Wall_1" && row.at("b").at("path").front() == "Pipe_1";
  }));
  const RunResult text = soms_run({"clash", reported("o_and_g.obj")});
  EXPECT_NE(text.out.find("Wall_1"), std::string::npos) << text.out;
  EXPECT_NE(text.out.find("Pipe_1"), std::string::npos) << text.out;
}

TEST(ReportedFiles, OffGluedIsRead) {
  const RunResult result = soms_run({"info", reported("off_glued.off"), "--json"});
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(json_lines(result.out).front().at("triangles"), 12);
}

TEST(ReportedFiles, HiddenNodesAreReadAndSaid) {
  const RunResult result = soms_run({"info", reported("hidden.gltf")});
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_NE(result.out.find("KHR_node_visibility"), std::string::npos) << result.out;
  EXPECT_EQ(soms_run({"info", reported("hidden.gltf"), "--strict"}).status, 3);
}

TEST(ReportedFiles, OrphanChildLacksParentsAndTheErrorSaysSo) {
  const RunResult result = soms_run({"info", reported("orphan_child.json")});
  EXPECT_EQ(result.status, 3);
  EXPECT_NE(result.err.find("the object \"c\" has no \"parents\""), std::string::npos)
      << result.err;
}

TEST(ReportedFiles, StlBinAttrbytesHasAttributesThatAreNoLengths) {
  const RunResult result = soms_run({"info", reported("stl_bin_attrbytes.stl")});
  EXPECT_EQ(result.status, 3);
  EXPECT_NE(result.err.find("attributes of STL are no lengths"), std::string::npos) << result.err;
}

/// A folder as a Mac leaves it: models, hidden files, files of other kinds.
class MacFolder {
 public:
  MacFolder() {
    write("._cube.obj", std::string("\0\5\26\7\0\2\0\0Mac OS X        \0\2", 26));
    write(".DS_Store", "");
    write("notes.json", "{\"a\":1}\n");
    const std::string solid =
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
    for (const char* const name : {"cube.obj", "cube (1).OBJ", "cube.obj.bak", "cube.obj~"}) {
      write(name, solid);
    }
  }

  void write(const std::string& name, const std::string& text) const {
    write_text(folder_.path() / name, text);
  }

  [[nodiscard]] std::string path() const { return folder_.path().string(); }

 private:
  TemporaryFolder folder_;
};

TEST(ReportedFiles, MacfolderIsReadWithoutWhatIsNoModel) {
  const MacFolder folder;
  const RunResult result = soms_run({"clash", folder.path(), "--json"});
  EXPECT_EQ(result.status, 0) << result.err;
  const Json totals = json_lines(result.out).back();
  EXPECT_EQ(totals.at("parts"), Json::array({2, 0}));
  EXPECT_EQ(totals.at("by_class").at("same"), 1);
  const std::string note =
      folder.path() + ": 3 files that are not models (cube.obj.bak, ...) not read";
  EXPECT_NE(result.err.find(note), std::string::npos) << result.err;
  EXPECT_EQ(totals.at("notes"), Json::array({note}));
  std::filesystem::remove(folder.path() + "/cube.obj~");
  std::filesystem::remove(folder.path() + "/cube.obj.bak");
  std::filesystem::create_directory(folder.path() + "/.git");
  std::filesystem::create_directory(folder.path() + "/more");
  const RunResult fewer = soms_run({"clash", folder.path()});
  EXPECT_NE(fewer.err.find(": 1 file that is not a model (notes.json) and 1 subfolder not read"),
            std::string::npos)
      << fewer.err;
}

TEST(ReportedFiles, MacfolderIsReadAlikeAsACell) {
  const MacFolder folder;
  const RunResult result = soms_run({"robot", data("robots/arm.urdf").string(), "--cell",
                                     folder.path(), "--random", "1", "--json"});
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_NE(result.err.find("3 files that are not models (cube.obj.bak, ...) not read"),
            std::string::npos)
      << result.err;
}

// A model that is broken is no other file: it must not be passed over.
TEST(ReportedFiles, AFolderWithABrokenModelIsRefused) {
  const MacFolder folder;
  folder.write("city.json", "{\"type\": \"CityJSON\", \"version\": \"2.0\"");
  const RunResult result = soms_run({"clash", folder.path()});
  EXPECT_EQ(result.status, 3);
  EXPECT_NE(result.err.find("city.json"), std::string::npos) << result.err;
}

/// A model that is missing is an obstacle that is missing.
TEST(ReportedFiles, AFolderWithALinkToNoModelIsRefused) {
  const MacFolder folder;
  std::filesystem::create_symlink("/nonexistent.obj",
                                  std::filesystem::path(folder.path()) / "wall.obj");
  const RunResult result = soms_run({"clash", folder.path()});
  EXPECT_EQ(result.status, 3);
  EXPECT_NE(result.err.find("wall.obj"), std::string::npos) << result.err;
}

}  // namespace
}  // namespace soms::test
