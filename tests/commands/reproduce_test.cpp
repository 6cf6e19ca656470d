#include "tests/commands/run.h"
#include "tests/support/slow_build.h"

#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <map>
#include <set>
#include <sstream>

namespace soms::test {
namespace {

namespace fs = std::filesystem;

/// Names, relative to the folder, of all files below it.
std::set<std::string> files_below(const fs::path& folder) {
  std::set<std::string> names;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file()) {
      names.insert(entry.path().lexically_relative(folder).generic_string());
    }
  }
  return names;
}

RunResult reproduce(const fs::path& folder, std::vector<std::string> words) {
  words.insert(words.begin(), {"reproduce", "--quick", "-o", folder.string()});
  return soms_run(std::move(words));
}

Json run_json(const fs::path& folder) {
  return Json::parse(read_text(folder / "run.json"));
}

/// What a run wrote, without times: for a table its lines with the timed columns cut out, for a
/// figure all of it unless it shows times.
std::map<std::string, std::string> untimed(const fs::path& folder) {
  std::map<std::string, std::string> kept;
  const Json run = run_json(folder);
  for (const Json& item : run.at("items")) {
    for (const Json& file : item.at("files")) {
      const auto name = file.at("file").get<std::string>();
      const std::string text = read_text(folder / name);
      if (!file.contains("timed_columns")) {
        kept[name] = file.at("timed").get<bool>() ? "" : text;
        continue;
      }
      const auto timed = file.at("timed_columns").get<std::set<std::size_t>>();
      std::istringstream lines(text);
      for (std::string line; std::getline(lines, line);) {
        if (line.find('"') != std::string::npos) {
          kept[name] += line + "\n";  // no cell with a comma stands beside a time in these items
          continue;
        }
        std::istringstream cells(line);
        std::size_t column = 0;
        for (std::string cell; std::getline(cells, cell, ',');) {
          kept[name] += timed.contains(column++) ? "," : cell + ",";
        }
        kept[name] += "\n";
      }
    }
  }
  return kept;
}

TEST(Reproduce, WritesTablesFiguresPageAndListOfFiles) {
  const TemporaryFolder folder;
  const RunResult result = reproduce(folder.path(), {"--item", "3.1,5.3", "--json"});
  ASSERT_EQ(result.status, 0) << result.err;
  const Json run = run_json(folder.path());
  EXPECT_EQ(run, Json::parse(result.out));
  EXPECT_EQ(run.at("schema"), "soms.reproduce/1");
  EXPECT_TRUE(run.at("quick").get<bool>());
  EXPECT_TRUE(run.at("not_run").empty());
  std::set<std::string> listed{"index.html", "run.json"};
  for (const Json& item : run.at("items")) {
    for (const Json& file : item.at("files")) {
      listed.insert(file.at("file").get<std::string>());
    }
  }
  EXPECT_TRUE(listed.contains("tables/table_5_3.csv"));
  EXPECT_TRUE(listed.contains("figures/figure_5_3.svg"));
  EXPECT_EQ(files_below(folder.path()), listed);
}

TEST(Reproduce, ListsWhereItsResultsComeFrom) {
  const TemporaryFolder folder;
  const RunResult result = reproduce(folder.path(), {"--item", "table-3.3"});
  ASSERT_EQ(result.status, 0) << result.err;
  const Json run = run_json(folder.path());
  EXPECT_NE(run.at("command").get<std::string>().find("reproduce --quick -o "), std::string::npos)
      << run.at("command");
  for (const char* const key : {"version", "commit", "date", "ended"}) {
    EXPECT_FALSE(run.at(key).get<std::string>().empty()) << key;
  }
  for (const char* const key : {"seconds", "processor_seconds"}) {
    EXPECT_GT(run.at(key).get<double>(), 0) << key;
  }
  EXPECT_FALSE(run.at("load").at("busy").get<bool>());  // nothing of this run is timed
  EXPECT_EQ(result.err.find("busy"), std::string::npos) << result.err;
  EXPECT_EQ(run.at("latex"), nullptr);
  const Json scene = run.at("models").at("scenes").at(0);
  EXPECT_EQ(scene.at("corner_hash"), "5e44b5637f4cb56c");
  EXPECT_EQ(scene.at("bytes"), fs::file_size(folder.path() / "scenes/u_mixed.3ds"));
  EXPECT_EQ(scene.at("sha256").get<std::string>().size(), 64U);
}

