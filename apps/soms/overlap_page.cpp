#include "apps/soms/overlap_page.h"

#include "apps/soms/page_plots.h"
#include "apps/support/text.h"
#include "apps/support/world.h"
#include "reproduce/chart.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace soms::command {

namespace {

constexpr std::size_t kMostTracked = 2048;
constexpr std::size_t kMostCounts = 1024;
/// Of a pose that touches at least so many pairs are listed before poses are left out.
constexpr std::size_t kFewPairs = 8;

/// Drops what is not at a multiple of `pause`.
template <typename Value>
void keep_multiples(std::map<std::uint64_t, Value>& values, std::uint64_t pause) {
  for (auto at = values.begin(); at != values.end();) {
    at = at->first % pause == 0 ? std::next(at) : values.erase(at);
  }
}

void count_part(std::vector<std::uint64_t>& counts, const PartsOf& part_of, TriangleId i) {
  const std::uint32_t part = part_of(i);
  if (part != Part::kNoParent) {
    ++counts[part];
  }
}

std::vector<report::Plot> bars_of_parts(const Mesh& mesh, const std::vector<std::uint64_t>& counts,
                                        const std::string& name) {
  std::map<std::string, double> by_name;
  for (std::size_t k = 0; k < counts.size(); ++k) {
    if (counts[k] > 0 && !mesh.parts[k].name.empty()) {
      by_name[mesh.parts[k].name] += static_cast<double>(counts[k]);
    }
  }
  return bars_of({by_name.begin(), by_name.end()}, "Parts of " + name, "pairs",
                 "Overlapping pairs of triangles by the part of " + name +
                     " that they lie in, all poses together; the parts with most.");
}

std::string triangles_of(const Mesh& mesh) {
  return counted(mesh.triangles.size(), "triangle");
}

}  // namespace

OverlapPage::OverlapPage(const Mesh& a, std::string name_a, const Mesh& b, std::string name_b)
    : a_(a),
      b_(b),
      parts_of_a_(a),
      parts_of_b_(b),
      name_a_(std::move(name_a)),
      name_b_(std::move(name_b)),
      most_pairs_(report::SceneLimits().contacts),
      parts_a_(a.parts.size(), 0),
      parts_b_(b.parts.size(), 0) {
}

void OverlapPage::add(const Pose& a, const Pose& b, const Overlap& answer) {
  follow(a, b);
  count_pairs(answer);
  if (!answer.pairs.empty() && poses_ % touching_pause_ == 0) {
    remember(a, b, answer);
  }
  ++poses_;
}

void OverlapPage::follow(const Pose& a, const Pose& b) {
  if (poses_ % pause_ != 0) {
    return;
  }
  track_[poses_] = {a, b};
  if (track_.size() > kMostTracked) {
    pause_ *= 2;
    keep_multiples(track_, pause_);
  }
}

