// Pruning: what it costs to go down although boxes are apart, in counts and as a picture.
#include "thesis/experiments/experiments.h"
#include "thesis/pictures/side_view.h"
#include "thesis/run/steps.h"
#include "thesis/run/traversal_tables.h"
#include "thesis/trips/frames.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>
#include <utility>

namespace soms::reproduce {

namespace {

/// A frame with the object a quarter inside.
constexpr std::size_t kFrame = 40;

/// Few enough boxes to be drawn.
constexpr int kDrawnLevel = 6;

/// What a traversal did in the frame, and the nodes that it looked at.
struct Visit {
  TraversalCounts counts;
  std::vector<NodePair> leaf_pairs;
  std::set<std::uint32_t> nodes_a;
  std::set<std::uint32_t> nodes_b;
};

Visit visit(const Trip& trip, TraversalOptions options, bool prune, const Limits& limits) {
  options.prune = prune;
  LeafTraversal traversal(trip, options);
  traversal.move(kFrame);
  Visit visit;
  TraversalVisitor visitor;
  visitor.keep_going = [&] {
    check_stop(limits);
    return true;
  };
  visitor.leaf_pair = [&](NodePair p) {
    visit.leaf_pairs.push_back(p);
    return true;
  };
  visitor.tested = [&](NodePair p, bool) {
    visit.nodes_a.insert(p.a);
    visit.nodes_b.insert(p.b);
  };
  visit.counts = traversal.run(visitor);
  std::sort(visit.leaf_pairs.begin(), visit.leaf_pairs.end(),
            [](NodePair p, NodePair q) { return std::pair(p.a, p.b) < std::pair(q.a, q.b); });
  return visit;
}

void add_row(Table& table, const Trip& trip, const NamedTraversal& traversal, bool prune,
             const Visit& visit) {
  std::vector<Cell> row{trip.rule, traversal.name, word_cell(prune ? "on" : "off")};
  add_count_cells(row, visit.counts);
  row.push_back(count_cell(visit.nodes_a.size()));
  row.push_back(count_cell(trip.a.tree()->nodes.size()));
  row.push_back(count_cell(visit.nodes_b.size()));
  table.rows.push_back(std::move(row));
}

void draw_boxes(Svg& svg, const SideView& view, const Tree& tree,
                const std::set<std::uint32_t>& nodes, const Vec3& offset, std::size_t color) {
  std::string path;
  for (const std::uint32_t i : nodes) {
    const Box& box = tree.nodes[i].bounds;
    path += view.box({box.lower + offset, box.upper + offset});
  }
  svg.path(path, fmt::format("class=\"s{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"0.9\"",
                             color, series_color(color)));
}

Figure picture(const Trip& trip, const Visit& on, const Visit& off) {
  const std::string title = "The boxes that a traversal looks at, with pruning and without";
  Box shown = trip.a.bounds();
  const Vec3& offset = trip.offsets[kFrame];
  shown.grow(Box{trip.b.bounds().lower + offset, trip.b.bounds().upper + offset});
  Svg svg(1000, 440, title);
  svg.text({20, 28}, title, {.size = 17, .bold = true});
  double left = 20;
  for (const auto& [words, visit] :
       {std::pair("with pruning", &on), std::pair("without pruning", &off)}) {
    const SideView view(Side::front, shown, {{left, 90}, 470, 330});
    svg.text({left, 58}, words, {.size = 15, .bold = true});
    svg.text(
        {left, 78},
        fmt::format("{} box tests; {} of {} boxes of the still object looked at",
                    visit->counts.box_tests, visit->nodes_a.size(), trip.a.tree()->nodes.size()),
        {.size = 13, .faint = true});
    for (const auto& [mesh, by] :
         {std::pair(&trip.a.mesh(), Vec3{}), std::pair(&trip.b.mesh(), offset)}) {
      svg.path(view.facing(*mesh, by), "class=\"f6\" fill=\"#555\" fill-opacity=\"0.22\"");
    }
    draw_boxes(svg, view, *trip.a.tree(), visit->nodes_a, {}, 0);
    draw_boxes(svg, view, *trip.b.tree(), visit->nodes_b, offset, 1);
    left += 490;
  }
  return {.id = "figure_4_35",
          .caption = fmt::format("Test right, frame {}, SOMS trees of level {}: boxes of the still "
                                 "object (blue) and the moving one (orange) that the simultaneous "
                                 "traversal looks at. With pruning it looks only near the contact.",
                                 kFrame, kDrawnLevel),
          .svg = svg.document()};
}

}  // namespace

Result figure_4_35(const Context& context) {
  const Model& object = context.models.objects.front();
  const std::array traversals{named_traversal("larger"), named_traversal("simultaneous"),
                              named_traversal("enode_both")};
  const std::vector<Contender> builds = thesis_rules(kObjectLevel);
  Table table{
      .id = "figure_4_35_counts",
      .caption = fmt::format("Test right, frame {}, trees of level {}: counts with pruning "
                             "and without; nodes looked at of the still and the moving tree.",
                             kFrame, kObjectLevel),
      .columns = {{"rule"}, {"algorithm"}, {"prune"}}};
  add_count_columns(table);
  for (const char* const name : {"nodes_seen_still", "nodes_still", "nodes_seen_moving"}) {
    table.columns.push_back({name});
  }
  Steps steps(context.limits, builds.size() * traversals.size());
  double least = 0;
  double most = 0;
  for (const Contender& build : builds) {
    const Trip trip = orientation_trip(object, Approach::right, build);
    for (const NamedTraversal& traversal : traversals) {
      const Visit on = visit(trip, traversal.options, true, context.limits);
      const Visit off = visit(trip, traversal.options, false, context.limits);
      require(on.leaf_pairs == off.leaf_pairs,
              fmt::format("{} on {} trees with pruning and without", traversal.name, build.title));
      add_row(table, trip, traversal, true, on);
      add_row(table, trip, traversal, false, off);
      const double ratio = static_cast<double>(off.counts.box_tests) /
                           static_cast<double>(std::max<std::uint64_t>(1, on.counts.box_tests));
      least = least == 0 ? ratio : std::min(least, ratio);
      most = std::max(most, ratio);
      steps.done_one();
    }
  }
  const Trip drawn = orientation_trip(object, Approach::right, thesis_rules(kDrawnLevel).back());
  const TraversalOptions simultaneous = named_traversal("simultaneous").options;
  return {.tables = {std::move(table)},
          .figures = {picture(drawn, visit(drawn, simultaneous, true, context.limits),
                              visit(drawn, simultaneous, false, context.limits))},
          .remarks = {object_remark(object),
                      fmt::format("Both ways report the same pairs of leaves; without pruning they "
                                  "make {:.0f} to {:.0f} times the box tests.",
                                  least, most)}};
}

}  // namespace soms::reproduce
