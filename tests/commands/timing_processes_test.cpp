// The processes that time races for a run.
#include "tests/commands/run.h"
#include "tests/support/wait.h"

#include <sys/types.h>

#include <algorithm>
#include <csignal>
#include <cstddef>
#include <exception>
#include <filesystem>
#include <string>
#include <vector>

namespace soms::test {
namespace {

namespace fs = std::filesystem;

/// What a file of /proc holds; empty where its process has ended.
std::string text_or_none(const fs::path& path) {
  try {
    return read_text(path);
  } catch (const std::exception&) {
    return {};
  }
}

/// Processes that this one started to time races.
std::vector<pid_t> timing_processes_of(pid_t parent) {
  std::vector<pid_t> found;
  for (const auto& entry : fs::directory_iterator("/proc")) {
    const std::string name = entry.path().filename().string();
    if (name.find_first_not_of("0123456789") != std::string::npos) {
      continue;
    }
    const std::string stat = text_or_none(entry.path() / "stat");
    const std::size_t close = stat.rfind(')');
    const bool child = close != std::string::npos &&
                       stat.substr(close + 4).starts_with(std::to_string(parent) + " ");
    if (child &&
        text_or_none(entry.path() / "cmdline").find("timing-process") != std::string::npos) {
      found.push_back(std::stoi(name));
    }
  }
  return found;
}

/// True if one of them runs. One may stay as a dead process until somebody collects it.
bool any_runs(const std::vector<pid_t>& processes) {
  return std::any_of(processes.begin(), processes.end(), [](pid_t process) {
    const std::string stat = text_or_none(fs::path("/proc") / std::to_string(process) / "stat");
    return !stat.empty() && stat.find(") Z ") == std::string::npos;
  });
}

/// True if one of them is left, running or dead.
bool any_is_left(const std::vector<pid_t>& processes) {
  return std::any_of(processes.begin(), processes.end(), [](pid_t process) {
    return fs::exists(fs::path("/proc") / std::to_string(process));
  });
}

/// A long run, once it times races.
struct LongRun {
  TemporaryFolder streams = {};
  TemporaryFolder folder = {};
  Child child{
      {command().string(), "reproduce", "--item", "claim-build-city", "-o", folder.path().string()},
      streams.path()};
  std::vector<pid_t> processes = {};

  [[nodiscard]] bool has_begun() {
    return child.wait_until([&] {
      processes = timing_processes_of(child.id());
      return processes.size() == 4;
    });
  }
};

TEST(TimingProcesses, RoundsOfAClaimComeFromFive) {
  const TemporaryFolder folder;
  const RunResult result = soms_run(
      {"reproduce", "--quick", "--item", "claim-build-43-ms", "-o", folder.path().string()});
  ASSERT_EQ(result.status, 0) << result.err;
  const std::vector<std::vector<std::string>> lines =
      read_csv(folder.path() / "tables" / "claim_build_43_ms.csv");
  ASSERT_GT(lines.size(), 1U);
  const auto column = [&](const std::string& name) {
    return static_cast<std::size_t>(std::find(lines[0].begin(), lines[0].end(), name) -
                                    lines[0].begin());
  };
  for (std::size_t k = 1; k < lines.size(); ++k) {
    EXPECT_EQ(lines[k].at(column("processes")), "5");
    EXPECT_EQ(lines[k].at(column("rounds")), "20");
  }
}

TEST(TimingProcesses, InterruptEndsAll) {
  LongRun run;
  ASSERT_TRUE(run.has_begun());
  run.child.send(SIGINT);
  const RunResult result = run.child.wait();
  EXPECT_EQ(result.status, 130) << result.err;
  EXPECT_FALSE(any_is_left(run.processes));
  EXPECT_FALSE(fs::exists(run.folder.path() / "tables"));  // no part of the item's files
}

TEST(TimingProcesses, OneThatEndsIsReported) {
  LongRun run;
  ASSERT_TRUE(run.has_begun());
  ::kill(run.processes.back(), SIGKILL);
  const RunResult result = run.child.wait();
  EXPECT_EQ(result.status, 3) << result.err;
  EXPECT_NE(result.err.find("a process that times races ended with status 137"), std::string::npos)
      << result.err;
  EXPECT_FALSE(any_is_left(run.processes));
}

TEST(TimingProcesses, TheyEndWithTheRunThatStartedThem) {
  LongRun run;
  ASSERT_TRUE(run.has_begun());
  run.child.send(SIGKILL);
  (void)run.child.wait();
  wait_until([&] { return !any_runs(run.processes); });
}

TEST(TimingProcesses, AreNotInTheHelp) {
  const RunResult help = soms_run({"reproduce", "--help"});
  EXPECT_EQ(help.status, 0);
  EXPECT_EQ(help.out.find("timing"), std::string::npos);
}

}  // namespace
}  // namespace soms::test
