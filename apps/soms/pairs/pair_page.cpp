#include "apps/soms/pairs/pair_page.h"

#include "soms/base/text.h"

#include "apps/cli/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace soms::command {

namespace {

constexpr std::size_t kMostTracked = 2048;

std::string triangles_in_text(const MeshView& mesh) {
  return counted(mesh.triangles.size(), "triangle");
}

}  // namespace

void PoseTrack::add(const PosesOfPair& poses) {
  const std::uint64_t row = rows_++;
  if (row % pause_ != 0) {
    return;
  }
  kept_[row] = poses;
  if (kept_.size() > kMostTracked) {
    pause_ *= 2;
    std::erase_if(kept_, [&](const auto& row_poses) { return row_poses.first % pause_ != 0; });
  }
}

report::Scene scene_of_pair(const PageModels& models, std::map<std::uint64_t, PosesOfPair> kept,
                            std::uint64_t rows) {
  const Pose first = kept.empty() ? Pose() : kept.begin()->second.second;
  const bool b_moves = std::any_of(
      kept.begin(), kept.end(), [&](const auto& step) { return !(step.second.second == first); });
  report::Scene scene;
  scene.models = {{models.a.shape.mesh(), models.name_a}, {models.b.shape.mesh(), models.name_b}};
  scene.models[0].numbers = models.a.numbers.list();
  scene.models[1].numbers = models.b.numbers.list();
  scene.bodies = {{0, models.name_a, true}, {1, models.name_b, b_moves}};
  scene.steps = {.count = std::max<std::uint64_t>(1, rows), .noun = "pose", .smooth = false};
  for (const auto& [step, poses] : kept) {
    scene.steps.kept.push_back(step);
  }
  scene.y_is_up = models.b.shape.mesh().up == UpAxis::y;
  scene.pose = [kept = std::move(kept)](std::uint32_t body, std::uint64_t step) {
    const auto next = kept.upper_bound(step);
    if (next == kept.begin()) {
      return Pose();
    }
    const PosesOfPair& poses = std::prev(next)->second;
    return body == 0 ? poses.first : poses.second;
  };
  return scene;
}

std::vector<report::Fact> facts_of_models(const PageModels& models, const PairReport& report) {
  std::vector<report::Fact> facts{
      {"A", fmt::format("{}, {}{}", models.name_a, triangles_in_text(models.a.shape.mesh()),
                        report.read_a)},
      {"B", fmt::format("{}, {}{}", models.name_b, triangles_in_text(models.b.shape.mesh()),
                        report.read_b)}};
  if (!report.georeference.empty()) {
    facts.push_back({"georeference", printable(describe(report.georeference))});
  }
  for (const std::string& note : report.notes) {
    facts.push_back({"note", note});
  }
  return facts;
}

report::Fact fact_of_poses(const PairReport& report, const RowTotals& totals,
                           const PoseWords& words) {
  return {"poses", fmt::format("{}{}: {} {}, {} {}{}",
                               report.interrupted ? "interrupted after "
                               : report.timed_out ? "out of time after "
                                                  : "",
                               with_commas(totals.rows), with_commas(totals.found), words.yes,
                               with_commas(totals.rows - totals.found - totals.undecided), words.no,
                               totals.undecided == 0
                                   ? ""
                                   : fmt::format(", {} undecided", with_commas(totals.undecided)))};
}

std::vector<report::Fact> facts_of_work(const PairReport& report, const RowTotals& totals,
                                        const Cost& cost) {
  std::vector<report::Fact> facts{
      {"tests",
       fmt::format("{} of boxes, {} of triangles, {} of them exact", with_commas(cost.node_tests),
                   with_commas(cost.triangle_tests), with_commas(cost.exact_tests))}};
  if (report.verified) {
    facts.push_back({"verified", fmt::format("by brute force: {} of {} equal",
                                             with_commas(totals.rows - totals.wrong),
                                             counted(totals.rows, "answer"))});
  }
  return facts;
}

}  // namespace soms::command
