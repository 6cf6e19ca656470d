#include "thesis/run/result.h"

#include <gtest/gtest.h>

namespace soms::reproduce {
namespace {

TEST(Result, TableBecomesCsvWithUnitsAndQuotes) {
  const Table table{.id = "t",
                    .caption = "c",
                    .columns = {{"rule"}, {"nodes"}, {"time", "ms", ColumnKind::timed}},
                    .rows = {{"a \"b\", c", std::int64_t{1234567}, 0.125},
                             {std::monostate{}, std::int64_t{-1}, 1234567.0}}};
  EXPECT_EQ(to_csv(table),
            "rule,nodes,time [ms]\n\"a \"\"b\"\", c\",1234567,0.125\n,-1,1.23457e+06\n");
}

TEST(Result, CellsAreReadable) {
  EXPECT_EQ(to_text(std::monostate{}), "");
  EXPECT_EQ(to_text(std::string("soms")), "soms");
  EXPECT_EQ(to_text(std::int64_t{999}), "999");
  EXPECT_EQ(to_text(std::int64_t{1000}), "1,000");
  EXPECT_EQ(to_text(std::int64_t{-1234567}), "-1,234,567");
  EXPECT_EQ(to_text(0.0123456), "0.0123");
  EXPECT_EQ(to_text(12345.6), "12,346");
  EXPECT_EQ(to_text(999.4), "999");
  EXPECT_EQ(to_text(999.5), "1,000");
  EXPECT_EQ(to_text(999.99), "1,000");
}

}  // namespace
}  // namespace soms::reproduce
