#include "apps/draw/chart.h"
#include "thesis/claims/comparison.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

namespace soms::reproduce {

namespace {

constexpr ColumnKind kTimedColumn = ColumnKind::timed;

Cell whole(std::uint64_t n) {
  return static_cast<std::int64_t>(n);
}

double per(double value, std::uint64_t count) {
  return count > 0 ? value / static_cast<double>(count) : 0;
}

double per(std::uint64_t value, std::uint64_t count) {
  return per(static_cast<double>(value), count);
}

/// Millions of triangles a second.
double rate(const Compared& c, const Timing& timing) {
  return timing.median > 0 ? 1e-3 * static_cast<double>(c.triangles) / timing.median : 0;
}

Table models_table(const std::string& prefix, std::span<const Compared> models) {
  Table table{.id = prefix + "_models",
              .caption =
                  "The models; spread is in decades, between the 5th and the 95th percentile "
                  "of the triangles' longest edges.",
              .columns = {{"model"},
                          {"triangles"},
                          {"longest_side"},
                          {"spread", "decades"},
                          {"mesh", "bytes/triangle"},
                          {"mover"},
                          {"poses"},
                          {"hits"},
                          {"pairs"}}};
  for (const Compared& c : models) {
    const Measured& any = c.builds.front();
    table.rows.push_back({c.model, whole(c.triangles), c.longest_side, c.spread,
                          per(any.mesh_bytes, c.triangles), c.mover, whole(c.queries),
                          whole(any.hits), whole(any.pairs)});
  }
  return table;
}

Table trees_table(const std::string& prefix, std::span<const Compared> models) {
  Table table{.id = prefix + "_trees",
              .caption =
                  "Trees of each rule with the thesis' options and with the product's: size, "
                  "SAH cost, memory, and the time on one thread to build the tree alone, and to "
                  "make a shape that is ready for queries.",
              .columns = {{"model"},
                          {"rule"},
                          {"options"},
                          {"nodes"},
                          {"depth"},
                          {"largest_leaf"},
                          {"undividable"},
                          {"sah_cost"},
                          {"tree", "bytes/triangle"},
                          {"layout", "bytes/triangle"},
                          {"build", "ms", kTimedColumn},
                          {"build_low", "ms", kTimedColumn},
                          {"build_high", "ms", kTimedColumn},
                          {"build_rate", "million triangles/s", kTimedColumn},
                          {"shape", "ms", kTimedColumn},
                          {"shape_rate", "million triangles/s", kTimedColumn}}};
  for (const Compared& c : models) {
    for (const Measured& m : c.builds) {
      table.rows.push_back({c.model, m.build.rule, m.build.options, whole(m.counts.nodes),
                            whole(m.counts.depth), whole(m.counts.largest_leaf),
                            whole(m.counts.undividable), m.sah_cost, per(m.tree_bytes, c.triangles),
                            per(m.layout_bytes, c.triangles), m.build_ms.median,
                            m.build_ms.lower_quartile, m.build_ms.upper_quartile,
                            rate(c, m.build_ms), m.shape_ms.median, rate(c, m.shape_ms)});
    }
  }
  return table;
}

Table visits_table(const std::string& prefix, std::span<const Compared> models) {
  Table table{.id = prefix + "_visits",
              .caption =
                  "What a cube looks at on average: nodes whose box it overlaps, and "
                  "triangles in leaves among them. Expected by the volumes of grown boxes, "
                  "measured by cubes anywhere in the model's box, and by cubes near its "
                  "triangles. Side in percent of the model's longest.",
              .columns = {{"model"},
                          {"rule"},
                          {"options"},
                          {"side", "%"},
                          {"expected_nodes"},
                          {"measured_nodes"},
                          {"expected_triangles"},
                          {"measured_triangles"},
                          {"near_nodes"},
                          {"near_triangles"}}};
  for (const Compared& c : models) {
    for (const Measured& m : c.builds) {
      for (const Measured::AtSide& s : m.sides) {
        table.rows.push_back({c.model, m.build.rule, m.build.options, 100 * s.share,
                              s.expected.nodes, s.anywhere.nodes, s.expected.triangles,
                              s.anywhere.triangles, s.near.nodes, s.near.triangles});
      }
    }
  }
  return table;
}

Table queries_table(const std::string& prefix, std::span<const Compared> models) {
  Table table{.id = prefix + "_queries",
              .caption =
                  "Exact overlap of a mover at poses near the model's triangles, as one "
                  "batch on one thread, by the library's default traversal: work and time a "
                  "pose. Answers are the same for all builds.",
              .columns = {{"model"},
                          {"rule"},
                          {"options"},
                          {"any_box_tests"},
                          {"all_box_tests"},
                          {"all_triangle_tests"},
                          {"any", "us", kTimedColumn},
                          {"all", "us", kTimedColumn}}};
  for (const Compared& c : models) {
    for (const Measured& m : c.builds) {
      table.rows.push_back(
          {c.model, m.build.rule, m.build.options, per(m.any.node_tests, c.queries),
           per(m.all.node_tests, c.queries), per(m.all.triangle_tests, c.queries),
           per(1e3 * m.any_ms.median, c.queries), per(1e3 * m.all_ms.median, c.queries)});
    }
  }
  return table;
}

/// The build by a rule with the product's options.
const Measured* find(const Compared& c, std::string_view rule) {
  const auto at = std::find_if(c.builds.begin(), c.builds.end(), [&](const Measured& m) {
    return m.build.rule == rule && m.build.options == "product";
  });
  return at == c.builds.end() ? nullptr : &*at;
}

/// What the smallest cubes near triangles look at, over the same by SAH with the product's options.
double looks_over_sah(const Compared& c, std::string_view rule) {
  const Measured* m = find(c, rule);
  const Measured* sah = find(c, "sah");
  if (m == nullptr || sah == nullptr) {
    return std::numeric_limits<double>::quiet_NaN();
  }
  return looks(m->sides.front().near) / looks(sah->sides.front().near);
}

/// A build with the product's options that the figures show.
struct ShownBuild {
  std::string_view rule;
  std::string_view title;
};

constexpr std::array kShown{ShownBuild{"spatial_median", "spatial median, goes on"},
                            ShownBuild{"soms", "SOMS"},
                            ShownBuild{"soms_sah", "SOMS with a second look"},
                            ShownBuild{"fast", "library's fast"},
                            ShownBuild{"quality", "library's quality"},
                            ShownBuild{"sah", "SAH"}};

std::vector<std::string> names(std::span<const Compared> models) {
  std::vector<std::string> all;
  for (const Compared& c : models) {
    all.push_back(c.model);
  }
  return all;
}

/// Least and greatest share by which a build looks at more than SAH, in percent.
struct Excess {
  double least = std::numeric_limits<double>::infinity();
  double greatest = -std::numeric_limits<double>::infinity();
  std::string where_least;
  std::string where_greatest;
};

Excess excess(std::span<const Compared> models, std::string_view rule) {
  Excess e;
  for (const Compared& c : models) {
    const double percent = std::round(100 * (looks_over_sah(c, rule) - 1)) + 0.0;
    if (percent < e.least) {
      e.least = percent;
      e.where_least = c.model;
    }
    if (percent > e.greatest) {
      e.greatest = percent;
      e.where_greatest = c.model;
    }
  }
  return e;
}

std::string excess_sentence(std::string_view title, const Excess& e) {
  if (e.where_least == e.where_greatest) {
    return fmt::format("{} looks at {:+.0f} % ({}) against SAH.", title, e.least, e.where_least);
  }
  return fmt::format("{} looks at {:+.0f} % ({}) to {:+.0f} % ({}) against SAH.", title, e.least,
                     e.where_least, e.greatest, e.where_greatest);
}

Figure looks_figure(const std::string& prefix, std::span<const Compared> models) {
  const Excess soms = excess(models, "soms");
  const Excess second = excess(models, "soms_sah");
  BarChart chart{.title = fmt::format("SOMS looks at up to {:.0f} % more than SAH; a "
                                      "second look: {:.0f} %",
                                      soms.greatest, second.greatest),
                 .y_label = "nodes and triangles visited, SAH = 1",
                 .groups = names(models)};
  for (const ShownBuild& shown : kShown) {
    if (shown.rule == "sah") {
      continue;
    }
    Bars bars{.name = std::string(shown.title)};
    for (const Compared& c : models) {
      bars.values.push_back(looks_over_sah(c, shown.rule));
    }
    chart.bars.push_back(std::move(bars));
  }
  return {.id = prefix + "_looks",
          .caption = fmt::format(
              "Nodes and triangles whose boxes a small body looks at (a cube of 0.1 % of the "
              "longest side near the model's triangles), relative to SAH; all builds with the "
              "product's options. {} {}",
              excess_sentence("SOMS", soms), excess_sentence("With a second look it", second)),
          .svg = draw(chart)};
}

Figure rate_figure(const std::string& prefix, std::span<const Compared> models) {
  BarChart chart{.title = "How fast a mesh becomes ready for queries",
                 .y_label = "million triangles a second",
                 .groups = names(models)};
  for (const ShownBuild& shown : kShown) {
    Bars bars{.name = std::string(shown.title)};
    for (const Compared& c : models) {
      const Measured* m = find(c, shown.rule);
      bars.values.push_back(m == nullptr ? std::numeric_limits<double>::quiet_NaN()
                                         : rate(c, m->shape_ms));
    }
    chart.bars.push_back(std::move(bars));
  }
  return {
      .id = prefix + "_build_rate",
      .caption =
          "Rate at which a mesh becomes a shape ready for queries, one thread, median; all builds "
          "with the product's options.",
      .svg = draw(chart),
      .timed = true};
}

/// Greatest difference of expected and measured nodes, over all builds, at one side.
std::string agreement(std::span<const Compared> models) {
  double worst = 0;
  double sum = 0;
  std::size_t count = 0;
  for (const Compared& c : models) {
    for (const Measured& m : c.builds) {
      for (const Measured::AtSide& s : m.sides) {
        const double off = std::abs(s.anywhere.nodes / s.expected.nodes - 1);
        worst = std::max(worst, off);
        sum += off;
        ++count;
      }
    }
  }
  return fmt::format(
      "Expected node visits and those counted in a sample of cubes differ by {:.1f} % on average "
      "and by at most {:.1f} %.",
      100 * per(sum, count), 100 * worst);
}

}  // namespace

Result report(const std::string& prefix, std::span<const Compared> models) {
  if (models.empty()) {
    return {.remarks = {"No model to compare on."}};
  }
  return {.tables = {models_table(prefix, models), trees_table(prefix, models),
                     visits_table(prefix, models), queries_table(prefix, models)},
          .figures = {looks_figure(prefix, models), rate_figure(prefix, models)},
          .remarks = {excess_sentence("SOMS", excess(models, "soms")),
                      excess_sentence("SOMS with a second look", excess(models, "soms_sah")),
                      excess_sentence("Spatial median that goes on by object median",
                                      excess(models, "spatial_median")),
                      excess_sentence("Object median", excess(models, "object_median")),
                      excess_sentence("The library's fast build", excess(models, "fast")),
                      excess_sentence("The library's quality build", excess(models, "quality")),
                      agreement(models)}};
}

}  // namespace soms::reproduce
