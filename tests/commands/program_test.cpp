#include "soms/io/formats.h"

#include "apps/cli/parse.h"
#include "tests/commands/run.h"
#include "tests/support/slow_build.h"

#include <regex>
#include <sstream>

namespace soms::test {
namespace {

using testing::Test;

std::vector<std::string> verb_names() {
  std::vector<std::string> names;
  std::istringstream help(soms_run({"--help"}).out);
  bool inside = false;
  for (std::string line; std::getline(help, line);) {
    if (line == "Verbs:") {
      inside = true;
    } else if (line.empty()) {
      inside = false;
    } else if (inside) {
      names.push_back(line.substr(2, line.find(' ', 2) - 2));
    }
  }
  return names;
}

/// False for verbs of soms-view where it was not built.
bool is_built(const std::string& verb) {
  return (verb != "view" && verb != "render") ||
         std::filesystem::exists(command().parent_path() / "soms-view");
}

/// The lines of a help text that follow "Example:" and begin with "  soms".
std::vector<std::string> examples(const std::string& help) {
  std::vector<std::string> lines;
  std::istringstream in(help.substr(std::min(help.size(), help.find("Example:"))));
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with("  soms ")) {
      lines.push_back("$soms " + line.substr(7));
    } else if (line.starts_with("  printf ") && line.find(" > ") != std::string::npos) {
      lines.push_back(line.substr(2));  // a file that the next lines read
    }
  }
  return lines;
}

TEST(Program, TellsItsVersionAndItsVerbs) {
  EXPECT_EQ(soms_run({"--version"}).out, "soms " SOMS_VERSION "\n");
  EXPECT_EQ(soms_run({"-V"}).out, "soms " SOMS_VERSION "\n");
  const RunResult help = soms_run({"--help"});
  EXPECT_EQ(help.status, 0);
  EXPECT_EQ(help.err, "");
  EXPECT_EQ(soms_run({}).out, help.out);
  EXPECT_EQ(soms_run({"help"}).out, help.out);
  for (const char* verb : {"completion", "convert", "generate", "info", "overlap"}) {
    EXPECT_NE(help.out.find(std::string("  ") + verb + " "), std::string::npos) << verb;
  }
}

TEST(Program, HelpsWithHelp) {
  const std::string help = soms_run({"--help"}).out;
  for (const char* const word : {"help", "--help", "-q"}) {
    EXPECT_EQ(soms_run({"help", word}).out, help) << word;
  }
  EXPECT_EQ(soms_run({"help", "overlap", "info"}).status, 2);
  EXPECT_EQ(soms_run({"--version", "overlap"}).status, 2);
}

TEST(Program, NamesOptionsThatDoNotGoTogether) {
  const std::string box = test::data("truth/meshes/box2.ply").string();
  const auto says = [](const std::vector<std::string>& words, const std::string& what) {
    const RunResult result = soms_run(words);
    EXPECT_EQ(result.status, 2) << result.err;
    EXPECT_NE(result.err.find(what), std::string::npos) << result.err;
  };
  says({"info", box, "--tree", "empty-side=chain"},
       "--tree empty-side=chain without --tree levels");
  says({"overlap", box, box, "--tree", "traversal=e-node-front", "--tree", "descent=cross"},
       "--tree traversal=e-node-front does not work with --tree descent=cross; use --tree "
       "descent=both or --tree descent=larger");
  says({"man", "overlap", "--output", "/tmp"}, "--output writes all pages");
  says({"info", "-", "-"}, "standard input is given twice");
  says({"info", ""}, "the name of a model is empty");
  says({"convert", box, "/dev/full"}, "choose a format with --format");
  says({"overlap", box, box, "--limit", "99999999999999999999"}, "18446744073709551615");
  EXPECT_EQ(soms_run({"info", box, "--no-trees", "--scale", "+2"}).status, 0);
}

