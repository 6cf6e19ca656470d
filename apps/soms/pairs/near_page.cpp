#include "apps/soms/pairs/near_page.h"

#include "apps/cli/text.h"
#include "apps/draw/chart.h"
#include "apps/model/models.h"
#include "apps/soms/answers/page_plots.h"
#include "apps/world/part_names.h"

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

bool NearPage::Near::operator<(const Near& other) const {
  return std::tie(length.upper, length.lower, pose) <
         std::tie(other.length.upper, other.length.lower, other.pose);
}

void NearPage::Extremes::grow(const Extremes& other) {
  least = std::fmin(least, other.least);  // of a number and none the number
  greatest = std::fmax(greatest, other.greatest);
}

NearPage::NearPage(PageModels models, NearWords words)
    : models_(std::move(models)), words_(std::move(words)) {
}

void NearPage::add(const PosesOfPair& poses, const NearFinding& finding) {
  const std::uint64_t pose = track_.rows();
  track_.add(poses);
  cost_ += finding.cost;
  complete_ = complete_ && finding.coverage == Coverage::complete;
  if (const NearPair& pair = finding.pair; pair.triangles) {
    keep({finding.length, pose, *pair.triangles, pair.point_a, pair.point_b, poses});
    follow(pose, has_bounds() ? Extremes{.least = finding.length.lower}
                              : Extremes{finding.length.lower, finding.length.lower});
    return;
  }
  follow(pose, has_bounds() ? Extremes{.greatest = finding.at_least} : Extremes{});
  if (has_bounds() && apart_.size() < report::SceneLimits().gaps) {
    apart_.push_back({pose, finding.at_least, finding.coverage == Coverage::cut});
  }
}

void NearPage::keep(const Near& near) {
  ++known_;
  if (near.touches()) {
    first_overlap_ = overlaps_++ == 0 ? near.pose : first_overlap_;
    last_overlap_ = near.pose;
  }
  nearest_.push_back(near);
  std::push_heap(nearest_.begin(), nearest_.end());
  if (nearest_.size() > report::SceneLimits().gaps) {
    std::pop_heap(nearest_.begin(), nearest_.end());
    nearest_.pop_back();
  }
}

void NearPage::follow(std::uint64_t pose, const Extremes& distance) {
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
void NearPage::add_overlaps(report::Scene& scene, const std::vector<Near>& nearest) const {
  scene.contact = words_.touching;
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

report::Scene NearPage::scene(const std::vector<Near>& nearest) const {
  std::map<std::uint64_t, PosesOfPair> kept = track_.kept();
  for (const Near& near : nearest) {
    kept[near.pose] = near.poses;
  }
  report::Scene scene = scene_of_pair(models_, std::move(kept), track_.rows());
  scene.lists_contacts = !words_.touching.one.empty();
  if (scene.lists_contacts) {
    add_overlaps(scene, nearest);
  }
  scene.gaps_in_all = known_;
  for (const Near& near : nearest) {
    scene.gaps.push_back({.a = 0,
                          .b = 1,
                          .begin = near.pose,
                          .end = near.pose,
                          .nearest = near.pose,
                          .point_a = near.point_a,
                          .point_b = near.point_b,
                          .length = four_digits(near.length.lower)});
  }
  return scene;
}

/// Of a table of `rows`: what it leaves out.
std::string NearPage::caption(std::size_t rows) const {
  const std::uint64_t all = has_bounds() ? track_.rows() : known_;
  if (all > rows) {
    return fmt::format("{} of {}. {} -o FILE.csv and --json have all.", with_commas(rows),
                       counted(all, "pose"), words_.order);
  }
  return "A distance is written with at most nine digits." + (all > 1 ? " " + words_.order : "");
}

report::Table NearPage::table(const std::vector<Near>& nearest) const {
  report::Table table{.title = words_.table,
                      .columns = {"pose", words_.column, "triangle of A", "triangle of B",
                                  "point on A", "point on B"},
                      .rows = {},
                      .of_gaps = true};
  for (const Near& near : nearest) {
    table.rows.push_back(
        {with_commas(near.pose), words_.named + readable(near.length.lower),
         triangle_label(models_.a.shape.mesh(), near.triangles.a, models_.a.numbers),
         triangle_label(models_.b.shape.mesh(), near.triangles.b, models_.b.numbers),
         point_in_text(near.point_a), point_in_text(near.point_b)});
  }
  for (const Apart& apart : apart_) {
    if (table.rows.size() == report::SceneLimits().gaps) {
      break;
    }
    const std::string answer = apart.undecided ? "undecided, at least " + readable(apart.at_least)
                               : std::isfinite(apart.at_least)
                                   ? words_.apart + readable(apart.at_least)
                                   : "no: a model has no triangles";
    table.rows.push_back({with_commas(apart.pose), answer, "", "", "", ""});
  }
  table.caption = caption(table.rows.size());
  return table;
}

std::vector<report::Plot> NearPage::plots() const {
  const bool any = std::any_of(course_.begin(), course_.end(), [](const Extremes& point) {
    return std::isfinite(point.least) || std::isfinite(point.greatest);
  });
  if (track_.rows() < 2 || !any) {
    return {};
  }
  reproduce::LineChart chart{
      .title = words_.plot, .x_label = "pose", .y_label = "distance", .markers = false};
  const bool each = poses_of_point_ == 1;
  const bool same = each && !has_bounds();  // the least and the greatest of one pose
  reproduce::Line least{.name = same ? "distance" : words_.least};
  reproduce::Line greatest{.name = words_.greatest};
  for (std::size_t k = 0; k < course_.size(); ++k) {
    for (const auto& [line, value] :
         {std::pair(&least, course_[k].least), std::pair(&greatest, course_[k].greatest)}) {
      line->x.push_back(static_cast<double>(k * poses_of_point_));
      line->y.push_back(value);
    }
  }
  chart.lines.push_back(std::move(least));
  if (!same) {
    chart.lines.push_back(std::move(greatest));
  }
  return {
      plot(reproduce::draw(chart),
           each ? words_.each : fmt::format("{} {} poses each.", words_.of_few, poses_of_point_))};
}

void NearPage::write(std::ostream& out, const PairReport& report, const RowTotals& totals,
                     const std::string& answer) const {
  std::vector<Near> nearest = nearest_;
  std::sort(nearest.begin(), nearest.end());
  report::Page page{.title = fmt::format("{} and {}", models_.name_a, models_.name_b),
                    .lead = fmt::format("{} and {}{}{}.", models_.name_a, models_.name_b,
                                        !report.single ? " at "
                                        : has_bounds() ? ", "
                                                       : ": ",
                                        answer),
                    .facts = facts_of_models(models_, report),
                    .plots = plots(),
                    .notes = {words_.lead, words_.note},
                    .scene = scene(nearest)};
  page.facts.push_back({"answer", answer});
  page.facts.push_back(fact_of_poses(report, totals, words_.poses));
  const std::vector<report::Fact> work = facts_of_work(report, totals, cost_);
  page.facts.insert(page.facts.end(), work.begin(), work.end());
  page.scene.complete = complete_ && !report.interrupted && !report.timed_out;
  if (report::Table answers = table(nearest); !answers.rows.empty()) {
    page.tables.push_back(std::move(answers));
  }
  for (const FrameWarning& warning : report.warnings) {
    page.warnings.push_back(warning.text());
  }
  report::write_page(out, page);
}

}  // namespace soms::command
