/// \file
/// Rows of the truth sets: CSV with a header line, whose numbers are read back exactly.
#pragma once

#include "soms/base/pose.h"
#include "soms/base/vector.h"

#include <charconv>
#include <cstddef>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

namespace soms::test {

using TruthRow = std::vector<std::string>;

/// The rows after the header. \errors std::runtime_error unless each has `columns` fields.
[[nodiscard]] std::vector<TruthRow> truth_rows(const std::filesystem::path& file,
                                               std::size_t columns);

/// A whole field as a number, in base `base` if one is given.
template <class Number, class... Base>
[[nodiscard]] Number truth_number(const std::string& text, Base... base) {
  Number value{};
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value, base...);
  if (error != std::errc() || stop != end) {
    throw std::runtime_error("truth set: \"" + text + "\" is not a number");
  }
  return value;
}

/// Twelve fields from `first` on as a pose, nine as a triangle.
[[nodiscard]] Pose truth_pose(const TruthRow& row, std::size_t first);
[[nodiscard]] Triangle truth_triangle(const TruthRow& row, std::size_t first);

}  // namespace soms::test