TEST(Program, R119OptionsThatWouldBeIgnoredAreRefused) {
  const std::string box = test::data("truth/meshes/box2.ply").string();
  const auto says = [](const std::vector<std::string>& words, const std::string& what) {
    const RunResult result = soms_run(words);
    EXPECT_EQ(result.status, 2) << what;
    EXPECT_EQ(result.out, "");
    EXPECT_NE(result.err.find(what), std::string::npos) << result.err;
  };
  says({"info", box, "--tree", "rule=fast", "--tree", "midpoint=centroid", "--tree",
        "empty-side=stop"},
       "--tree midpoint has no effect: the rules fast, quality and quick have builders of their "
       "own; "
       "leave it out, or give another --tree rule");
  // Its default, too: whoever gives it means it to matter.
  says({"info", box, "--tree", "rule=quality", "--tree", "midpoint=aabb"},
       "--tree midpoint has no effect");
  says({"overlap", box, box, "--tree", "axis-from=outer"}, "--tree axis-from has no effect");
  says({"overlap", box, box, "--tree", "rule=sah", "--tree", "c-vertex=0"},
       "--tree c-vertex has no effect: only the midpoint thesis has a corner C; leave it out, or "
       "also give --tree midpoint=thesis");
  says({"info", box, "--tree", "root-level=0"},
       "--tree root-level has no effect: levels are not limited");
  says({"info", box, "--no-trees", "--tree", "leaf=4"},
       "--tree leaf has no effect: --no-trees builds no trees");
  says({"overlap", box, box, "--tree", "traversal=a-first", "--tree", "descent=both"},
       "--tree descent has no effect");
  says({"overlap", box, box, "--any", "--no-pairs"}, "--no-pairs has no effect");
  says({"overlap", box, box, "--any", "--limit", "3"}, "--limit");
  says({"man", "overlap", "--json"}, "--json has no effect");
  says({"completion", "bash", "--json"}, "--json has no effect");
}

// Where trees are built by every rule, an option that only some use is no error; that is said.
TEST(Program, R119OptionsThatSomeRulesIgnoreAreNoted) {
  const std::string box = test::data("truth/meshes/box2.ply").string();
  const RunResult result =
      soms_run({"info", box, "--tree", "midpoint=thesis", "--tree", "c-vertex=0"});
  EXPECT_EQ(result.status, 0);
  EXPECT_EQ(result.err,
            "rule fast does not use --tree midpoint, --tree c-vertex\n"
            "rule quality does not use --tree midpoint, --tree c-vertex\n"
            "rule quick does not use --tree midpoint, --tree c-vertex\n");
}

TEST(Program, TakesAnEmptyNameOfAnOutputForAnError) {
  const std::string box = test::data("truth/meshes/box2.ply").string();
  const auto refused = [](std::vector<std::string> words, const std::string& option) {
    words.insert(words.end(), {option, ""});
    const RunResult result = soms_run(words);
    EXPECT_EQ(result.status, 2) << result.err;
    EXPECT_EQ(result.out, "");
    EXPECT_NE(result.err.find(option + ": the name is empty; give a name"), std::string::npos)
        << result.err;
  };
  refused({"overlap", box, box}, "--report");
  for (const char* const option :
       {"--map", "--report", "--events", "--contacts", "--record", "--picture"}) {
    refused({"simulate", box, "--count", "1", "--frames", "1"}, option);
  }
  refused({"reproduce", "--item", "table-3.1"}, "--output");
  refused({"reproduce", "--item", "table-3.1"}, "--report");
  refused({"man"}, "--output");
  refused({"bench", box, box, "--random", "1"}, "--output");
}

TEST(Program, SuggestsTheVerbThatWasMeant) {
  const RunResult result = soms_run({"ovrelap", "a", "b"});
  EXPECT_EQ(result.status, 2);
  EXPECT_EQ(result.out, "");
  EXPECT_EQ(result.err,
            "soms: unknown verb ovrelap; did you mean overlap? (soms --help lists them)\n");
  EXPECT_NE(soms_run({"xyzzy"}).err.find("unknown verb xyzzy; soms --help lists them"),
            std::string::npos);
}

