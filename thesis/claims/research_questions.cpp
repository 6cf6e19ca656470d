#include "thesis/claims/research_questions.h"

#include "soms/base/text.h"

#include "thesis/claims/nearest_verdict.h"
#include "thesis/page/html.h"
#include "thesis/trips/interactive_rates.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace soms::reproduce {

namespace {

const Entry* entry_of(const Report& report, std::string_view item) {
  const auto found = std::find_if(report.entries.begin(), report.entries.end(),
                                  [&](const Entry& one) { return one.experiment->item == item; });
  return found == report.entries.end() ? nullptr : &*found;
}

const Claim* claim_of(const Report& report, std::string_view id) {
  for (const Entry& entry : report.entries) {
    for (const Claim& claim : entry.result.claims) {
      if (claim.id == id) {
        return &claim;
      }
    }
  }
  return nullptr;
}

const Table* table_of(const Report& report, std::string_view item, std::string_view id) {
  const Entry* const entry = entry_of(report, item);
  if (entry == nullptr) {
    return nullptr;
  }
  const auto found = std::find_if(entry->result.tables.begin(), entry->result.tables.end(),
                                  [&](const Table& table) { return table.id == id; });
  return found == entry->result.tables.end() ? nullptr : &*found;
}

/// A row of a table by the names of its columns.
class NamedRow {
 public:
  NamedRow(const Table& table, std::size_t row) : table_(table), row_(table.rows[row]) {}

  [[nodiscard]] std::string words(std::string_view column) const {
    const Cell* const cell = find(column);
    const auto* const text = cell == nullptr ? nullptr : std::get_if<std::string>(cell);
    return text == nullptr ? std::string() : *text;
  }

  [[nodiscard]] std::optional<double> number(std::string_view column) const {
    const Cell* const cell = find(column);
    if (cell == nullptr) {
      return std::nullopt;
    }
    if (const auto* const count = std::get_if<std::int64_t>(cell)) {
      return static_cast<double>(*count);
    }
    const auto* const measured = std::get_if<double>(cell);
    return measured == nullptr ? std::nullopt : std::optional(*measured);
  }

 private:
  [[nodiscard]] const Cell* find(std::string_view column) const {
    for (std::size_t k = 0; k < table_.columns.size() && k < row_.size(); ++k) {
      if (table_.columns[k].name == column) {
        return &row_[k];
      }
    }
    return nullptr;
  }

