// What soms-import may still do once its model is open: a hostile child tries, and fails.
#include "soms/io/detail/import/import.h"
#include "soms/io/read_mesh.h"

#include "tests/io/files.h"
#include "tests/support/support.h"

#include <gtest/gtest.h>
#include <sys/syscall.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace soms::test {
namespace {

/// Status of run_program for a process that the filter killed.
constexpr int kKilledByFilter = 128 + SIGSYS;
constexpr int kNoSuchCall = 128 + SIGSEGV;
/// Statuses of import_attempt.
constexpr int kWorked = 0;
constexpr int kNotPermitted = 1;

/// Runs import_attempt in a fresh folder with a file `victim`.
RunResult attempt(const std::string& words) {
  const TemporaryFolder folder;
  write_content(folder.path() / "victim", "still here");
  return run_program(
      {"/bin/sh", "-c",
       "cd '" + folder.path().string() + "' && exec '" SOMS_IMPORT_ATTEMPT "' " + words});
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream input(text);
  for (std::string line; std::getline(input, line);) {
    lines.push_back(line);
  }
  return lines;
}

TEST(ImportSandbox, RefusesWhatAHostileFileWouldTry) {
  const std::vector<std::string> names = lines_of(attempt("names").out);
  ASSERT_GT(names.size(), 40U);
  for (const std::string& name : names) {
    const bool foreign = name.starts_with("foreign-");
    if (!foreign && !name.starts_with("privileged-")) {
      const RunResult bare = attempt(name + " bare");
      EXPECT_EQ(bare.status, kWorked) << name << " without the sandbox: " << bare.out;
    }
    const RunResult guarded = attempt(name);
    // A kernel without calls of 32 bits ends the program before any filter.
    const bool unknown = foreign && attempt(name + " bare").status == kNoSuchCall;
    EXPECT_EQ(guarded.status, unknown   ? kNoSuchCall
                              : foreign ? kKilledByFilter
                                        : kNotPermitted)
        << name << ": " << guarded.out;
  }
}

TEST(ImportSandbox, LeavesNoSystemCallButThoseItNames) {
  std::set<std::string> left;
  for (std::string& call : lines_of(attempt("calls").out)) {
    left.insert(std::move(call));
  }
  // mmap, mprotect, write, writev and tgkill are allowed for some arguments only, not for these.
  std::set<std::string> allowed;
  for (const long call : {
           SYS_brk,
           SYS_madvise,
           SYS_mremap,
           SYS_munmap,
           SYS_clock_gettime,
           SYS_futex,
           SYS_getpid,
           SYS_getrandom,
           SYS_gettid,
           SYS_gettimeofday,
           SYS_sched_getaffinity,
           SYS_sched_yield,
           SYS_sysinfo,
           SYS_exit,
           SYS_exit_group,
           SYS_restart_syscall,
           SYS_rt_sigaction,
           SYS_rt_sigprocmask,
           SYS_rt_sigreturn,
#ifdef SYS_time
           SYS_time,
#endif
       }) {
    allowed.insert(std::to_string(call));
  }
  EXPECT_EQ(left, allowed);
}

/// A chain of this many triangles in AC3D, whose answer fills every pipe.
std::string many_triangles(int count) {
  std::string vertices;
  std::string surfaces;
  for (int i = 0; i < count + 2; ++i) {
    vertices += std::to_string(i) + " " + std::to_string(i % 2) + " 0\n";
  }
  for (int i = 0; i < count; ++i) {
    surfaces += "SURF 0x0\nmat 0\nrefs 3\n";
    for (int corner = i; corner < i + 3; ++corner) {
      surfaces += std::to_string(corner) + " 0 0\n";
    }
  }
  return "AC3Db\nMATERIAL \"\" rgb 1 1 1  amb 0 0 0  emis 0 0 0  spec 0 0 0  shi 0  trans 0\n"
         "OBJECT poly\nnumvert " +
         std::to_string(count + 2) + "\n" + vertices + "numsurf " + std::to_string(count) + "\n" +
         surfaces + "kids 0\n";
}

// The answer's first line is there, its rest waits for a reader: the program is amid its work.
TEST(ImportSandbox, GuardsSomsImportWhileItReads) {
  const TemporaryFolder folder;
  write_content(folder.path() / "model.ac", many_triangles(20'000));
  const RunResult run =
      run_program({"/bin/sh", "-c", "cd '" + folder.path().string() + R"sh(' && mkfifo answer
')sh" SOMS_IMPORT_PROGRAM R"sh(' .ac < model.ac > answer & child=$!
{ read -r magic; echo "$magic"; grep -E '^(Seccomp|NoNewPrivs):' /proc/$child/status
  [ -e /proc/$child/fd/0 ] || echo the model is closed; cat > rest; } < answer
wait $child)sh"});
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(run.out, "soms-import 1\nNoNewPrivs:\t1\nSeccomp:\t2\nthe model is closed\n");
  EXPECT_GT(std::filesystem::file_size(folder.path() / "rest"), std::size_t{1} << 17);
}

/// Reads a model by soms-import while the object lives: as it is, or where the kernel knows no
/// filter.
class Reader {
 public:
  explicit Reader(bool filtered) {
    const std::string before = filtered ? "" : "'" SOMS_IMPORT_ATTEMPT "' without-seccomp ";
    const std::filesystem::path script = folder_.path() / "reader";
    write_content(script, "#!/bin/sh\nexec " + before + "'" SOMS_IMPORT_PROGRAM "' \"$@\"\n");
    std::filesystem::permissions(script, std::filesystem::perms::owner_all);
    setenv("SOMS_IMPORT", script.c_str(), 1);
  }

  ~Reader() { unsetenv("SOMS_IMPORT"); }

  Reader(const Reader&) = delete;
  Reader& operator=(const Reader&) = delete;

 private:
  TemporaryFolder folder_;
};

TEST(ImportSandbox, SaysWhereTheKernelRefusesIt) {
  const std::string model = many_triangles(2);
  const auto notes = [&](bool filtered) {
    const Reader reader(filtered);
    return read_text(model, "a.ac").notes;
  };
  const std::vector<std::string> guarded = notes(true);
  std::vector<std::string> unguarded = notes(false);
  ASSERT_EQ(unguarded.size(), guarded.size() + 1);
  EXPECT_EQ(unguarded.back(),
            "soms-import ran without its sandbox (the kernel does not allow it: Invalid argument): "
            "a malicious file could have run code with your permissions; read untrusted files in a "
            "container");
  unguarded.pop_back();
  EXPECT_EQ(unguarded, guarded);
}

/// The smallest model of each file extension that Assimp's own tests have.
std::vector<std::filesystem::path> models_of_assimp() {
  std::map<std::string, std::filesystem::path> smallest;
  std::error_code missing;
  for (const auto& entry :
       std::filesystem::recursive_directory_iterator("/usr/share/assimp/models", missing)) {
    std::string extension = entry.path().extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
    if (!entry.is_regular_file() || !detail::is_imported(extension)) {
      continue;
    }
    std::filesystem::path& known = smallest[extension];
    const auto rank = [](const std::filesystem::path& path) {
      return std::pair(std::filesystem::file_size(path), path);
    };
    if (known.empty() || rank(entry.path()) < rank(known)) {
      known = entry.path();
    }
  }
  std::vector<std::filesystem::path> models;
  models.reserve(smallest.size());
  for (const auto& [extension, path] : smallest) {
    models.push_back(path);
  }
  return models;
}

TEST(ImportSandbox, ReadsEveryFormatAsWithoutIt) {
  const std::vector<std::filesystem::path> models = models_of_assimp();
  if (models.empty()) {
    GTEST_SKIP() << "assimp-testmodels is not installed: skipped a model of each of 35 formats";
  }
  int read = 0;
  for (const std::filesystem::path& model : models) {
    const auto result = [&](bool filtered) {
      const Reader reader(filtered);
      Mesh mesh;
      const auto refusal = refusal_of([&] { mesh = read_mesh(model, {.allow_empty = true}); });
      return std::pair(std::move(mesh), refusal ? refusal->words : std::string());
    };
    const auto [guarded, fault] = result(true);
    const auto [unguarded, other_fault] = result(false);
    EXPECT_EQ(fault, other_fault) << model;
    EXPECT_EQ(guarded.vertices, unguarded.vertices) << model;
    EXPECT_EQ(guarded.triangles, unguarded.triangles) << model;
    EXPECT_EQ(guarded.parts, unguarded.parts) << model;
    read += fault.empty() ? 1 : 0;
  }
  // Some are refused, with and without: of these formats the smallest model is a broken one.
  EXPECT_GT(read, 20) << "of " << models.size();
}

}  // namespace
}  // namespace soms::test
