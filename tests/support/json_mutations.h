/// \file
/// JSON that was changed in its structure: members of other types, absent ones, further ones.
#pragma once

#include "soms/base/random.h"

#include <nlohmann/json.hpp>

#include <cstddef>
#include <vector>

namespace soms::test {

/// Every value of a document, the document first.
template <class Json>
std::vector<Json*> values_of(Json& document) {
  std::vector<Json*> values{&document};
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (values[i]->is_structured()) {
      for (Json& child : *values[i]) {
        values.push_back(&child);
      }
    }
  }
  return values;
}

/// A value of any type, of which some are at limits.
template <class Json>
Json any_value(Rng& rng) {
  const std::vector<Json> values{nullptr,
                                 true,
                                 0,
                                 -1,
                                 2.5,
                                 1e300,
                                 18446744073709551615U,
                                 "",
                                 "text",
                                 "complete",
                                 Json::array(),
                                 Json::array({"soms.clash/1"}),
                                 Json::array({1, nullptr, "x"}),
                                 Json::object(),
                                 Json::object({{"key", 7}})};
  return values[rng.below(values.size())];
}

/// Changes one value: another in its place, or one more, or one fewer, in it.
template <class Json>
void mutate(Json& document, Rng& rng) {
  const std::vector<Json*> values = values_of(document);
  Json& value = *values[rng.below(values.size())];
  if (value.is_array() && !value.empty() && rng.below(2) == 0) {
    const std::size_t at = rng.below(value.size());
    if (rng.below(2) == 0) {
      value.erase(at);
    } else {
      value.push_back(Json(value[at]));
    }
  } else if (value.is_object() && !value.empty() && rng.below(2) == 0) {
    auto member = value.begin();
    for (std::size_t skip = rng.below(value.size()); skip > 0; --skip) {
      ++member;
    }
    value.erase(member);
  } else {
    value = any_value<Json>(rng);
  }
}

}  // namespace soms::test