  const Table& table_;
  const std::vector<Cell>& row_;
};

/// How the reading nearest to the text stands of a claim; empty if it was not tested.
std::string stand_words(const Report& report, std::string_view id) {
  const Claim* const claim = claim_of(report, id);
  if (claim == nullptr) {
    return "";
  }
  const NearestVerdict nearest = nearest_of(*claim);
  const std::string share = shares_words(nearest);
  return fmt::format(" &#8220;<a href=\"#claim-{}\">{}</a>&#8221;: {}{}.", xml_text(id),
                     xml_text(claim->statement), name(nearest.stand),
                     share.empty() ? "" : fmt::format(" ({})", share));
}

std::string stand_words(const Report& report, std::span<const std::string_view> ids) {
  std::string words;
  for (const std::string_view id : ids) {
    words += stand_words(report, id);
  }
  return words;
}

/// The lowest of the mean frame rates by SOMS in the orientation tests of the thesis that ran.
struct SlowestRate {
  std::string model;
  std::string test;
  double rate = 0;
};

std::optional<SlowestRate> slowest_rate(const Report& report) {
  constexpr std::array<std::array<std::string_view, 3>, 4> kTests{
      {{"figure-5.6", "figure_5_6_times", "right"},
       {"figure-5.7", "figure_5_7_times", "left"},
       {"figure-5.8", "figure_5_8_times", "top"},
       {"orientation-bottom", "orientation_bottom_times", "bottom"}}};
  std::optional<SlowestRate> slowest;
  for (const auto& [item, id, test] : kTests) {
    const Table* const table = table_of(report, item, id);
    for (std::size_t i = 0; table != nullptr && i < table->rows.size(); ++i) {
      const NamedRow row(*table, i);
      const std::optional<double> mean = row.number("mean");
      if (row.words("rule") == "soms" && row.words("quantity") == "fps" && mean &&
          (!slowest || *mean < slowest->rate)) {
        slowest = SlowestRate{row.words("model"), std::string(test), *mean};
      }
    }
  }
  return slowest;
}

/// Frames a second beside the 30 to 60 of section 1.1.
std::string rate_words(const Report& report) {
  const std::optional<SlowestRate> slowest = slowest_rate(report);
  if (!slowest) {
    return "";
  }
  const std::string where = fmt::format("{}, test {}", xml_text(slowest->model), slowest->test);
  const std::string rate = fmt::format("<em>{:.0f}</em> frames a second", slowest->rate);
  if (slowest->rate < kMostInteractive) {
    return fmt::format(
        " Section 1.1 wants {:g} to {:g} frames a second: without drawing, the slowest orientation "
        "test on trees by SOMS ({}) has {} on this machine.",
        kLeastInteractive, kMostInteractive, where, rate);
  }
  return fmt::format(
      " Section 1.1 wants {:g} to {:g} frames a second: without drawing, the slowest orientation "
      "test on trees by SOMS ({}) has {} on this machine, {:.0f} times the {:g}.",
      kLeastInteractive, kMostInteractive, where, rate,
      std::floor(slowest->rate / kMostInteractive), kMostInteractive);
}

/// What boxes say and what triangles do, of the first object that comes from the right.
std::string accuracy_words(const Report& report) {
  const Table* const table = table_of(report, "figure-5.6", "figure_5_6_counts");
  for (std::size_t i = 0; table != nullptr && i < table->rows.size(); ++i) {
    const NamedRow row(*table, i);
    const std::optional<double> roots = row.number("root_overlap_frames");
    const std::optional<double> leaves = row.number("hit_frames");
    const std::optional<double> contact = row.number("first_contact_frame");
    const std::optional<double> frames = row.number("frames");
    if (row.words("rule") == "soms" && roots && leaves && frames) {
      return fmt::format(
          " Accuracy: triangles are tested exactly, and all trees and traversals gave the same "
          "triangles that touch, else the run would have ended with an error. Boxes alone do not: "
          "of {:.0f} frames of {} coming from the right the roots overlap in {:.0f} and leaves in "
          "{:.0f}{}.",
          *frames, xml_text(row.words("model")), *roots, *leaves,
          contact ? fmt::format("; triangles touch from frame {:.0f} on", *contact) : "");
    }
  }
  return "";
}

std::string improvement(const Report& report) {
  constexpr std::array<std::string_view, 2> kClaims{"no_fallback", "soms_is_cheaper_to_query"};
  return "The thesis looks for it in the splitting rule, where spatial median cannot divide "
         "triangles of unlike size." +
         stand_words(report, kClaims);
}

std::string kind_of_tree(const Report&) {
  return "Binary: the abstract and section 1.3 state it, and no heading, table or figure compares "
         "another. This run builds binary trees alone, so it has no count for quad-trees and "
         "octrees.";
}

std::string construction(const Report&) {
  return "Top-down, by heading 4.4.1; figure 4.28 shows such a build, node by node. Bottom-up and "
         "insertion stand in figures 2.8 and 2.9, from the work of others, and are not run.";
}

std::string splitting(const Report& report) {
  constexpr std::array<std::string_view, 3> kClaims{"more_single_leaves", "26_percent",
                                                    "more_balanced"};
  return "By SOMS: in the middle of the box of the midpoints, across its longest axis." +
         stand_words(report, kClaims);
}

std::string differences(const Report&) {
  return "Each rule puts its plane at another number: half of the triangles by count, the mean of "
         "the midpoints, the middle of the box of all corners, the middle of the box of the "
         "midpoints. The middle of the corners may have every midpoint on one side, and then "
         "spatial median stops: tables 5.5 and 5.11 count such nodes.";
}

std::string volumes(const Report&) {
  return "Boxes along the axes, by section 1.3; spheres, oriented boxes and polytopes stand in "
         "chapter 2 by its headings, and no table or figure tests them. This run uses boxes along "
         "the axes alone, so it does not say whether others suit better.";
}

std::string speed(const Report& report) {
  constexpr std::array<std::string_view, 4> kClaims{"build_8_percent", "build_city", "enode_faster",
                                                    "enode_earlier"};
  return "Speed:" + stand_words(report, kClaims) + rate_words(report) + accuracy_words(report);
}

/// A question in our words, what answers it, and the items with its tables.
struct Question {
  std::string_view words;
  std::string (*answer)(const Report& report) = nullptr;
  std::array<std::string_view, 4> items = {};
};

constexpr std::array<Question, 7> kQuestions{{
    {"How is an improvement of BVHs found that helps collision detection in complex environments?",
     improvement,
     {"claim-fallback", "claim-cheaper"}},
    {"Which tree: binary, quad-tree or octree?", kind_of_tree, {"figure-4.16", "table-5.1"}},
    {"Which construction: top-down, bottom-up or insertion?", construction, {"figure-4.28"}},
    {"By which criterion is a branch split?",
     splitting,
     {"claim-single-leaves", "claim-26-percent", "claim-balance", "table-5.3"}},
    {"Why do splitting rules differ in their results?",
     differences,
     {"figure-4.7", "table-5.5", "table-5.11"}},
    {"Which bounding volumes suit?", volumes, {"figure-4.8"}},
    {"Is it faster, by how much, and how is its accuracy measured?",
     speed,
     {"figure-5.6", "claim-enode-faster", "claim-build-8-percent", "drives"}},
}};

std::string links(const Report& report, const Question& question) {
  std::string html;
  for (const std::string_view item : question.items) {
    if (!item.empty() && entry_of(report, item) != nullptr) {
      html += fmt::format("{}<a href=\"#item-{}\">{}</a>", html.empty() ? "" : ", ", item,
                          spoken(item));
    }
  }
  return html;
}

}  // namespace

std::string questions_section(const Report& report) {
  std::string html =
      "<h2 id=\"questions\">The research questions, answered</h2>\n<p class=\"note\">Section 1.2 "
      "of the thesis asks seven; they are shortened here. "
      "Claims stand by the reading nearest to the text.</p>\n<ol class=\"questions\">\n";
  for (const Question& question : kQuestions) {
    const std::string tables = links(report, question);
    html +=
        fmt::format("<li><details><summary><strong>{}</strong></summary>{}{}</details></li>\n",
                    question.words, question.answer(report),
                    tables.empty() ? "" : fmt::format(" <span class=\"faint\">{}</span>", tables));
  }
  return html + "</ol>\n";
}

}  // namespace soms::reproduce
