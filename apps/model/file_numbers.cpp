#include "apps/model/file_numbers.h"

#include <algorithm>

namespace soms::command {

std::optional<TriangleId> FileNumbers::in_shape(TriangleId number) const {
  if (!numbers_) {
    return number;
  }
  const auto at = std::lower_bound(numbers_->begin(), numbers_->end(), number);
  return at != numbers_->end() && *at == number
             ? std::optional(static_cast<TriangleId>(at - numbers_->begin()))
             : std::nullopt;
}

TrianglePair in_files(const FileNumbers& a, const FileNumbers& b, const TrianglePair& pair) {
  return {a(pair.a), b(pair.b)};
}

Overlap in_files(const FileNumbers& a, const FileNumbers& b, Overlap answer) {
  for (TrianglePair& pair : answer.pairs) {
    pair = in_files(a, b, pair);
  }
  return answer;
}

}  // namespace soms::command
