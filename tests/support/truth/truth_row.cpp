#include "tests/support/truth/truth_row.h"

#include "tests/support/support.h"

namespace soms::test {

std::vector<TruthRow> truth_rows(const std::filesystem::path& file, std::size_t columns) {
  std::vector<TruthRow> table = read_csv(file);
  table.erase(table.begin());
  for (const TruthRow& row : table) {
    if (row.size() != columns) {
      throw std::runtime_error("truth set: a row of another width in " + file.string());
    }
  }
  return table;
}

Pose truth_pose(const TruthRow& row, std::size_t first) {
  Pose pose;
  for (std::size_t i = 0; i < 12; ++i) {
    pose.m[i] = truth_number<double>(row[first + i]);
  }
  return pose;
}

Triangle truth_triangle(const TruthRow& row, std::size_t first) {
  Triangle t;
  for (Vec3* p : {&t.a, &t.b, &t.c}) {
    *p = {truth_number<double>(row[first]), truth_number<double>(row[first + 1]),
          truth_number<double>(row[first + 2])};
    first += 3;
  }
  return t;
}

}  // namespace soms::test
