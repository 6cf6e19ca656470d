#include "tests/support/truth/truth.h"

#include "tests/support/support.h"
#include "tests/support/truth/truth_row.h"

namespace soms::test {

namespace {

std::vector<TruthRow> rows(std::string_view name, std::size_t columns) {
  return truth_rows(test::data("truth/" + std::string(name)), columns);
}

TruthCase truth_case(const TruthRow& row) {
  TruthCase c;
  c.number = truth_number<int>(row[0]);
  c.mesh_a = row[2];
  c.mesh_b = row[3];
  c.kind = row[4];
  c.pose_a = truth_pose(row, 5);
  c.pose_b = truth_pose(row, 17);
  c.overlap = row[29] == "1";
  c.count = truth_number<std::uint64_t>(row[30]);
  c.hash = truth_number<std::uint64_t>(row[31], 16);
  c.solid = row[32];
  c.listed = row[33] == "1";
  return c;
}

}  // namespace

const std::vector<TruthCase>& truth_cases() {
  static const std::vector<TruthCase> cases = [] {
    std::vector<TruthCase> list;
    for (const TruthRow& row : rows("cases.csv", 34)) {
      list.push_back(truth_case(row));
    }
    return list;
  }();
  return cases;
}

const std::map<int, std::vector<TrianglePair>>& truth_lists() {
  static const std::map<int, std::vector<TrianglePair>> lists = [] {
    std::map<int, std::vector<TrianglePair>> table;
    for (const TruthRow& row : rows("lists.csv", 3)) {
      table[truth_number<int>(row[0])].push_back(
          {truth_number<TriangleId>(row[1]), truth_number<TriangleId>(row[2])});
    }
    return table;
  }();
  return lists;
}

const std::vector<TruthTriangles>& truth_triangles() {
  static const std::vector<TruthTriangles> pairs = [] {
    std::vector<TruthTriangles> list;
    for (const TruthRow& row : rows("tritri.csv", 20)) {
      list.push_back({row[0], truth_triangle(row, 1), truth_triangle(row, 10), row[19] == "1"});
    }
    return list;
  }();
  return pairs;
}

}  // namespace soms::test
