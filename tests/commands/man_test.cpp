#include "tests/commands/run.h"

#include <algorithm>
#include <regex>

namespace soms::test {
namespace {

/// A page's text with its dashes as they are read.
std::string with_dashes(std::string page) {
  for (std::size_t at = page.find("\\-"); at != std::string::npos; at = page.find("\\-", at)) {
    page.erase(at, 1);
  }
  return page;
}

/// Names of options that stand at the beginning of a line of --help.
std::vector<std::string> options_in(const std::string& help) {
  const std::regex name("\n  (?:-[a-z],)?(--[a-z][a-z-]*)");
  std::vector<std::string> names;
  for (std::sregex_iterator at(help.begin(), help.end(), name), end; at != end; ++at) {
    names.push_back((*at)[1]);
  }
  return names;
}

/// The verbs of soms --help.
std::vector<std::string> verbs_in(const std::string& help) {
  const std::regex name("\n  ([a-z]+) {2,}");
  std::vector<std::string> names;
  for (std::sregex_iterator at(help.begin(), help.end(), name), end; at != end; ++at) {
    names.push_back((*at)[1]);
  }
  return names;
}

TEST(Man, HasAPageForEveryVerbWithEveryOptionOfItsHelp) {
  const TemporaryFolder folder;
  const RunResult made = soms_run({"man", "--output", folder.path().string()});
  ASSERT_EQ(made.status, 0) << made.err;
  const std::vector<std::string> files = files_in(folder.path());
  std::size_t all = 0;
  for (const std::string& verb : verbs_in(soms_run({"--help"}).out)) {
    if (made.err.find("soms-" + verb + ".1 is not written") != std::string::npos) {
      continue;
    }
    ASSERT_NE(std::find(files.begin(), files.end(), "soms-" + verb + ".1"), files.end()) << verb;
    const std::string page = with_dashes(read_text(folder.path() / ("soms-" + verb + ".1")));
    EXPECT_EQ(page, with_dashes(soms_run({"man", verb}).out));
    const std::vector<std::string> options = options_in(soms_run({verb, "--help"}).out);
    all += options.size();
    for (const std::string& option : options) {
      EXPECT_NE(page.find("\\fB" + option + "\\fR"), std::string::npos) << verb << " " << option;
    }
  }
  EXPECT_GE(all, 150U);
}

TEST(Man, TellsOfTheCommandWhatItsHelpTells) {
  const std::string page = with_dashes(soms_run({"man"}).out);
  for (const std::string& verb : verbs_in(soms_run({"--help"}).out)) {
    EXPECT_NE(page.find("\n.TP\n\\fB" + verb + "\\fR\n"), std::string::npos) << verb;
    EXPECT_NE(page.find("\\fBsoms-" + verb + "\\fR(1)"), std::string::npos) << verb;
  }
  EXPECT_NE(page.find("5 could not write"), std::string::npos);
  EXPECT_NE(page.find("soms - find exactly, and fast, which"), std::string::npos);
}

TEST(Man, KeepsExamplesAsTheyAreTyped) {
  const std::string page = with_dashes(soms_run({"man", "overlap"}).out);
  EXPECT_NE(page.find(".SH EXAMPLE\n.nf\nsoms generate knot --triangles 2000 -o knot.ply\n"),
            std::string::npos);
  EXPECT_NE(page.find("stop at the first pair found, whichever it is; not with --all, --by, "
                      "--first or --limit"),
            std::string::npos)
      << page;
}

TEST(Man, ListsTheKeysOfAListBelowTheOptions) {
  for (const std::string verb : {"overlap", "render"}) {
    const std::string page = with_dashes(soms_run({"man", verb}).out);
    EXPECT_NE(page.find("\n.SH KEYS OF --TREE\n"), std::string::npos) << verb;
    EXPECT_NE(page.find("\n.TP\n\\fBleaf=\\fR\\fIN\\fR\nmaximum number of triangles in a leaf"),
              std::string::npos)
        << page;
    EXPECT_EQ(page.find("\\fB--leaf"), std::string::npos) << verb;
  }
}

TEST(Man, HasNamesOfASecondModelOnTheLineOfTheFirst) {
  const std::string page = with_dashes(soms_run({"man", "overlap"}).out);
  EXPECT_NE(
      page.find(
          "\n.TP\n\\fB--scale\\fR, \\fB--scale-b\\fR \\fIX\\fR\nmultiply the coordinates of A "
          "or B; 1 confirms"),
      std::string::npos)
      << page;
  EXPECT_NE(page.find("\n.SH SYNOPSIS\n\\fBsoms overlap\\fR [OPTIONS] A B\n"), std::string::npos)
      << page;
}

TEST(Man, MakesPagesWithoutFaultsToTheFormatter) {
  if (shell("command -v groff").status != 0) {
    GTEST_SKIP() << "groff is not installed";
  }
  const RunResult result = shell(
      "for v in '' overlap simulate generate reproduce; do "
      "\"$soms\" man $v | groff -ww -man -Tutf8 -z || exit 1; done");
  EXPECT_EQ(result.status, 0);
  EXPECT_EQ(result.out + result.err, "");
}

TEST(Man, NamesTheVerbsToAWrongWord) {
  const RunResult result = soms_run({"man", "overlop"});
  EXPECT_EQ(result.status, 2);
  EXPECT_NE(result.err.find("did you mean overlap?"), std::string::npos) << result.err;
}

}  // namespace
}  // namespace soms::test
