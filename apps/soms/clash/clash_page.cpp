#include "apps/soms/clash/clash_page.h"

#include "soms/base/text.h"
#include "soms/query/overlap.h"

#include "apps/cli/text.h"
#include "apps/report/placing.h"
#include "apps/report/scene.h"
#include "apps/soms/clash/clash_output.h"
#include "apps/soms/clash/clash_sight.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <map>
#include <optional>
#include <string_view>
#include <utility>

namespace soms::command {

namespace {

/// Rows whose curves are drawn: the first ones, which are the worst.
constexpr std::size_t kRowsWithCurves = 10'000;

report::PageSight page_sight(const ClashSight& sight) {
  return {sight.place, sight.focus, sight.reach, sight.toward, sight.a_is_larger};
}

/// How many lines of each row the page takes, of those that have any.
std::vector<std::uint64_t> lines_of_rows(const ClashReport& report,
                                         const report::SceneLimits& limits) {
  std::vector<std::uint64_t> wanted;
  for (std::size_t k = 0; k < std::min(report.rows.size(), kRowsWithCurves); ++k) {
    wanted.push_back(
        std::min<std::uint64_t>(report.rows[k].clash.triangle_pairs, limits.pairs_of_row));
  }
  return report::fair_shares(wanted, limits.lines);
}

/// Makes the page of one report.
class ClashPageMaker {
 public:
  ClashPageMaker(const ClashReport& report, std::string command, bool verified)
      : report_(report),
        clashes_(report),
        command_(std::move(command)),
        verified_(verified),
        shares_(lines_of_rows(report, limits_)) {
    add_parts(report.models.a);
    first_of_b_ = page_.parts.size();
    if (report.models.two_sets) {
      add_parts(report.models.b);
    }
    add_sides();
  }

  report::ShownParts write(std::ostream& out) {
    page_.page.title = title();
    page_.page.lead = lead();
    add_facts();
    for (const FrameWarning& warning : report_.models.warnings) {
      page_.page.warnings.push_back(warning.text());
    }
    if (!report_.complete()) {
      page_.page.warnings.push_back(
          fmt::format("The comparison ended early: {} of parts were not compared, so there may be "
                      "more clashes.",
                      counted(report_.left, "pair")));
    }
    page_.page.notes = {
        "A part that is open encloses nothing that is known: a pair with it is undecided. Parts "
        "and "
        "places in the picture are rounded and may be simplified; the list never is."};
    page_.totals = totals();
    page_.rows = clashes_.size();
    page_.row = [this](std::size_t k) { return row(k); };
    return report::write_parts_page(out, page_, limits_);
  }

 private:
  void add_parts(const ClashSet& set) {
    for (const PartBody& part : set.parts) {
      page_.parts.push_back({part.body.shape.mesh(), false, {}});
    }
  }

  [[nodiscard]] std::size_t part_of_page(std::uint32_t part, bool is_b) const {
    return part + (is_b && report_.models.two_sets ? first_of_b_ : 0);
  }

  /// Each side once, by what JSON says of it; and for each row the numbers of its two.
  void add_sides() {
    std::map<std::string, std::size_t> numbers;
    for (std::size_t k = 0; k < clashes_.size(); ++k) {
      const ListedClash clash = clashes_.at(k);
      const std::optional<ClashSight> sight = sight_of(report_.models, clash);
      std::array<std::size_t, 2> sides{};
      for (const bool is_b : {false, true}) {
        const std::optional<std::uint32_t>& part = is_b ? clash.b : clash.a;
        const std::size_t drawn = part ? part_of_page(*part, is_b) : report::kNoPart;
        if (part) {
          report::PagePart& of_page = page_.parts[drawn];
          of_page.is_listed = true;
          if (sight) {
            of_page.detail.points.push_back(sight->focus);
            of_page.detail.radius = std::max(of_page.detail.radius, sight->reach);
          }
        }
        const char* const key = is_b ? "b" : "a";
        const std::string text =
            json_text(clash.row.contains(key) ? clash.row[key] : Json::object());
        const auto [at, added] =
            numbers.try_emplace(fmt::format("{} {}", drawn, text), page_.sides.size());
        if (added) {
          page_.sides.push_back({text, drawn});
        }
        sides[is_b ? 1 : 0] = at->second;
      }
      keep_worst(clash.row);
      sides_.push_back(sides);
      sights_.push_back(sight);
    }
  }

  /// Remembers the worst row of the first class that has any, by the rule of clash_rows.js.
  void keep_worst(const Json& row) {
    const auto lower = [&row](const char* key) {
      const Json value = row.value(key, Json());
      return value.is_array() && !value.empty() ? value[0].get<double>()
             : value.is_number()                ? value.get<double>()
                                                : 0.0;
    };
    if (text_of(row, "status") == "resolved") {
      return;
    }
    const Badness badness{-class_number(text_of(row, "class")), lower("depth"), -lower("gap"),
                          lower("triangle_pairs")};
    if (!worst_ || *worst_ < badness) {
      worst_ = badness;
      worst_words_ = fmt::format("{} and {}, {}", side_label(row, "a"), side_label(row, "b"),
                                 text_of(row, "class"));
      if (badness[1] > 0) {
        worst_words_ += fmt::format(", {} deep", four_digits(badness[1]));
      } else if (badness[2] < 0) {
        worst_words_ += fmt::format(", {} apart", four_digits(-badness[2]));
      }
    }
  }

  [[nodiscard]] static double class_number(std::string_view kind) {
    std::size_t number = 0;
    while (number < kClashKinds && name(static_cast<ClashKind>(number)) != kind) {
      ++number;
    }
    return static_cast<double>(number);
  }

