#include "apps/soms/pairs/overlap_report.h"

#include "apps/soms/pairs/overlap_parts.h"

#include <gtest/gtest.h>

namespace soms::command {
namespace {

std::string printed(const OverlapReport& report, const Overlap& answer) {
  return text_of(report, 0, {answer, {}}, {}, {});
}

TEST(OverlapReportText, SaysThatALesserPairMayBeThereWhenTimeIsUp) {
  Mesh mesh;
  mesh.source = "m";
  const PairReport pair{.a = mesh, .b = mesh};
  const OverlapReport first{.pair = pair, .mode = OverlapMode::first};
  Overlap answer{.any = true, .pairs = {{3, 4}}, .coverage = Coverage::first, .cost = {}};
  EXPECT_EQ(printed(first, answer), "overlap: triangle 3 of m and 4 of m\n");
  answer.coverage = Coverage::cut;
  EXPECT_EQ(printed(first, answer),
            "overlap: triangle 3 of m and 4 of m (out of time: there may be an earlier pair)\n");
  const OverlapReport any{.pair = pair, .mode = OverlapMode::any};
  EXPECT_EQ(printed(any, answer), "overlap: triangle 3 of m and 4 of m\n");
}

}  // namespace
}  // namespace soms::command
