#include "apps/output/output.h"

#include "apps/cli/progress.h"
#include "tests/commands/run.h"
#include "tests/support/wait.h"

#include <sys/stat.h>

#include <algorithm>
#include <cstdlib>

namespace soms::test {
namespace {

TEST(Output, FailsWhenTheDiskIsFull) {
  const std::string box = test::data("truth/meshes/box2.ply").string();
  const std::vector<std::string> lines{"$soms generate sphere -o /dev/full",
                                       "$soms generate sphere -o - > /dev/full",
                                       "$soms info '" + box + "' > /dev/full",
                                       "$soms overlap '" + box + "' '" + box + "' > /dev/full",
                                       "$soms --help > /dev/full",
                                       "$soms overlap --help > /dev/full",
                                       "$soms completion bash > /dev/full"};
  for (std::string line : lines) {
    if (line.find("generate sphere -o /dev") != std::string::npos) {
      line += " --format ply";
    }
    const RunResult result = shell(line);
    EXPECT_EQ(result.status, 5) << line << ": " << result.err;
    EXPECT_NE(result.err.find("No space left on device"), std::string::npos) << result.err;
  }
}

TEST(Output, LeavesNothingBehindWhenAFileMayNotGrow) {
  const TemporaryFolder folder;
  const std::string path = (folder.path() / "big.ply").string();
  const RunResult result =
      shell("ulimit -f 8; $soms generate sphere --triangles 100000 -o '" + path + "'");
  EXPECT_EQ(result.status, 5) << result.err;
  EXPECT_NE(result.err.find("File too large"), std::string::npos) << result.err;
  EXPECT_TRUE(files_in(folder.path()).empty());
}

TEST(Output, KeepsTheOldFileWhenTheNewOneFails) {
  const TemporaryFolder folder;
  const std::string path = (folder.path() / "model.ply").string();
  write_text(path, "old");
  EXPECT_EQ(shell("ulimit -f 8; $soms generate sphere --triangles 100000 -o '" + path + "'").status,
            5);
  EXPECT_EQ(read_text(path), "old");
  EXPECT_EQ(files_in(folder.path()), std::vector<std::string>{"model.ply"});
}

TEST(Output, ReplacesAFileAndKeepsItsPermissions) {
  const TemporaryFolder folder;
  const std::string path = (folder.path() / "model.ply").string();
  write_text(path, "old");
  ASSERT_EQ(chmod(path.c_str(), 0640), 0);
  ASSERT_EQ(soms_run({"generate", "sphere", "-o", path}).status, 0);

  struct stat status {};

  ASSERT_EQ(stat(path.c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777U, 0640U);
  EXPECT_TRUE(read_text(path).starts_with("ply"));
}

TEST(Output, FollowsASymbolicLink) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder.path() / "far");
  const auto target = folder.path() / "far" / "model.ply";
  const auto link = folder.path() / "link.ply";
  write_text(target, "old");
  std::filesystem::create_symlink(target, link);
  ASSERT_EQ(soms_run({"generate", "sphere", "-o", link.string()}).status, 0);
  EXPECT_TRUE(std::filesystem::is_symlink(link));
  EXPECT_TRUE(read_text(target).starts_with("ply"));
}

// Another file of that name would take the place of what stands there, and lose what follows.
TEST(Output, IntoWhatIsOpenGoesOnWhereThatStands) {
  const TemporaryFolder folder;
  const std::string path = (folder.path() / "all").string();
  for (const std::string& name : {std::string("/dev/stdout"), std::string("/dev/fd/3")}) {
    const RunResult result =
        shell("{ echo before; $soms generate sphere --triangles 8 --format off -o " + name +
              "; echo after; } > '" + path + "' 3>&1");
    EXPECT_EQ(result.status, 0) << result.err;
    const std::string content = read_text(path);
    EXPECT_TRUE(content.starts_with("before\nOFF\n")) << content;
    EXPECT_TRUE(content.ends_with("\nafter\n")) << content;
    EXPECT_EQ(files_in(folder.path()), std::vector<std::string>{"all"});
  }
}

TEST(Output, NamesThePlaceThatCannotBeWritten) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder.path() / "folder.ply");
  const std::vector<std::string> places{"/proc/soms.ply", (folder.path() / "folder.ply").string(),
                                        (folder.path() / "no" / "such" / "place.ply").string()};
  for (const std::string& place : places) {
    const RunResult result = soms_run({"generate", "sphere", "-o", place});
    EXPECT_EQ(result.status, 5) << result.err;
    EXPECT_NE(result.err.find(place), std::string::npos) << result.err;
    EXPECT_NE(result.err.find("; "), std::string::npos) << result.err;
  }
  EXPECT_EQ(files_in(folder.path()), std::vector<std::string>{"folder.ply"});
}

TEST(Output, AnUnknownExtensionIsWrongUsage) {
  const TemporaryFolder folder;
  const std::string box = test::data("truth/meshes/box2.ply").string();
  for (const std::string name : {"x.xyz", "x", "x.gltf"}) {
    const std::string path = (folder.path() / name).string();
    for (const auto& words : {std::vector<std::string>{"generate", "sphere", "-o", path},
                              std::vector<std::string>{"convert", box, path}}) {
      const RunResult result = soms_run(words);
      EXPECT_EQ(result.status, 2) << result.err;
      EXPECT_NE(result.err.find(path + ": the extension is not that of a format"),
                std::string::npos)
          << result.err;
    }
  }
  const RunResult place = soms_run({"convert", box, folder.path().string()});
  EXPECT_EQ(place.status, 2) << place.err;
  EXPECT_NE(place.err.find(": is a folder; "), std::string::npos) << place.err;
  EXPECT_TRUE(files_in(folder.path()).empty());
}

