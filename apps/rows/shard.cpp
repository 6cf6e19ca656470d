#include "apps/rows/shard.h"

#include "soms/base/error.h"

#include "apps/cli/parse.h"

#include <fmt/format.h>

#include <algorithm>

namespace soms::command {

namespace {

constexpr std::uint64_t kMostShards = 1'000'000'000;

}  // namespace

RowRange Shard::rows_of(std::uint64_t rows) const {
  const std::uint64_t each = rows / of;
  const std::uint64_t larger = rows % of;  // shares of a row more
  const auto first = [&](std::uint64_t share) { return share * each + std::min(share, larger); };
  return {first(number - 1), first(number)};
}

std::string Shard::text() const {
  return fmt::format("{}/{}", number, of);
}

Shard parse_shard(std::string_view option, std::string_view text) {
  const std::size_t slash = text.find('/');
  if (slash == std::string_view::npos) {
    throw Error(ErrorKind::usage, fmt::format("{} {}: no K/N", option, text),
                "give the number of the shard and how many there are, such as 3/8");
  }
  Shard shard;
  shard.of = parse_count(option, text.substr(slash + 1), 1, kMostShards);
  shard.number = parse_count(option, text.substr(0, slash), 1, shard.of);
  return shard;
}

}  // namespace soms::command
