#include "tests/commands/run.h"

namespace soms::test {
namespace {

TEST(Version, TellsVersionInstructionSetAndFormats) {
  const RunResult text = soms_run({"version"});
  EXPECT_EQ(text.status, 0) << text.err;
  EXPECT_TRUE(text.out.starts_with(soms_run({"--version"}).out)) << text.out;
  const Json said = json_lines(soms_run({"version", "--json"}).out).at(0);
  EXPECT_EQ(said.at("schema"), "soms.version/1");
  EXPECT_EQ(said.at("version"), SOMS_VERSION);
  EXPECT_EQ(said.at("reads").at(0), ".ply");
  EXPECT_EQ(said.at("writes").size(), 6U);
  EXPECT_NE(text.out.find(" .zgl\n"), std::string::npos);
}

TEST(Version, TellsWhetherTheInstructionSetThatIsRequestedForIsThere) {
  const Json plain = json_lines(shell("SOMS_ISA=scalar $soms version --json").out).at(0);
  EXPECT_EQ(plain.at("instruction_set"), "scalar");
  EXPECT_EQ(plain.at("instruction_sets").at(0), "scalar");
  const RunResult unknown = shell("SOMS_ISA=foo $soms version");
  EXPECT_EQ(unknown.status, 0) << unknown.err;
  EXPECT_NE(
      unknown.out.find("instruction set none, queries fail: SOMS_ISA: foo is not an instruction "
                       "set; use one of scalar"),
      std::string::npos)
      << unknown.out;
  // What asks no question needs no instruction set; what asks one fails.
  const std::string mesh = test::data("truth/meshes/box2.ply").string();
  EXPECT_EQ(shell("SOMS_ISA=foo $soms info '" + mesh + "'").status, 0);
  const RunResult query = shell("SOMS_ISA=foo $soms overlap '" + mesh + "' '" + mesh + "'");
  EXPECT_EQ(query.status, 2);
  EXPECT_NE(query.err.find("SOMS_ISA: foo is not an instruction set"), std::string::npos)
      << query.err;
}

}  // namespace
}  // namespace soms::test