TEST(Program, SuggestsTheOptionThatWasMeant) {
  const RunResult result = soms_run({"overlap", "a.ply", "b.ply", "--jsno"});
  EXPECT_EQ(result.status, 2);
  EXPECT_NE(result.err.find("soms overlap: unknown option --jsno; did you mean --json?"),
            std::string::npos)
      << result.err;
}

TEST(Program, SuggestsEveryOptionThatIsEquallyNear) {
  const RunResult result = soms_run({"overlap", "a.ply", "b.ply", "--upb", "y"});
  EXPECT_EQ(result.status, 2);
  EXPECT_NE(result.err.find("unknown option --upb; did you mean --up or --up-b?"),
            std::string::npos)
      << result.err;
}

TEST(Program, NamesTheOptionThatConvertsUnits) {
  const RunResult result = soms_run({"convert", "a.ply", "b.ply", "--unit", "mm"});
  EXPECT_EQ(result.status, 2);
  EXPECT_NE(result.err.find("unknown option --unit; --scale converts units"), std::string::npos)
      << result.err;
}

TEST(Program, NamesTheDecimalPointWhereANumberHasAComma) {
  const RunResult result = soms_run({"convert", "a.ply", "b.ply", "--scale", "0,001"});
  EXPECT_EQ(result.status, 2);
  EXPECT_NE(result.err.find("--scale 0,001; give a finite number, with a decimal point, not a "),
            std::string::npos)
      << result.err;
}

TEST(Program, SuggestsNothingForAShortWordUnlessItsCaseDiffers) {
  const RunResult same = soms_run({"info", "a.ply", "--up", "Z"});
  EXPECT_EQ(same.status, 2);
  EXPECT_NE(same.err.find("did you mean z?"), std::string::npos) << same.err;
  for (const std::string word : {"w", "xy", ""}) {
    const RunResult other = soms_run({"info", "a.ply", "--up", word});
    EXPECT_EQ(other.status, 2);
    EXPECT_EQ(other.err.find("did you mean"), std::string::npos) << other.err;
    EXPECT_NE(other.err.find("choose one of x, y, z"), std::string::npos) << other.err;
  }
}

TEST(Program, NamesAnUnknownOptionBeforeAMissingArgument) {
  EXPECT_NE(
      soms_run({"overlap", "--frist"}).err.find("unknown option --frist; did you mean --first?"),
      std::string::npos);
}

TEST(Program, WantsTheVerbFirst) {
  const RunResult result = soms_run({"--json", "overlap"});
  EXPECT_EQ(result.status, 2);
  EXPECT_NE(result.err.find("--json is given before the verb"), std::string::npos);
}

TEST(Program, TakesWhatFollowsTwoDashesForNames) {
  const TemporaryFolder folder;
  std::filesystem::copy_file(test::data("truth/meshes/box2.ply"), folder.path() / "-box.ply");
  const std::string go = "cd '" + folder.path().string() + "'; $soms ";
  EXPECT_EQ(shell(go + "info --no-trees -- -box.ply").status, 0);
  EXPECT_EQ(shell(go + "overlap --any -- -box.ply -box.ply").status, 0);
  EXPECT_EQ(shell(go + "-- info --no-trees -- -box.ply").status, 0);
  EXPECT_NE(shell(go + "overlap -- -box.ply -box.ply --any").err.find("unexpected argument --any"),
            std::string::npos);
  EXPECT_NE(shell(go + "info --nothing -- -box.ply").err.find("unknown option --nothing"),
            std::string::npos);
  EXPECT_EQ(soms_run({"--"}).out, soms_run({"--help"}).out);
  EXPECT_EQ(
      shell(go + "info -box.ply").err,
      "soms info: unknown option -box.ply; for a file of that name, write ./-box.ply, or put -- "
      "before it\n");
}

