/// \file
/// Tests that are run with each instruction set.
#pragma once

#include "soms/base/error.h"
#include "soms/query/instruction_set.h"

#include <gtest/gtest.h>

namespace soms::test {

/// Skips where SOMS_ISA names what this processor lacks.
class NeedsInstructionSet : public testing::Test {
 protected:
  void SetUp() override {
    try {
      static_cast<void>(instruction_set());
    } catch (const Error& error) {
      ASSERT_EQ(error.kind(), ErrorKind::unsupported) << error.what();
      GTEST_SKIP() << error.what();
    }
  }
};

}  // namespace soms::test
