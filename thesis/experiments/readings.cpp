// What else SOMS might be: other readings of its captions, each with what speaks for it, what it
// counts, and what the thesis' own words or these counts say against it.
//
// Words exclude a reading where the text says something else. Counts exclude none: whatever they
// contradict, SOMS as taken contradicts it too, or there are models on which they do not. They
// speak against a reading, and the models on which they do not are named. The first reading is the
// one that the other experiments take; those that vary the axis or the midpoint say so.
#include "soms/tree/build.h"

#include "apps/draw/grouped_bars.h"
#include "thesis/experiments/experiments.h"
#include "thesis/run/counts.h"
#include "thesis/run/steps.h"
#include "thesis/trees/alternative_rules.h"
#include "thesis/trees/open_options.h"
#include "thesis/trips/object_meshes.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>

namespace soms::reproduce {

namespace {

/// A model's tree by a reading, beside spatial median's with the same midpoints and meshes.
struct Read {
  const Model* model = nullptr;
  int level = 0;
  std::size_t trees = 1;
  TreeStatistics counts = {};
  TreeStatistics spatial = {};

  /// Greatest balanced level that so many triangles and the limit of levels allow.
  [[nodiscard]] std::uint64_t possible_level() const {
    return std::min<std::uint64_t>(
        static_cast<std::uint64_t>(std::bit_width(model->mesh->triangles.size())),
        static_cast<std::uint64_t>(level));
  }
};

/// What became of a reading, and why.
struct Judgment {
  std::string_view stands;  ///< "taken", "open", "against", "excluded by words"
  std::string why;
};

/// A reading of the rule.
struct Reading {
  std::string_view name;
  std::string_view title;
  std::string_view speaks_for;  ///< quotation, with its place
  std::string_view thesis_says;
  Midpoint midpoint = Midpoint::thesis;
  RuleFunction rule = nullptr;  ///< nullptr for SOMS itself, and with `tree`
  AxisFrom axis = AxisFrom::inner;
  Tree (*tree)(const Mesh& mesh, int level) = nullptr;  ///< makes the tree where no rule can
  bool by_object = false;                               ///< a tree for each object of the file
  /// The reading taken comes second. \pre As many of one as of the other.
  Judgment (*judge)(std::span<const Read> own, std::span<const Read> taken) = nullptr;
};

/// Of SOMS on the urban scene. \source thesis, figure 5.5 by its caption.
constexpr std::uint64_t kSceneBalancedLevel = 7;

bool is_scene(const Read& read) {
  return read.level == kSceneLevel;
}

Judgment judge_taken(std::span<const Read> /*own*/, std::span<const Read> /*taken*/) {
  return {"taken",
          "\"between the midpoint of the triangles\" names the box of the midpoints, and the "
          "abstract in Malay says so plainly: object-based spatial median, the middle of space as "
          "the midpoints of the objects span it."};
}

/// "12 on u_mixed, 12 on u_boxes".
std::string levels_of(std::span<const Read> reads) {
  std::string text;
  for (const Read& read : reads) {
    if (is_scene(read)) {
      text += fmt::format("{}{} on {}", text.empty() ? "" : ", ", read.counts.balanced_level,
                          read.model->name);
    }
  }
  return text;
}

/// "bunny, venus": the models that fit.
std::string names_of(std::span<const Read> reads, bool (*fits)(const Read& read)) {
  std::string text;
  for (const Read& read : reads) {
    if (fits(read)) {
      text += fmt::format("{}{}", text.empty() ? "" : ", ", read.model->name);
    }
  }
  return text;
}

/// The models on which a reading has what the abstract claims.
std::string names_with_more(std::span<const Read> reads) {
  return names_of(reads, [](const Read& read) { return read.counts.one > read.spatial.one; });
}

/// Object median in effect. Counts are no evidence: the reading that is taken misses the level of
/// figure 5.5 as well.
Judgment judge_pair(std::span<const Read> own, std::span<const Read> taken) {
  const std::string more = names_with_more(own);
  std::string why = fmt::format(
      "It halves the triangles by count: object median in effect, which figure 4.7 shows apart "
      "from "
      "SOMS, and nothing in it is based on the least and the greatest midpoint. It has more leaves "
      "with one triangle than spatial median on {}, as the abstract has it.",
      more.empty() ? "no model" : more);
  const bool taken_misses = std::none_of(taken.begin(), taken.end(), [](const Read& read) {
    return is_scene(read) && read.counts.balanced_level == kSceneBalancedLevel;
  });
  if (const std::string levels = levels_of(own); !levels.empty()) {
    why += fmt::format(
        " Figure 5.5 has balanced level {} on the scene of the thesis. Here it is {}; "
        "with SOMS as taken {}{}",
        kSceneBalancedLevel, levels, levels_of(taken),
        taken_misses ? ", so the level excludes neither." : ".");
  }
  return {"against", why};
}

/// "95 nodes on bunny (as taken 20)": the models on which more nodes stay whole than as taken.
std::string stuck_words(std::span<const Read> own, std::span<const Read> taken) {
  std::string text;
  for (std::size_t i = 0; i < own.size(); ++i) {
    if (own[i].counts.undividable > taken[i].counts.undividable) {
      text += fmt::format("{}{} on {} (as taken {})", text.empty() ? "" : ", ",
                          words(own[i].counts.undividable), own[i].model->name,
                          words(taken[i].counts.undividable));
    }
  }
  return text;
}

/// It gets stuck where midpoints differ.
Judgment judge_corners(std::span<const Read> own, std::span<const Read> taken) {
  const std::string more = names_with_more(own);
  const std::string stuck = stuck_words(own, taken);
  return {"against",
          fmt::format("One large triangle may hold both corners. The plane is then at its own "
                      "midpoint, and where none is less, one side is empty though midpoints "
                      "differ: the rule needs the fallback that SOMS is to do without. Nodes that "
                      "stay whole: {}. It has more "
                      "leaves with one triangle than spatial median on {}, as the abstract has it.",
                      stuck.empty() ? "no more than as taken on these models" : stuck,
                      more.empty() ? "no model" : more)};
}

/// It begins with another plane.
Judgment judge_hybrid(std::span<const Read> own, std::span<const Read> /*taken*/) {
  std::uint64_t more = 0;
  for (const Read& read : own) {
    more = std::max(more, read.counts.nodes - std::min(read.counts.nodes, read.spatial.nodes));
  }
  return {"excluded by words",
          fmt::format("\"The process starts\" between the midpoints, and this one starts with "
                      "spatial median. Its tree has the nodes of spatial median's, divided by the "
                      "same planes, and up to {} more on these models, so it would hardly be built "
                      "faster, as the abstract has it.",
                      words(more))};
}

Judgment judge_aabb(std::span<const Read> own, std::span<const Read> /*taken*/) {
  const std::string caption =
      "The words are divided: figure 4.23 constructs another point, f between A and B, then the "
      "middle of f and C.";
  const std::string none = names_of(own, [](const Read& read) { return read.counts.one == 0; });
  const std::string more = names_with_more(own);
  const std::string counts = none.empty()
                                 ? std::string()
                                 : fmt::format(
                                       " On {} it has no leaf with one triangle at all: the "
                                       "two triangles of a rectangle share the middle of "
                                       "their box, so no plane parts them.",
                                       none);
  return {
      "against",
      fmt::format(
          "{}{} It has more leaves with one triangle than spatial median with the same midpoint on "
          "{}, as the abstract has it.",
          caption, counts, more.empty() ? "no model" : more)};
}

Judgment judge_centroid(std::span<const Read> own, std::span<const Read> taken) {
  double most = 0;
  for (std::size_t i = 0; i < own.size(); ++i) {
    const double base = static_cast<double>(std::max<std::uint64_t>(1, taken[i].counts.one));
    const double change = 100 * (static_cast<double>(own[i].counts.one) / base - 1);
    most = change * change > most * most ? change : most;
  }
  return {"excluded by words",
          fmt::format("Figure 4.23 constructs another point: f between A and B, then the middle of "
                      "f and C. The counts do not decide: leaves with one triangle change by at "
                      "most {:+.1f} %.",
                      most)};
}

Judgment judge_objects(std::span<const Read> own, std::span<const Read> /*taken*/) {
  if (own.empty()) {
    return {"open", "No model that was given has more than one object."};
  }
  return {"open",
          "Figures 5.4 and 5.5 speak of one balanced level of the whole simulation, which trees of "
          "single objects do not have; section 4.6.2 and table 3.3 leave it open. Claim "
          "claim-26-percent "
          "judges both."};
}

constexpr std::string_view kMidpointQuote =
    "Abstract: \"splitting the longest axis between the midpoint of the triangles based on their "
    "minimum and maximum points\". Abstract in Malay: \"Peraturan Pemecahan Ruang Median "
    "berdasarkan Objek\" (object-based spatial median splitting rule) and \"memotong paksi "
    "terpanjang yang dikira "
    "antara titik tengah segitiga-segitiga berdasarkan titik minimum dan maksimum\" (the longest "
    "axis, computed between the midpoints of the triangles by minimum and maximum).";

constexpr std::array kReadings{
    Reading{.name = "soms",
            .title = "SOMS as taken",
            .speaks_for = kMidpointQuote,
            .thesis_says =
                "Nothing against it. The other experiments take this reading; those that show the "
                "outer axis or another midpoint beside it say so.",
            .judge = judge_taken},
    Reading{.name = "middle_pair",
            .title = "middle pair",
            .speaks_for = "Figure 4.6, caption: \"using the Spatial Midpoint between Midpoints of "
                          "Two Triangles which will become their Separating Plane\", the two being "
                          "those in the middle of the order.",
            .thesis_says =
                "Figure 4.7, caption: \"(a) Splitting at Object Median\" and \"(d) SOMS\" apart; "
                "abstract: \"based on their minimum and maximum points\".",
            .rule = middle_pair,
            .judge = judge_pair},
    Reading{.name = "corner_pair",
            .title = "pair of outermost corners",
            .speaks_for = "Figure 4.6, caption: \"the Spatial Midpoint between Midpoints of Two "
                          "Triangles which will become their Separating Plane\", the two being "
                          "those that hold the \"Minimum and Maximum points\" of figure 4.4.",
            .thesis_says =
                "Section 1.2: \"increasing the level of BVH that can be generated automatically "
                "without using heuristic at the earlier phase\"; abstract: \"so that each of them "
                "can be bounded with single Axis-Aligned Bounding Box\".",
            .tree = corner_pair_tree,
            .judge = judge_corners},
    Reading{
        .name = "spatial_then_soms",
        .title = "spatial median, then SOMS",
        .speaks_for = "Section 1.2: \"without using heuristic at the earlier phase\", which may "
                      "leave SOMS to the later phase, where spatial median stops.",
        .thesis_says = "Abstract: \"The process starts by splitting the longest axis between the "
                       "midpoint of the triangles\"; and SOMS is built 8 % faster than spatial "
                       "median.",
        .rule = spatial_then_soms,
        .axis = AxisFrom::outer,
        .judge = judge_hybrid},
    Reading{.name = "aabb_midpoint",
            .title = "middle of the triangle's box",
            .speaks_for = "Abstract: \"based on their minimum and maximum points\".",
            .thesis_says =
                "Abstract: more leaf nodes with a single triangle; figure 4.23, caption: "
                "\"find the Midpoint between A and B and then calculate The Midpoint "
                "between f and C\".",
            .midpoint = Midpoint::aabb,
            .judge = judge_aabb},
    Reading{.name = "centroid",
            .title = "centroid",
            .speaks_for = "Figure 4.23, caption, which calls its point the center of the triangle.",
            .thesis_says = "Figure 4.23, caption: \"find the Midpoint between A and B and then "
                           "calculate The Midpoint between f and C\".",
            .midpoint = Midpoint::centroid,
            .judge = judge_centroid},
    Reading{.name = "tree_per_object",
            .title = "a tree for each object",
            .speaks_for = "Abstract: \"the total object triangle count for the complex environment "
                          "are 5672 triangles\"; figure 4.27, caption: \"Array for Each Object by "
                          "TreeID\".",
            .thesis_says = "Figure 5.5, caption: one level for the whole urban simulation.",
            .by_object = true,
            .judge = judge_objects},
};

void add(TreeStatistics& sum, const TreeStatistics& one) {
  sum.nodes += one.nodes;
  sum.leaves += one.leaves;
  sum.one += one.one;
  sum.undividable += one.undividable;
  sum.balanced_level = one.balanced_level;
}

TreeStatistics counts_by(const Reading& reading, const Mesh& mesh, int level,
                         const Limits& limits) {
  if (reading.tree != nullptr) {
    check_stop(limits);
    return statistics(reading.tree(mesh, level), options_of(Rule::soms, level, {}));
  }
  if (reading.rule == nullptr) {
    return counts_of(mesh, Rule::soms, level, {.midpoint = reading.midpoint}, limits);
  }
  BuildOptions options = options_of(Rule::soms, level, {.midpoint = reading.midpoint});
  options.axis_from = reading.axis;
  return statistics(build_by(mesh, reading.rule, options, {.threads = 1, .stop = limits.stop}),
                    options);
}

Read read(const Reading& reading, const Leveled& one, std::span<const Mesh> meshes,
          const Limits& limits) {
  Read result{one.model, one.level, meshes.size()};
  for (const Mesh& mesh : meshes) {
    add(result.counts, counts_by(reading, mesh, one.level, limits));
    add(result.spatial,
        counts_of(mesh, Rule::spatial_median, one.level, {.midpoint = reading.midpoint}, limits));
  }
  return result;
}

/// A reading of trees by object is tried only where there are several objects.
std::vector<Read> read_all(const Reading& reading, std::span<const Leveled> models,
                           const Limits& limits) {
  std::vector<Read> all;
  for (const Leveled& one : models) {
    if (!reading.by_object) {
      all.push_back(read(reading, one, {one.model->mesh.get(), 1}, limits));
      continue;
    }
    const std::vector<Mesh> objects = object_meshes(*one.model->mesh);
    if (objects.size() > 1) {
      all.push_back(read(reading, one, objects, limits));
    }
  }
  return all;
}

Table counts_table(const std::string& note) {
  return {.id = "readings",
          .caption =
              "What each reading of SOMS counts, beside spatial median with the same "
              "midpoints: leaves with one triangle, nodes, balanced level and the greatest "
              "that the triangles and the level allow. Level 15 for objects, 13 for scenes, "
              "empty side stop; sums over the trees where there are several." +
              note,
          .columns = {{"reading"},
                      {"model"},
                      {"trees"},
                      {"one"},
                      {"spatial_median_one"},
                      {"nodes"},
                      {"spatial_median_nodes"},
                      {"balanced_level"},
                      {"possible_level"},
                      {"stands"}}};
}

void add_row(Table& table, const Reading& reading, const Read& read, std::string_view stands) {
  const auto count = [](std::uint64_t n) { return Cell{static_cast<std::int64_t>(n)}; };
  const bool one_tree = read.trees == 1;
  table.rows.push_back({std::string(reading.name), read.model->name, count(read.trees),
                        count(read.counts.one), count(read.spatial.one), count(read.counts.nodes),
                        count(read.spatial.nodes),
                        one_tree ? count(read.counts.balanced_level) : Cell{},
                        one_tree ? count(read.possible_level()) : Cell{}, std::string(stands)});
}

}  // namespace

Result readings(const Context& context) {
  const std::vector<Leveled> models = at_greatest_level(context.models);
  Table counts = counts_table(note_on_stand_ins(context.models.objects) +
                              note_on_stand_ins(context.models.scenes));
  Table reasons{.id = "readings_reasons",
                .caption =
                    "What speaks for each reading of SOMS, what the thesis says against it, "
                    "and how it stands: taken, open, against (something speaks against it, nothing "
                    "excludes it), or excluded by words.",
                .columns = {{"reading"}, {"speaks_for"}, {"thesis_says"}, {"stands"}, {"why"}}};
  std::vector<Datum> data;
  std::vector<Read> taken;
  Steps steps(context.limits, kReadings.size());
  for (const Reading& reading : kReadings) {
    const std::vector<Read> own = read_all(reading, models, steps.quiet());
    taken = taken.empty() ? own : taken;
    const Judgment judgment = reading.judge(own, taken);
    for (const Read& one : own) {
      add_row(counts, reading, one, judgment.stands);
      const double triangles =
          static_cast<double>(std::max<std::size_t>(1, one.model->mesh->triangles.size()));
      data.push_back({label_of(*one.model), std::string(reading.title),
                      100 * static_cast<double>(one.counts.one) / triangles});
    }
    reasons.rows.push_back({std::string(reading.name), std::string(reading.speaks_for),
                            std::string(reading.thesis_says), std::string(judgment.stands),
                            judgment.why});
    steps.done_one();
  }
  return {.tables = {std::move(reasons), std::move(counts)},
          .figures = {{.id = "readings",
                       .caption = "Triangles alone in a leaf by each reading of SOMS, at level 15 "
                                  "for objects and 13 for scenes, with empty side stop. A tree for "
                                  "each object is tried where a file has several.",
                       .svg = draw(grouped_bars("What each reading of SOMS leaves alone",
                                                "% of all triangles", data))}}};
}

}  // namespace soms::reproduce
