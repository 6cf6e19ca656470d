#include "tests/commands/run.h"

namespace soms::test {
namespace {

TEST(Completion, CompletesVerbsAndOptionsInBash) {
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "soms.bash").string();
  write_text(file, soms_run({"completion", "bash"}).out);
  const auto complete = [&](const std::string& words, int at) {
    return run_program({"bash", "-c",
                        "source '" + file + "'; COMP_WORDS=(" + words + "); COMP_CWORD=" +
                            std::to_string(at) + "; _soms; echo \"${COMPREPLY[@]}\""})
        .out;
  };
  EXPECT_EQ(complete("soms ove", 1), "overlap\n");
  EXPECT_EQ(complete("soms overlap --tra", 2), "--traversal\n");
  EXPECT_EQ(complete("soms generate --tri", 2), "--triangles\n");
  EXPECT_EQ(complete("soms info " + file.substr(0, file.size() - 3), 2), file + "\n");
}

TEST(Completion, NamesEveryVerbInEveryShell) {
  for (const char* shell : {"bash", "zsh", "fish"}) {
    const RunResult result = soms_run({"completion", shell});
    EXPECT_EQ(result.status, 0);
    EXPECT_NE(result.out.find("overlap"), std::string::npos);
    EXPECT_NE(result.out.find("generate"), std::string::npos);
    EXPECT_NE(result.out.find("descent"), std::string::npos);
  }
}

TEST(Completion, ListsTheShells) {
  const RunResult result = soms_run({"completion", "tcsh"});
  EXPECT_EQ(result.status, 2);
  EXPECT_NE(result.err.find("bash, zsh, fish"), std::string::npos);
}

}  // namespace
}  // namespace soms::test
