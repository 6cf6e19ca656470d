// What a person sees on a terminal: lines of its width, tables, colors. Pipes get neither.
#include "apps/cli/table.h"
#include "tests/commands/run.h"
#include "tests/support/support.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

namespace soms::test {
namespace {

/// Sets a variable of the environment for a while.
class Setting {
 public:
  Setting(const char* name, const std::string& value) : name_(name) {
    setenv(name, value.c_str(), 1);
  }

  ~Setting() { unsetenv(name_); }

  Setting(const Setting&) = delete;
  Setting& operator=(const Setting&) = delete;

 private:
  const char* name_;
};

std::string without_colors(const std::string& text) {
  return std::regex_replace(text, std::regex("\x1b\\[[0-9;]*m|\r"), "");
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) {
    lines.push_back(line);
  }
  return lines;
}

/// The words alone: layout is blanks, line breaks and the backslashes of commands.
std::string words_of(const std::string& text) {
  return std::regex_replace(text, std::regex("[ \\n\\\\]+"), " ");
}

std::vector<std::string> clash_words() {
  return {"clash", test::data("clash/structure.obj").string(), "--against",
          test::data("clash/services.gltf").string()};
}

// Names have letters of several bytes: none is cut, and columns stand below each other.
TEST(Terminal, TablesCountLetters) {
  const std::vector<command::TableColumn> columns{{"part", false, true}, {"depth", true, false}};
  const std::string text =
      command::table_text(columns,
                          {{{"L\u00fcftungsrohr Au\u00dfenwand S\u00fcd \u00dcbergang", "1"}, {}},
                           {{"Sch\u00e4chte", "22"}, {}}},
                          {.person = true, .colors = false, .width = 30});
  EXPECT_EQ(text,
            "  part                   depth\n"
            "  L\u00fcftungsr... \u00dcbergang      1\n"
            "  Sch\u00e4chte                  22\n");
}

TEST(Terminal, HelpHasItsWidthAndAllWords) {
  for (const char* const verb : {"clash", "robot", "simulate", "overlap", "completion"}) {
    const std::string piped = soms_run({verb, "--help"}).out;
    for (const std::size_t width : {50U, 80U, 200U}) {
      const Setting columns("COLUMNS", std::to_string(width));
      const std::string shown = without_colors(soms_on_terminal({verb, "--help"}).out);
      EXPECT_EQ(words_of(shown), words_of(piped)) << verb;
      for (const std::string& line : lines_of(shown)) {
        const bool one_word = line.find(' ', line.find_first_not_of(' ')) == std::string::npos;
        const bool script = line.starts_with("  printf ") || line.starts_with("    soms ");
        EXPECT_TRUE(line.size() <= width || one_word || script)
            << verb << " at " << width << ": " << line;
      }
      EXPECT_EQ(soms_run({verb, "--help"}).out, piped) << "a pipe has no width";
    }
  }
}

TEST(Terminal, HelpKeepsMeaningsInTheirColumn) {
  const Setting columns("COLUMNS", "80");
  const std::string shown = without_colors(soms_on_terminal({"robot", "--help"}).out);
  EXPECT_NE(shown.find("\n  --random N                  random states"), std::string::npos)
      << shown;
  EXPECT_NE(shown.find("or a\n                              named state of the SRDF file\n"),
            std::string::npos)
      << shown;
}

TEST(Terminal, ColorsObeyTheReader) {
  const std::vector<std::string> words = {"solid", box(), box(), "--pose", "0.5 0 0"};
  const std::string plain = soms_run(words).out;
  const std::string red = "\x1b[1;31mcrossing\x1b[0m: ";
  EXPECT_TRUE(plain.starts_with("crossing: "));
  EXPECT_TRUE(soms_on_terminal(words).out.starts_with(red));
  {
    const Setting forced("CLICOLOR_FORCE", "1");
    EXPECT_TRUE(soms_run(words).out.starts_with(red));
    const Setting never("NO_COLOR", "1");
    EXPECT_EQ(soms_run(words).out, plain);
    EXPECT_TRUE(soms_on_terminal(words).out.starts_with("crossing: "));
  }
  const Setting off("CLICOLOR", "0");
  EXPECT_TRUE(soms_on_terminal(words).out.starts_with("crossing: "));
}

TEST(Terminal, VerdictsAreRedOrGreen) {
  const auto shown = [](const std::string& verb, const std::string& pose) {
    return soms_on_terminal({verb, box(), box(), "--pose", pose}).out;
  };
  for (const char* const verb : {"overlap", "distance", "solid"}) {
    EXPECT_NE(shown(verb, "2 0 0").find("\x1b[1;31m"), std::string::npos) << verb;
    EXPECT_NE(shown(verb, "5 0 0").find("\x1b[32m"), std::string::npos) << verb;
    EXPECT_EQ(shown(verb, "5 0 0").find("\x1b[1;31m"), std::string::npos) << verb;
  }
}

TEST(Terminal, ClashesAreATableWithTheDeepestFirst) {
  const Setting columns("COLUMNS", "90");
  const std::string shown = without_colors(soms_on_terminal(clash_words()).out);
  const std::vector<std::string> lines = lines_of(shown);
  const auto head = std::find_if(lines.begin(), lines.end(), [](const std::string& line) {
    return line.starts_with("  class ");
  });
  ASSERT_NE(head, lines.end()) << shown;
  const std::size_t depth_end = head->find("depth") + 5;
  const std::size_t second = head->find("second part");
  double last = 1e9;
  for (auto line = head + 1; line->starts_with("  crossing"); ++line) {
    EXPECT_LE(line->size(), 90U);
    EXPECT_EQ((*line)[second - 1], ' ');
    EXPECT_NE((*line)[second], ' ');
    EXPECT_NE((*line)[depth_end - 1], ' ');
    const double depth = std::stod(line->substr(10, depth_end - 10));
    EXPECT_LE(depth, last);
    last = depth;
    EXPECT_FALSE(std::regex_search(*line, std::regex("[0-9]\\.[0-9]{7}"))) << *line;
  }
  EXPECT_LT(last, 4.5);
}

TEST(Terminal, PipesListTheDeepestClashesFirst) {
  const std::string piped = soms_run(clash_words()).out;
  EXPECT_LT(piped.find(", 4.5 deep"), piped.find(", 1.44249"));
  EXPECT_EQ(piped.find("depth"), std::string::npos);
}

TEST(Terminal, AWarningNamesAPathOnce) {
  const RunResult result = soms_run(clash_words());
  const std::string path = test::data("clash/structure.obj").string();
  std::size_t warnings = 0;
  for (const std::string& line : lines_of(result.err)) {
    if (line.starts_with("warning: ")) {
      ++warnings;
      const std::size_t at = line.find(path);
      ASSERT_NE(at, std::string::npos) << line;
      EXPECT_EQ(line.find(path, at + 1), std::string::npos) << line;
      EXPECT_NE(line.find("structure.obj", at + path.size()), std::string::npos) << line;
    }
  }
  EXPECT_EQ(warnings, 2U) << result.err;
}

TEST(Terminal, FilesOfOneNameKeepTheirPathsInWarnings) {
  const TemporaryFolder folder;
  const std::string model = test::data("clash/services.gltf").string();
  const std::string twin = (folder.path() / "services.gltf").string();
  const std::string other = (folder.path() / "other.gltf").string();
  std::filesystem::copy_file(model, twin);
  std::filesystem::copy_file(model, other);
  const auto warning = [&](const std::string& file) {
    return soms_run({"overlap", file, model, "--scale", "2", "--scale-b", "1000", "--any"}).err;
  };
  EXPECT_NE(warning(twin).find("to convert " + twin), std::string::npos) << warning(twin);
  EXPECT_NE(warning(other).find("to convert other.gltf"), std::string::npos) << warning(other);
}

TEST(Terminal, InfoSumsUpBeforeItListsPlaces) {
  const TemporaryFolder folder;
  const std::string open = (folder.path() / "open.off").string();
  write_text(open, triangle_off("0 0 0", "1 0 0", "0 1 0"));
  const std::string out = soms_run({"info", open}).out;
  ASSERT_NE(out.find("open edges, "), std::string::npos) << out;
  EXPECT_LT(out.find("trees with at most"), out.find("  open edges, ")) << out;
}

TEST(Terminal, TablesHaveSixDigitsAndPipesNine) {
  const TemporaryFolder folder;
  const std::string poses = (folder.path() / "poses.csv").string();
  write_text(poses, "x,y,z\n3.123456789,0,0\n5005000.25,0,0\n");
  const std::vector<std::string> words = {"distance", box(), box(), "--pose", poses};
  const std::string shown = soms_on_terminal(words).out;
  EXPECT_NE(shown.find("  1.12346  "), std::string::npos) << shown;
  EXPECT_NE(shown.find("  5004998.25  "), std::string::npos) << "cut before the point: " << shown;
  EXPECT_NE(soms_run(words).out.find("  1.12345679  "), std::string::npos);
}

}  // namespace
}  // namespace soms::test
