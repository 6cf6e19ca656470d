// The truth set of rays, through the command.
#include "soms/io/write_mesh.h"

#include "tests/commands/near.h"
#include "tests/support/truth/question_truth.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

namespace soms::test {
namespace {

using Rows = std::vector<RayTruthRow>;

std::map<std::string, Rows> rows_by_mesh() {
  std::map<std::string, Rows> groups;
  for (RayTruthRow& row : read_ray_rows(data("questions/ray.csv"))) {
    groups[row.mesh].push_back(std::move(row));
  }
  return groups;
}

/// The rows as a file of rays.
std::string file_of_rays(const Rows& rows) {
  std::string text = "ox,oy,oz,dx,dy,dz,length\n";
  for (const RayTruthRow& row : rows) {
    const auto& [o, d] = std::pair(row.ray.origin, row.ray.direction);
    text += fmt::format("{},{},{},{},{},{},{}\n", o.x, o.y, o.z, d.x, d.y, d.z, row.ray.length);
  }
  return text;
}

Bracket bracket_of(const Json& hit) {
  return {hit.at("lower"), hit.at("upper")};
}

void expect_first(const Json& answer, const RayTruthRow& row) {
  ASSERT_EQ(answer.at("hit"), row.hits != 0);
  if (row.hits != 0) {
    ASSERT_EQ(bracket_of(answer), row.closest.t);
    ASSERT_EQ(answer.at("triangle"), *row.closest.triangle);
  }
}

void expect_all(const Json& answer, const RayTruthRow& row) {
  ASSERT_EQ(answer.at("hit"), row.hits != 0);
  ASSERT_EQ(answer.at("count"), row.hits);
  const Json& hits = answer.at("hits");
  ASSERT_EQ(hits.empty(), row.hits == 0);
  std::uint64_t ties = 0;
  std::uint64_t count = 0;
  for (const Json& place : hits) {
    count += place.at("triangles").size();
    ties += bracket_of(place) == row.closest.t ? place.at("triangles").size() : 0;
  }
  ASSERT_EQ(count, row.hits);
  if (row.hits != 0) {
    ASSERT_EQ(bracket_of(hits[0]), row.closest.t);
    ASSERT_EQ(hits[0].at("triangles")[0], *row.closest.triangle);
    ASSERT_GE(ties, row.ties) << "another t may have the same bracket";
  }
}

/// Answers of `soms ray` with these words, which must succeed.
std::vector<Json> answers_of(const std::string& model, const std::string& rays,
                             const std::vector<std::string>& mode) {
  std::vector<std::string> words{"ray", model, "--allow-empty", "--rays", "-", "--json"};
  words.insert(words.end(), mode.begin(), mode.end());
  const RunResult result = soms_run(words, rays);
  EXPECT_EQ(result.status, 0) << result.err;
  return json_lines(result.out);
}

TEST(RayTruth, TheCommandAnswersWhatIsKnown) {
  const TemporaryFolder folder;
  const std::filesystem::path model = folder.path() / "model.ply";
  std::size_t answered = 0;
  for (const auto& [name, rows] : rows_by_mesh()) {
    SCOPED_TRACE(name);
    const Mesh* mesh = question_mesh(name);
    if (mesh == nullptr) {
      continue;  // of the models of others, which SOMS_DATA has
    }
    write_mesh(model, *mesh, MeshFormat::ply);
    const std::string rays = file_of_rays(rows);
    const std::vector<Json> first = answers_of(model.string(), rays, {});
    const std::vector<Json> any = answers_of(model.string(), rays, {"--any"});
    const std::vector<Json> all = answers_of(model.string(), rays, {"--all"});
    ASSERT_EQ(first.size(), rows.size());
    ASSERT_EQ(any.size(), rows.size());
    ASSERT_EQ(all.size(), rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i, ++answered) {
      SCOPED_TRACE(fmt::format("{} ray {}", rows[i].kind, i));
      ASSERT_NO_FATAL_FAILURE(expect_first(first[i], rows[i]));
      ASSERT_EQ(any[i].at("hit"), rows[i].hits != 0);
      ASSERT_NO_FATAL_FAILURE(expect_all(all[i], rows[i]));
    }
  }
  EXPECT_GT(answered, 1000U);
}

}  // namespace
}  // namespace soms::test
