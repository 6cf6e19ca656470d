#include "tests/support/truth.h"

#include "tests/support/support.h"

#include <charconv>
#include <stdexcept>

namespace soms::test {

namespace {

using Row = std::vector<std::string>;

template <class Number, class... Base>
Number number(const std::string& text, Base... base) {
  Number value{};
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value, base...);
  if (error != std::errc() || stop != end) {
    throw std::runtime_error("truth set: \"" + text + "\" is not a number");
  }
  return value;
}

std::vector<Row> rows(std::string_view name, std::size_t columns) {
  std::vector<Row> table = read_csv(test::data("truth/" + std::string(name)));
  table.erase(table.begin());
  for (const Row& row : table) {
    if (row.size() != columns) {
      throw std::runtime_error("truth set: a row of another width in " + std::string(name));
    }
  }
  return table;
}

Pose pose(const Row& row, std::size_t first) {
  Pose pose;
  for (std::size_t i = 0; i < 12; ++i) {
    pose.m[i] = number<double>(row[first + i]);
  }
  return pose;
}

Triangle triangle(const Row& row, std::size_t first) {
  Triangle t;
  for (Vec3* p : {&t.a, &t.b, &t.c}) {
    *p = {number<double>(row[first]), number<double>(row[first + 1]),
          number<double>(row[first + 2])};
    first += 3;
  }
  return t;
}

TruthCase truth_case(const Row& row) {
  TruthCase c;
  c.number = number<int>(row[0]);
  c.mesh_a = row[2];
  c.mesh_b = row[3];
  c.kind = row[4];
  c.pose_a = pose(row, 5);
  c.pose_b = pose(row, 17);
  c.overlap = row[29] == "1";
  c.count = number<std::uint64_t>(row[30]);
  c.hash = number<std::uint64_t>(row[31], 16);
  c.solid = row[32];
  c.listed = row[33] == "1";
  return c;
}

}  // namespace

const std::vector<TruthCase>& truth_cases() {
  static const std::vector<TruthCase> cases = [] {
    std::vector<TruthCase> list;
    for (const Row& row : rows("cases.csv", 34)) {
      list.push_back(truth_case(row));
    }
    return list;
  }();
  return cases;
}

const std::map<int, std::vector<TrianglePair>>& truth_lists() {
  static const std::map<int, std::vector<TrianglePair>> lists = [] {
    std::map<int, std::vector<TrianglePair>> table;
    for (const Row& row : rows("lists.csv", 3)) {
      table[number<int>(row[0])].emplace_back(number<TriangleId>(row[1]),
                                              number<TriangleId>(row[2]));
    }
    return table;
  }();
  return lists;
}

const std::vector<TruthTriangles>& truth_triangles() {
  static const std::vector<TruthTriangles> pairs = [] {
    std::vector<TruthTriangles> list;
    for (const Row& row : rows("tritri.csv", 20)) {
      list.push_back({row[0], triangle(row, 1), triangle(row, 10), row[19] == "1"});
    }
    return list;
  }();
  return pairs;
}

}  // namespace soms::test