TEST(Output, EndsQuietlyWhenThePipeIsClosed) {
  const TemporaryFolder folder;
  const std::string status = (folder.path() / "status").string();
  const std::string poses = (folder.path() / "poses.csv").string();
  std::string rows = "x,y,z\n";
  for (int i = 0; i < 20'000; ++i) {
    rows += "0.5,0,0\n";
  }
  write_text(poses, rows);
  const std::string box = test::data("truth/meshes/box2.ply").string();
  const std::vector<std::string> lines{
      "$soms overlap '" + box + "' '" + box + "' --json --pose '" + poses + "'",
      "$soms generate sphere --triangles 400000 -o -",
      "$soms generate sphere --triangles 400000 --format ply -o /dev/stdout",
      "$soms convert '" + box + "' - --format obj"};
  for (const std::string& line : lines) {
    // Writing into the pipe fails from when its reader is gone.
    const RunResult result = shell("{ (trap '' PIPE; while echo 2>&-; do :; done); " + line +
                                   "; echo $? > '" + status + "'; } | head -c 0");
    EXPECT_EQ(read_text(status), "0\n") << line;
    EXPECT_EQ(result.err, "") << line;
  }
}

TEST(Output, InFilesAndTheStatusAreWholeWhenTheReaderIsGone) {
  const TemporaryFolder folder;
  const std::string at = folder.path().string();
  const std::string box = test::data("truth/meshes/box2.ply").string();
  std::string rows = "x,y,z\n";
  for (int i = 0; i < 20'000; ++i) {
    rows += "4,0,0\n";
  }
  write_text(at + "/apart.csv", rows);
  write_text(at + "/once.csv", rows + "0.5,0,0\n");
  const auto run = [&](const std::string& verb, const std::string& more) {
    std::string line = "cd '";
    line += at + "'; rm -f status; { (trap '' PIPE; while echo 2>&-; do :; done); $soms " + verb +
            " '" + box + "' '" + box + "' " + more + "; echo $? > status; } | head -c 0";
    EXPECT_EQ(shell(line).err, "") << line;
    return read_text(at + "/status");
  };
  for (const std::string json : {"", " --json"}) {
    for (const std::string verb : {"overlap", "distance", "within --clearance 1"}) {
      EXPECT_EQ(run(verb, "--pose apart.csv -o rows.csv" + json), "0\n") << verb;
      const std::string csv = read_text(at + "/rows.csv");
      EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), verb == "overlap" ? 1 : 20'001) << verb;
    }
    EXPECT_EQ(run("within --clearance 1", "--pose apart.csv --fail-if within" + json), "0\n");
    EXPECT_EQ(run("within --clearance 1", "--pose once.csv --fail-if within" + json), "1\n");
    EXPECT_EQ(run("overlap", "--pose once.csv --fail-if overlap" + json), "1\n");
  }
}

TEST(Output, ThatIsAnotherPipeIsNotWrittenWhenItIsClosed) {
  const TemporaryFolder folder;
  const RunResult result =
      shell("cd '" + folder.path().string() +
            "'; mkfifo pipe; head -c 0 < pipe & $soms generate sphere --triangles 400000 "
            "--format ply -o pipe");
  EXPECT_EQ(result.status, 5) << result.err;
  EXPECT_NE(result.err.find("pipe: cannot write: Broken pipe"), std::string::npos) << result.err;
}

TEST(Output, ShowsNoControlCharacters) {
  testing::internal::CaptureStderr();
  {
    command::Progress bar("reading a\x1b[31m", true);
    wait_at_least(1.05);  // it shows itself by then
    bar.show(std::string("now"));
  }
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "\rreading a?[31m now\x1b[K\r\x1b[K");
}

TEST(Output, ShowsNeitherColorNorProgressWhereThereIsNoTerminal) {
  const RunResult result = soms_run({"info", "missing.ply"});
  EXPECT_EQ(result.err.find('\x1b'), std::string::npos);
}

TEST(Output, ShowsColorOnATerminalUnlessReportedNotTo) {
  const RunResult colored = soms_on_terminal({"info", "missing.ply"});
  EXPECT_EQ(colored.status, 3);
  EXPECT_TRUE(colored.out.starts_with("\x1b[1;31msoms info:\x1b[0m missing.ply")) << colored.out;
  setenv("NO_COLOR", "1", 1);
  const RunResult plain = soms_on_terminal({"info", "missing.ply"});
  unsetenv("NO_COLOR");
  EXPECT_TRUE(plain.out.starts_with("soms info: missing.ply")) << plain.out;
}

TEST(Output, AcceptsNamesWithSpacesAndRelativePaths) {
  const TemporaryFolder folder;
  const RunResult result =
      shell("cd '" + folder.path().string() +
            "' && mkdir 'a b' && $soms generate sphere -o 'a b/my ball.off' -q && cd 'a b' && "
            "$soms info './my ball.off' --json --no-trees && $soms convert 'my ball.off' ../c.obj");
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(files_in(folder.path()), (std::vector<std::string>{"a b", "c.obj"}));
}

}  // namespace
}  // namespace soms::test
