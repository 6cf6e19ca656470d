#include "soms/scene/detail/id_list.h"

#include "tests/support/support.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace soms {

namespace {

TEST(IdList, GivesAscendingNumbersAndNoneTwice) {
  detail::IdList<int> list("thing");
  EXPECT_EQ(list.add(10), 0U);
  EXPECT_EQ(list.add(11), 1U);
  list.remove(1);
  EXPECT_EQ(list.add(12), 2U);
  EXPECT_EQ(list.ids(), (std::vector<std::uint32_t>{0, 2}));
  EXPECT_EQ(list.at(0), 10);
  EXPECT_EQ(list.at(2), 12);
}

TEST(IdList, NamesAMissingNumberAndSaysWhy) {
  detail::IdList<int> list("thing");
  list.add(1);
  list.remove(0);
  const auto message = [&](std::uint32_t id) -> std::string {
    try {
      static_cast<void>(list.at(id));
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::usage);
      return error.what();
    }
    return "no error";
  };
  EXPECT_NE(message(0).find("no thing 0; it was removed"), std::string::npos) << message(0);
  EXPECT_NE(message(5).find("no thing 5; use a number"), std::string::npos) << message(5);
}

TEST(IdList, KeepsPlacesInProportionToWhatIsThere) {
  detail::IdList<int> list("thing");
  for (int k = 0; k < 10; ++k) {
    list.add(k);
  }
  for (int k = 10; k < 100000; ++k) {
    const std::uint32_t id = list.add(k);
    ASSERT_LE(list.places().size(), 21U);
    list.remove(id - 10);
  }
  EXPECT_EQ(list.ids().size(), 10U);
  EXPECT_EQ(list.at(99999), 99999);
}

TEST(IdList, GivesMemoryBackWhenMostAreRemoved) {
  detail::IdList<int> list("thing");
  for (int k = 0; k < 100000; ++k) {
    list.add(k);
  }
  for (std::uint32_t id = 10; id < 100000; ++id) {
    list.remove(id);
  }
  EXPECT_LE(list.places().capacity(), 100U);
  EXPECT_EQ(list.at(9), 9);
}

TEST(IdList, DestroysARemovedValueAtOnce) {
  detail::IdList<std::shared_ptr<int>> list("thing");
  const auto value = std::make_shared<int>(3);
  list.add(value);
  list.add(nullptr);
  list.add(nullptr);
  EXPECT_EQ(value.use_count(), 2);
  list.remove(0);
  EXPECT_EQ(value.use_count(), 1);
}

}  // namespace

}  // namespace soms
