#include "apps/cli/suggest.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstddef>

namespace soms::command {

namespace {

/// Restricted Damerau-Levenshtein distance.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before(b.size() + 1);
  std::vector<std::size_t> above(b.size() + 1);
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) {
    above[j] = j;
  }
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replace = above[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      row[j] = std::min({replace, above[j] + 1, row[j - 1] + 1});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
        row[j] = std::min(row[j], before[j - 2] + 1);
      }
    }
    before.swap(above);
    above.swap(row);
  }
  return above[b.size()];
}

/// In small letters, with `-` for `_`: how names of options are written.
std::string as_option_name(std::string_view word) {
  std::string result(word);
  std::transform(result.begin(), result.end(), result.begin(), [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c == '_' ? '-' : c;
  });
  return result;
}

}  // namespace

std::string nearest_words(std::string_view word, const std::vector<std::string>& known) {
  constexpr std::size_t kMostNamed = 3;
  // Very long words are not typing errors, and the distance takes quadratic time.
  if (word.size() > 64) {
    return {};
  }
  const auto same = std::find_if(known.begin(), known.end(), [&](const std::string& candidate) {
    return as_option_name(candidate) == as_option_name(word);
  });
  // Of one or two letters, every other such word is near.
  if (same != known.end() || word.size() <= 2) {
    return same == known.end() ? std::string() : *same;
  }
  std::size_t best = std::clamp<std::size_t>(word.size() / 3, 1, 3) + 1;
  std::vector<std::string> nearest;
  for (const std::string& candidate : known) {
    const std::size_t distance = candidate.starts_with(word) ? 1 : edit_distance(word, candidate);
    if (distance < best) {
      best = distance;
      nearest = {candidate};
    } else if (distance == best && nearest.size() < kMostNamed && !nearest.empty()) {
      nearest.push_back(candidate);
    }
  }
  return fmt::to_string(fmt::join(nearest, " or "));
}

}  // namespace soms::command
