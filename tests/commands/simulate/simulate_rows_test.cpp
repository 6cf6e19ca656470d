#include "apps/soms/simulate/simulate_rows.h"

#include <gtest/gtest.h>

#include <vector>

namespace soms::command {
namespace {

TEST(FairSample, HoldsTheFirstContactOfARowHoweverShort) {
  ContactRows rows;
  rows.rows.resize(2);
  std::vector<Contact> contacts;
  for (std::uint64_t k = 0; k < 40; ++k) {  // later contacts are longer
    contacts.push_back({.mover = static_cast<MoverId>(k % 2), .begin = k, .end = 2 * k});
    rows.row_of.push_back(k % 2);
  }
  EXPECT_EQ(fair_sample(rows, contacts, 6), (std::vector<std::size_t>{0, 1, 36, 37, 38, 39}));
  EXPECT_EQ(fair_sample(rows, contacts, 2), (std::vector<std::size_t>{0, 1}));
  EXPECT_EQ(fair_sample(rows, contacts, 100).size(), 40U);
  EXPECT_EQ(fair_sample(rows, contacts, 1).size(), 1U);
}

}  // namespace
}  // namespace soms::command
