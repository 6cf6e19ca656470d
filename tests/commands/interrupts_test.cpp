#include "tests/commands/run.h"
#include "tests/support/pipe.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <utility>

namespace soms::test {
namespace {

std::string many_poses(const TemporaryFolder& folder) {
  std::string rows = "x,y,z\n";
  for (int i = 0; i < 3'000'000; ++i) {
    rows += "0.5,0,0\n";
  }
  const std::string path = (folder.path() / "poses.csv").string();
  write_text(path, rows);
  return path;
}

TEST(Interrupts, EndWithWhatIsDone) {
  const TemporaryFolder folder;
  const std::string poses = many_poses(folder);
  for (const int signal : {SIGINT, SIGTERM}) {
    Child child({command().string(), "overlap", box(), box(), "--pose", poses, "--json"},
                folder.path());
    ASSERT_TRUE(child.wait_for_output(100'000));
    child.send(signal);
    const RunResult result = child.wait();
    EXPECT_EQ(result.status, 130) << result.err;
    EXPECT_EQ(result.out.back(), '\n');
    const std::vector<Json> answers = json_lines(result.out);  // every line is whole
    EXPECT_LT(answers.size(), 3'000'000U);
    for (std::size_t k = 0; k < answers.size(); ++k) {
      ASSERT_EQ(answers[k].at("pose"), k);
      ASSERT_EQ(answers[k].at("coverage"), "complete");
    }
    EXPECT_NE(result.err.find("soms overlap: "), std::string::npos);
    EXPECT_NE(result.err.find("poses are answered"), std::string::npos) << result.err;
  }
}

TEST(Interrupts, TwiceAtOnceAreOne) {
  // As `timeout` sends them: to the command, then to the whole process group.
  const TemporaryFolder folder;
  const std::string poses = many_poses(folder);
  for (const int second : {SIGTERM, SIGINT}) {
    Child child({command().string(), "overlap", box(), box(), "--pose", poses, "--json"},
                folder.path());
    ASSERT_TRUE(child.wait_for_output(100'000));
    child.send(SIGTERM);
    usleep(100);
    child.send(second);
    const RunResult result = child.wait();
    EXPECT_EQ(result.status, 130) << result.err;
    EXPECT_EQ(result.out.back(), '\n');
    EXPECT_FALSE(json_lines(result.out).empty());  // every line is whole
    EXPECT_NE(result.err.find("poses are answered"), std::string::npos) << result.err;
  }
}

TEST(Interrupts, EndAtOnceWhenAskedAgainLater) {
  // Nothing reads the pipe, so the first request cannot be finished.
  const RunResult result = shell(
      "d=$(mktemp -d); mkfifo $d/pipe; exec 3<>$d/pipe; "
      "$soms generate sphere --triangles 100000 --format obj -o $d/pipe & "
      "sleep 0.5; kill -TERM $!; sleep 0.8; kill -TERM $!; wait $!; s=$?; rm -r $d; exit $s");
  EXPECT_EQ(result.status, 130) << result.err;
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
    usleep(200'000);
    child.send(SIGINT);
    const RunResult stopped = child.wait();
    EXPECT_EQ(stopped.status, 130) << words[0] << stopped.err;
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
  RunResult result;
  for (const char* seconds : {"0.5", "5"}) {  // a busy machine may not come to the first by then
    const Pipe poses(folder.path() / seconds, "x,y,z\n0.5,0,0\n5,0,0\n");
    result = soms_run(
        {"overlap", box(), box(), "--pose", poses.path(), "--no-pairs", "--timeout", seconds});
    if (result.status != 4) {
      break;
    }
  }
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_NE(result.err.find("out of time after 2 poses"), std::string::npos) << result.err;
  EXPECT_NE(result.out.find("2 poses: "), std::string::npos) << result.out;
}

TEST(Interrupts, LeaveNoPartOfAFile) {
  const TemporaryFolder folder;
  const TemporaryFolder target;
  Child child({command().string(), "generate", "knot", "--triangles", "10000000", "-o",
               (target.path() / "knot.obj").string()},
              folder.path());
  ASSERT_TRUE(child.wait_for_writing(1'000'000));
  child.send(SIGINT);
  EXPECT_EQ(child.wait().status, 130);
  EXPECT_TRUE(files_in(target.path()).empty());
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
  const TemporaryFolder outputs;
  std::vector<std::string> words = {command().string(), "info", "--json", "--no-trees", box()};
  words.insert(words.end(), 20, large);
  Child child(words, outputs.path());
  ASSERT_TRUE(child.wait_for_output(100));
  usleep(100'000);
  child.send(SIGINT);
  const RunResult result = child.wait();
  EXPECT_EQ(result.status, 130) << result.err;
  const std::vector<Json> reports = json_lines(result.out);
  EXPECT_EQ(reports.at(0).at("triangles"), 12);
  EXPECT_LT(reports.size(), 21U);
}

TEST(Interrupts, RespectIgnoredSignals) {
  const RunResult result = shell(
      "trap '' INT; $soms generate sphere --triangles 200000 -o "
      "/dev/null --format obj & sleep 0.05; kill -INT $!; wait $!");
  EXPECT_EQ(result.status, 0) << result.err;
}

TEST(Interrupts, LeaveTotalsAndThePageOfWhatOverlapAnswered) {
  const TemporaryFolder folder;
  const std::string page = (folder.path() / "page.html").string();
  const std::string poses = many_poses(folder);
  Child child({command().string(), "overlap", box(), box(), "--pose", poses, "--no-pairs",
               "--threads", "1", "--report", page},
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
  Child child(
      {command().string(), "overlap", knot, knot, "--pose", poses, "--no-pairs", "--threads", "1"},
      folder.path());
  ASSERT_TRUE(child.wait_for_output(1));
  child.send(SIGINT);
  const RunResult result = child.wait();
  EXPECT_EQ(result.status, 130) << result.err;
  EXPECT_NE(result.err.find("1 pose is answered"), std::string::npos) << result.err;
}

}  // namespace
}  // namespace soms::test