TEST(Reproduce, WritesTablesForLatex) {
  const TemporaryFolder folder;
  ASSERT_EQ(reproduce(folder.path(), {"--item", "3.1,3.2", "--latex"}).status, 0);
  const Json run = run_json(folder.path());
  EXPECT_EQ(run.at("latex"), "latex/all.tex");
  const std::string all = read_text(folder.path() / "latex/all.tex");
  int tables = 0;
  for (const Json& item : run.at("items")) {
    for (const Json& file : item.at("files")) {
      if (file.contains("latex")) {
        const fs::path path = folder.path() / file.at("latex").get<std::string>();
        EXPECT_NE(all.find("\\input{" + path.filename().string() + "}"), std::string::npos);
        EXPECT_NE(read_text(path).find("\\caption{"), std::string::npos);
        ++tables;
      }
    }
  }
  EXPECT_EQ(tables, 2);
}

TEST(Reproduce, TwoRunsAgreeOnAllButTimes) {
  SOMS_SKIP_IN_SLOW_BUILDS();
  const TemporaryFolder one;
  const TemporaryFolder two;
  const std::string items = "3.1,3.2,3.3,3.8,4.2,4.30,5.3,5.9,5.10,5.11";
  ASSERT_EQ(reproduce(one.path(), {"--item", items}).status, 0);
  ASSERT_EQ(reproduce(two.path(), {"--item", items}).status, 0);
  EXPECT_EQ(files_below(one.path()), files_below(two.path()));
  EXPECT_EQ(untimed(one.path()), untimed(two.path()));
}

TEST(Reproduce, SaysWhichModelsAreStandIns) {
  const TemporaryFolder folder;
  const RunResult result = reproduce(folder.path(), {"--item", "table-3.1"});
  ASSERT_EQ(result.status, 0) << result.err;
  const Json run = run_json(folder.path());
  for (const Json& model : run.at("models").at("objects")) {
    EXPECT_TRUE(model.at("stand_in").get<bool>());
    EXPECT_NE(model.at("title").get<std::string>().find("stand-in"), std::string::npos) << model;
  }
}

TEST(Reproduce, NamesAModelThatCannotBeRead) {
  const TemporaryFolder folder;
  const TemporaryFolder models;
  write_text(models.path() / "bun_zipper_res4.ply", "ply\nthis is no model\n");
  const RunResult result =
      reproduce(folder.path(), {"--item", "table-3.1", "--models", models.path().string()});
  EXPECT_EQ(result.status, 0);
  EXPECT_NE(result.err.find("bun_zipper_res4.ply"), std::string::npos) << result.err;
  EXPECT_NE(result.err.find("venus.ply"), std::string::npos) << result.err;
  EXPECT_TRUE(result.err.starts_with("soms reproduce: bunny: ")) << result.err;
  const Json bunny = run_json(folder.path()).at("models").at("objects").at(0);
  EXPECT_EQ(bunny.at("name"), "bunny");
  EXPECT_TRUE(bunny.at("stand_in").get<bool>());
  EXPECT_NE(bunny.at("trouble").get<std::string>().find("bun_zipper_res4.ply"), std::string::npos);
  EXPECT_NE(read_text(folder.path() / "index.html").find("bun_zipper_res4.ply"), std::string::npos);
}

