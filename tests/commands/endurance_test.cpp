// What the command leaves behind when it is killed, when the disk is full, or when its input
// shrinks; and that long runs take no more memory. Longer runs: tests/endurance/endurance.py.
#include "soms/base/error.h"
#include "soms/io/read_mesh.h"

#include "tests/commands/run.h"
#include "tests/support/wait.h"

#include <unistd.h>

#include <atomic>
#include <csignal>
#include <iostream>
#include <set>
#include <thread>

namespace soms::test {
namespace {

namespace fs = std::filesystem;

/// A verb that writes, and the names of what it writes, in a folder where "old" stands in each.
struct Writer {
  std::string words;
  std::vector<std::string> files;
};

/// Words of a verb with `$d` (the folder) and `$m` (models) put in.
std::vector<std::string> words_of(const Writer& writer, const fs::path& folder,
                                  const fs::path& models) {
  std::vector<std::string> words{command().string()};
  std::istringstream in(writer.words);
  for (std::string word; in >> word;) {
    if (word.starts_with("$d")) {
      word = folder.string() + word.substr(2);
    } else if (word.starts_with("$m")) {
      word = models.string() + word.substr(2);
    }
    words.push_back(word);
  }
  return words;
}

void make_models(const fs::path& folder) {
  ASSERT_EQ(
      soms_run({"generate", "knot", "--triangles", "400000", "-o", (folder / "knot.ply").string()})
          .status,
      0);
  ASSERT_EQ(soms_run({"generate", "urban-mixed", "-o", (folder / "town.ply").string()}).status, 0);
  write_text(folder / "bad.csv", "x,y,z\n0,0\n");
}

void put_old_files(const Writer& writer, const fs::path& folder) {
  for (const std::string& file : writer.files) {
    write_text(folder / file, "old");
  }
}

/// True if the folder holds the old files and nothing else.
bool only_old(const Writer& writer, const fs::path& folder) {
  const std::set<std::string> names(writer.files.begin(), writer.files.end());
  const std::vector<std::string> there = files_in(folder);
  return std::set<std::string>(there.begin(), there.end()) == names &&
         std::all_of(names.begin(), names.end(),
                     [&](const std::string& name) { return read_text(folder / name) == "old"; });
}

TEST(Endurance, KilledInTheMiddleOfWritingLeavesTheOldFile) {
  const TemporaryFolder models;
  make_models(models.path());
  const std::vector<Writer> writers{
      {"generate knot --triangles 2000000 -o $d/a.obj", {"a.obj"}},
      {"generate city --triangles 4000000 -o $d/a.ply", {"a.ply"}},
      {"convert $m/knot.ply $d/a.obj", {"a.obj"}},
      {"simulate $m/town.ply --count 30 --frames 100000000 --record $d/r -o $d/e.csv -o $d/m.svg "
       "-o $d/p.html",
       {"r", "e.csv", "m.svg", "p.html"}}};
  for (const Writer& writer : writers) {
    bool killed = false;
    // On a busy machine a child may be done before it is seen writing.
    for (int i = 0; i < 20 && !killed; ++i) {
      const TemporaryFolder streams;
      const TemporaryFolder target;
      put_old_files(writer, target.path());
      Child child(words_of(writer, target.path(), models.path()), streams.path());
      if (child.wait_for_writing(500'000)) {
        child.send(SIGKILL);
        killed = child.wait().status == 128 + SIGKILL;
        EXPECT_TRUE(!killed || only_old(writer, target.path())) << writer.words;
      }
    }
    EXPECT_TRUE(killed) << writer.words;
  }
}

TEST(Endurance, FilesThatAreWholeStayWholeWhenReproduceIsKilled) {
  const TemporaryFolder streams;
  const TemporaryFolder target;
  // One of the first items, which takes no time; all of them take minutes.
  Child child({command().string(), "reproduce", "-o", target.path().string()}, streams.path());
  ASSERT_TRUE(child.wait_until(
      [&] { return fs::exists(target.path() / "tables" / "claim_more_balanced.csv"); }));
  child.send(SIGKILL);
  (void)child.wait();
  std::size_t seen = 0;
  for (const auto& entry : fs::recursive_directory_iterator(target.path())) {
    const std::string extension = entry.path().extension().string();
    const std::string text = entry.is_regular_file() ? read_text(entry.path()) : "\n";
    EXPECT_FALSE(text.empty()) << entry.path();
    EXPECT_TRUE(extension != ".svg" || text.ends_with("</svg>\n")) << entry.path();
    EXPECT_TRUE(extension != ".csv" || text.ends_with("\n")) << entry.path();
    EXPECT_NE(extension, ".part") << entry.path();
    seen += entry.is_regular_file() ? 1U : 0U;
  }
  EXPECT_GT(seen, 0U);
}

TEST(Endurance, EveryVerbKeepsOldFilesWhereFilesMayNotGrow) {
  const TemporaryFolder models;
  make_models(models.path());
  const std::vector<Writer> writers{
      {"generate sphere --triangles 50000 -o $d/a.ply", {"a.ply"}},
      {"convert $m/knot.ply $d/a.stl", {"a.stl"}},
      {"overlap $m/town.ply $m/town.ply --no-pairs -o $d/p.html", {"p.html"}},
      {"simulate $m/town.ply --count 30 --frames 40 --record $d/r", {"r"}},
      {"simulate $m/town.ply --count 30 --frames 4 -o $d/m.svg", {"m.svg"}},
      {"simulate $m/town.ply --count 3 --frames 4 -o $d/p.html", {"p.html"}}};
  for (const Writer& writer : writers) {
    const TemporaryFolder target;
    put_old_files(writer, target.path());
    std::string line = "ulimit -f 8; exec";
    for (const std::string& word : words_of(writer, target.path(), models.path())) {
      line += " '" + word + "'";
    }
    const RunResult result = shell(line);
    EXPECT_EQ(result.status, 5) << line << result.err;
    EXPECT_NE(result.err.find("File too large"), std::string::npos) << result.err;
    EXPECT_NE(result.err.find(target.path().string()), std::string::npos) << result.err;
    EXPECT_TRUE(only_old(writer, target.path())) << line;
  }
}

TEST(Endurance, AFileThatShrinksWhileItIsReadIsWholeOrAnError) {
  const TemporaryFolder folder;
  const fs::path path = folder.path() / "model.ply";
  ASSERT_EQ(soms_run({"generate", "sphere", "--triangles", "20000", "-o", path.string()}).status,
            0);
  const std::string bytes = read_text(path);
  const Mesh whole = read_mesh(path);
  std::atomic<bool> over = false;
  std::thread shrinking([&] {
    for (std::size_t i = 0; !over; ++i) {
      fs::resize_file(path, bytes.size() * (i % 7) / 7);
      wait_for_a_later_date(folder.path());
      write_text(path, bytes);
      wait_for_a_later_date(folder.path());
    }
  });
  int errors = 0;
  int read = 0;
  // One read at least must meet a file cut short, for which the other thread needs its turn.
  while (errors + read < 400 || errors == 0) {
    try {
      const Mesh mesh = read_mesh(path);
      EXPECT_EQ(mesh.vertices.size(), whole.vertices.size());
      EXPECT_EQ(mesh.triangles, whole.triangles);
      ++read;
    } catch (const Error& error) {
      EXPECT_TRUE(error.kind() == ErrorKind::bad_file || error.kind() == ErrorKind::cannot_open)
          << error.what();
      ++errors;
    }
  }
  over = true;
  shrinking.join();
  std::cout << read << " times whole, " << errors << " errors\n";
}

TEST(Endurance, TenTimesTheFramesTakeNoMoreMemory) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "skipped: a sanitizer keeps freed memory";
#endif
  const TemporaryFolder models;
  make_models(models.path());
  const auto most_resident = [&](const char* frames) {
    const TemporaryFolder streams;
    Child child({command().string(), "simulate", (models.path() / "town.ply").string(), "--count",
                 "20", "--threads", "1", "--frames", frames, "-q"},
                streams.path());
    EXPECT_EQ(child.wait().status, 0);
    return child.max_resident();
  };
  const long few = most_resident("1000");
  const long many = most_resident("10000");
  // Times of frames and contacts are kept: 4 and 40 bytes.
  EXPECT_LT(many, few + 1500) << few << " and " << many << " KiB";
}

}  // namespace
}  // namespace soms::test
