/// \file
/// What rows of the query table are made of, whatever they are queries of.
#pragma once

#include "soms/base/hash.h"
#include "soms/base/text.h"

#include "tests/support/truth/query_table.h"

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <sstream>
#include <string>
#include <string_view>

namespace soms::test::detail {

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

inline void add(Fnv1a& hash, Coverage coverage) {
  hash.add(static_cast<std::uint64_t>(coverage));
}

inline void add(Fnv1a& hash, bool flag) {
  hash.add(static_cast<std::uint64_t>(flag));
}

inline void add(Fnv1a& hash, const Vec3& v) {
  hash.add(v.x);
  hash.add(v.y);
  hash.add(v.z);
}

/// One line of JSON. Numbers of a triangle and coordinates are written by the functions below.
using Line = std::ostringstream;

inline void write(Line& line, const TrianglePair& pair) {
  line << '[' << pair.a << ',' << pair.b << ']';
}

inline void write(Line& line, const Vec3& v) {
  line << '[' << shortest(v.x) << ',' << shortest(v.y) << ',' << shortest(v.z) << ']';
}

/// A pair with its points, as `distance` and `within` name them.
template <class Named>
void write_pair(Line& line, const Named& answer) {
  if (answer.triangles) {
    line << ",\"triangles\":";
    write(line, *answer.triangles);
    line << ",\"points\":[";
    write(line, answer.point_a);
    line << ',';
    write(line, answer.point_b);
    line << ']';
  }
}

/// What every line ends with.
inline std::string finished(Line& line, Coverage coverage, const Cost& cost) {
  line << ",\"coverage\":\"" << name(coverage) << "\",\"cost\":{\"node_tests\":" << cost.node_tests
       << ",\"triangle_tests\":" << cost.triangle_tests << ",\"exact_tests\":" << cost.exact_tests
       << "}}";
  return line.str();
}

/// Columns of a batch as answers.
template <class Batch>
BatchAnswer answers_of(const Batch& batch) {
  BatchAnswer result;
  for (std::size_t k = 0; k < batch.size(); ++k) {
    result.answers.emplace_back(batch.at(k));
  }
  result.cost = batch.cost;
  return result;
}

/// The limits, with a deadline that has passed where that is wanted.
inline Limits limits_of(const RowOptions& options, Limits limits = {}) {
  if (options.late) {
    limits.deadline = std::chrono::steady_clock::now() - std::chrono::seconds(1);
  }
  return limits;
}

}  // namespace soms::test::detail
