#include "apps/world/mover_filter.h"

#include "soms/base/error.h"

#include "apps/cli/text.h"
#include "apps/world/world.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <filesystem>
#include <optional>

namespace soms::command {

namespace {

constexpr std::size_t kMostPairs = 1'000'000;

[[noreturn]] void refuse(const NamedPair& pair, const std::string& fault,
                         const std::string& remedy) {
  throw Error(ErrorKind::usage,
              fmt::format("--ignore-pair {},{}: {}", pair.first, pair.second, fault), remedy);
}

/// A number in plain digits.
std::optional<std::size_t> number_in(const std::string& text) {
  std::size_t number = 0;
  const char* const end = text.data() + text.size();
  const auto [at, error] = std::from_chars(text.data(), end, number);
  return at == end && error == std::errc{} ? std::optional(number) : std::nullopt;
}

/// True if the model goes by this name: that of its file, with or without folder and extension.
bool is_named(const Model& model, const std::string& name) {
  return model.name == name || model.origin.source == name ||
         std::filesystem::path(model.origin.source).filename() == name;
}

/// The movers of a model of this name; where none is named so, the mover of this number.
std::vector<MoverId> movers_named(const World& world, const std::string& name,
                                  const NamedPair& pair) {
  std::vector<MoverId> movers;
  for (std::size_t k = 0; k < world.routes.size(); ++k) {
    if (is_named(world.models[world.routes[k].model], name)) {
      movers.push_back(static_cast<MoverId>(k));
    }
  }
  if (!movers.empty()) {
    return movers;
  }
  if (const auto number = number_in(name); number && *number < world.routes.size()) {
    return {static_cast<MoverId>(*number)};
  }
  refuse(pair, fmt::format("there is no mover {}", name),
         world.routes.empty() ? std::string("leave it out")
                              : fmt::format("give numbers from 0 to {}, or names of models",
                                            world.routes.size() - 1));
}

}  // namespace

bool MoverFilter::tests(MoverId a, MoverId b) const {
  return between && !std::binary_search(ignored.begin(), ignored.end(),
                                        std::pair<MoverId, MoverId>(std::minmax(a, b)));
}

NamedPair parse_pair(const std::string& text) {
  const std::size_t comma = text.find(',');
  if (comma == std::string::npos || comma == 0 || comma + 1 == text.size() ||
      text.find(',', comma + 1) != std::string::npos) {
    throw Error(ErrorKind::usage, fmt::format("--ignore-pair {}", text),
                "give two movers, A,B, by their numbers or the names of their models");
  }
  return {text.substr(0, comma), text.substr(comma + 1)};
}

std::vector<std::pair<MoverId, MoverId>> ignored_pairs(const World& world,
                                                       const std::vector<NamedPair>& named) {
  std::vector<std::pair<MoverId, MoverId>> pairs;
  for (const NamedPair& pair : named) {
    const std::vector<MoverId> first = movers_named(world, pair.first, pair);
    const std::vector<MoverId> second = movers_named(world, pair.second, pair);
    if (first.size() * second.size() > kMostPairs - std::min(kMostPairs, pairs.size())) {
      refuse(pair, fmt::format("more than {} pairs of movers", with_commas(kMostPairs)),
             "ignore fewer, or use --no-between-movers");
    }
    const std::size_t before = pairs.size();
    for (const MoverId a : first) {
      for (const MoverId b : second) {
        if (a != b) {
          pairs.emplace_back(std::minmax(a, b));
        }
      }
    }
    if (pairs.size() == before) {
      refuse(pair, "these are the same mover", "give two movers");
    }
  }
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

}  // namespace soms::command
