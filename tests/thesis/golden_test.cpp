// Every row of thesis_traversal.csv. The rows were written by an independent implementation, which
// found the answers equal to brute force.
#include "soms/thesis/e_node_front.h"
#include "soms/thesis/posed_boxes.h"
#include "soms/thesis/thesis_frames.h"
#include "soms/thesis/traversals.h"
#include "soms/tree/build.h"
#include "soms/tree/rule/rules.h"

#include "tests/support/support.h"
#include "tests/tree/models.h"

#include <array>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace soms {
namespace {

/// Static model, rule, test: what the rows of one drive share.
using Drive = std::array<std::string, 3>;

/// Sums over all frames: the columns from `frames` on.
using Sums = std::array<std::uint64_t, 8>;

/// Rows of each drive by algorithm.
std::map<Drive, std::map<std::string, Sums>> golden_rows() {
  std::map<Drive, std::map<std::string, Sums>> rows;
  for (const auto& line : test::read_csv(test::data("thesis/thesis_traversal.csv"))) {
    if (line.at(0) == "static") {
      continue;
    }
    Sums sums{};
    for (std::size_t i = 0; i < sums.size(); ++i) {
      sums[i] = std::stoull(line.at(5 + i));
    }
    rows[{line[0], line[2], line[3]}][line[4]] = sums;
  }
  return rows;
}

/// Options of an algorithm by its name in the table.
TraversalOptions options_of(const std::string& algorithm) {
  TraversalOptions options;
  if (algorithm == "enode_start") {
    options.traversal = Traversal::e_node_front;
    options.descent = Descent::larger;
  } else if (algorithm.starts_with("enode_")) {
    options.traversal = Traversal::e_node;
    options.descent = descent_named(algorithm.substr(6)).descent;
  } else {
    options.traversal = traversal_named(algorithm).traversal;
  }
  return options;
}

struct Model {
  Mesh mesh;
  Tree tree;
};

Model model(const Mesh& mesh, const std::string& rule, int level) {
  return {mesh, build(mesh, thesis_options(rule_named(rule).rule, level))};
}

Sums run(const Model& still, const Model& moving, const std::vector<Vec3>& offsets,
         const TraversalOptions& options) {
  PosedBoxes a(still.mesh, still.tree);
  PosedBoxes b(moving.mesh, moving.tree);
  EnodeFront front(still.tree, moving.tree, Descent::larger);
  a.move(Pose::identity());
  Sums sums{};
  sums[0] = offsets.size();
  for (const Vec3& offset : offsets) {
    b.move(Pose::translation(offset.x, offset.y, offset.z));
    const TraversalCounts counts = options.traversal == Traversal::e_node_front
                                       ? front.next(a.boxes(), b.boxes())
                                       : traverse(a.view(), b.view(), options);
    sums[1] += overlaps(a.boxes()[0], b.boxes()[0]) ? 1U : 0U;
    sums[2] += counts.leaf_pairs > 0 ? 1U : 0U;
    sums[3] += counts.box_tests;
    sums[4] += counts.entered;
    sums[5] += counts.leaf_pairs;
    sums[6] += counts.triangle_pairs;
    sums[7] += counts.first_tests;
  }
  return sums;
}

void expect_rows(const Drive& drive, const Model& still, const Model& moving,
                 const std::vector<Vec3>& offsets) {
  static const auto golden = golden_rows();
  const auto rows = golden.find(drive);
  ASSERT_NE(rows, golden.end());
  ASSERT_EQ(rows->second.size(), 9U);
  for (const auto& [algorithm, sums] : rows->second) {
    EXPECT_EQ(run(still, moving, offsets, options_of(algorithm)), sums) << algorithm;
  }
}

class OrientationTest : public testing::TestWithParam<const char*> {};

TEST_P(OrientationTest, CountsAreThoseOfTheIndependentImplementation) {
  SOMS_NEEDS_OUTSIDE_DATA("36 rows of thesis_traversal.csv (the bunny's)");
  const Model bunny = model(test::golden_mesh(test::kGoldenModels[0]).value(), GetParam(), 15);
  for (const auto& [from, name] : kApproaches) {
    SCOPED_TRACE(name);
    expect_rows({"bunny", GetParam(), std::string(name)}, bunny, bunny,
                orientation_test(bunny.tree.nodes[0].bounds, from));
  }
}

INSTANTIATE_TEST_SUITE_P(Traversal, OrientationTest,
                         testing::Values("object_median", "object_mean", "spatial_median", "soms"),
                         [](const auto& test) { return std::string(test.param); });

class GoldenCityDrive : public testing::TestWithParam<std::tuple<std::size_t, const char*>> {};

TEST_P(GoldenCityDrive, CountsAreThoseOfTheIndependentImplementation) {
  SOMS_NEEDS_OUTSIDE_DATA("9 rows of thesis_traversal.csv (the mover is the bunny)");
  const auto& [scene, rule] = GetParam();
  const test::GoldenModel& city = test::kGoldenModels[scene];
  const Mesh bunny = test::golden_mesh(test::kGoldenModels[0]).value();
  expect_rows({city.name, rule, "drive"}, model(test::golden_mesh(city).value(), rule, 13),
              model(transformed(bunny, 500, UpAxis::y), rule, 15), city_drive());
}

INSTANTIATE_TEST_SUITE_P(Traversal, GoldenCityDrive,
                         testing::Combine(testing::Values(1, 2, 3),
                                          testing::Values("object_median", "spatial_median",
                                                          "soms")),
                         [](const auto& test) {
                           return std::string(test::kGoldenModels[std::get<0>(test.param)].name) +
                                  "_" + std::get<1>(test.param);
                         });

TEST(GoldenRows, AreAllRequestedFor) {
  std::size_t rows = 0;
  for (const auto& [drive, algorithms] : golden_rows()) {
    rows += algorithms.size();
  }
  EXPECT_EQ(rows, 225U);  // 4 rules x 4 approaches x 9 algorithms + 3 scenes x 3 rules x 9
}

/// Cells of the rows of docs/traversals.md whose first cell names an algorithm.
std::map<std::string, std::vector<std::string>> page_rows() {
  std::map<std::string, std::vector<std::string>> rows;
  std::ifstream page(test::data("../../docs/traversals.md"));
  for (std::string line; std::getline(page, line);) {
    std::vector<std::string> cells;
    std::istringstream in(line);
    for (std::string cell; std::getline(in, cell, '|');) {
      cells.push_back(cell.size() < 2 ? cell : cell.substr(1, cell.size() - 2));
    }
    if (cells.size() == 6 && cells[2].find(" / ") != std::string::npos) {
      rows[cells[1]] = {cells.begin() + 2, cells.end()};
    }
  }
  return rows;
}

TEST(GoldenRows, AreWhatThePageOfTraversalsShows) {
  const std::array<Drive, 4> columns{{{"bunny", "soms", "right"},
                                      {"u_mixed", "soms", "drive"},
                                      {"u_boxes", "soms", "drive"},
                                      {"u_plain", "soms", "drive"}}};
  const auto golden = golden_rows();
  std::map<std::string, std::vector<std::string>> expected;
  for (const Drive& column : columns) {
    for (const auto& [algorithm, sums] : golden.at(column)) {
      std::ostringstream cell;
      cell << sums[3] << " / " << sums[4] << " / " << sums[7];
      expected[algorithm].push_back(cell.str());
    }
  }
  EXPECT_EQ(page_rows(), expected);
}

}  // namespace
}  // namespace soms
