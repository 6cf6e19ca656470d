#include "apps/soms/pairs/motion_page.h"

#include "apps/cli/text.h"
#include "apps/model/models.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <utility>

namespace soms::command {

namespace {

constexpr std::size_t kMostMotions = 1000;

/// The time that is shown first: of the contact, or of what may be one.
double moment_of(const FirstContact& answer) {
  return std::isfinite(answer.t.upper) ? answer.t.upper : answer.t.lower;
}

/// Where bodies are at a step of the scene.
Pose pose_at_step(const report::SceneMotion& shown, std::uint64_t step) {
  const std::array<double, report::kStepsOfMotion> times{0, shown.moment, 1};
  return shown.motion.pose_at(times[step % report::kStepsOfMotion]);
}

}  // namespace

MotionPage::MotionPage(PageModels models, const Pose& resting)
    : models_(std::move(models)), resting_(resting) {
}

void MotionPage::add(const RigidMotion& motion, const FirstContact& answer,
                     const MotionSaid& said) {
  const bool blocked = answer.verdict != ContactVerdict::free;
  const std::uint64_t number = motions_++;
  blocked_in_all_ += blocked ? 1U : 0U;
  cost_ += answer.cost;
  complete_ = complete_ && answer.coverage == Coverage::complete;
  std::vector<Kept>& list = blocked ? blocked_ : free_;
  if (list.size() == kMostMotions) {
    return;
  }
  Kept kept{.shown = {.motion = motion,
                      .number = number,
                      .blocked = blocked,
                      .t = answer.t,
                      .moment = moment_of(answer),
                      .verdict = said.verdict,
                      .words = said.sentence},
            .triangles = {},
            .triangle_a = said.triangle_a,
            .triangle_b = said.triangle_b};
  if (answer.triangles) {
    kept.shown.place = answer.point;
    kept.triangles = *answer.triangles;
  }
  list.push_back(std::move(kept));
}

/// Those that are not free come first.
std::vector<MotionPage::Kept> MotionPage::chosen() const {
  std::vector<Kept> motions = blocked_;
  const std::size_t room = std::min(free_.size(), kMostMotions - motions.size());
  motions.insert(motions.end(), free_.begin(), free_.begin() + static_cast<std::ptrdiff_t>(room));
  return motions;
}

report::Scene MotionPage::scene(const std::vector<Kept>& motions) const {
  report::Scene scene = scene_of_pair(models_, {}, report::kStepsOfMotion * motions.size());
  scene.steps.noun = "step";
  scene.lists_contacts = !motions.empty();
  scene.contacts_in_all = blocked_in_all_;
  scene.motions_in_all = motions_;
  for (std::size_t k = 0; k < motions.size(); ++k) {
    const Kept& kept = motions[k];
    scene.motions.push_back(kept.shown);
    if (!kept.shown.place) {
      continue;
    }
    const std::uint64_t step = report::kStepsOfMotion * k + 1;
    report::SceneRow row{.a = 0,
                         .b = 1,
                         .count = 1,
                         .steps = 1,
                         .begin = step,
                         .end = step,
                         .first = kept.triangles};
    row.box.grow(*kept.shown.place);
    scene.contacts.push_back({.row = scene.rows.size(),
                              .a = 0,
                              .b = 1,
                              .begin = step,
                              .end = step,
                              .pairs = {kept.triangles},
                              .pairs_in_all = 1});
    scene.rows.push_back(std::move(row));
  }
  scene.pose = [shown = scene.motions, resting = resting_](std::uint32_t body, std::uint64_t step) {
    return body != 0 || shown.empty() ? resting
                                      : pose_at_step(shown[step / report::kStepsOfMotion], step);
  };
  return scene;
}

report::Table MotionPage::table(const std::vector<Kept>& motions) const {
  report::Table table{
      .title = "Motions",
      .columns = {"motion", "first contact", "triangle of A", "triangle of B", "point"},
      .rows = {},
      .of_motions = true};
  for (const Kept& kept : motions) {
    table.rows.push_back({with_commas(kept.shown.number), kept.shown.verdict, kept.triangle_a,
                          kept.triangle_b,
                          kept.shown.place ? point_in_text(*kept.shown.place) : ""});
  }
  table.caption = motions_ > motions.size()
                      ? fmt::format(
                            "{} of {}. Those that are not free come first. -o FILE.csv and "
                            "--json have all.",
                            with_commas(motions.size()), counted(motions_, "motion"))
                      : "Those that are not free come first.";
  return table;
}

/// The answer of the only motion, or of the first that is not free.
std::string MotionPage::lead(const std::vector<Kept>& motions) const {
  if (motions.empty()) {
    return "No motion was answered.";
  }
  const report::SceneMotion& first = motions.front().shown;
  if (motions_ > 1 && !first.blocked) {
    return fmt::format("All {} are free.", counted(motions_, "motion"));
  }
  // Without the triangles, which the page says below its slider.
  std::string verdict = "is " + first.words.substr(0, first.words.find(';'));
  constexpr std::string_view kWay = "the way";
  if (const std::size_t at = verdict.find(kWay); at != std::string::npos) {
    verdict.insert(at + kWay.size(), " past " + models_.name_b);
  }
  return motions_ == 1 ? fmt::format("{} {}.", models_.name_a, verdict)
                       : fmt::format("{} of {} are not free. In motion {} {} {}.",
                                     with_commas(blocked_in_all_), counted(motions_, "motion"),
                                     with_commas(first.number), models_.name_a, verdict);
}

void MotionPage::write(std::ostream& out, const PairReport& report, const RowTotals& totals) const {
  const std::vector<Kept> motions = chosen();
  report::Page page{
      .title = fmt::format("{} on its way past {}", models_.name_a, models_.name_b),
      .lead = lead(motions),
      .facts = facts_of_models(models_, report),
      .plots = {},
      .notes = {"A motion is free where no contact is at any time of the way, which is proved and "
                "not sampled. Only surfaces are compared. The picture may be simplified, and it "
                "rounds poses; the answers never are."},
      .scene = scene(motions)};
  page.facts.push_back(
      {"motions", fact_of_poses(report, totals, {.yes = "not free", .no = "free"}).value});
  const std::vector<report::Fact> work = facts_of_work(report, totals, cost_);
  page.facts.insert(page.facts.end(), work.begin(), work.end());
  page.scene.complete = complete_ && !report.interrupted && !report.timed_out;
  page.tables.push_back(table(motions));
  for (const FrameWarning& warning : report.warnings) {
    page.warnings.push_back(warning.text());
  }
  report::write_page(out, page);
}

}  // namespace soms::command
