#include "reproduce/experiment.h"

#include "soms/base/error.h"

#include "reproduce/experiments/experiments.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace soms::reproduce {

namespace {

constexpr Needs kObjects{.objects = true};

constexpr std::array kExperiments{
    Experiment{"table-3.1", "The objects: specification of the PLY models", Chapter::thesis,
               kObjects, 1, table_3_1},
};

bool is_named(const Experiment& experiment, std::string_view word) {
  if (word == "thesis" || word == "beyond") {
    return (experiment.chapter == Chapter::thesis) == (word == "thesis");
  }
  const std::string_view item = experiment.item;
  return item == word || item == fmt::format("table-{}", word) ||
         item == fmt::format("figure-{}", word);
}

Error unknown(std::string_view word) {
  std::string items = "thesis, beyond";
  for (const Experiment& experiment : kExperiments) {
    items += fmt::format(", {}", experiment.item);
  }
  return Error(ErrorKind::usage, fmt::format("'{}' is no item", word), "give one of: " + items);
}

}  // namespace

int Context::repetitions(int whole) const {
  return quick ? std::min(whole, std::max(5, whole / 10)) : whole;
}

std::span<const Experiment> experiments() {
  return kExperiments;
}

std::vector<const Experiment*> experiments_named(std::span<const std::string_view> words) {
  std::vector<bool> wanted(kExperiments.size(), words.empty());
  for (const std::string_view word : words) {
    bool found = word == "thesis" || word == "beyond";
    for (std::size_t i = 0; i < kExperiments.size(); ++i) {
      if (is_named(kExperiments[i], word)) {
        wanted[i] = true;
        found = true;
      }
    }
    if (!found) {
      throw unknown(word);
    }
  }
  std::vector<const Experiment*> result;
  for (std::size_t i = 0; i < kExperiments.size(); ++i) {
    if (wanted[i]) {
      result.push_back(&kExperiments[i]);
    }
  }
  return result;
}

}  // namespace soms::reproduce
