// --tree KEY=VALUE,...: the options of trees in one list, and their old forms.
#include "tests/commands/run.h"

#include <regex>

namespace soms::test {
namespace {

/// A folder with a knot and a ball that touch.
class TreeList : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_EQ(soms_run({"generate", "knot", "--triangles", "400", "-o", knot()}).status, 0);
    ASSERT_EQ(soms_run({"generate", "sphere", "--triangles", "80", "-o", ball()}).status, 0);
  }

  [[nodiscard]] std::string knot() const { return (folder_.path() / "knot.ply").string(); }

  [[nodiscard]] std::string ball() const { return (folder_.path() / "ball.ply").string(); }

  [[nodiscard]] RunResult overlap(std::vector<std::string> words) const {
    words.insert(words.begin(), {"overlap", knot(), ball(), "--no-pairs"});
    return soms_run(words);
  }

 private:
  TemporaryFolder folder_;
};

TEST_F(TreeList, SetsWhatTheOldOptionsSet) {
  const RunResult list =
      overlap({"--tree", "rule=soms,leaf=1,levels=9", "--tree=traversal=larger"});
  EXPECT_EQ(list.status, 0) << list.err;
  EXPECT_EQ(list.err, "");
  EXPECT_NE(list.out.find("traversal larger: "), std::string::npos) << list.out;
  const RunResult old =
      overlap({"--rule", "soms", "--leaf=1", "--levels", "9", "--traversal", "larger"});
  EXPECT_EQ(old.out, list.out);
  EXPECT_NE(overlap({"--tree", "traversal=larger"}).out, list.out);
}

TEST_F(TreeList, AnOldFormSaysWhatItIsNow) {
  const RunResult old = overlap({"--leaf", "1"});
  EXPECT_EQ(old.status, 0);
  EXPECT_EQ(old.err, "--leaf is now --tree leaf=N; the old form ends with the next release\n");
  EXPECT_EQ(overlap({"--leaf", "1", "--quiet"}).err, "");
}

TEST_F(TreeList, RefusesWhatIsNoKeyOrHasNoValue) {
  const auto says = [&](const std::string& list, const std::string& what) {
    const RunResult result = overlap({"--tree", list});
    EXPECT_EQ(result.status, 2) << list;
    EXPECT_EQ(result.out, "");
    EXPECT_NE(result.err.find(what), std::string::npos) << result.err;
  };
  says("rull=soms", "--tree: unknown key rull; did you mean rule?");
  says("pose=1", "--tree: unknown key pose; use rule, levels, leaf");
  says("", "unknown key \"\"");
  says("rule=soms,", "unknown key \"\"");
  says("leaf", "--tree: leaf has no value; write --tree leaf=VALUE");
  says("leaf=x", "--tree leaf=x;");
  says("rule=somes", "--tree rule=somes; did you mean soms?");
  says("leaf=1,leaf=2", "--tree leaf is given more than once");
  says("empty-side=chain,rule=soms", "--tree empty-side=chain without --tree levels never ends");
  says("midpoint=thesis", "--tree midpoint has no effect");
  EXPECT_NE(overlap({"--tree"}).err.find("--tree needs a value"), std::string::npos);
}

TEST_F(TreeList, IsNoListWhereItIsTheValueOfAnotherOption) {
  const TemporaryFolder folder;
  for (const char* const word : {"--tree", "--tree=help", "--rule"}) {
    const RunResult result = shell("cd '" + folder.path().string() + "' && $soms overlap '" +
                                   knot() + "' '" + ball() + "' --csv " + word + " rule=soms");
    EXPECT_EQ(result.status, 2) << word;
    EXPECT_NE(result.err.find("unexpected argument rule=soms"), std::string::npos) << result.err;
  }
  EXPECT_EQ(files_in(folder.path()), std::vector<std::string>());
}

TEST_F(TreeList, MessagesLeaveNamesOfFilesAlone) {
  for (const char* const name : {"d--rule/x.off", "x--rule", "--rule.off"}) {
    const RunResult result = soms_run({"overlap", "--", name, ball()});
    EXPECT_NE(result.err.find(name), std::string::npos) << result.err;
  }
}

TEST_F(TreeList, HelpWinsOverAFault) {
  EXPECT_EQ(soms_run({"overlap", "--tree", "foo=1", "--help"}).status, 0);
}

TEST_F(TreeList, HelpListsTheKeys) {
  const RunResult keys = soms_run({"overlap", "--tree", "help"});
  EXPECT_EQ(keys.status, 0);
  for (const char* const key : {"rule=NAME", "levels=N", "leaf=N", "traversal=NAME",
                                "vertex that is C for --tree midpoint=thesis", "object-median|"}) {
    EXPECT_NE(keys.out.find(key), std::string::npos) << key << keys.out;
  }
  EXPECT_EQ(soms_run({"closest", "--tree", "help"}).out.find("traversal="), std::string::npos);
}

TEST_F(TreeList, ManPagesListTheKeys) {
  const std::string page = soms_run({"man", "overlap"}).out;
  EXPECT_NE(page.find(".SH KEYS OF \\-\\-TREE\n"), std::string::npos) << page;
  EXPECT_NE(page.find("\\fBrule=\\fR\\fINAME\\fR"), std::string::npos);
  EXPECT_EQ(soms_run({"man", "convert"}).out.find("KEYS OF"), std::string::npos);
}

TEST(HelpOfQueries, HasAtMostTwentyOptions) {
  const std::regex option("\n  -[^\n]*");
  for (const char* const verb : {"overlap", "closest", "distance", "within", "contains", "ray"}) {
    const std::string help = soms_run({verb, "--help"}).out;
    const auto count = std::distance(std::sregex_iterator(help.begin(), help.end(), option),
                                     std::sregex_iterator());
    EXPECT_LE(count, 20) << help;
    EXPECT_GE(count, 8) << help;
    EXPECT_NE(help.find("Shared options (soms --help): --help, --json, "), std::string::npos)
        << help;
    EXPECT_NE(help.find("--tree KEY=VALUE,..."), std::string::npos) << help;
    EXPECT_EQ(help.find("--rule"), std::string::npos) << help;
  }
  const std::string all = soms_run({"--help"}).out;
  for (const char* const shared : {"-h,--help", "--threads N", "--timeout SECONDS"}) {
    EXPECT_NE(all.find(std::string("\n  ") + shared + " "), std::string::npos) << all;
  }
}

}  // namespace
}  // namespace soms::test