void OverlapPage::count_pairs(const Overlap& answer) {
  pairs_ += answer.pairs.size();
  cut_ = cut_ || answer.coverage == Coverage::cut;
  cost_ += answer.cost;
  for (const auto& [i, j] : answer.pairs) {
    count_part(parts_a_, parts_of_a_, i);
    count_part(parts_b_, parts_of_b_, j);
  }
  if (poses_ % poses_of_count_ == 0) {
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

void OverlapPage::remember(const Pose& a, const Pose& b, const Overlap& answer) {
  const std::size_t kept = std::min(most_pairs_, answer.pairs.size());
  touching_.push_back(
      {.pose = poses_,
       .pairs = {answer.pairs.begin(), answer.pairs.begin() + static_cast<std::ptrdiff_t>(kept)}});
  placed_[poses_] = {a, b};
  held_ += kept;
  while (held_ > report::SceneLimits().contacts) {
    thin_out();
  }
}

/// Fewer pairs of each pose; where they are few, fewer poses.
void OverlapPage::thin_out() {
  if (most_pairs_ > kFewPairs) {
    most_pairs_ /= 2;
  } else {
    touching_pause_ *= 2;
    keep_multiples(placed_, touching_pause_);
    std::erase_if(touching_, [&](const Touching& t) { return t.pose % touching_pause_ != 0; });
  }
  held_ = 0;
  for (Touching& touching : touching_) {
    touching.pairs.resize(std::min(most_pairs_, touching.pairs.size()));
    held_ += touching.pairs.size();
  }
}

report::Scene OverlapPage::scene() const {
  report::Scene scene;
  std::map<std::uint64_t, Poses> kept = track_;
  kept.insert(placed_.begin(), placed_.end());
  const Pose first = kept.empty() ? Pose() : kept.begin()->second.b;
  const bool b_moves = std::any_of(kept.begin(), kept.end(),
                                   [&](const auto& step) { return !(step.second.b == first); });
  scene.models = {{&a_, name_a_}, {&b_, name_b_}};
  scene.bodies = {{0, name_a_, true}, {1, name_b_, b_moves}};
  for (const Touching& touching : touching_) {
    for (const TrianglePair& pair : touching.pairs) {
      scene.contacts.push_back({.a = 0,
                                .b = 1,
                                .part_a = parts_of_a_.name(pair.first),
                                .part_b = parts_of_b_.name(pair.second),
                                .begin = touching.pose,
                                .end = touching.pose,
                                .pairs = {pair},
                                .pairs_in_all = 1});
    }
  }
  scene.contacts_in_all = pairs_;
  scene.steps = {.count = std::max<std::uint64_t>(1, poses_), .noun = "pose", .smooth = false};
  for (const auto& [step, poses] : kept) {
    scene.steps.kept.push_back(step);
  }
  scene.y_is_up = b_.up == UpAxis::y;
  scene.pose = [kept = std::move(kept)](std::uint32_t body, std::uint64_t step) {
    const auto next = kept.upper_bound(step);
    if (next == kept.begin()) {
      return Pose();
    }
    const Poses& poses = std::prev(next)->second;
    return body == 0 ? poses.a : poses.b;
  };
  return scene;
}

std::vector<report::Plot> OverlapPage::plots() const {
  std::vector<report::Plot> plots;
  if (poses_ > 1) {
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
  for (std::vector<report::Plot> bars :
       {bars_of_parts(a_, parts_a_, name_a_), bars_of_parts(b_, parts_b_, name_b_)}) {
    std::move(bars.begin(), bars.end(), std::back_inserter(plots));
  }
  return plots;
}

std::vector<report::Fact> OverlapPage::facts(const OverlapReport& report,
                                             const OverlapTotals& totals) const {
  std::vector<report::Fact> facts{{"A", fmt::format("{}, {}", name_a_, triangles_of(a_))},
                                  {"B", fmt::format("{}, {}", name_b_, triangles_of(b_))}};
  facts.push_back({"asked", report.mode == OverlapMode::all     ? "every pair of triangles"
                            : report.mode == OverlapMode::first ? "the least pair of triangles"
                                                                : "any pair of triangles"});
  facts.push_back(
      {"poses", fmt::format("{}{}: {} with overlap, {} without{}",
                            report.interrupted ? "interrupted after " : "",
                            with_commas(totals.poses), with_commas(totals.overlapping),
                            with_commas(totals.poses - totals.overlapping - totals.undecided),
                            totals.undecided == 0
                                ? ""
                                : fmt::format(", {} undecided", with_commas(totals.undecided)))});
  facts.push_back(
      {"pairs found", fmt::format("{}{}", cut_ ? "at least " : "", with_commas(pairs_))});
  facts.push_back(
      {"tests",
       fmt::format("{} of boxes, {} of triangles, {} of them exact", with_commas(cost_.node_tests),
                   with_commas(cost_.triangle_tests), with_commas(cost_.exact_tests))});
  for (const FrameWarning& warning : report.warnings) {
    facts.push_back({"warning", warning.text()});
  }
  if (report.verified) {
    facts.push_back({"verified", fmt::format("by brute force: {} of {} equal",
                                             with_commas(totals.poses - totals.wrong),
                                             counted(totals.poses, "answer"))});
  }
  return facts;
}

void OverlapPage::write(std::ostream& out, const OverlapReport& report,
                        const OverlapTotals& totals) const {
  report::Page page{.title = fmt::format("{} and {}", name_a_, name_b_),
                    .lead = "Which triangles share a point, decided exactly.",
                    .facts = facts(report, totals),
                    .plots = plots(),
                    .notes = {"Touching counts: corners and edges belong to their triangles. "
                              "Surfaces only: a body wholly inside another overlaps nothing of it. "
                              "The picture may be simplified; the answers never are."},
                    .scene = scene()};
  if (!touching_.empty() && held_ < pairs_) {
    page.notes.push_back(fmt::format(
        "Listed are the first {} of each pose{}.", counted(most_pairs_, "pair"),
        touching_pause_ == 1 ? "" : fmt::format(", of every {}th pose", touching_pause_)));
  }
  report::write_page(out, page);
}

}  // namespace soms::command