TEST(Program, NamesOptionsThatTheVerbHasWhereAModelIsEmptyOrMemoryIsShort) {
  const std::string empty = test::data("nasty/empty_mesh.ply").string();
  EXPECT_NE(soms_run({"info", empty}).err.find("or allow an empty one with --allow-empty"),
            std::string::npos);
  const RunResult city = soms_run({"simulate", empty, "--count", "1"});
  EXPECT_EQ(city.status, 3);
  EXPECT_NE(city.err.find("give a model with faces\n"), std::string::npos) << city.err;
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)  // both reserve terabytes
  const RunResult small =
      soms_run({"info", test::data("truth/meshes/box2.ply").string(), "--max-memory", "100"});
  EXPECT_EQ(small.status, 4);
  EXPECT_NE(small.err.find("--max-memory"), std::string::npos) << small.err;
  EXPECT_EQ(small.err.find("max_memory"), std::string::npos) << small.err;
#endif
}

TEST(Program, SaysWhatIsMissingOrTooMuch) {
  EXPECT_NE(soms_run({"overlap", "a.ply"}).err.find("B is required"), std::string::npos);
  EXPECT_NE(soms_run({"overlap", "a", "b", "c"}).err.find("unexpected argument c"),
            std::string::npos);
  EXPECT_NE(soms_run({"info", "a", "--threads"}).err.find("--threads needs a value"),
            std::string::npos);
  EXPECT_NE(soms_run({"info", "a", "--threads", "1", "--threads", "2"})
                .err.find("--threads is given more than once"),
            std::string::npos);
}

TEST(Program, RefusesNumbersThatMakeNoSenseAndNamesTheOption) {
  const std::vector<std::pair<std::string, std::string>> cases{
      {"--threads", "-1"},      {"--threads", "4294967297"},
      {"--threads", "2x"},      {"--threads", ""},
      {"--threads", "1e3"},     {"--threads", "nan"},
      {"--seed", "-1"},         {"--seed", "18446744073709551616"},
      {"--timeout", "-1"},      {"--timeout", "nan"},
      {"--timeout", "inf"},     {"--max-memory", "0"},
      {"--max-memory", "-5"},   {"--max-memory", "5X"},
      {"--max-memory", "5MX"},  {"--max-memory", "99999999999T"},
      {"--tree", "leaf=0"},     {"--tree", "leaf=2147483648"},
      {"--tree", "levels=-3"},  {"--tree", "levels=1000"},
      {"--tree", "c-vertex=3"}, {"--tree", "root-level=2"},
      {"--scale", "0"},         {"--scale", "-1"},
      {"--scale", "nan"},       {"--scale", "1,5"},
      {"--limit", "0"},         {"--limit", "-7"}};
  for (const auto& [option, value] : cases) {
    const RunResult result = soms_run({"overlap", "a.ply", "b.ply", option, value});
    EXPECT_EQ(result.status, 2) << option << " " << value << ": " << result.err;
    EXPECT_NE(result.err.find("soms overlap: " + option), std::string::npos) << result.err;
    EXPECT_EQ(result.out, "");
  }
}

TEST(Program, TakesSizesInEitherCase) {
  for (const char* size : {"500M", "500m", "500MB", "500mb", "500MiB", "500mib"}) {
    EXPECT_EQ(command::parse_bytes("--max-memory", size), 500ULL << 20) << size;
  }
}

TEST(Program, ListsTheWordsOfAChoice) {
  const RunResult rule = soms_run({"overlap", "a", "b", "--tree", "rule=shah"});
  EXPECT_EQ(rule.status, 2);
  EXPECT_NE(rule.err.find("--tree rule=shah; did you mean sah? choose one of object-median"),
            std::string::npos)
      << rule.err;
  for (const auto& [given, meant] :
       {std::pair("SAH", "sah"), std::pair("object_median", "object-median"),
        std::pair("Object_Median", "object-median"), std::pair("SOMS", "soms")}) {
    const RunResult other = soms_run({"info", "a", "--tree", std::string("rule=") + given});
    EXPECT_NE(other.err.find(std::string("did you mean ") + meant + "? "), std::string::npos)
        << other.err;
  }
  const RunResult traversal = soms_run({"overlap", "a", "b", "--tree", "traversal=zig-zag"});
  EXPECT_EQ(traversal.status, 2);
  EXPECT_NE(traversal.err.find("e-node"), std::string::npos) << traversal.err;
}