TEST(Reproduce, InterruptLeavesWholeFilesAndSaysWhatIsMissing) {
  const TemporaryFolder streams;
  const TemporaryFolder folder;
  Child child({command().string(), "reproduce", "-o", folder.path().string()}, streams.path());
  // One of the first items, which takes no time; all of them take minutes.
  ASSERT_TRUE(child.wait_until(
      [&] { return fs::exists(folder.path() / "tables" / "claim_more_balanced.csv"); }));
  child.send(SIGINT);
  const RunResult result = child.wait();
  EXPECT_EQ(result.status, 130) << result.err;
  const Json run = run_json(folder.path());
  EXPECT_FALSE(run.at("not_run").empty());
  EXPECT_NE(result.err.find("soms reproduce: ended early"), std::string::npos) << result.err;
  std::set<std::string> listed{"index.html", "run.json"};
  for (const Json& item : run.at("items")) {
    for (const Json& file : item.at("files")) {
      listed.insert(file.at("file").get<std::string>());
    }
  }
  for (const Json& file : run.at("models").at("files")) {
    listed.insert(file.get<std::string>());
  }
  EXPECT_EQ(files_below(folder.path()), listed);  // no part of a file
  const std::string page = read_text(folder.path() / "index.html");
  EXPECT_NE(page.find("</html>"), std::string::npos);
  EXPECT_NE(page.find(run.at("not_run").at(0).get<std::string>()), std::string::npos);
}

TEST(Reproduce, UnknownItemIsAUsageErrorThatListsThem) {
  const TemporaryFolder folder;
  const RunResult result = reproduce(folder.path(), {"--item", "5.99"});
  EXPECT_EQ(result.status, 2);
  EXPECT_NE(result.err.find("--item: unknown item '5.99'"), std::string::npos) << result.err;
  EXPECT_NE(result.err.find("table-5.3"), std::string::npos) << result.err;
  const RunResult near = reproduce(folder.path(), {"--item", "5.4,table5.3"});
  EXPECT_EQ(near.status, 2);
  EXPECT_NE(near.err.find("--item: unknown item 'table5.3'; did you mean table-5.3? "),
            std::string::npos)
      << near.err;
}

TEST(Reproduce, WordsThatNameNothingAreUsageErrorsAndMakeNoFolder) {
  const TemporaryFolder folder;
  const std::filesystem::path out = folder.path() / "out";
  for (const std::string items : {"", ",", " , "}) {
    const RunResult result = reproduce(out, {"--item", items});
    EXPECT_EQ(result.status, 2) << result.err;
    EXPECT_NE(result.err.find("--item: the list is empty"), std::string::npos) << result.err;
  }
  EXPECT_EQ(reproduce(out, {"--item", "nothing"}).status, 2);
  EXPECT_EQ(reproduce(out, {"--item", "table-3.1", "--models", ""}).status, 2);
  EXPECT_FALSE(fs::exists(out));
  EXPECT_EQ(reproduce(out, {"--item", "table-3.1, table-3.2"}).status, 0);
}

TEST(Reproduce, DoesNotWaitForAPipeNamedLikeAModel) {
  const TemporaryFolder folder;
  const TemporaryFolder models;
  for (const char* const name : {"venus.ply", "city.3ds"}) {
    ASSERT_EQ(mkfifo((models.path() / name).c_str(), 0600), 0);
  }
  const RunResult result =
      reproduce(folder.path(), {"--item", "3.1,3.3", "--models", models.path().string()});
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_NE(result.err.find("venus.ply: not a file"), std::string::npos) << result.err;
  EXPECT_NE(result.err.find("city.3ds: not a file"), std::string::npos) << result.err;
}

TEST(Reproduce, ClosedStandardOutputIsAnErrorAndNoFileGetsTheWords) {
  const TemporaryFolder folder;
  const RunResult result =
      shell("$soms reproduce --quick --item table-3.1 -o '" + folder.path().string() + "' >&-");
  EXPECT_EQ(result.status, 5) << result.err;
  EXPECT_EQ(read_text(folder.path() / "index.html").find("written; see"), std::string::npos);
}

TEST(Reproduce, RefusesToReplaceThePageOfItsFolder) {
  const TemporaryFolder folder;
  const fs::path out = folder.path() / "out";
  const RunResult result =
      reproduce(out, {"--item", "table-3.1", "--report", (out / "." / "index.html").string()});
  EXPECT_EQ(result.status, 2) << result.err;
  EXPECT_NE(result.err.find("--output names the same file"), std::string::npos) << result.err;
  EXPECT_FALSE(fs::exists(out));
}

