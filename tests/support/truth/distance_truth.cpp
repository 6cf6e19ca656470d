#include "tests/support/truth/distance_truth.h"

#include "tests/support/support.h"
#include "tests/support/truth/truth_row.h"

#include <stdexcept>
#include <string_view>
#include <utility>

namespace soms::test {

namespace {

Bracket bracket(const TruthRow& row, std::size_t first) {
  return {truth_number<double>(row[first]), truth_number<double>(row[first + 1])};
}

TrianglePair pair(const TruthRow& row, std::size_t first, std::size_t second) {
  return {truth_number<TriangleId>(row[first]), truth_number<TriangleId>(row[second])};
}

Vec3 point(const TruthRow& row, std::size_t first) {
  return {truth_number<double>(row[first]), truth_number<double>(row[first + 1]),
          truth_number<double>(row[first + 2])};
}

DistanceCase distance_case(const TruthRow& row) {
  DistanceCase c;
  c.number = truth_number<int>(row[0]);
  c.mesh_a = row[1];
  c.mesh_b = row[2];
  c.kind = row[3];
  c.pose_a = truth_pose(row, 4);
  c.pose_b = truth_pose(row, 16);
  c.d = bracket(row, 28);
  c.ties = truth_number<std::uint64_t>(row[30]);
  c.pair = pair(row, 31, 32);
  c.within_lower = row[33] == "1";
  c.within_upper = row[34] == "1";
  if (!row[35].empty()) {
    c.within_below = row[35] == "1";
  }
  c.pair_if_exchanged = pair(row, 37, 36);
  return c;
}

TriangleFeature feature(const std::string& name) {
  for (const auto& [known, feature] :
       {std::pair("vertex", TriangleFeature::vertex), std::pair("edge", TriangleFeature::edge),
        std::pair("face", TriangleFeature::face)}) {
    if (name == known) {
      return feature;
    }
  }
  throw std::runtime_error("no feature is named " + name);
}

}  // namespace

std::vector<DistanceCase> read_distance_cases(const std::filesystem::path& file) {
  std::vector<DistanceCase> cases;
  for (const TruthRow& row : truth_rows(file, 38)) {
    cases.push_back(distance_case(row));
  }
  return cases;
}

std::vector<TriangleDistanceRow> read_triangle_distances(const std::filesystem::path& file) {
  std::vector<TriangleDistanceRow> pairs;
  for (const TruthRow& row : truth_rows(file, 24)) {
    pairs.push_back({row[0], truth_triangle(row, 1), truth_triangle(row, 10), bracket(row, 21),
                     row[23] == "1"});
  }
  return pairs;
}

std::vector<ClosestPointRow> read_closest_points(const std::filesystem::path& file) {
  std::vector<ClosestPointRow> rows;
  for (const TruthRow& row : truth_rows(file, 14)) {
    rows.push_back({row[0], row[1], point(row, 2), bracket(row, 5),
                    truth_number<TriangleId>(row[7]), truth_number<std::uint64_t>(row[8]),
                    feature(row[9]), truth_number<int>(row[10]) != 0, point(row, 11)});
  }
  return rows;
}

const std::vector<TriangleDistanceRow>& triangle_distances() {
  static const std::vector<TriangleDistanceRow> rows = read_triangle_distances(
      outside_distance("tridist.csv").value_or(data("distance/tridist.csv")));
  return rows;
}

std::optional<std::filesystem::path> outside_distance(std::string_view name) {
  const auto file = outside_data("distance/" + std::string(name));
  return file && std::filesystem::exists(*file) ? file : std::nullopt;
}

}  // namespace soms::test
