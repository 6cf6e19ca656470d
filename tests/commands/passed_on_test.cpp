// The verb `reproduce`, which the command passes on to soms-reproduce; a script stands for it here.
// What soms-reproduce does is tested in reproduce_test.cpp.
#include "tests/commands/run.h"

namespace soms::test {
namespace {

/// Runs the command where no other program of soms is near.
RunResult alone(const TemporaryFolder& folder, const std::string& words) {
  const std::filesystem::path program = folder.path() / "soms";
  if (!std::filesystem::exists(program)) {
    std::filesystem::copy_file(command(), program);
  }
  return shell("PATH=/usr/bin:/bin; unset SOMS_REPRODUCE SOMS_VIEW; cd '" + folder.path().string() +
               "'; ./soms " + words);
}

TEST(PassedOn, AMissingProgramIsNamedWithTheCommandThatBuildsIt) {
  const TemporaryFolder folder;
  for (const char* const words :
       {"reproduce", "reproduce --quick -o thesis", "help reproduce", "man reproduce"}) {
    const RunResult result = alone(folder, words);
    EXPECT_EQ(result.status, 3) << words;
    EXPECT_EQ(result.out, "") << words;
    EXPECT_NE(result.err.find("the program soms-reproduce is not installed; make build builds it"),
              std::string::npos)
        << result.err;
  }
}

TEST(PassedOn, TheManualLeavesOutAPageWhoseProgramIsMissing) {
  const TemporaryFolder folder;
  const RunResult result = alone(folder, "man --output .");
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_NE(result.err.find("soms-reproduce.1 is not written: soms-reproduce is not installed"),
            std::string::npos)
      << result.err;
  EXPECT_NE(result.err.find("soms-view.1 is not written: soms-view is not installed"),
            std::string::npos)
      << result.err;
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "soms-overlap.1"));
}

TEST(PassedOn, TheProgramGetsTheWordsAndGivesItsStatus) {
  const TemporaryFolder folder;
  const std::filesystem::path program = folder.path() / "program";
  write_text(program, "#!/bin/sh\nfor word; do echo \"<$word>\"; done\nexit 7\n");
  std::filesystem::permissions(program, std::filesystem::perms::owner_all);
  const RunResult result = shell("export SOMS_REPRODUCE='" + program.string() +
                                 "'; $soms reproduce --item 'a b' --quick --help");
  EXPECT_EQ(result.status, 7) << result.err;
  EXPECT_EQ(result.out, "<reproduce>\n<--item>\n<a b>\n<--quick>\n<--help>\n");
}

TEST(PassedOn, AProgramOfAnotherVersionIsTakenForAMissingOne) {
  const TemporaryFolder folder;
  const std::filesystem::path program = folder.path() / "program";
  for (const std::string said : {"", "  --size WxH  width", "{}", "{\"schema\":\"soms.verb/2\"}",
                                 "{\"schema\":\"soms.verb/1\",\"options\":[{}]}"}) {
    write_text(program, "#!/bin/sh\necho '" + said + "'\n");
    std::filesystem::permissions(program, std::filesystem::perms::owner_all);
    const std::string view = "export SOMS_VIEW='" + program.string() + "'; $soms ";
    const RunResult completion = shell(view + "completion bash");
    EXPECT_EQ(completion.status, 0) << completion.err;
    EXPECT_NE(completion.out.find("\"view -\"*) words=\"\" ;;"), std::string::npos) << said;
    EXPECT_EQ(shell(view + "man view").out, "") << said;
  }
}

TEST(PassedOn, TheBuiltProgramSpeaksAsTheCommand) {
  const RunResult help = soms_run({"reproduce", "--help"});
  EXPECT_EQ(help.status, 0) << help.err;
  EXPECT_NE(help.out.find("Usage: soms reproduce"), std::string::npos) << help.out;
  const RunResult wrong = soms_run({"reproduce", "--itm", "table-3.1"});
  EXPECT_EQ(wrong.status, 2);
  EXPECT_TRUE(wrong.err.starts_with("soms reproduce: ")) << wrong.err;
  EXPECT_NE(shell("$soms completion bash").out.find("\"reproduce -\"*) words=\"--models --item"),
            std::string::npos);
}

}  // namespace
}  // namespace soms::test