/// A program in the place of Chromium: a line of the shell, with `$pdf` for the file to write and
/// `$page` for the page.
fs::path browser(const TemporaryFolder& folder, const std::string& line) {
  const fs::path path = folder.path() / "browser";
  write_text(path,
             "#!/bin/sh\nfor word; do\n  case $word in --print-to-pdf=*) pdf=${word#*=} ;; esac\n"
             "  page=${word#file://}\ndone\n" +
                 line + "\n");
  fs::permissions(path, fs::perms::owner_all);
  return path;
}

TEST(Reproduce, PrintsThePageForPaperAndLeavesNothingBehind) {
  const TemporaryFolder tools;
  const TemporaryFolder temporary;
  const TemporaryFolder folder;
  const fs::path chromium = browser(tools,
                                    "{ printf '%%PDF-'; cat \"$page\"; } > \"$pdf\"; "
                                    "pwd > \"$HOME/x\"; echo said");
  const fs::path pdf = folder.path() / "out" / "thesis.pdf";
  const RunResult result =
      shell("SOMS_CHROMIUM='" + chromium.string() + "' TMPDIR='" + temporary.path().string() +
            "' $soms reproduce --quick --item table-3.2 -o '" + (folder.path() / "out").string() +
            "' --pdf '" + pdf.string() + "'");
  ASSERT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(result.out.find("said"), std::string::npos);
  EXPECT_NE(read_text(pdf).find("@page"), std::string::npos);
  EXPECT_TRUE(files_in(temporary.path()).empty());
}

TEST(Reproduce, ReportsABrowserThatDoesNotPrint) {
  const std::vector<std::pair<std::string, std::string>> cases{
      {"echo no display; exit 7", "ended with status 7: no display"},
      {"exit 0", "wrote no PDF"},
      {": > \"$pdf\"", "wrote no PDF"},
      {"kill -9 $$", "ended with status 137"}};
  for (const auto& [line, message] : cases) {
    const TemporaryFolder tools;
    const TemporaryFolder folder;
    const fs::path pdf = folder.path() / "thesis.pdf";
    const RunResult result = shell("SOMS_CHROMIUM='" + browser(tools, line).string() +
                                   "' $soms reproduce --quick --item table-3.2 -o '" +
                                   folder.path().string() + "' --pdf '" + pdf.string() + "'");
    EXPECT_EQ(result.status, 3) << line << result.err;
    EXPECT_NE(result.err.find(message), std::string::npos) << result.err;
    EXPECT_NE(result.out.find("1 of 1 item written"), std::string::npos) << result.out;
    EXPECT_FALSE(fs::exists(pdf)) << line;
  }
}

TEST(Reproduce, MissingBrowserIsReportedBeforeTheRun) {
  const TemporaryFolder folder;
  const fs::path out = folder.path() / "out";
  const std::string words = " reproduce --quick --item table-3.2 --pdf '" +
                            (folder.path() / "a.pdf").string() + "' -o '" + out.string() + "'";
  const RunResult none = shell("PATH=/nowhere $soms" + words);
  EXPECT_EQ(none.status, 3) << none.err;
  EXPECT_NE(none.err.find("--pdf needs Chromium or Chrome"), std::string::npos) << none.err;
  const RunResult wrong = shell("SOMS_CHROMIUM=/nowhere/chromium $soms" + words);
  EXPECT_EQ(wrong.status, 3) << wrong.err;
  EXPECT_NE(wrong.err.find("SOMS_CHROMIUM does not name a program"), std::string::npos)
      << wrong.err;
  EXPECT_FALSE(fs::exists(out));
}

