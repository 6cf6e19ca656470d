// How the command finds and starts soms-view; a script stands for it here. What soms-view does is
// tested in tests/view.
#include "soms/scene/replay.h"

#include "apps/cli/verb_data.h"
#include "tests/commands/run.h"

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <utility>
#include <vector>

namespace soms::test {
namespace {

/// Writes a script that anyone may run.
std::string write_program(const std::filesystem::path& path, const std::string& lines) {
  std::filesystem::create_directories(path.parent_path());
  write_text(path, "#!/bin/sh\n" + lines);
  std::filesystem::permissions(path, std::filesystem::perms::owner_all);
  return path.string();
}

/// Runs a line of the shell in which $soms finds `viewer`.
RunResult with_viewer(const std::string& viewer, const std::string& line) {
  return shell("export SOMS_VIEW='" + viewer + "'; " + line);
}

TEST(Viewer, IsSaidToBeMissingWithTheWayToGetIt) {
  const TemporaryFolder folder;
  std::filesystem::copy_file(command(), folder.path() / "soms");
  const std::string alone =
      "PATH=/usr/bin:/bin; unset SOMS_VIEW; '" + (folder.path() / "soms").string() + "' ";
  for (const char* words : {"view", "render -o a.png", "simulate --view", "simulate -o a.png"}) {
    const RunResult result = shell(alone + words);
    EXPECT_EQ(result.status, 3) << words;
    EXPECT_EQ(result.out, "");
    EXPECT_NE(result.err.find("the program soms-view is not installed; make view installs"),
              std::string::npos)
        << result.err;
  }
  const RunResult named = with_viewer("/nowhere/soms-view", "$soms view");
  EXPECT_EQ(named.status, 3);
  EXPECT_NE(named.err.find("SOMS_VIEW does not name a program: /nowhere/soms-view"),
            std::string::npos);
}

TEST(Viewer, IsFoundByItsVariableBesideTheCommandInLibexecAndOnThePath) {
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder.path() / "bin");
  std::filesystem::copy_file(command(), folder.path() / "bin/soms");
  const std::string path = folder.path().string();
  const auto found = [&](const std::string& variable) {
    return shell("export PATH='" + path + "/other:/usr/bin:/bin'; unset SOMS_VIEW; " + variable +
                 " '" + path + "/bin/soms' view")
        .out;
  };
  write_program(folder.path() / "other/soms-view", "echo path");
  EXPECT_EQ(found(""), "path\n");
  write_program(folder.path() / "libexec/soms/soms-view", "echo libexec");
  EXPECT_EQ(found(""), "libexec\n");
  write_program(folder.path() / "bin/soms-view", "echo beside");
  EXPECT_EQ(found(""), "beside\n");
  const std::string own = write_program(folder.path() / "own", "echo variable");
  EXPECT_EQ(found("SOMS_VIEW='" + own + "'"), "variable\n");
}

TEST(Viewer, GetsTheWordsAfterTheVerbAndGivesItsStatus) {
  const TemporaryFolder folder;
  const std::string viewer =
      write_program(folder.path() / "viewer", "for word; do echo \"<$word>\"; done\nexit 7\n");
  const RunResult view = with_viewer(viewer, "$soms view 'a b.ply' --whatever 3 --help");
  EXPECT_EQ(view.status, 7);
  EXPECT_EQ(view.out, "<view>\n<a b.ply>\n<--whatever>\n<3>\n<--help>\n");
  EXPECT_EQ(with_viewer(viewer, "$soms render -o -").out, "<render>\n<-o>\n<->\n");
  EXPECT_EQ(with_viewer(viewer, "$soms help render").out, "<render>\n<--help>\n");
}

TEST(Viewer, ShowsTheWorldOfASimulation) {
  const TemporaryFolder folder;
  const std::string viewer = write_program(folder.path() / "viewer", "echo \"$@\"");
  EXPECT_EQ(with_viewer(viewer, "$soms simulate --view").out,
            "view --count 1000 --seed 1 --threads 0\n");
  EXPECT_EQ(
      with_viewer(viewer,
                  "$soms simulate a.ply b.ply --view --mover c.ply --mover d.ply --route e.csv "
                  "--scale 0.1 --up y --mover-scale 2 --mover-up x --seed 3 --threads 2 "
                  "--frames 9 -q")
          .out,
      "view --frames 9 --mover c.ply --mover d.ply --route e.csv --scale 0.1 --up y "
      "--mover-scale 2 --mover-up x --seed 3 --threads 2 --quiet a.ply b.ply\n");
  EXPECT_EQ(with_viewer(viewer, "$soms simulate --view --count 5").out,
            "view --count 5 --seed 1 --threads 0\n");
  EXPECT_EQ(
      with_viewer(viewer, "$soms simulate --view a.ply --ignore road --only 'B*' --only c").out,
      "view --count 1000 --only=B* --only=c --ignore=road --seed 1 --threads 0 a.ply\n");
  EXPECT_EQ(with_viewer(viewer,
                        "$soms simulate --view --count 5 --tree rule=soms,leaf=1,levels=15 "
                        "--tree midpoint=thesis --traversal e-node --descent both")
                .out,
            "view --tree rule=soms,levels=15,leaf=1,midpoint=thesis,traversal=e-node,"
            "descent=both --count 5 --seed 1 --threads 0\n");
  EXPECT_EQ(with_viewer(viewer, "$soms simulate --view --tree descent=both").status, 2);
  for (const char* other :
       {"--json", "--verify", "-o a.svg", "-o a.csv", "-o a.json", "--contacts a.csv",
        "--record a.rec", "-o a.png", "--picture-frame 3", "--fail-if contact"}) {
    EXPECT_EQ(with_viewer(viewer, std::string("$soms simulate --view ") + other).status, 2)
        << other;
  }
}

TEST(Viewer, DrawsAFrameOfASimulationFromATemporaryRecording) {
  const TemporaryFolder folder;
  const std::string path = folder.path().string();
  std::filesystem::create_directory(folder.path() / "tmp");
  // Words: render --quiet --frame N --output FILE RECORDING.
  const std::string viewer =
      write_program(folder.path() / "viewer",
                    "echo \"$1 $2 $3 $4 $5\" > \"$6\"; cp \"$7\" '" + path + "/kept'\n");
  const auto draw = [&](const std::string& words) {
    return with_viewer(viewer, "export TMPDIR='" + path + "/tmp'; cd '" + path +
                                   "' && $soms generate city --triangles 3000 -o town.ply && $soms "
                                   "generate car -o car.ply && $soms simulate town.ply --mover "
                                   "car.ply --count 5 --frames 20 -o a.png " +
                                   words);
  };
  const RunResult last = draw("");
  ASSERT_EQ(last.status, 0) << last.err;
  EXPECT_EQ(read_text(folder.path() / "a.png"), "render --quiet --frame 19 --output\n");
  EXPECT_NE(last.out.find("picture       a.png"), std::string::npos) << last.out;
  const Replay replay(folder.path() / "kept");
  EXPECT_EQ(replay.frames(), 20U);
  EXPECT_TRUE(files_in(folder.path() / "tmp").empty());
  EXPECT_EQ(draw("--picture-frame 4 --record run.somsrec").status, 0);
  EXPECT_EQ(read_text(folder.path() / "a.png"), "render --quiet --frame 4 --output\n");
  EXPECT_EQ(read_text(folder.path() / "kept"), read_text(folder.path() / "run.somsrec"));
  EXPECT_EQ(draw("--picture-frame 20").status, 2);
  write_program(viewer, "exit 9");
  EXPECT_EQ(draw("").status, 9);
}

/// Runs a picture of a small town in `folder` by a viewer of these lines.
RunResult picture_by(const TemporaryFolder& folder, const std::string& lines,
                     const std::string& before, const std::string& words) {
  const std::string viewer = write_program(folder.path() / "viewer", lines);
  return with_viewer(viewer, "cd '" + folder.path().string() +
                                 "' && $soms generate city --triangles 3000 -q -o town.ply && " +
                                 before + " $soms simulate town.ply --count 3 -o a.png " + words);
}

TEST(Viewer, ThatEndsByASignalDrewNothing) {
  const TemporaryFolder folder;
  const RunResult result = picture_by(folder, "kill -9 $$", "", "--frames 2");
  EXPECT_EQ(result.status, 5) << result.err;
  EXPECT_NE(result.out.find("frames "), std::string::npos) << result.out;
  EXPECT_EQ(result.out.find("picture "), std::string::npos) << result.out;
}

TEST(Viewer, LeavesTheTableOfARunWhosePictureWasInterrupted) {
  const TemporaryFolder folder;
  const RunResult result =
      picture_by(folder, "kill -INT $PPID; exec sleep infinity", "", "--frames 2 --json");
  EXPECT_EQ(result.status, 130) << result.err;
  ASSERT_FALSE(result.out.empty());
  EXPECT_EQ(Json::parse(result.out)["coverage"], "complete");
}

TEST(Viewer, DrewNothingOfARunThatWasInterrupted) {
  const TemporaryFolder folder;
  const std::string viewer = write_program(folder.path() / "viewer", "exit 0");
  const std::string town = (folder.path() / "town.ply").string();
  ASSERT_EQ(soms_run({"generate", "city", "--triangles", "3000", "-o", town}).status, 0);
  Child child({"env", "SOMS_VIEW=" + viewer, command().string(), "simulate", town, "--count", "3",
               "-o", (folder.path() / "a.png").string(), "--frames", "100000000"},
              folder.path());
  ASSERT_TRUE(child.wait_for_writing(10'000));  // the recording, so frames have been made
  child.send(SIGINT);
  const RunResult result = child.wait();
  EXPECT_EQ(result.status, 130) << result.err;
  EXPECT_NE(result.err.find("no picture: interrupted"), std::string::npos) << result.err;
  EXPECT_EQ(result.out.find("picture "), std::string::npos) << result.out;
}

TEST(Viewer, DrawsFromNoRecordingThatIsAPipe) {
  const TemporaryFolder folder;
  const std::string good = "echo picture > \"$6\"";
  const RunResult pipe = picture_by(folder, good, "mkfifo pipe;", "--frames 2 --record pipe");
  EXPECT_EQ(pipe.status, 2) << pipe.err;
  EXPECT_NE(pipe.err.find("--record pipe is not a regular file"), std::string::npos) << pipe.err;
  EXPECT_EQ(picture_by(folder, good, "", "--frames 2 --record /dev/null").status, 0);
}

TEST(Viewer, GivesItsStatusWhereTheEndsOfChildrenAreIgnored) {
  const TemporaryFolder folder;
  const std::string viewer = write_program(folder.path() / "viewer", "exit 7");
  EXPECT_EQ(with_viewer(viewer, "env --ignore-signal=CHLD $soms simulate --view").status, 7);
}

/// What a viewer prints of its options: they follow the verb's shared ones.
std::string fake_data(std::vector<command::OptionData> options) {
  options.push_back({.names = {"--help", "-h"}});
  options.push_back({.names = {"--json"}});
  return command::data_as_json({.name = "soms-view render", .options = std::move(options)});
}

TEST(Viewer, CompletesTheOptionsThatItHas) {
  const TemporaryFolder folder;
  const std::string viewer = write_program(
      folder.path() / "viewer", "echo '" +
                                    fake_data({{.names = {"--output", "-o"}, .value = "FILE"},
                                               {.names = {"--level"}, .value = "N"}}) +
                                    "'");
  const std::string script = with_viewer(viewer, "$soms completion bash").out;
  EXPECT_NE(script.find("\"render -\"*) words=\"--output -o --level --help -h --json\""),
            std::string::npos)
      << script;
  EXPECT_NE(with_viewer("/nowhere", "$soms completion bash").out.find("\"view -\"*) words=\"\""),
            std::string::npos);
}

TEST(Viewer, CompletesTheWordsThatItsOptionsTake) {
  const TemporaryFolder folder;
  const std::string viewer = write_program(
      folder.path() / "viewer",
      "echo '" +
          fake_data(
              {{.names = {"--output", "-o"}, .value = "FILE"},
               {.names = {"--flag"}},
               {.names = {"--rule"}, .value = "NAME", .choices = {"mean", "median", "quality"}},
               {.names = {"--very-long-name"}, .value = "NAME", .choices = {"one", "two"}}}) +
          "'");
  const std::string bash = with_viewer(viewer, "$soms completion bash").out;
  EXPECT_NE(bash.find("\"render --rule\") words=\"mean median quality\""), std::string::npos)
      << bash;
  EXPECT_NE(bash.find("\"render --very-long-name\") words=\"one two\""), std::string::npos);
  EXPECT_EQ(bash.find("\"render --output\")"), std::string::npos);
  const std::string fish = with_viewer(viewer, "$soms completion fish").out;
  EXPECT_NE(fish.find("render' -l output -s o -r\n"), std::string::npos) << fish;
  EXPECT_NE(fish.find("render' -l flag\n"), std::string::npos);
}

TEST(Viewer, EndsWhenTimeIsUp) {
  const TemporaryFolder folder;
  const std::string viewer = write_program(folder.path() / "viewer", "exec sleep infinity");
  EXPECT_EQ(with_viewer(viewer, "$soms simulate --view --timeout 0.1").status, 4);
}

}  // namespace
}  // namespace soms::test
