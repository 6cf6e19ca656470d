/// \file
/// Truth sets of motions, by the names of their columns.
#pragma once

#include "soms/base/pose.h"

#include "tests/support/support.h"

#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace soms::test {

/// A table by the names of its columns.
class MotionTable {
 public:
  explicit MotionTable(const std::filesystem::path& file) : rows_(test::read_csv(file)) {
    for (std::size_t k = 0; k < rows_.at(0).size(); ++k) {
      column_[rows_[0][k]] = k;
    }
  }

  [[nodiscard]] std::size_t size() const { return rows_.size() - 1; }

  [[nodiscard]] const std::string& text(std::size_t row, const std::string& name) const {
    static const std::string nothing;
    const auto& fields = rows_[row + 1];
    const std::size_t at = column_.at(name);
    return at < fields.size() ? fields[at] : nothing;
  }

  [[nodiscard]] double number(std::size_t row, const std::string& name) const {
    return std::strtod(text(row, name).c_str(), nullptr);
  }

  [[nodiscard]] Vec3 vector(std::size_t row, const std::string& name) const {
    return {number(row, name + "x"), number(row, name + "y"), number(row, name + "z")};
  }

  [[nodiscard]] Pose pose(std::size_t row, const std::string& name) const {
    Pose pose;
    for (std::size_t k = 0; k < 12; ++k) {
      pose.m[k] = number(row, name + std::to_string(k));
    }
    return pose;
  }

 private:
  std::vector<std::vector<std::string>> rows_;
  std::map<std::string, std::size_t> column_;
};

}  // namespace soms::test
