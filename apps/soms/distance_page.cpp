#include "apps/soms/distance_page.h"

#include "apps/soms/page_plots.h"
#include "apps/support/models.h"
#include "apps/support/part_names.h"
#include "apps/support/text.h"
#include "reproduce/chart.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

namespace soms::command {

namespace {

constexpr std::size_t kMostOfCourse = 1024;

}  // namespace

bool DistancePage::Near::operator<(const Near& other) const {
  return std::tie(distance.upper, distance.lower, pose) <
         std::tie(other.distance.upper, other.distance.lower, other.pose);
}

void DistancePage::Extremes::grow(const Extremes& other) {
  least = std::fmin(least, other.least);  // of a number and none the number
  greatest = std::fmax(greatest, other.greatest);
}

DistancePage::DistancePage(PageModels models) : models_(std::move(models)) {
}

void DistancePage::add(const Pose& a, const Pose& b, const Distance& answer) {
  const std::uint64_t pose = track_.rows();
  track_.add({a, b});
  cost_ += answer.cost;
  complete_ = complete_ && answer.coverage == Coverage::complete;
  if (answer.coverage != Coverage::complete || !answer.triangles) {
    follow(pose, {});
    return;
  }
  follow(pose, {answer.distance.lower, answer.distance.lower});
  ++known_;
  nearest_.push_back(
      {answer.distance, pose, *answer.triangles, answer.point_a, answer.point_b, {a, b}});
  if (nearest_.back().touches()) {
    first_overlap_ = overlaps_++ == 0 ? pose : first_overlap_;
    last_overlap_ = pose;
  }
  std::push_heap(nearest_.begin(), nearest_.end());
  if (nearest_.size() > report::SceneLimits().gaps) {
    std::pop_heap(nearest_.begin(), nearest_.end());
    nearest_.pop_back();
  }
}

void DistancePage::follow(std::uint64_t pose, const Extremes& distance) {
  if (pose % poses_of_point_ == 0) {
    course_.emplace_back();
  }
  course_.back().grow(distance);
  if (course_.size() > kMostOfCourse) {
    // An odd number: the last one stands alone and goes on being filled.
    for (std::size_t k = 0; k < course_.size(); ++k) {
      if (k % 2 == 0) {
        course_[k / 2] = course_[k];
      } else {
        course_[k / 2].grow(course_[k]);
      }
    }
    course_.resize((course_.size() + 1) / 2);
    poses_of_point_ *= 2;
  }
}

/// The poses with overlap as contacts of the two models; the answers name one pair of triangles of
/// each.
void DistancePage::add_overlaps(report::Scene& scene, const std::vector<Near>& nearest) const {
  scene.contact = {"pose with overlap", "poses with overlap"};
  scene.contacts_in_all = overlaps_;
  for (const Near& near : nearest) {
    if (near.touches()) {
      scene.contacts.push_back({.a = 0,
                                .b = 1,
                                .begin = near.pose,
                                .end = near.pose,
                                .pairs = {near.triangles},
                                .pairs_in_all = 1});
    }
  }
  if (overlaps_ > 0) {
    report::SceneRow row{.a = 0,
                         .b = 1,
                         .count = overlaps_,
                         .steps = overlaps_,
                         .begin = first_overlap_,
                         .end = last_overlap_,
                         .first = nearest.front().triangles};
    for (const Near& near : nearest) {
      if (near.touches()) {
        row.box.grow(near.point_a);
      }
    }
    scene.rows.push_back(row);
  }
}

report::Scene DistancePage::scene(const std::vector<Near>& nearest) const {
  std::map<std::uint64_t, PosesOfPair> kept = track_.kept();
  for (const Near& near : nearest) {
    kept[near.pose] = near.poses;
  }
  report::Scene scene = scene_of_pair(models_, std::move(kept), track_.rows());
  add_overlaps(scene, nearest);
  scene.gaps_in_all = known_;
  for (const Near& near : nearest) {
    scene.gaps.push_back({.a = 0,
                          .b = 1,
                          .begin = near.pose,
                          .end = near.pose,
                          .nearest = near.pose,
                          .point_a = near.point_a,
                          .point_b = near.point_b,
                          .length = four_digits(near.distance.lower)});
  }
  return scene;
}

report::Table DistancePage::table(const std::vector<Near>& nearest) const {
  report::Table table{
      .title = "Nearest points",
      .columns = {"pose", "distance", "triangle of A", "triangle of B", "point on A", "point on B"},
      .rows = {},
      .caption = "A distance is written with at most nine digits.",
      .of_gaps = true};
  if (known_ > nearest.size()) {
    table.caption =
        fmt::format("The nearest {} of {}, the nearest first; --csv and --json have all.",
                    with_commas(nearest.size()), counted(known_, "pose"));
  } else if (known_ > 1) {
    table.caption += " The nearest come first.";
  }
  for (const Near& near : nearest) {
    table.rows.push_back({with_commas(near.pose), readable(near.distance.lower),
                          triangle_label(models_.a, near.triangles.first),
                          triangle_label(models_.b, near.triangles.second),
                          point_in_text(near.point_a), point_in_text(near.point_b)});
  }
  return table;
}

std::vector<report::Plot> DistancePage::plots() const {
  if (track_.rows() < 2 || known_ == 0) {
    return {};
  }
  reproduce::LineChart chart{
      .title = "Distance by pose", .x_label = "pose", .y_label = "distance", .markers = false};
  const bool each = poses_of_point_ == 1;
  reproduce::Line least{.name = each ? "distance" : "least"};
  reproduce::Line greatest{.name = "greatest"};
  for (std::size_t k = 0; k < course_.size(); ++k) {
    for (const auto& [line, value] :
         {std::pair(&least, course_[k].least), std::pair(&greatest, course_[k].greatest)}) {
      line->x.push_back(static_cast<double>(k * poses_of_point_));
      line->y.push_back(value);
    }
  }
  chart.lines.push_back(std::move(least));
  if (!each) {
    chart.lines.push_back(std::move(greatest));
  }
  return {plot(reproduce::draw(chart),
               each
                   ? "The distance of the surfaces at each pose; a line that breaks off: not known."
                   : fmt::format("The distance of the surfaces: the least and the greatest in {} "
                                 "poses each.",
                                 poses_of_point_))};
}

void DistancePage::write(std::ostream& out, const PairReport& report, const RowTotals& totals,
                         const std::string& answer) const {
  std::vector<Near> nearest = nearest_;
  std::sort(nearest.begin(), nearest.end());
  report::Page page{.title = fmt::format("{} and {}", models_.name_a, models_.name_b),
                    .lead = "How far apart the surfaces are, exact to the last bit.",
                    .facts = facts_of_models(models_, report),
                    .plots = plots(),
                    .notes = {"The distance is that of the surfaces: 0 if they overlap, and above "
                              "0 if a body is entirely inside another one. The picture may be "
                              "simplified; the answers never are."},
                    .scene = scene(nearest)};
  page.facts.push_back({"answer", answer});
  page.facts.push_back(fact_of_poses(report, totals));
  const std::vector<report::Fact> work = facts_of_work(report, totals, cost_);
  page.facts.insert(page.facts.end(), work.begin(), work.end());
  page.scene.complete = complete_ && !report.interrupted && !report.timed_out;
  if (!nearest.empty()) {
    page.tables.push_back(table(nearest));
  }
  for (const FrameWarning& warning : report.warnings) {
    page.warnings.push_back(warning.text());
  }
  report::write_page(out, page);
}

}  // namespace soms::command
