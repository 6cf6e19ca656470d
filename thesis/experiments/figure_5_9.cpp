// E-Node explained: in which order it tests and enters pairs, beside the simultaneous traversal,
// drawn from runs on two small trees.
#include "thesis/experiments/experiments.h"
#include "thesis/pictures/side_view.h"
#include "thesis/run/traversal_tables.h"
#include "thesis/trips/traversal_course.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

namespace soms::reproduce {

namespace {

/// Boxes share corners, so each depth has its own: roots above the box, leaves in the upper left,
/// what is between in the lower right.
Spot label_place(const SideView& view, const Node& node) {
  const Spot upper_left = view({node.bounds.lower.x, node.bounds.upper.y, 0});
  const Spot lower_right = view({node.bounds.upper.x, node.bounds.lower.y, 0});
  if (node.depth == 0) {
    return {(upper_left.x + lower_right.x) / 2, upper_left.y - 5};
  }
  return node.is_leaf() ? Spot{upper_left.x + 4, upper_left.y + 14}
                        : Spot{lower_right.x - 13, lower_right.y - 5};
}

void draw_bodies(Svg& svg, const ToyPair& toy) {
  Box shown = toy.boxes_a.boxes().front();
  shown.grow(toy.boxes_b.boxes().front());
  const SideView view(Side::front, shown, {{40, 76}, 880, 206});
  const auto draw_one = [&](const Mesh& mesh, const Tree& tree, std::size_t color) {
    const auto paint = series_color(color);
    svg.path(view.facing(mesh, {}),
             fmt::format("class=\"f{0}\" fill=\"{1}\" fill-opacity=\"0.35\"", color, paint));
    for (const Node& node : tree.nodes) {
      svg.path(view.box(node.bounds),
               fmt::format("class=\"s{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"{}\"{}", color,
                           paint, node.depth == 0 ? "2" : "1.2",
                           node.is_leaf() ? "" : " stroke-dasharray=\"6 4\""));
    }
    for (const Node& node : tree.nodes) {
      svg.text(label_place(view, node), std::to_string(node.id),
               {.size = 13, .bold = node.is_leaf(), .haloed = true});
    }
  };
  draw_one(toy.mesh_a, toy.tree_a, 0);
  draw_one(toy.mesh_b, toy.tree_b, 1);
}

/// Places of the pairs on the page: a row for each depth, under their parents.
std::vector<Spot> places(const Course& course, double top) {
  constexpr double kLeft = 30;
  constexpr double kWidth = 900;
  constexpr double kRow = 82;
  std::vector<std::vector<std::size_t>> children(course.stories.size());
  std::vector<Spot> spots(course.stories.size());
  for (std::size_t i = 1; i < course.stories.size(); ++i) {
    children[course.stories[i].parent].push_back(i);
  }
  for (auto& family : children) {
    std::sort(family.begin(), family.end(), [&](std::size_t one, std::size_t other) {
      const NodePair p = course.stories[one].pair;
      const NodePair q = course.stories[other].pair;
      return std::pair(p.a, p.b) < std::pair(q.a, q.b);
    });
  }
  spots[0] = {kLeft + kWidth / 2, top};
  std::vector<std::size_t> row = children[0];
  for (double y = top + kRow; !row.empty(); y += kRow) {
    std::vector<std::size_t> next;
    const double step = kWidth / static_cast<double>(row.size());
    for (std::size_t i = 0; i < row.size(); ++i) {
      spots[row[i]] = {kLeft + step * (static_cast<double>(i) + 0.5), y};
      next.insert(next.end(), children[row[i]].begin(), children[row[i]].end());
    }
    row = std::move(next);
  }
  return spots;
}

void draw_pair(Svg& svg, const ToyPair& toy, const Story& story, Spot at) {
  const std::string_view look =
      story.reported > 0 ? "fill=\"#d55e00\" class=\"f1\" stroke=\"#d55e00\" stroke-width=\"2\""
      : story.overlap
          ? "fill=\"#fff\" class=\"paper s0\" stroke=\"#0072b2\" stroke-width=\"2.5\""
          : "fill=\"#fff\" class=\"paper axis\" stroke=\"#9aa0a6\" stroke-width=\"1.2\" "
            "stroke-dasharray=\"3 3\"";
  svg.circle(at, 16, look);
  svg.text({at.x, at.y + 4}, pair_words(toy, story.pair), {.size = 12, .anchor = Anchor::middle});
  svg.text({at.x + 14, at.y - 14}, fmt::format("{}", story.tested),
           {.size = 14, .bold = true, .haloed = true});
  if (story.entered > 0) {
    svg.text({at.x - 16, at.y - 14}, fmt::format("e{}", story.entered),
             {.size = 12, .anchor = Anchor::end, .faint = true, .haloed = true});
  }
}

void draw_course(Svg& svg, const ToyPair& toy, const Course& course, double top) {
  svg.text({30, top}, course.name, {.size = 16, .bold = true});
  svg.text({30, top + 22}, fmt::format("{} tests, {} pairs entered,", course.counts.box_tests,
                                       course.counts.entered));
  svg.text({30, top + 42},
           fmt::format("first overlap of leaves after {} tests", course.counts.first_tests));
  const std::vector<Spot> spots = places(course, top + 30);
  for (std::size_t i = 1; i < course.stories.size(); ++i) {
    svg.line(spots[course.stories[i].parent], spots[i],
             "class=\"grid\" stroke=\"#c8ccd0\" stroke-width=\"1.2\"");
  }
  for (std::size_t i = 0; i < course.stories.size(); ++i) {
    draw_pair(svg, toy, course.stories[i], spots[i]);
  }
}

Figure drawing(const ToyPair& toy, const std::array<Course, 2>& courses) {
  const std::string title = "E-Node tests a whole family before it enters any of it";
  Svg svg(960, 830, title);
  svg.text({30, 30}, title, {.size = 18, .bold = true});
  svg.text({30, 52},
           "Two bodies, their boxes and TreeIDs (blue: still, orange: moving; dashed: inner nodes)",
           {.size = 13, .faint = true});
  draw_bodies(svg, toy);
  draw_course(svg, toy, courses[0], 320);
  draw_course(svg, toy, courses[1], 560);
  svg.lines(
      {30, 802},
      {"Circles: pairs of nodes, still|moving. Tests are numbered at the right of the circles, "
       "entries (e) at the left.",
       "Ring: boxes overlap; dashed: apart; filled: two leaves that overlap."},
      {.size = 13, .faint = true});
  return {.id = "figure_5_9",
          .caption =
              "E-Node beside the simultaneous traversal on two trees of four triangles, drawn "
              "from runs: the same tests in another order, fewer pairs entered.",
          .svg = svg.document()};
}

Table event_table(const ToyPair& toy, const std::array<Course, 2>& courses) {
  Table table{.id = "figure_5_9_steps",
              .caption =
                  "Both traversals step by step on the small trees; pairs are TreeIDs of the "
                  "still and the moving node.",
              .columns = {{"algorithm"}, {"step"}, {"what"}, {"pair"}, {"outcome"}}};
  for (const Course& course : courses) {
    for (std::size_t i = 0; i < course.events.size(); ++i) {
      const Event& event = course.events[i];
      table.rows.push_back(
          {course.name, count_cell(i + 1), event.what, pair_words(toy, event.pair), event.outcome});
    }
  }
  return table;
}

}  // namespace

Result figure_5_9(const Context& context) {
  check_stop(context.limits);
  const ToyPair toy;
  const std::array courses{record(toy, "simultaneous", {.traversal = Traversal::simultaneous}),
                           record(toy, "E-Node", {.traversal = Traversal::e_node})};
  require(courses[0].counts.leaf_pairs == courses[1].counts.leaf_pairs,
          "E-Node and the simultaneous traversal on the small trees");
  return {.tables = {event_table(toy, courses)},
          .figures = {drawing(toy, courses)},
          .remarks = {"The thesis names E-Node (\"Earlier Node detection\") in captions without "
                      "pseudo code. Our reconstruction: all child pairs of a pair are tested "
                      "before any is entered, and a pair is entered only if its boxes overlap."}};
}

}  // namespace soms::reproduce