TEST(Reproduce, InterruptEndsTheBrowserWithAllThatItStarted) {
  const TemporaryFolder tools;
  const TemporaryFolder streams;
  const TemporaryFolder folder;
  const fs::path started = tools.path() / "started";
  const fs::path chromium =
      browser(tools, "tail -f /dev/null & echo $! > '" + started.string() + ".new'; mv '" +
                         started.string() + ".new' '" + started.string() + "'; wait");
  Child child({"/usr/bin/env", "SOMS_CHROMIUM=" + chromium.string(), command().string(),
               "reproduce", "--quick", "--item", "table-3.2", "-o", folder.path().string(), "--pdf",
               (folder.path() / "thesis.pdf").string()},
              streams.path());
  ASSERT_TRUE(child.wait_until([&] { return fs::exists(started); }));
  child.send(SIGINT);
  const RunResult result = child.wait();
  EXPECT_EQ(result.status, 130) << result.err;
  EXPECT_FALSE(fs::exists(folder.path() / "thesis.pdf"));
  // It may stay as a dead process until somebody collects it.
  const fs::path state = fs::path("/proc") / std::to_string(std::stoi(read_text(started))) / "stat";
  EXPECT_TRUE(!fs::exists(state) || read_text(state).find(") Z ") != std::string::npos);
}

TEST(Reproduce, CountThatDiffersFromTheGoldenTablesIsNamed) {
  SOMS_SKIP_IN_SLOW_BUILDS();
  const TemporaryFolder golden;
  const TemporaryFolder folder;
  for (const char* const name : {"thesis_counts.csv", "thesis_traversal.csv"}) {
    write_text(golden.path() / name, read_text(test::data(std::string("thesis/") + name)));
  }
  const std::vector<std::string> words{"--item", "table-3.2", "--golden", golden.path().string()};
  const RunResult equal = reproduce(folder.path(), words);
  EXPECT_EQ(equal.status, 0) << equal.err;
  EXPECT_NE(equal.out.find("golden tables: 3,744 of 8,961 rows compared, all equal"),
            std::string::npos)
      << equal.out;
  std::string text = read_text(golden.path() / "thesis_counts.csv");
  const std::string row = "u_plain,5672,soms,thesis,inner,stop,13,6537,";
  const std::size_t at = text.find(row);
  ASSERT_NE(at, std::string::npos);
  text[at + row.size() - 2] = '8';
  write_text(golden.path() / "thesis_counts.csv", text);
  const RunResult result = reproduce(folder.path(), words);
  EXPECT_EQ(result.status, 6) << result.err;
  const std::string said = "u_plain 5672 soms thesis inner stop level 13: nodes 6538, here 6537";
  EXPECT_NE(result.err.find(said), std::string::npos) << result.err;
  EXPECT_NE(result.out.find("3,744 of 8,961 rows compared, 1 different"), std::string::npos);
  EXPECT_NE(read_text(folder.path() / "index.html").find(said), std::string::npos);
  const Json compared = run_json(folder.path()).at("golden");
  EXPECT_EQ(compared.at("differences").size(), 1U);
  EXPECT_EQ(compared.at("files").at(0).at("equal"), 3743);
}

TEST(Reproduce, FolderWithoutGoldenTablesIsReportedBeforeTheRun) {
  const TemporaryFolder folder;
  const fs::path out = folder.path() / "out";
  const RunResult result =
      reproduce(out, {"--item", "table-3.2", "--golden", (folder.path() / "none").string()});
  EXPECT_EQ(result.status, 3) << result.err;
  EXPECT_NE(result.err.find("--golden: cannot open"), std::string::npos) << result.err;
  EXPECT_FALSE(fs::exists(out));
}

TEST(Reproduce, FolderThatCannotBeMadeIsReported) {
  const TemporaryFolder folder;
  write_text(folder.path() / "file", "x");
  const RunResult result = reproduce(folder.path() / "file", {"--item", "table-3.1"});
  EXPECT_EQ(result.status, 5) << result.err;
  EXPECT_EQ(read_text(folder.path() / "file"), "x");
}

TEST(Reproduce, FolderOfModelsThatIsMissingIsReported) {
  const TemporaryFolder folder;
  const RunResult result = reproduce(
      folder.path(), {"--item", "table-3.1", "--models", (folder.path() / "none").string()});
  EXPECT_EQ(result.status, 3) << result.err;
  EXPECT_NE(result.err.find("none"), std::string::npos) << result.err;
}

}  // namespace
}  // namespace soms::test
