#include "tests/commands/run.h"
#include "tests/support/pipe.h"

#include <algorithm>

namespace soms::test {
namespace {

/// Runs `overlap` of two boxes with pose files of these texts; an empty text is no option.
RunResult with_rows(const TemporaryFolder& folder, const std::string& a, const std::string& b) {
  std::vector<std::string> words{"overlap", box(), box(), "--json", "--no-pairs"};
  const auto add = [&](const char* option, const char* name, const std::string& text) {
    if (!text.empty()) {
      write_text(folder.path() / name, text);
      words.insert(words.end(), {option, (folder.path() / name).string()});
    }
  };
  add("--pose", "a.csv", a);
  add("--pose-b", "b.csv", b);
  return soms_run(words);
}

std::vector<bool> overlaps(const RunResult& result) {
  EXPECT_EQ(result.status, 0) << result.err;
  std::vector<bool> found;
  for (const Json& answer : json_lines(result.out)) {
    EXPECT_EQ(answer.at("pose"), found.size());
    found.push_back(answer.at("any"));
  }
  return found;
}

TEST(PoseSource, ReadsRowsOfBothFilesSideBySide) {
  const TemporaryFolder folder;
  EXPECT_EQ(overlaps(with_rows(folder, "x,y,z\n0,0,0\n10,0,0\n20,0,0\n",
                               "x,y,z\n0,0,0\n10,0,0\n0,0,0\n")),
            (std::vector{true, true, false}));
}

TEST(PoseSource, ASingleRowServesAll) {
  const TemporaryFolder folder;
  const std::vector expected{true, false, true};
  const std::string three = "x,y,z\n0,0,0\n10,0,0\n0.5,0,0\n";
  EXPECT_EQ(overlaps(with_rows(folder, three, "x,y,z\n0.25,0,0\n")), expected);
  EXPECT_EQ(overlaps(with_rows(folder, "x,y,z\n0.25,0,0\n", three)), expected);
  EXPECT_EQ(overlaps(with_rows(folder, three, "")), expected);
  EXPECT_EQ(overlaps(with_rows(folder, "", three)), expected);
  EXPECT_EQ(overlaps(with_rows(folder, "x,y,z\n10,0,0\n", "x,y,z\n10,0,0\n")), std::vector{true});
}

TEST(PoseSource, RefusesFilesOfUnequalLength) {
  const TemporaryFolder folder;
  const RunResult result =
      with_rows(folder, "x,y,z\n0,0,0\n1,0,0\n2,0,0\n", "x,y,z\n0,0,0\n1,0,0\n");
  EXPECT_EQ(result.status, 3);
  EXPECT_EQ(json_lines(result.out).size(), 2U);
  EXPECT_NE(result.err.find("b.csv: has 2 poses"), std::string::npos) << result.err;
}

TEST(PoseSource, AnswersAFileWithoutRowsByNoRows) {
  const TemporaryFolder folder;
  const RunResult result = with_rows(folder, "x,y,z\n", "");
  EXPECT_EQ(result.status, 0);
  EXPECT_EQ(result.out, "");
  EXPECT_NE(result.err.find("a.csv: no rows"), std::string::npos) << result.err;
  const RunResult piped = soms_run({"overlap", box(), box(), "--pose", "-"}, "x,y,z\n");
  EXPECT_EQ(piped.status, 0);
  EXPECT_NE(piped.err.find("standard input: no rows"), std::string::npos) << piped.err;
  const RunResult unequal = with_rows(folder, "x,y,z\n", "x,y,z\n0,0,0\n1,0,0\n");
  EXPECT_EQ(unequal.status, 3);
  EXPECT_NE(unequal.err.find("a.csv: has 0 poses, but "), std::string::npos) << unequal.err;
}

// The place of a body is not a batch: without a pose it would be answered where it does not stand.
TEST(PoseSource, RefusesAFileWithoutRowsWhereOnePoseIsNeeded) {
  const TemporaryFolder folder;
  write_text(folder.path() / "none.csv", "x,y,z\n");
  const std::string none = (folder.path() / "none.csv").string();
  const RunResult result =
      soms_run({"contains", box(), "--points", "-", "--pose", none}, "x,y,z\n0,0,0\n");
  EXPECT_EQ(result.status, 3);
  EXPECT_NE(result.err.find("none.csv: no rows; give at least one pose"), std::string::npos)
      << result.err;
}

TEST(PoseSource, NamesFileAndLineOfAPoseThatIsNotRigid) {
  const TemporaryFolder folder;
  const RunResult result = with_rows(
      folder, "x,y,z,qw,qx,qy,qz\n0,0,0,1,0,0,0\n0,0,0,1,0,0,0\n0,0,0,1,1,0,0\n0,0,0,1,0,0,0\n",
      "");
  EXPECT_EQ(result.status, 3);
  EXPECT_EQ(json_lines(result.out).size(), 2U);  // the rows before are answered
  EXPECT_NE(result.err.find("a.csv"), std::string::npos) << result.err;
  EXPECT_NE(result.err.find("4"), std::string::npos) << result.err;
  EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1);
}

TEST(PoseSource, AnswersAllRowsBeforeAPoseThatGoesTooFar) {
  const TemporaryFolder folder;
  std::string rows = "x,y,z\n";
  for (int good = 1; good < 6; ++good) {
    rows += "0,0,0\n";
    for (const bool first : {true, false}) {
      const std::string faulty = rows + "1e200,0,0\n0,0,0\n";
      const RunResult result =
          first ? with_rows(folder, faulty, "") : with_rows(folder, "", faulty);
      EXPECT_EQ(result.status, 3);
      EXPECT_EQ(json_lines(result.out).size(), static_cast<std::size_t>(good));
      EXPECT_NE(
          result.err.find("csv: pose " + std::to_string(good) + ": a moved vertex may exceed"),
          std::string::npos)
          << result.err;
    }
  }
  const RunResult none = with_rows(folder, "x,y,z\n1e200,0,0\n0,0,0\n", "");
  EXPECT_EQ(none.status, 3);
  EXPECT_EQ(none.out, "");
  EXPECT_NE(none.err.find("a.csv: pose 0: a moved vertex"), std::string::npos) << none.err;
}

TEST(PoseSource, NamesTheFileOfEveryOtherFault) {
  const TemporaryFolder folder;
  for (const char* text : {"x,y,z\nnan,0,0\n", "x,y,z\n1,2\n", "x,y\n1,2\n", "1,2,3\n",
                           "x,y,z\n1,two,3\n", "x,y,z\n0,0,0\n0,0,0\n1,2,3,4\n"}) {
    const RunResult result = with_rows(folder, text, "");
    EXPECT_EQ(result.status, 3) << text;
    EXPECT_NE(result.err.find("a.csv"), std::string::npos) << result.err;
  }
}

TEST(PoseSource, TakesAPoseFromTheCommandLine) {
  const auto status = [](const std::string& pose) {
    return soms_run({"overlap", box(), box(), "--pose", pose});
  };
  EXPECT_EQ(status("1 2 3").status, 0);
  EXPECT_EQ(status("-1,-2,-3").status, 0);
  EXPECT_EQ(status("1 2 3 1 0 0 0").status, 0);
  for (const char* pose : {"1 2", "1 2 3 4", "nan 0 0", "1 2 3 1 1 0 0", "1e999 0 0", ""}) {
    if (*pose == '\0') {
      continue;
    }
    const RunResult result = status(pose);
    EXPECT_NE(result.status, 0) << pose;
    EXPECT_NE(result.err.find("--pose"), std::string::npos) << result.err;
  }
}

TEST(PoseSource, ReadsPosesFromStandardInput) {
  const RunResult result =
      soms_run({"overlap", box(), box(), "--pose", "-", "--json"}, "x,y,z\n0,0,0\n9,0,0\n");
  EXPECT_EQ(overlaps(result), (std::vector{true, false}));
}

TEST(PoseSource, AnswersEachRowOfAPipeBeforeTheNextIsGiven) {
  const std::vector<std::string> rows{"0,0,0\n", "9,0,0\r\n", "# near\n0.5,0,0\n", "0,9,0\n"};
  for (std::size_t given = 1; given <= rows.size(); ++given) {
    const TemporaryFolder folder;
    Pipe poses(folder.path() / "poses", "x,y,z\n");
    Child child({command().string(), "overlap", box(), box(), "--pose", poses.path(), "--json",
                 "--no-pairs"},
                folder.path());
    for (std::size_t k = 0; k < given; ++k) {
      poses.give(rows[k]);
      ASSERT_TRUE(child.wait_for_lines(static_cast<std::ptrdiff_t>(k) + 1));
    }
    poses.end();
    std::vector expected{true, false, true, false};
    expected.resize(given);
    EXPECT_EQ(overlaps(child.wait()), expected);
  }
}

TEST(PoseSource, NamesTheFileOfThePoseThatGoesTooFar) {
  const TemporaryFolder folder;
  const std::string good = "x,y,z\n0,0,0\n0,0,0\n";
  const std::string far = "x,y,z\n0,0,0\n0,1e200,0\n";
  EXPECT_NE(with_rows(folder, good, far).err.find("b.csv: pose 1: a moved"), std::string::npos);
  EXPECT_NE(with_rows(folder, far, good).err.find("a.csv: pose 1: a moved"), std::string::npos);
  const auto stated = [&](const std::string& rows) {
    write_text(folder.path() / "rows.csv", rows);
    return soms_run({"overlap", box(), box(), "--pose", "1e200 0 0", "--pose-b",
                     (folder.path() / "rows.csv").string(), "--json"})
        .err;
  };
  EXPECT_NE(stated(good).find("soms overlap: --pose: pose 0: a moved"), std::string::npos);
  EXPECT_NE(stated("x,y,z\n0,0,0\n").find("soms overlap: --pose: pose 0: a moved"),
            std::string::npos);
  const RunResult alone = with_rows(folder, "x,y,z\n1e200,0,0\n", good);
  EXPECT_NE(alone.err.find("a.csv: pose 0: a moved"), std::string::npos) << alone.err;
}

TEST(PoseSource, NamesAFileThatIsMissing) {
  const RunResult result = soms_run({"overlap", box(), box(), "--pose", "my poses.csv"});
  EXPECT_EQ(result.status, 3);
  EXPECT_NE(result.err.find("my poses.csv"), std::string::npos) << result.err;
}

TEST(PoseSource, CallsStandardInputByItsName) {
  const auto message = [](const std::string& text) {
    return soms_run({"overlap", box(), box(), "--pose", "-"}, text).err;
  };
  EXPECT_NE(message("x,y,z\n0,0,0\n1,2\n").find("standard input, line 3: 2 numbers"),
            std::string::npos)
      << message("x,y,z\n0,0,0\n1,2\n");
  EXPECT_NE(message("a,b\n").find("standard input, line 1: the header"), std::string::npos);
  EXPECT_NE(message("x,y,z\n").find("standard input: no rows"), std::string::npos);
  EXPECT_EQ(shell("$soms overlap '" + box() + "' '" + box() + "' --pose - </dev/null").err,
            "soms overlap: standard input is empty; pipe poses into it, or name a file\n");
  const RunResult model =
      shell("$soms overlap - '" + box() + "' --pose '0.5 0 0' < '" + box() + "'");
  EXPECT_NE(model.out.find("triangle of standard input and"), std::string::npos) << model.out;
}

}  // namespace
}  // namespace soms::test
