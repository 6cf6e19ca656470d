#include "apps/soms/pairs/overlap_page.h"

#include "apps/cli/text.h"
#include "apps/draw/chart.h"
#include "apps/model/models.h"
#include "apps/report/scene_words.h"
#include "apps/soms/answers/page_plots.h"
#include "apps/world/part_names.h"

#include <fmt/format.h>

#include <algorithm>
#include <unordered_map>
#include <utility>

namespace soms::command {

namespace {

constexpr std::size_t kMostCounts = 1024;

/// Which parts take part in most pairs of triangles: those of A, or of B.
std::vector<report::Plot> bars_of_parts(const MeshView& mesh,
                                        const std::vector<OverlapRows::Row>& rows,
                                        std::uint32_t OverlapRows::Row::*part,
                                        const std::string& name, std::size_t color) {
  std::map<std::uint32_t, double> by_part;  // not by name: several parts may have the same
  for (const OverlapRows::Row& row : rows) {
    if (!mesh.parts.empty()) {
      by_part[row.*part] += static_cast<double>(row.count);
    }
  }
  std::vector<std::pair<std::string, double>> bars;
  bars.reserve(by_part.size());
  for (const auto& [number, count] : by_part) {
    bars.emplace_back(part_label(mesh, number), count);
  }
  return bars_of(std::move(bars), "Parts of " + name, "pairs",
                 "Overlapping pairs of triangles by the part of " + name +
                     " that they lie in, summed over all poses; the parts with the most pairs.",
                 color);
}

/// Numbers the parts of one mesh as a page does: each once.
class PagedParts {
 public:
  PagedParts(const MeshView& mesh, std::vector<report::ScenePart>& parts)
      : mesh_(mesh), parts_(parts) {}

  std::uint32_t number(std::uint32_t part) {
    if (part == Part::kNoParent) {
      return report::kNoPart;
    }
    const auto [at, added] = numbers_.try_emplace(part, static_cast<std::uint32_t>(parts_.size()));
    if (added) {
      parts_.push_back(
          {part_label(mesh_, part), part_path_label(mesh_, part, report::kLongestText)});
    }
    return at->second;
  }

