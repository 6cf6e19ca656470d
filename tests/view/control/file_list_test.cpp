#include "apps/view/control/file_list.h"

#include "tests/support/support.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <optional>

namespace soms::view {
namespace {

namespace fs = std::filesystem;

class FileListTest : public testing::Test {
 protected:
  void SetUp() override {
    fs::create_directory(path("zoo"));
    fs::create_directory(path("Alps"));
    for (const char* const name :
         {"b.ply", "A.STL", "notes.txt", ".hidden.ply", "c.obj", "d.off", "zoo/lion.ply"}) {
      std::ofstream(path(name)) << "x";
    }
  }

  [[nodiscard]] fs::path path(const std::string& name) const { return folder_.path() / name; }

  static std::vector<std::string> texts(const FileList& list) {
    std::vector<std::string> all;
    for (const FileRow& row : list.rows()) {
      all.push_back(row.text);
    }
    return all;
  }

  soms::test::TemporaryFolder folder_;
};

TEST_F(FileListTest, ListsFoldersThenModels) {
  const FileList list(folder_.path());
  EXPECT_EQ(texts(list),
            (std::vector<std::string>{"Alps/", "zoo/", "A.STL", "b.ply", "c.obj", "d.off"}));
  EXPECT_EQ(list.fault(), "");
  EXPECT_EQ(list.chosen(), 0U);
}

TEST_F(FileListTest, EntersFoldersAndComesBackToThem) {
  FileList list(folder_.path());
  list.move(1);
  EXPECT_EQ(list.open(), std::nullopt);
  EXPECT_EQ(texts(list), std::vector<std::string>{"lion.ply"});
  EXPECT_EQ(list.open(), fs::weakly_canonical(path("zoo/lion.ply")));
  list.up();
  EXPECT_EQ(list.folder(), fs::weakly_canonical(folder_.path()));
  EXPECT_EQ(list.rows()[list.chosen()].text, "zoo/");
}

TEST_F(FileListTest, MovesToTheEndsAndNoFarther) {
  FileList list(folder_.path());
  list.move(-3);
  EXPECT_EQ(list.chosen(), 0U);
  list.move(100);
  EXPECT_EQ(list.chosen(), 5U);
  list.move(-2);
  EXPECT_EQ(list.chosen(), 3U);
  list.choose(77);
  EXPECT_EQ(list.chosen(), 5U);
}

TEST_F(FileListTest, JumpsToTheNextOfALetterAndRound) {
  FileList list(folder_.path());
  list.jump('A');
  EXPECT_EQ(list.rows()[list.chosen()].text, "A.STL");
  list.jump('A');
  EXPECT_EQ(list.rows()[list.chosen()].text, "Alps/");
  list.jump('Q');
  EXPECT_EQ(list.rows()[list.chosen()].text, "Alps/");
}

TEST_F(FileListTest, SaysWhyAFolderCannotBeRead) {
  FileList list(path("nowhere"));
  EXPECT_TRUE(list.rows().empty());
  EXPECT_NE(list.fault(), "");
  EXPECT_EQ(list.open(), std::nullopt);
  list.move(1);
  list.jump('A');
  EXPECT_EQ(list.chosen(), 0U);
}

TEST_F(FileListTest, NamesCannotSpeakToATerminal) {
  std::ofstream(path("e\x1b[2Jvil.ply")) << "x";
  FileList list(folder_.path());
  list.jump('E');
  EXPECT_EQ(list.rows()[list.chosen()].text, "e?[2Jvil.ply");
  EXPECT_EQ(list.open()->filename(), "e\x1b[2Jvil.ply");
}

TEST(FileList, GoesToAPathThatIsWrittenOut) {
  const soms::test::TemporaryFolder folder;
  std::filesystem::create_directory(folder.path() / "inner");
  std::ofstream(folder.path() / "inner" / "a.ply") << "x";
  FileList list(folder.path());
  EXPECT_EQ(list.go_to("inner"), std::nullopt);
  EXPECT_EQ(list.folder().filename(), "inner");
  ASSERT_EQ(list.rows().size(), 1U);
  const auto file = list.go_to((folder.path() / "inner" / "a.ply").string());
  ASSERT_TRUE(file);
  EXPECT_EQ(file->filename(), "a.ply");
  EXPECT_EQ(list.go_to("nowhere"), std::nullopt);
  EXPECT_FALSE(list.fault().empty());
}

}  // namespace
}  // namespace soms::view
