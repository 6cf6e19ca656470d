#include "thesis/run/provenance.h"

#include "apps/output/sha256.h"
#include "tests/reproduce/well_formed.h"
#include "tests/support/support.h"
#include "thesis/run/build.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <memory>
#include <string>
#include <vector>

namespace soms::reproduce {

using command::sha256;
using command::sha256_of_file;

namespace {

TEST(Sha256, IsThatOfTheStandard) {
  EXPECT_EQ(sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(sha256(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
}

TEST(Sha256, OfAFileIsThatOfItsBytesHoweverManyThereAre) {
  const test::TemporaryFolder folder;
  for (const std::size_t size : {0U, 1U << 20U, (1U << 20U) + 1, 3'000'000U}) {
    std::string bytes(size, 'x');
    if (size > 0) {
      bytes[size / 2] = '\0';
    }
    const auto path = folder.path() / "bytes";
    std::ofstream(path, std::ios::binary) << bytes;
    EXPECT_EQ(sha256_of_file(path), sha256(bytes)) << size;
  }
  EXPECT_EQ(sha256_of_file(folder.path() / "none"), "");
  EXPECT_EQ(sha256_of_file(folder.path()), "");
}

TEST(Build, NamesACommitAndTheFlagsOfTheLibrary) {
  const Build build = this_build();
  const std::string_view digits = build.commit.substr(0, build.commit.find('-'));
  EXPECT_TRUE(build.commit == "unknown" ||
              (digits.size() == 40 &&
               digits.find_first_not_of("0123456789abcdef") == std::string_view::npos))
      << build.commit;
  EXPECT_NE(build.flags.find("-ffp-contract=off"), std::string_view::npos) << build.flags;
  EXPECT_EQ(build.flags.find("-W"), std::string_view::npos) << build.flags;
}

TEST(Machine, IsKnown) {
  const Machine machine = this_machine();
  EXPECT_GT(machine.processors, 0);
  EXPECT_FALSE(machine.usable_processors.empty());
  EXPECT_GT(machine.memory, 1U << 20U);
  EXPECT_FALSE(machine.instruction_set.empty());
}

TEST(CommandLine, IsQuotedForAShell) {
  const std::vector<std::string> words{"soms", "reproduce", "--item=5.3,5.9", "a b", "",
                                       "it's", "$(x)"};
  EXPECT_EQ(shell_line(words), R"(soms reproduce --item=5.3,5.9 'a b' '' 'it'\''s' '$(x)')");
  EXPECT_NE(command_line(), "");
}

TEST(Processors, AreListedAsRanges) {
  EXPECT_EQ(joined_ranges(std::vector<int>{}), "");
  EXPECT_EQ(joined_ranges(std::vector<int>{3}), "3");
  EXPECT_EQ(joined_ranges(std::vector<int>{0, 1, 2, 3, 6, 8, 9}), "0-3,6,8-9");
}

Report known_report() {
  Report report{.machine = {"Processor <x>", "Linux", "g++ 12", "0.1.0", 2},
                .date = "2026-01-01T00:00:00Z"};
  report.machine.commit = std::string(40, 'a') + "-dirty";
  report.machine.flags = "-O3 -march=\"native\"";
  report.machine.memory = 3ULL << 30U;
  report.command = "soms reproduce -o 'a & b'";
  report.ended = "2026-01-01T00:01:40Z";
  report.seconds = 100;
  report.processor_seconds = 60;
  report.load = {
      .start = {{1.5, 1, 1}}, .processors = 2, .timed_seconds = 90, .timed_processor_seconds = 50};
  const auto mesh = std::make_shared<const Mesh>();
  report.models.objects = {{.name = "bunny",
                            .title = "Bunny",
                            .file = "b&.ply",
                            .mesh = mesh,
                            .bytes = 1234,
                            .sha256 = sha256("abc")},
                           {.name = "venus", .title = "Statue", .stand_in = true, .mesh = mesh}};
  return report;
}

TEST(Provenance, IsOnThePage) {
  const std::string html = page(known_report());
  const std::vector<std::string_view> empty_elements{"meta", "link", "br"};
  EXPECT_EQ(test::markup_fault(html, empty_elements), "");
  for (const std::string words :
       {"soms 0.1.0, commit aaaaaaaaaaaa with local changes", "<dd>3.0 GiB</dd>",
        "-march=&quot;native&quot;", "a &amp; b", "1.50, 1.00, 1.00 at the start; unknown",
        "<td>b&amp;.ply</td><td class=\"number\">1,234</td>", "ba7816bf", "aaaa-dirty"}) {
    EXPECT_EQ(test::count_of(html, words), 1U) << words;
  }
}

TEST(Provenance, WarnsOfABusyMachineOnThePageAndInTheListOfFiles) {
  Report report = known_report();
  EXPECT_EQ(test::count_of(page(report), "The machine was busy."), 1U);
  EXPECT_EQ(test::count_of(page(report), "got 50.0 s of processor time (56 %)"), 1U);
  EXPECT_EQ(test::count_of(manifest(report), "\"busy\": true"), 1U);
  report.load.start = {{0.25, 1, 1}};
  report.load.timed_processor_seconds = 90;
  EXPECT_EQ(test::count_of(page(report), "busy"), 0U);
  EXPECT_EQ(test::count_of(manifest(report), "\"busy\": false"), 1U);
}

}  // namespace
}  // namespace soms::reproduce
