/// \file
/// RapidCheck within GoogleTest: the same cases on every run, unless RC_PARAMS says otherwise.
#pragma once

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cstdlib>
#include <sstream>
#include <string>
#include <utility>

namespace soms::test {

/// Checks a property on random arguments; a failure is reported with its least case and the seed.
template <class Testable>
void check_property(const std::string& name, Testable&& property) {
  // RapidCheck reads its settings once, from here; its own default is a new seed for every run.
  static const int seeded = setenv("RC_PARAMS", "seed=20261121 max_success=300", 0);
  ASSERT_EQ(seeded, 0);
  rc::detail::TestMetadata metadata;
  metadata.id = name;
  metadata.description = name;
  const auto result = rc::detail::checkTestable(std::forward<Testable>(property), metadata);
  if (!result.template is<rc::detail::SuccessResult>()) {
    std::ostringstream text;
    rc::detail::printResultMessage(result, text);
    FAIL() << text.str();
  }
}

}  // namespace soms::test
