#include "tests/support/truth/question_truth.h"

#include "soms/io/read_mesh.h"

#include "tests/support/support.h"
#include "tests/support/truth/truth.h"
#include "tests/support/truth/truth_row.h"

#include <array>
#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <stdexcept>
#include <utility>

namespace soms::test {

namespace {

Side side_named(const std::string& name) {
  if (name == "on") {
    return Side::on;
  }
  if (name != "inside" && name != "outside") {
    throw std::runtime_error("truth set: no side is named " + name);
  }
  return name == "inside" ? Side::inside : Side::outside;
}

}  // namespace

std::vector<InsideRow> read_inside_rows(const std::filesystem::path& file) {
  std::vector<InsideRow> rows;
  for (const TruthRow& row : truth_rows(file, 6)) {
    rows.push_back(
        {row[0],
         row[1],
         {truth_number<double>(row[2]), truth_number<double>(row[3]), truth_number<double>(row[4])},
         side_named(row[5])});
  }
  return rows;
}

std::optional<Relation> relation_named(std::string_view name) {
  static constexpr std::array<std::pair<std::string_view, Relation>, 6> kNames{
      {{"clear", Relation::clear},
       {"touching", Relation::touching},
       {"crossing", Relation::crossing},
       {"a_in_b", Relation::a_in_b},
       {"b_in_a", Relation::b_in_a},
       {"same", Relation::same}}};
  for (const auto& [word, relation] : kNames) {
    if (word == name) {
      return relation;
    }
  }
  return std::nullopt;
}

std::vector<SolidRow> read_solid_rows(const std::filesystem::path& file) {
  constexpr std::string_view kTouching = "_touching";  // these surfaces always meet
  std::vector<SolidRow> rows;
  for (const TruthRow& row : truth_rows(file, 30)) {
    SolidRow solid{.mesh_a = row[1], .mesh_b = row[2], .kind = row[3]};
    for (std::size_t i = 0; i < 12; ++i) {
      solid.pose_a.m[i] = truth_number<double>(row[4 + i]);
      solid.pose_b.m[i] = truth_number<double>(row[16 + i]);
    }
    solid.count = truth_number<std::uint64_t>(row[28]);
    std::string_view answer = row[29];
    if (answer.ends_with(kTouching)) {
      answer.remove_suffix(kTouching.size());
    }
    const std::optional<Relation> relation = relation_named(answer);
    if (!relation) {
      throw std::runtime_error("truth set: no relation is named " + row[29]);
    }
    solid.relation = *relation;
    rows.push_back(std::move(solid));
  }
  return rows;
}

std::vector<ClosedRow> read_closed_rows(const std::filesystem::path& file) {
  std::vector<ClosedRow> rows;
  for (const TruthRow& row : truth_rows(file, 7)) {
    rows.push_back({row[0], truth_number<int>(row[1]), truth_number<TriangleId>(row[2]),
                    truth_number<std::uint64_t>(row[3]), truth_number<std::uint64_t>(row[4]),
                    truth_number<std::uint64_t>(row[5]), truth_number<std::uint64_t>(row[6])});
  }
  return rows;
}

std::vector<RayTruthRow> read_ray_rows(const std::filesystem::path& file) {
  std::vector<RayTruthRow> rows;
  for (const TruthRow& row : truth_rows(file, 15)) {
    const auto number = [&](std::size_t i) { return truth_number<double>(row[i]); };
    RayTruthRow truth{
        row[0],
        row[1],
        {{number(2), number(3), number(4)}, {number(5), number(6), number(7)}, number(8)},
        truth_number<std::uint64_t>(row[10]),
        truth_number<std::uint64_t>(row[14]),
        {}};
    if (truth.hits != 0) {
      truth.closest.t = {number(11), number(12)};
      truth.closest.triangle = truth_number<TriangleId>(row[13]);
    }
    rows.push_back(std::move(truth));
  }
  return rows;
}

std::vector<RayListRow> read_ray_lists(const std::filesystem::path& file) {
  std::vector<RayListRow> rows;
  for (const TruthRow& row : truth_rows(file, 5)) {
    rows.push_back({truth_number<std::uint64_t>(row[0]),
                    truth_number<std::uint64_t>(row[1]),
                    {truth_number<double>(row[2]), truth_number<double>(row[3])},
                    truth_number<TriangleId>(row[4])});
  }
  return rows;
}

const Mesh* question_mesh(std::string_view name) {
  static std::map<std::string, std::unique_ptr<const Mesh>, std::less<>> meshes;
  const auto known = meshes.find(name);
  if (known != meshes.end()) {
    return known->second.get();
  }
  const std::filesystem::path file = test::data("questions/meshes/" + std::string(name) + ".ply");
  if (!std::filesystem::exists(file)) {
    return truth_mesh(name);
  }
  auto mesh = std::make_unique<const Mesh>(read_mesh(file));
  return meshes.emplace(name, std::move(mesh)).first->second.get();
}

std::optional<std::filesystem::path> outside_question(std::string_view name) {
  const auto file = outside_data("questions/" + std::string(name));
  return file && std::filesystem::exists(*file) ? file : std::nullopt;
}

}  // namespace soms::test
