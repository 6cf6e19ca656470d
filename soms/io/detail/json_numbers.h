/// \file
/// Lists of a fixed length in JSON: numbers and matrices.
#pragma once

#include "soms/io/detail/affine.h"
#include "soms/io/detail/json_document.h"

#include <array>
#include <cstddef>
#include <string>

namespace soms::detail {

/// The numbers of a list. \errors ErrorKind::bad_file: another count, or none.
template <std::size_t N>
[[nodiscard]] std::array<double, N> json_numbers(const JsonValue& list) {
  if (list.size() != N) {
    list.fail(std::to_string(list.size()) + " numbers instead of " + std::to_string(N));
  }
  std::array<double, N> values{};
  for (std::size_t i = 0; i < N; ++i) {
    values[i] = list.at(i).number();
  }
  return values;
}

/// A matrix of 4 x 4, column by column. \errors ErrorKind::bad_file: its last row is not 0 0 0 1.
[[nodiscard]] Affine json_matrix(const JsonValue& list);

}  // namespace soms::detail
