// Options by names of an earlier release.
#include "apps/cli/parse.h"
#include "apps/cli/parser.h"
#include "apps/cli/verb_data.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace soms::command {
namespace {

/// A verb whose `--ignore` was split: values with a comma are pairs now, others still patterns.
class OldNames : public testing::Test {
 protected:
  OldNames() {
    add_length(parser_, "--clearance", clearance_, "how near")->old_name("--within");
    add_repeatable(parser_, "-o,--output", outputs_, "what is written", "FILE")
        ->old_name("--csv")
        ->old_name("--binary");
    add_repeatable(parser_, "--ignore", patterns_, "parts left out", "PATTERN");
    add_repeatable(parser_, "--ignore-pair", pairs_, "pairs left out", "A,B")
        ->old_name("--ignore",
                   [](const std::string& value) { return value.find(',') != value.npos; });
    parser_.add_flag("--every", every_, "all of them")->old_name("--all");
    parser_.add_option("FILE", files_, "models");
  }

  Parser parser_{"a verb", "soms verb"};
  double clearance_ = 0;
  bool every_ = false;
  std::vector<std::string> outputs_;
  std::vector<std::string> patterns_;
  std::vector<std::string> pairs_;
  std::vector<std::string> files_;
};

using Words = std::vector<std::string>;

TEST_F(OldNames, SetWhatTheNewNamesSet) {
  const ParsedWords parsed = parser_.parse({"--within", "2", "--csv=a.csv", "--all", "x", "y"});
  EXPECT_EQ(parsed.fault, "");
  EXPECT_EQ(clearance_, 2);
  EXPECT_EQ(outputs_, Words{"a.csv"});
  EXPECT_TRUE(every_);
  EXPECT_EQ(files_, (Words{"x", "y"}));
  EXPECT_EQ(parser_.count("--clearance"), 1U);
  EXPECT_EQ(parsed.remarks,
            (Words{"--within D is now --clearance D; the old form ends with the next release",
                   "--csv FILE is now --output FILE; the old form ends with the next release",
                   "--all is now --every; the old form ends with the next release"}));
  EXPECT_EQ(parser_.parse({"--clearance", "2", "-o", "a.csv"}).remarks, Words{});
}

TEST_F(OldNames, TakeOnlyTheValuesThatFit) {
  const ParsedWords parsed = parser_.parse({"--ignore", "a,b", "--ignore=c", "--ignore=d,e"});
  EXPECT_EQ(pairs_, (Words{"a,b", "d,e"}));
  EXPECT_EQ(patterns_, Words{"c"});
  EXPECT_EQ(parsed.remarks.size(), 2U);
}

TEST_F(OldNames, AreNoNamesWhereTheyAreValues) {
  const ParsedWords parsed = parser_.parse({"-o", "--all", "--", "--within"});
  EXPECT_EQ(outputs_, Words{"--all"});
  EXPECT_EQ(files_, Words{"--within"});
  EXPECT_EQ(parsed.remarks, Words{});
}

TEST_F(OldNames, CountAsTheNewName) {
  EXPECT_THROW((void)parser_.parse({"--within", "1", "--clearance", "2"}), Error);
  EXPECT_THROW((void)parser_.parse({"--within"}), Error);
}

TEST_F(OldNames, AreDataButNotInTheHelp) {
  EXPECT_EQ(parser_.help().find("--within"), std::string::npos);
  const VerbData data = data_of(parser_);
  EXPECT_EQ(data.options.at(0).names, Words{"--clearance"});
  EXPECT_EQ(data.options.at(0).old_names, Words{"--within"});
  EXPECT_EQ(data_from_json(data_as_json(data)), data);
}

}  // namespace
}  // namespace soms::command