  /// How many clashes of each class, and the worst.
  [[nodiscard]] std::string lead() const {
    if (report_.rows.empty()) {
      return report_.complete() ? "No parts clash." : "No clash was found so far.";
    }
    return fmt::format("{}{}{}. The worst: {}.", report_.complete() ? "" : "At least ",
                       clashes_in_all(), counts_of_classes(), worst_words_);
  }

  [[nodiscard]] std::string clashes_in_all() const {
    return fmt::format("{} {}", with_commas(report_.rows.size()),
                       report_.rows.size() == 1 ? "clash" : "clashes");
  }

  [[nodiscard]] report::PageRow row(std::size_t k) const {
    ListedClash clash = clashes_.at(k);
    clash.row.erase("schema");
    clash.row["a"] = sides_[k][0];
    clash.row["b"] = sides_[k][1];
    report::PageRow row{.json = json_text(clash.row)};
    if (sights_[k]) {
      row.sight = page_sight(*sights_[k]);
      row.lines = lines(k);
    }
    return row;
  }

  /// Where triangles of the two cross: every so many of all pairs.
  [[nodiscard]] std::vector<std::array<Vec3, 2>> lines(std::size_t k) const {
    std::vector<std::array<Vec3, 2>> lines;
    if (k >= shares_.size() || shares_[k] == 0) {
      return lines;
    }
    const Clash& clash = report_.rows[k].clash;
    const Body& a = report_.models.a.parts[clash.a].body;
    const Body& b = report_.models.second().parts[clash.b].body;
    const std::vector<TrianglePair> pairs = overlap(a, b).pairs;
    const std::uint64_t count = std::min<std::uint64_t>(shares_[k], pairs.size());
    for (std::uint64_t n = 0; n < count; ++n) {
      const TrianglePair& pair = pairs[n * pairs.size() / count];
      lines.push_back(
          report::crossing_line(a.shape.mesh().triangle(pair.a), b.shape.mesh().triangle(pair.b)));
    }
    return lines;
  }

  [[nodiscard]] static std::string set_name(const ClashSet& set) {
    const std::string first =
        set.meshes.empty() ? std::string("no model")
                           : std::filesystem::path(set.meshes.front().source).filename().string();
    return set.meshes.size() > 1 ? fmt::format("{} and {} more", first, set.meshes.size() - 1)
                                 : first;
  }

  [[nodiscard]] std::string title() const {
    return report_.models.two_sets
               ? fmt::format("Clashes of {} with {}", set_name(report_.models.a),
                             set_name(report_.models.b))
               : "Clashes of " + set_name(report_.models.a);
  }

  void add_fact(const std::string& name, const std::string& value) {
    page_.page.facts.push_back({name, value});
  }

  void add_models(const std::string& name, const ClashSet& set) {
    std::string files;
    for (const Mesh& mesh : set.meshes) {
      files += fmt::format("{}{}", files.empty() ? "" : ", ", mesh.source);
    }
    add_fact(name, fmt::format("{} ({})", files, counted(set.parts.size(), "part")));
  }

  [[nodiscard]] std::string counts_of_classes() const {
    std::string text;
    for (std::size_t k = 0; k < kClashKinds; ++k) {
      if (report_.by_kind[k] != 0) {
        text += fmt::format("{}{} {}", text.empty() ? ": " : ", ", with_commas(report_.by_kind[k]),
                            name(static_cast<ClashKind>(k)));
      }
    }
    return text;
  }

  void add_facts() {
    if (report_.models.two_sets) {
      add_models("first set", report_.models.a);
      add_models("second set", report_.models.b);
    } else {
      add_models("models", report_.models.a);
    }
    if (!report_.models.georeference.empty()) {
      add_fact("georeference", printable(describe(report_.models.georeference)));
    }
    add_fact("clashes", fmt::format("{}{}{}", report_.complete() ? "" : "at least ",
                                    with_commas(report_.rows.size()), counts_of_classes()));
    if (report_.has_baseline) {
      add_fact("since the older list",
               report_.complete() ? fmt::format("{} resolved, listed with their older places",
                                                with_commas(report_.resolved.size()))
                                  : std::string("what is resolved is unknown"));
    }
    for (const auto& [what, count] : report_.removed) {
      add_fact("removed by " + what, with_commas(count));
    }
    add_fact("compared",
             fmt::format("{} of {} of parts, those whose boxes meet", with_commas(report_.compared),
                         counted(report_.models.pairs(), "pair")));
    if (verified_) {
      add_fact("verified", "by brute force: every pair of parts is equal");
    }
    for (const std::string& note : report_.models.notes) {
      add_fact("note", note);
    }
    add_fact("made by", "soms " SOMS_VERSION);
    add_fact("again", command_);
  }

  [[nodiscard]] std::string totals() const {
    Json json = Json::object();
    json["pairs"] = report_.rows.size();
    json["resolved"] = report_.resolved.size();
    json["complete"] = report_.complete();
    json["command"] = command_;
    return json_text(json);
  }

  const ClashReport& report_;
  ListedClashes clashes_;
  std::string command_;
  bool verified_;
  report::SceneLimits limits_;
  std::vector<std::uint64_t> shares_;  ///< lines of the first rows
  report::PartsPage page_;
  std::size_t first_of_b_ = 0;
  std::vector<std::array<std::size_t, 2>> sides_;  ///< of each row
  std::vector<std::optional<ClashSight>> sights_;  ///< likewise
  /// What makes a row worse, the most important first.
  using Badness = std::array<double, 4>;
  std::optional<Badness> worst_;
  std::string worst_words_;
};

}  // namespace

report::ShownParts write_clashes_as_page(const ClashReport& report, const std::string& command,
                                         bool verified, std::ostream& out) {
  return ClashPageMaker(report, command, verified).write(out);
}

}  // namespace soms::command
