#include "soms/base/error.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace soms {
namespace {

TEST(Error, TellsPlaceAndRemedy) {
  const Error error(ErrorKind::bad_file, "model.ply, line 17", "repair or drop the face");
  EXPECT_STREQ(error.what(), "model.ply, line 17; repair or drop the face");
  EXPECT_EQ(error.place(), "model.ply, line 17");
  EXPECT_EQ(error.remedy(), "repair or drop the face");
  EXPECT_STREQ(Error(ErrorKind::cancelled, "stopped", "").what(), "stopped");
}

TEST(Error, KindsHaveNamesOfTheirOwnAndStatesOfTheCommand) {
  std::set<std::string> names;
  constexpr int kKinds = static_cast<int>(ErrorKind::cancelled) + 1;
  for (int i = 0; i < kKinds; ++i) {
    names.insert(std::string(name(static_cast<ErrorKind>(i))));
  }
  EXPECT_EQ(names.size(), 13U);
  EXPECT_EQ(names.count("unknown"), 0U);
  EXPECT_EQ(exit_code(ErrorKind::usage), 2);
  EXPECT_EQ(exit_code(ErrorKind::not_rigid), 3);
  EXPECT_EQ(exit_code(ErrorKind::not_closed), 3);
  EXPECT_EQ(exit_code(ErrorKind::bad_file), 3);
  EXPECT_EQ(exit_code(ErrorKind::timed_out), 4);
  EXPECT_EQ(exit_code(ErrorKind::out_of_memory), 4);
  EXPECT_EQ(exit_code(ErrorKind::cannot_write), 5);
  EXPECT_EQ(exit_code(ErrorKind::cancelled), 130);
}

}  // namespace
}  // namespace soms
