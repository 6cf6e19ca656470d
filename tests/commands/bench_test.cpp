#include "tests/commands/run.h"

#include <cstdlib>

namespace soms::test {
namespace {

const char* const kQuick = " --random 50 --rounds 1 --threads 1";

TEST(Bench, SaysHowToGetTheProgramWhereItIsMissing) {
  const TemporaryFolder folder;
  std::filesystem::copy_file(command(), folder.path() / "soms");
  const RunResult alone = run_program(
      {"env", "-u", "SOMS_BENCH", (folder.path() / "soms").string(), "bench", "a.ply", "b.ply"});
  EXPECT_EQ(alone.status, 3);
  EXPECT_EQ(alone.out, "");
  EXPECT_NE(alone.err.find("soms bench: the program soms-bench is not installed; build it (cmake "
                           "--preset bench"),
            std::string::npos)
      << alone.err;
  const RunResult named = shell("SOMS_BENCH=/nowhere/soms-bench $soms bench a.ply b.ply");
  EXPECT_EQ(named.status, 3);
  EXPECT_NE(named.err.find("SOMS_BENCH does not name a program: /nowhere/soms-bench"),
            std::string::npos)
      << named.err;
}

TEST(Bench, FindsTheProgramInLibexecOfItsPrefix) {
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder.path() / "bin");
  std::filesystem::create_directories(folder.path() / "libexec/soms");
  std::filesystem::copy_file(command(), folder.path() / "bin/soms");
  const auto program = folder.path() / "libexec/soms/soms-bench";
  write_text(program, "#!/bin/sh\necho \"$@\"\nexit 6\n");
  std::filesystem::permissions(program, std::filesystem::perms::owner_all);
  const RunResult result =
      run_program({"env", "-u", "SOMS_BENCH", (folder.path() / "bin/soms").string(), "bench",
                   "a.ply", "b.ply", "--pose", "1 2 3", "--ask", "all", "--json"});
  EXPECT_EQ(result.status, 6);
  EXPECT_EQ(result.out, "a.ply b.ply --jobs all --rounds 7 --seed 1 --pose 1 2 3 --json\n");
  const RunResult dashes =
      run_program({"env", "-u", "SOMS_BENCH", (folder.path() / "bin/soms").string(), "bench",
                   "--rounds", "3", "--", "--a.ply", "-b.ply"});
  EXPECT_EQ(dashes.out, "./--a.ply ./-b.ply --jobs any,all --rounds 3 --seed 1 --random 1000\n");
}

TEST(Bench, EndsTheProgramWhenTimeIsOver) {
  const TemporaryFolder folder;
  const auto program = folder.path() / "slow";
  write_text(program, "#!/bin/sh\nexec sleep infinity\n");
  std::filesystem::permissions(program, std::filesystem::perms::owner_all);
  const RunResult result =
      shell("SOMS_BENCH='" + program.string() + "' $soms bench a.ply b.ply --timeout 0.1");
  EXPECT_EQ(result.status, 4);
  EXPECT_NE(result.err.find("out of time while slow ran"), std::string::npos) << result.err;
}

TEST(Bench, ComparesAnswersAndTimesOfTwoFiles) {
  const std::string a = test::data("truth/meshes/torus.ply").string();
  const std::string b = test::data("truth/meshes/terrain.ply").string();
  const RunResult result = shell("$soms bench '" + a + "' '" + b + "' --json" + kQuick);
  ASSERT_EQ(result.status, 0) << result.err;
  std::vector<std::string> ours;
  for (const Json& row : json_lines(result.out)) {
    EXPECT_EQ(row.at("schema"), "soms.bench/2");
    EXPECT_EQ(row.at("queried"), 50) << row;
    EXPECT_GT(row.at("median_us"), 0) << row;
    const std::string library = row.at("library");
    if (library.starts_with("soms")) {
      EXPECT_EQ(row.at("wrong"), 0) << row;
      EXPECT_EQ(row.at("checked"), 50) << row;
      ours.push_back(library + " " + row.at("job").get<std::string>());
    }
  }
  EXPECT_EQ(ours, (std::vector<std::string>{"soms any", "soms-batch any", "soms all"}));
}

TEST(Bench, AsksForDistancesAndClearances) {
  const std::string ask =
      "$soms bench '" + box() + "' '" + box() + "' --random 20 --rounds 1 --json -q --ask ";
  for (const auto& [job, sets] :
       {std::pair<std::string, std::vector<std::string>>{"distance", {"random", "random"}},
        {"within",
         {"half random", "half random", "0.99 random", "0.99 random", "1.01 random",
          "1.01 random"}}}) {
    const RunResult result = shell(ask + job);
    ASSERT_EQ(result.status, 0) << result.err;
    std::vector<std::string> ours;
    for (const Json& row : json_lines(result.out)) {
      EXPECT_EQ(row.at("job"), job);
      EXPECT_EQ(row.at("sum") > 0, !row.at("set").get<std::string>().starts_with("half") &&
                                       !row.at("set").get<std::string>().starts_with("0.99"))
          << row;
      if (row.at("library").get<std::string>().starts_with("soms")) {
        EXPECT_EQ(row.at("wrong"), 0) << row;
        ours.push_back(row.at("set"));
      }
    }
    EXPECT_EQ(ours, sets);
  }
}

TEST(Bench, CountsWhatOverlapCounts) {
  const std::string a = test::data("truth/meshes/torus.ply").string();
  const RunResult bench = soms_run(
      {"bench", a, a, "--pose", "0.25 0 0", "--ask", "all", "--rounds", "1", "--json", "--quiet"});
  ASSERT_EQ(bench.status, 0) << bench.err;
  const RunResult overlap = soms_run({"overlap", a, a, "--pose", "0.25 0 0", "--json"});
  for (const Json& row : json_lines(bench.out)) {
    if (row.at("library") == "soms") {
      EXPECT_EQ(row.at("sum"), json_lines(overlap.out).at(0).at("count"));
    }
  }
}

TEST(Bench, PrintsATableForPeopleAndWritesItsFiles) {
  const TemporaryFolder folder;
  const std::string a = test::data("truth/meshes/torus.ply").string();
  const RunResult result = shell("$soms bench '" + a + "' '" + a + "' -o '" +
                                 folder.path().string() + "/new/results'" + kQuick);
  ASSERT_EQ(result.status, 0) << result.err;
  EXPECT_NE(result.out.find("| any | own | random |"), std::string::npos) << result.out;
  EXPECT_EQ(files_in(folder.path() / "new/results"),
            (std::vector<std::string>{"peers.csv", "peers.md"}));
}

TEST(Bench, PassesOnWhatTheProgramComplainsAbout) {
  const std::string a = test::data("truth/meshes/torus.ply").string();
  const RunResult missing = soms_run({"bench", a, "/nowhere/b.ply"});
  EXPECT_EQ(missing.status, 3);
  EXPECT_NE(missing.err.find("soms bench: /nowhere/b.ply"), std::string::npos) << missing.err;
  EXPECT_EQ(missing.err.find("soms-bench:"), std::string::npos) << missing.err;
  const RunResult pose = soms_run({"bench", a, a, "--pose", "1 2"});
  EXPECT_EQ(pose.status, 2) << pose.err;
}

TEST(Bench, FailsWhereItsAnswerCannotBeWritten) {
  const std::string ask = "$soms bench '" + box() + "' '" + box() + "'" + kQuick + " -q ";
  for (const char* const form : {"", "--json "}) {
    const RunResult full = shell(ask + form + "> /dev/full");
    EXPECT_EQ(full.status, 5);
    EXPECT_NE(full.err.find("standard output: cannot write"), std::string::npos) << full.err;
  }
  EXPECT_EQ(soms_run({"bench", "-", box()}).status, 2);
}

TEST(Bench, TellsBeforeTheWorkThatAFolderCannotBeMade) {
  const TemporaryFolder folder;
  write_text(folder.path() / "file", "x");
  for (const char* const place : {"file", "file/results"}) {
    const RunResult result = soms_run({"bench", box(), box(), "--random", "50", "--rounds", "1",
                                       "-o", (folder.path() / place).string()});
    EXPECT_EQ(result.status, 5) << result.err;
    EXPECT_EQ(result.out, "");
    EXPECT_NE(result.err.find("cannot create the folder"), std::string::npos) << result.err;
  }
}

TEST(Bench, CallsStandardInputByItsName) {
  const RunResult faulty = soms_run({"bench", box(), box(), "--pose", "-"}, "x,y,z\n1,2\n");
  EXPECT_EQ(faulty.status, 3) << faulty.err;
  EXPECT_NE(faulty.err.find("soms bench: standard input, line 2: "), std::string::npos)
      << faulty.err;
}

TEST(Bench, AsksNothingElseWherePosesAreMissing) {
  const TemporaryFolder folder;
  write_text(folder.path() / "none.csv", "x,y,z\n");
  const RunResult file =
      soms_run({"bench", box(), box(), "--pose", (folder.path() / "none.csv").string()});
  EXPECT_EQ(file.status, 3) << file.out;
  EXPECT_NE(file.err.find("none.csv: no rows; give at least one pose"), std::string::npos)
      << file.err;
  const RunResult piped = soms_run({"bench", box(), box(), "--pose", "-"}, "x,y,z\n");
  EXPECT_EQ(piped.status, 3) << piped.out;
  EXPECT_NE(piped.err.find("standard input: no rows"), std::string::npos) << piped.err;
}

}  // namespace
}  // namespace soms::test
