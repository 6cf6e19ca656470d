#include "tests/commands/run.h"
#include "tests/support/pipe.h"
#include "tests/support/wait.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <utility>

namespace soms::test {
namespace {

/// Poses at which two boxes overlap, without end.
EndlessPipe endless_poses(const TemporaryFolder& folder, const std::string& name = "poses") {
  return {folder.path() / name, "x,y,z", "0.5,0,0"};
}

TEST(Interrupts, EndWithWhatIsDone) {
  const TemporaryFolder folder;
  for (const int signal : {SIGINT, SIGTERM}) {
    const EndlessPipe poses = endless_poses(folder, std::to_string(signal));
    Child child({command().string(), "overlap", box(), box(), "--pose", poses.path(), "--json"},
                folder.path());
    ASSERT_TRUE(child.wait_for_output(100'000));
    child.send(signal);
    const RunResult result = child.wait();
    EXPECT_EQ(result.status, 130) << result.err;
    EXPECT_EQ(result.out.back(), '\n');
    const std::vector<Json> answers = json_lines(result.out);  // every line is whole
    for (std::size_t k = 0; k < answers.size(); ++k) {
      ASSERT_EQ(answers[k].at("pose"), k);
      ASSERT_EQ(answers[k].at("coverage"), "complete");
    }
    EXPECT_NE(result.err.find("soms overlap: "), std::string::npos);
    EXPECT_NE(result.err.find("poses are answered"), std::string::npos) << result.err;
  }
}

TEST(Interrupts, TwiceAtOnceAreOne) {
  // As `timeout` sends them: to the command, then to the whole process group, or as somebody does
  // who ends both.
  const TemporaryFolder folder;
  const std::vector<std::vector<int>> cases{
      {SIGTERM, SIGTERM}, {SIGTERM, SIGINT}, {SIGINT, SIGTERM, SIGHUP}};
  for (const std::vector<int>& signals : cases) {
    const EndlessPipe poses =
        endless_poses(folder, std::to_string(signals.size()) + std::to_string(signals.back()));
    Child child({command().string(), "overlap", box(), box(), "--pose", poses.path(), "--json"},
                folder.path());
    ASSERT_TRUE(child.wait_for_output(100'000));
    child.send_together(signals);
    const RunResult result = child.wait();
    EXPECT_EQ(result.status, 130) << result.err;
    EXPECT_EQ(result.out.back(), '\n');
    EXPECT_FALSE(json_lines(result.out).empty());  // every line is whole
    EXPECT_NE(result.err.find("poses are answered"), std::string::npos) << result.err;
  }
}

TEST(Interrupts, EndAtOnceWhenRequestedAgainLater) {
  // Nothing reads the pipe, so the first request cannot be finished; later ones end it.
  const TemporaryFolder folder;
  const Pipe unread(folder.path() / "pipe");
  Child child({command().string(), "generate", "sphere", "--triangles", "100000", "--format", "obj",
               "-o", unread.path()},
              folder.path());
  ASSERT_TRUE(child.wait_until([&] { return unread.is_full(); }));
  child.send_until_it_ends(SIGTERM);
  EXPECT_EQ(child.wait().status, 130);
}

TEST(Interrupts, AndTheEndOfTimeEndTheWaitForAPipe) {
  const TemporaryFolder folder;
  const Pipe model(folder.path() / "model", "OFF\n");
  const Pipe poses(folder.path() / "poses", "x,y,z\n");
  const Pipe route(folder.path() / "route", "x,y,z\n");
  const std::string unopened = (folder.path() / "unopened").string();
  ASSERT_EQ(mkfifo(unopened.c_str(), 0600), 0);
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{"info", model.path()},
        {"info", unopened},
        {"thesis", unopened},
        {"overlap", box(), box(), "--pose", poses.path()},
        {"simulate", box(), "--mover", box(), "--route", route.path()}}) {
    std::vector<std::string> limited = words;
    limited.insert(limited.end(), {"--timeout", "0.1"});
    const RunResult late = soms_run(limited);
    EXPECT_EQ(late.status, 4) << words[0] << late.err;
    EXPECT_NE(late.err.find("out of time while "), std::string::npos) << late.err;
    std::vector<std::string> program = words;
    program.insert(program.begin(), command().string());
    const TemporaryFolder outputs;
    Child child(program, outputs.path());
    ASSERT_TRUE(child.wait_for_interrupts());
    ASSERT_TRUE(child.wait_until([&] { return has_open(child.id(), words.back()); }));
    child.send(SIGINT);
    const RunResult stopped = child.wait();
    EXPECT_EQ(stopped.status, 130) << words[0] << stopped.err;
    EXPECT_NE(stopped.err.find("interrupted"), std::string::npos) << words[0] << stopped.err;
  }
}

TEST(Interrupts, KeepWhatWasAnsweredBeforeThePosesStalled) {
  const TemporaryFolder folder;
  const Pipe poses(folder.path() / "poses", "x,y,z\n0.5,0,0\n5,0,0\n");
  const TemporaryFolder outputs;
  Child child({command().string(), "overlap", box(), box(), "--pose", poses.path(), "--no-pairs"},
              outputs.path());
  ASSERT_TRUE(child.wait_for_lines(2));
  child.send(SIGINT);
  const RunResult result = child.wait();
  EXPECT_EQ(result.status, 130) << result.err;
  EXPECT_NE(result.err.find("2 poses are answered"), std::string::npos) << result.err;
  EXPECT_NE(result.out.find("2 poses: 1 with overlap, "), std::string::npos) << result.out;
}

TEST(Interrupts, ByTheEndOfTimeKeepWhatWasAnsweredBeforeThePosesStalled) {
  const TemporaryFolder folder;
  const RunResult result = run_with_time(
      [&](const std::string& seconds) {
        const Pipe poses(folder.path() / seconds, "x,y,z\n0.5,0,0\n5,0,0\n");
        return soms_run(
            {"overlap", box(), box(), "--pose", poses.path(), "--no-pairs", "--timeout", seconds});
      },
      [](const RunResult& run) { return run.status != 4; });
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_NE(result.err.find("out of time after 2 poses"), std::string::npos) << result.err;
  EXPECT_NE(result.out.find("2 poses: "), std::string::npos) << result.out;
}

TEST(Interrupts, LeaveNoPartOfAFile) {
  int status = 0;
  // Where this test is kept waiting the file may be whole before the signal comes.
  for (int i = 0; i < 20 && status == 0; ++i) {
    const TemporaryFolder folder;
    const TemporaryFolder target;
    Child child({command().string(), "generate", "knot", "--triangles", "10000000", "-o",
                 (target.path() / "knot.obj").string()},
                folder.path());
    ASSERT_TRUE(child.wait_for_writing(1'000'000));
    child.send(SIGINT);
    status = child.wait().status;
    EXPECT_EQ(files_in(target.path()).empty(), status != 0);
  }
  EXPECT_EQ(status, 130);
}

TEST(Interrupts, AndTheEndOfTimeEndTheMakingOfACity) {
  const TemporaryFolder folder;
  const std::string city = (folder.path() / "city.ply").string();
  const RunResult result =
      soms_run({"generate", "city", "--triangles", "20000000", "-o", city, "--timeout", "0.1"});
  EXPECT_EQ(result.status, 4) << result.err;
  EXPECT_NE(result.err.find("out of time while making city"), std::string::npos) << result.err;
  EXPECT_FALSE(std::filesystem::exists(city));
}

// Reports of the models before the interrupted one are whole.
TEST(Interrupts, EndAReportOfDefects) {
  const TemporaryFolder folder;
  const std::string large = (folder.path() / "large.ply").string();
  ASSERT_EQ(soms_run({"generate", "knot", "--triangles", "1000000", "-o", large}).status, 0);
  const Pipe never_whole(folder.path() / "pipe", "OFF\n");  // so the last report is never made
  const TemporaryFolder outputs;
  std::vector<std::string> words = {command().string(), "info", "--json", "--no-trees", box()};
  words.insert(words.end(), 20, large);
  words.push_back(never_whole.path());
  Child child(words, outputs.path());
  ASSERT_TRUE(child.wait_for_reading(std::filesystem::file_size(large)));
  child.send(SIGINT);
  const RunResult result = child.wait();
  EXPECT_EQ(result.status, 130) << result.err;
  const std::vector<Json> reports = json_lines(result.out);
  EXPECT_EQ(reports.at(0).at("triangles"), 12);
  EXPECT_LT(reports.size(), 22U);
}

TEST(Interrupts, RespectIgnoredSignals) {
  // The pipe holds less than the file, so the command is amid its work when the signal comes.
  const TemporaryFolder folder;
  const RunResult result =
      shell("cd '" + folder.path().string() +
            "'; mkfifo pipe; trap '' INT; "
            "$soms generate sphere --triangles 200000 --format obj -o - > pipe & "
            "{ head -c 1 > first; kill -INT $!; cat > rest; } < pipe; wait $!");
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_GT(std::filesystem::file_size(folder.path() / "rest"), 1'000'000U);
}

TEST(Interrupts, LeaveTotalsAndThePageOfWhatOverlapAnswered) {
  const TemporaryFolder folder;
  const std::string page = (folder.path() / "page.html").string();
  const EndlessPipe poses = endless_poses(folder);
  Child child({command().string(), "overlap", box(), box(), "--pose", poses.path(), "--no-pairs",
               "--threads", "1", "-o", page},
              folder.path());
  ASSERT_TRUE(child.wait_for_output(1));
  child.send(SIGTERM);
  const RunResult result = child.wait();
  EXPECT_EQ(result.status, 130) << result.err;
  EXPECT_NE(result.err.find(" answered"), std::string::npos) << result.err;
  EXPECT_NE(result.out.find(" with overlap, "), std::string::npos);
  EXPECT_NE(read_text(page).find("interrupted after "), std::string::npos);
}

// The row at fault is read with the one before it, whose answer takes long and is given up.
TEST(Interrupts, ComeBeforeAFaultyRowThatWasReadAhead) {
  const TemporaryFolder folder;
  const std::string knot = (folder.path() / "knot.ply").string();
  const std::string poses = (folder.path() / "poses.csv").string();
  ASSERT_EQ(soms_run({"generate", "knot", "--triangles", "200000", "-o", knot}).status, 0);
  write_text(poses, "x,y,z\n1000,0,0\n0,0,0\n0,0\n");
  RunResult result;
  // Where this test is kept waiting the answer may be there, and the fault named, before the
  // signal.
  for (int i = 0; i < 20 && (i == 0 || result.status == 3); ++i) {
    Child child({command().string(), "overlap", knot, knot, "--pose", poses, "--no-pairs",
                 "--threads", "1"},
                folder.path());
    ASSERT_TRUE(child.wait_for_output(1));
    child.send(SIGINT);
    result = child.wait();
  }
  EXPECT_EQ(result.status, 130) << result.err;
  EXPECT_NE(result.err.find("1 pose is answered"), std::string::npos) << result.err;
}

}  // namespace
}  // namespace soms::test
