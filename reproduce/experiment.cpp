#include "reproduce/experiment.h"

#include "soms/base/error.h"

#include "reproduce/experiments/experiments.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace soms::reproduce {

namespace {

constexpr Needs kNothing{};
constexpr Needs kObjects{.objects = true};
constexpr Needs kObjectsAndScenes{.objects = true, .scenes = true};

constexpr std::array kExperiments{
    Experiment{"table-3.1", "The objects: specification of the PLY models", Chapter::thesis,
               kObjects, 1, table_3_1},
    Experiment{"table-3.2", "The orientation tests: axis and direction", Chapter::thesis, kObjects,
               1, table_3_2},
    Experiment{"figure-3.8", "The object and from where it is approached", Chapter::thesis,
               kObjects, 1, figure_3_8},
    Experiment{"figure-4.35", "Traversal with pruning and without", Chapter::thesis, kObjects, 1,
               figure_4_35},
    Experiment{"figure-5.6", "Orientation test right, generic traversal", Chapter::thesis, kObjects,
               1, figure_5_6},
    Experiment{"figure-5.7", "Orientation test left, generic traversal", Chapter::thesis, kObjects,
               1, figure_5_7},
    Experiment{"figure-5.8", "Orientation test top, generic traversal", Chapter::thesis, kObjects,
               1, figure_5_8},
    Experiment{"figure-5.9", "E-Node explained", Chapter::thesis, kNothing, 1, figure_5_9},
    Experiment{"figure-5.10", "E-Node against Larsson's traversal", Chapter::thesis,
               kObjectsAndScenes, 10, figure_5_10},
    Experiment{"orientation-bottom", "Orientation test bottom, generic traversal", Chapter::beyond,
               kObjects, 1, orientation_bottom},
    Experiment{"orientation-front", "Orientation test front, generic traversal", Chapter::beyond,
               kObjects, 1, orientation_front},
    Experiment{"orientation-back", "Orientation test back, generic traversal", Chapter::beyond,
               kObjects, 1, orientation_back},
    Experiment{"traversals", "Every traversal on every test", Chapter::beyond, kObjectsAndScenes,
               60, traversals},
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
