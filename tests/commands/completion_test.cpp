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
  EXPECT_EQ(complete("soms overlap --tre", 2), "--tree\n");
  EXPECT_EQ(complete("soms generate --tri", 2), "--triangles\n");
  EXPECT_EQ(complete("soms generate ci", 2), "city\n");
  EXPECT_EQ(complete("soms generate --seed 7 kn", 4), "knot\n");
  EXPECT_EQ(complete("soms convert a b --format stl", 5), "stl stl-ascii\n");
  EXPECT_EQ(complete("soms completion ''", 2), "bash zsh fish\n");
  EXPECT_EQ(complete("soms generate knot ''", 3), "\n");
  EXPECT_EQ(complete("soms convert a b --format = st", 6), "stl stl-ascii\n");
  EXPECT_EQ(complete("soms convert a b --format =", 5),
            complete("soms convert a b --format ''", 5));
  EXPECT_EQ(complete("soms convert a b --format=st", 4), "--format=stl --format=stl-ascii\n");
  for (const std::string verb : {"man", "help"}) {
    EXPECT_EQ(complete("soms " + verb + " ove", 2), "overlap\n");
  }
  EXPECT_EQ(complete("soms man ''", 2), complete("soms help ''", 2));
}

TEST(Completion, CompletesKeysOfAListAndTheirValuesInBash) {
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "soms.bash").string();
  write_text(file, soms_run({"completion", "bash"}).out);
  // Bash makes words of a line at blanks and around "="; the last one is completed.
  const auto complete = [&](const std::string& words) {
    return run_program({"bash", "-c",
                        "source '" + file + "'; COMP_WORDS=(soms " + words +
                            "); COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); _soms; echo "
                            "\"${COMPREPLY[@]}\""})
        .out;
  };
  EXPECT_EQ(complete("overlap a b --tree le"), "levels= leaf=\n");
  EXPECT_EQ(complete("overlap a b --tree des"),
            "descent=both descent=larger descent=cross descent=fewest\n");
  EXPECT_EQ(complete("overlap a b --tree rule = qu"), "quality quick\n");
  EXPECT_EQ(complete("overlap a b --tree rule ="), complete("overlap a b --tree rule = ''"));
  EXPECT_EQ(complete("overlap a b --tree rule = soms,lea"), "soms,leaf=\n");
  EXPECT_EQ(complete("overlap a b --tree leaf = 4,rule = qu"), "quality quick\n");
  EXPECT_EQ(complete("overlap --tree = rule = qu"), "quality quick\n");
  EXPECT_EQ(complete("overlap --tree = lea"), "leaf=\n");
  EXPECT_EQ(complete("overlap --tree hel"), "help\n");
  // A verb has its own keys.
  EXPECT_EQ(complete("distance a b --tree des"), "\n");
  EXPECT_EQ(complete("render --tree des"), complete("overlap --tree des"));
}

// Readline's own completion knows how to quote: an answer of ours would be cut at blanks.
TEST(Completion, LeavesFilesToTheShellInBash) {
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "soms.bash").string();
  write_text(file, soms_run({"completion", "bash"}).out);
  write_text(folder.path() / "my town.ply", "");
  const std::string source = "cd '" + folder.path().string() + "'; source ./soms.bash; ";
  EXPECT_EQ(run_program({"bash", "-c", source + "complete -p soms"}).out,
            "complete -o bashdefault -o default -F _soms soms\n");
  for (const std::string words :
       {"soms info my", "soms generate city -o my", "soms overlap my\\ t"}) {
    const std::string ask =
        "COMP_WORDS=(" + words +
        "); COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); _soms; echo \"${#COMPREPLY[@]}\"";
    EXPECT_EQ(run_program({"bash", "-c", source + ask}).out, "0\n") << words;
  }
}

bool has_program(const std::string& name) {
  return run_program({"sh", "-c", "command -v " + name}).status == 0;
}

TEST(Completion, WorksInZsh) {
  if (!has_program("zsh")) {
    GTEST_SKIP() << "zsh is not installed: its completion is untested";
  }
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "soms.zsh").string();
  write_text(file, soms_run({"completion", "zsh"}).out);
  const auto complete = [&](const std::string& words, int at) {
    return run_program({"zsh", "-f", "-c",
                        "autoload -U compinit; compinit -D -u; source '" + file +
                            "'; ask() { emulate -L sh; COMP_WORDS=(" + words + "); COMP_CWORD=" +
                            std::to_string(at) + "; _soms; echo \"${COMPREPLY[@]}\"; }; ask"});
  };
  // Outside of a terminal zsh does not choose by what was typed so far.
  EXPECT_TRUE(complete("soms convert a b --format=st", 4).out.starts_with("--format=ply "));
  EXPECT_TRUE(complete("soms generate kn", 2).out.starts_with("knot "));
  const RunResult second = complete("soms generate knot kn", 3);
  EXPECT_EQ(second.out + second.err, "\n");
}

TEST(Completion, WorksInFish) {
  if (!has_program("fish")) {
    GTEST_SKIP() << "fish is not installed: its completion is untested";
  }
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "soms.fish").string();
  write_text(file, soms_run({"completion", "fish"}).out);
  const auto complete = [&](const std::string& line) {
    return run_program(
               {"fish", "-c",
                "cd '" + folder.path().string() + "'; source soms.fish; complete -C'" + line + "'"})
        .out;
  };
  EXPECT_TRUE(complete("soms conv").starts_with("convert"));
  EXPECT_EQ(complete("soms generate kn"), "knot\n");
  EXPECT_EQ(complete("soms generate knot kn"), "");
  EXPECT_TRUE(complete("soms man ov").starts_with("overlap"));
  EXPECT_TRUE(complete("soms help ov").starts_with("overlap"));
  EXPECT_TRUE(complete("soms he").starts_with("help"));
  EXPECT_EQ(complete("soms convert a b --format st"), "stl\nstl-ascii\n");
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