TEST(Program, DoesNotTranslateNumbersByTheLocale) {
  const RunResult result = shell("LC_ALL=de_DE.UTF-8 $soms overlap a b --scale 1.5");
  EXPECT_EQ(result.status, 3) << result.err;  // no file "a": the number was understood
}

TEST(Program, EveryVerbsExampleWorks) {
  const std::vector<std::string> verbs = verb_names();
  ASSERT_GE(verbs.size(), 5U);
  for (const std::string& verb : verbs) {
    if (!is_built(verb)) {
      continue;
    }
    const RunResult help = soms_run({verb, "--help"});
    EXPECT_EQ(help.status, 0);
    EXPECT_EQ(soms_run({"help", verb}).out, help.out);
    const std::vector<std::string> lines = examples(help.out);
    EXPECT_FALSE(lines.empty()) << verb << " shows no example";
    const TemporaryFolder folder;
    for (const std::string& line : lines) {
      std::string there = "cd '";
      there += folder.path().string();
      if (line.starts_with("$soms view ") || line.starts_with("$soms render ")) {
        continue;  // run by tests/view, which know whether there is a display
      }
      if (line.starts_with("$soms reproduce ") && kSlowBuild) {
        continue;  // a minute and a half
      }
      const RunResult result = shell(there + "' && " + line);
      EXPECT_EQ(result.status, 0) << line << "\n" << result.err;
    }
  }
}

TEST(Program, SaysInWordsWhichOptionsStandAlone) {
  const std::string help = soms_run({"overlap", "--help"}).out;
  EXPECT_NE(help.find("; not with --any or --first\n"), std::string::npos) << help;
  EXPECT_EQ(help.find("Excludes"), std::string::npos);
  EXPECT_NE(soms_run({"bench", "--help"}).out.find("(default 1000); not with --pose\n"),
            std::string::npos);
}

TEST(Program, ListsTheFormatsThatAreWrittenInEveryHelp) {
  const std::string help = soms_run({"generate", "--help"}).out;
  EXPECT_NE(help.find(writable_extensions()), std::string::npos) << help;
  std::string words;
  for (const WritableFormat& row : writable_formats()) {
    words.append(words.empty() ? "" : "|").append(row.name);
  }
  EXPECT_NE(help.find(words), std::string::npos) << words;
  EXPECT_NE(soms_run({"--help"}).out.find("convert a model to " + writable_names() + "\n"),
            std::string::npos);
}

TEST(Program, EveryHelpFitsAScreen) {
  for (const std::string& verb : verb_names()) {
    if (!is_built(verb)) {
      continue;
    }
    std::istringstream help(soms_run({verb, "--help"}).out);
    for (std::string line; std::getline(help, line);) {
      EXPECT_LE(line.size(), 120U) << verb << ": " << line;
    }
  }
}

TEST(Program, EveryOptionIsOnThePageOfTheCommand) {
  const std::string page = read_text(std::string(SOMS_DOCS) + "/commands.md");
  ASSERT_FALSE(page.empty());
  const std::regex option("--[a-z][a-z-]*");
  for (const std::string& verb : verb_names()) {
    const std::size_t begin = page.find("\n## " + verb + "\n");
    ASSERT_NE(begin, std::string::npos) << "no section for " << verb;
    const std::size_t end = page.find("\n## ", begin + 1);
    const std::string section = page.substr(begin, end - begin);
    const std::size_t shared = page.find("\n## Shared options\n");
    ASSERT_NE(shared, std::string::npos);
    const std::string common = page.substr(shared, page.find("\n## ", shared + 1) - shared);
    const std::string help = soms_run({verb, "--help"}).out;
    const std::string listed = help.substr(0, help.find("Example:"));
    for (std::sregex_iterator it(listed.begin(), listed.end(), option), last; it != last; ++it) {
      std::string quoted = "`";
      quoted += it->str();
      EXPECT_TRUE(section.find(quoted) != std::string::npos ||
                  common.find(quoted) != std::string::npos)
          << it->str() << " of " << verb << " is not in docs/commands.md";
    }
  }
}

}  // namespace
}  // namespace soms::test
