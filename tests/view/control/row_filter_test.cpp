#include "apps/view/control/row_filter.h"

#include <gtest/gtest.h>

namespace soms::view {
namespace {

TEST(RowFilter, LooksAtEachRowOnceUntilOtherWordsAreWanted) {
  EventList list{{{"car touches house"}, {"person touches tree"}}, 0, 0, 10};
  RowFilter filter;
  EXPECT_EQ(filter.update(list, ""), 2U);
  EXPECT_EQ(filter.rows(), (std::vector<std::size_t>{0, 1}));
  EXPECT_EQ(filter.update(list, ""), 0U);
  list.rows.push_back({"car touches tree"});
  EXPECT_EQ(filter.update(list, ""), 1U);
  EXPECT_EQ(filter.update(list, "tree"), 3U);
  EXPECT_EQ(filter.rows(), (std::vector<std::size_t>{1, 2}));
  EXPECT_EQ(filter.update(list, "tree CAR"), 3U);
  EXPECT_EQ(filter.rows(), (std::vector<std::size_t>{2}));
}

TEST(RowFilter, StartsOverWithTheSearch) {
  EventList list{{{"car touches house"}}, 0, 0, 10};
  RowFilter filter;
  filter.update(list, "house");
  list.rows = {{"person touches tree"}, {"van touches house"}};
  ++list.edition;
  EXPECT_EQ(filter.update(list, "house"), 2U);
  EXPECT_EQ(filter.rows(), (std::vector<std::size_t>{1}));
}

}  // namespace
}  // namespace soms::view
