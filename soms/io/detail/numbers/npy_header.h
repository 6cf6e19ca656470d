/// \file
/// The header of a NumPy array file.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace soms::detail {

/// What every such file begins with.
inline constexpr std::string_view kNpyMagic = "\x93NUMPY";

/// An array of little-endian floats in C order.
struct NpyHeader {
  std::size_t width = 8;             ///< bytes of a number: 4 or 8
  std::vector<std::uint64_t> shape;  ///< of any length

  [[nodiscard]] bool operator==(const NpyHeader&) const = default;
};

/// The header whose text, a dictionary in the notation of Python, is given. `name` is the file's,
/// for messages.
/// \errors ErrorKind::bad_file for what is no such header, and for arrays of other kinds: other
///         types, big-endian, or in Fortran order.
/// \source NumPy Enhancement Proposal 1, A simple file format for NumPy arrays.
[[nodiscard]] NpyHeader parse_npy_header(std::string_view text, const std::string& name);

/// A shape as Python writes it: "(2, 3)".
[[nodiscard]] std::string npy_shape(const std::vector<std::uint64_t>& shape);

}  // namespace soms::detail
