// Figure 5.1: the testing procedure, as steps of this program.
#include "apps/draw/svg.h"
#include "thesis/experiments/experiments.h"
#include "thesis/run/traversal_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace soms::reproduce {

namespace {

/// A step of the procedure: a section of chapter 5 and the items that are its tests.
struct Stage {
  std::string_view name;
  std::string_view heading;  ///< of the thesis
  std::string_view items;    ///< of this program, separated by spaces
};

/// \source thesis, headings of chapter 5.
constexpr std::array kStages{
    Stage{"Models", "3.9 Testing controlled environment", "table-3.1 table-3.3"},
    Stage{"Trees of the objects", "5.2 PLY object BVH tree construction test",
          "figure-5.2 figure-5.3 table-5.1 table-5.2 table-5.3 table-5.4 table-5.5"},
    Stage{"Trees of the urban scene", "5.3 Construction of complex environment BVH",
          "figure-5.4 figure-5.5 table-5.6 table-5.7 table-5.8 table-5.9"},
    Stage{"Traversals", "5.4 Traversal testing",
          "table-3.2 figure-5.6 figure-5.7 figure-5.8 table-5.10 table-5.11"},
    Stage{"E-Node", "5.5 Introduction of E-Node", "figure-5.9 figure-5.10"},
};

std::vector<const Experiment*> items_of(const Stage& stage) {
  std::vector<const Experiment*> items;
  for (std::size_t from = 0; from < stage.items.size();) {
    const std::size_t end = std::min(stage.items.find(' ', from), stage.items.size());
    const std::string_view item = stage.items.substr(from, end - from);
    const std::vector<const Experiment*> named = experiments_named(std::span(&item, 1));
    items.insert(items.end(), named.begin(), named.end());
    from = end + 1;
  }
  return items;
}

std::string draw_stages(const std::string& title) {
  constexpr double kLine = 20;
  double height = 56;
  for (const Stage& stage : kStages) {
    height += 44 + kLine * static_cast<double>(std::max<std::size_t>(2, items_of(stage).size()));
  }
  Svg svg(1000, height, title);
  svg.text({20, 30}, title, {.size = 17, .bold = true});
  double y = 50;
  for (const Stage& stage : kStages) {
    const std::vector<const Experiment*> items = items_of(stage);
    const double box = 18 + kLine * static_cast<double>(std::max<std::size_t>(2, items.size()));
    svg.rect({20, y}, 960, box, "class=\"f5\" fill=\"#56b4e9\" fill-opacity=\"0.14\" rx=\"6\"");
    svg.text({36, y + 26}, stage.name, {.size = 15, .bold = true});
    svg.text({36, y + 46}, stage.heading, {.size = 12, .faint = true});
    for (std::size_t k = 0; k < items.size(); ++k) {
      const double line = y + 24 + kLine * static_cast<double>(k);
      svg.text({400, line}, items[k]->item, {.size = 13, .bold = true});
      svg.text({500, line}, items[k]->title, {.size = 13});
    }
    y += box;
    if (&stage != &kStages.back()) {
      svg.path(PathData().move({200, y + 2}).line({200, y + 22}).data(),
               "class=\"axis\" stroke=\"#1d1f21\" stroke-width=\"2\" fill=\"none\"");
      svg.path(PathData().move({194, y + 15}).line({200, y + 23}).line({206, y + 15}).data(),
               "class=\"axis\" stroke=\"#1d1f21\" stroke-width=\"2\" fill=\"none\"");
    }
    y += 26;
  }
  return svg.document();
}

}  // namespace

Result figure_5_1(const Context&) {
  Table table{.id = "figure_5_1_steps",
              .caption =
                  "Steps of the testing procedure by headings of the thesis, and the items "
                  "of this program that are its tests.",
              .columns = {{"step"}, {"name"}, {"heading"}, {"item"}, {"title"}}};
  std::string alt;
  for (std::size_t k = 0; k < kStages.size(); ++k) {
    alt += fmt::format("{}: {}. ", k + 1, kStages[k].name);
    for (const Experiment* const item : items_of(kStages[k])) {
      table.rows.push_back({count_cell(k + 1), word_cell(kStages[k].name),
                            word_cell(kStages[k].heading), word_cell(item->item),
                            word_cell(item->title)});
    }
  }
  return {
      .tables = {std::move(table)},
      .figures = {{.id = "figure_5_1",
                   .caption = "The testing procedure: sections of the thesis, in order, and the "
                              "items of this program that run them again. The chart of the "
                              "thesis itself was not available to us.",
                   .svg = draw_stages("Testing procedure"),
                   .alt = alt}}};
}

}  // namespace soms::reproduce