 private:
  MeshView mesh_;
  std::vector<report::ScenePart>& parts_;
  std::unordered_map<std::uint32_t, std::uint32_t> numbers_;
};

}  // namespace

OverlapPage::OverlapPage(PageModels models)
    : models_(std::move(models)),
      rows_(models_.a.shape.mesh(), models_.b.shape.mesh(), report::SceneLimits().contacts) {
}

std::vector<PartPair> OverlapPage::parts(const Pose& a, const Pose& b, const Overlap& answer,
                                         const Limits& limits) const {
  return rows_.parts({a, b}, answer.pairs, limits);
}

void OverlapPage::add(const Pose& a, const Pose& b, const Overlap& answer,
                      std::span<const PartPair> parts) {
  const std::uint64_t pose = track_.rows();
  track_.add({a, b});
  count_pairs(pose, answer);
  rows_.add(pose, {a, b}, answer.pairs, parts);
}

void OverlapPage::count_pairs(std::uint64_t pose, const Overlap& answer) {
  pairs_ += answer.pairs.size();
  complete_ = complete_ && answer.coverage == Coverage::complete;
  cost_ += answer.cost;
  if (pose % poses_of_count_ == 0) {
    counts_.push_back(0);
  }
  counts_.back() = std::max<std::uint64_t>(counts_.back(), answer.pairs.size());
  if (counts_.size() > kMostCounts) {
    // An odd number: the last one stands alone and goes on being filled.
    for (std::size_t k = 0; k < counts_.size(); ++k) {
      counts_[k / 2] = k % 2 == 0 ? counts_[k] : std::max(counts_[k / 2], counts_[k]);
    }
    counts_.resize((counts_.size() + 1) / 2);
    poses_of_count_ *= 2;
  }
}

void OverlapPage::add_rows(report::Scene& scene) const {
  PagedParts of_a(models_.a.shape.mesh(), scene.parts);
  PagedParts of_b(models_.b.shape.mesh(), scene.parts);
  for (const OverlapRows::Row& row : rows_.rows()) {
    const std::size_t number = scene.rows.size();
    scene.rows.push_back({.a = 0,
                          .b = 1,
                          .part_a = of_a.number(row.part_a),
                          .part_b = of_b.number(row.part_b),
                          .count = row.count,
                          .steps = row.poses,
                          .begin = row.begin,
                          .end = row.end,
                          .first = row.first,
                          .box = row.box});
    for (const OverlapRows::Sample& sample : row.samples) {
      scene.contacts.push_back({.row = number,
                                .a = 0,
                                .b = 1,
                                .part_a = scene.rows.back().part_a,
                                .part_b = scene.rows.back().part_b,
                                .begin = sample.pose,
                                .end = sample.pose,
                                .pairs = {sample.pair},
                                .pairs_in_all = 1});
    }
  }
  std::sort(scene.contacts.begin(), scene.contacts.end(), [](const auto& x, const auto& y) {
    return x.begin != y.begin ? x.begin < y.begin : x.pairs < y.pairs;
  });
}

bool OverlapPage::is_complete(const OverlapReport& report) const {
  return complete_ && !report.pair.interrupted && !report.pair.timed_out;
}

report::Scene OverlapPage::scene(const OverlapReport& report) const {
  std::map<std::uint64_t, PosesOfPair> kept = track_.kept();
  kept.insert(rows_.placed().begin(), rows_.placed().end());
  report::Scene scene = scene_of_pair(models_, std::move(kept), track_.rows());
  scene.complete = is_complete(report);
  add_rows(scene);
  scene.contacts_in_all = pairs_;
  scene.contact = {"pair of triangles", "pairs of triangles"};
  return scene;
}

std::vector<report::Plot> OverlapPage::plots() const {
  std::vector<report::Plot> plots;
  if (track_.rows() > 1) {
    reproduce::LineChart chart{.title = "Overlapping pairs of triangles by pose",
                               .x_label = "pose",
                               .y_label = "pairs",
                               .markers = false};
    reproduce::Line line{.name = "pairs"};
    for (std::size_t k = 0; k < counts_.size(); ++k) {
      line.x.push_back(static_cast<double>(k * poses_of_count_));
      line.y.push_back(static_cast<double>(counts_[k]));
    }
    chart.lines.push_back(std::move(line));
    plots.push_back(plot(reproduce::draw(chart),
                         poses_of_count_ == 1
                             ? "Pairs of triangles that share a point, at each pose."
                             : fmt::format("Pairs of triangles that share a point: the most in {} "
                                           "poses each.",
                                           poses_of_count_)));
  }
  using Row = OverlapRows::Row;
  for (std::vector<report::Plot> bars :
       {bars_of_parts(models_.a.shape.mesh(), rows_.rows(), &Row::part_a, models_.name_a,
                      reproduce::kMovesColor),
        bars_of_parts(models_.b.shape.mesh(), rows_.rows(), &Row::part_b, models_.name_b,
                      reproduce::kStillColor)}) {
    std::move(bars.begin(), bars.end(), std::back_inserter(plots));
  }
  return plots;
}

std::vector<report::Fact> OverlapPage::facts(const OverlapReport& report,
                                             const RowTotals& totals) const {
  std::vector<report::Fact> facts = facts_of_models(models_, report.pair);
  facts.push_back({"query", report.mode == OverlapMode::all ? "every pair of triangles"
                            : report.mode == OverlapMode::first
                                ? "the first pair of triangles in order"
                                : "any pair of triangles"});
  facts.push_back(fact_of_poses(report.pair, totals));
  const char* const at_least = is_complete(report) ? "" : "at least ";
  facts.push_back({"pairs found", at_least + with_commas(pairs_)});
  if (!models_.a.shape.mesh().parts.empty() || !models_.b.shape.mesh().parts.empty()) {
    facts.push_back({"pairs of parts", at_least + with_commas(rows_.rows().size())});
  }
  const std::vector<report::Fact> work = facts_of_work(report.pair, totals, cost_);
  facts.insert(facts.end(), work.begin(), work.end());
  return facts;
}

/// What touches what, in a sentence; the pair of parts with the most pairs of triangles first.
std::string OverlapPage::lead(const report::Scene& scene, const RowTotals& totals) const {
  const std::string poses =
      track_.rows() > 1
          ? fmt::format(" at {} of {}", with_commas(totals.found), counted(track_.rows(), "pose"))
          : std::string();
  const std::optional<std::size_t> worst = report::worst_row(scene);
  if (!worst) {
    return scene.complete ? fmt::format("{} and {} do not touch{}.", models_.name_a, models_.name_b,
                                        track_.rows() > 1 ? " at any pose" : "")
                          : "No overlap was found so far.";
  }
  const report::SceneRow& row = scene.rows[*worst];
  const char* const at_least = scene.complete ? "" : "at least ";
  if (scene.rows.size() == 1) {
    return fmt::format("{}{}: {}{} of triangles overlap.", report::who_touches(scene, row), poses,
                       at_least, counted(row.count, "pair"));
  }
  return fmt::format("{} most, with {} of triangles. In all {}{} of parts touch{}.",
                     report::who_touches(scene, row), counted(row.count, "pair"), at_least,
                     counted(scene.rows.size(), "pair"), poses);
}

void OverlapPage::write(std::ostream& out, const OverlapReport& report,
                        const RowTotals& totals) const {
  report::Page page{
      .title = fmt::format("{} and {}", models_.name_a, models_.name_b),
      .lead = {},
      .facts = facts(report, totals),
      .plots = plots(),
      .notes = {"Touching counts as overlap: corners and edges belong to their triangles. Only "
                "surfaces are tested: a body entirely inside another one does not overlap it. "
                "The picture may be simplified; the answers never are."},
      .scene = scene(report)};
  page.lead = lead(page.scene, totals);
  for (const FrameWarning& warning : report.pair.warnings) {
    page.warnings.push_back(warning.text());
  }
  report::write_page(out, page);
}

}  // namespace soms::command
