/// \file
/// A page about an answer: figures, plots, a time line and a view of the scene, in one HTML file
/// that needs nothing else.
#pragma once

#include "apps/report/scene.h"
#include "apps/report/scene_data.h"

#include <ostream>
#include <string>
#include <vector>

namespace soms::report {

/// A named figure of the answer, in words.
struct Fact {
  std::string name;
  std::string value;
};

/// A drawing as SVG without ids, made by us, and what it says. The caption is plain text.
struct Plot {
  std::string svg;
  std::string caption;
};

/// A table of plain texts.
struct Table {
  std::string title;
  std::vector<std::string> columns;
  std::vector<std::vector<std::string>> rows;  ///< a text for each column
  std::string caption = {};
  bool of_gaps = false;     ///< row k is about gap k of the scene, and leads to it
  bool of_motions = false;  ///< the same of motions
};

/// All that a page says. Texts are plain: markup in them is shown, not obeyed.
struct Page {
  std::string title;
  std::string lead;
  std::vector<Fact> facts;
  std::vector<std::string> warnings = {};  ///< reasons to doubt the answer, a box for each
  std::vector<Plot> plots;
  std::vector<Plot> beside = {};  ///< plots that are the answer: they stand beside the scene
  std::vector<Table> tables = {};
  std::vector<std::string> notes;
  Scene scene = {};
};

/// Writes the page, a block at a time. Says what of the scene it had room for, as the page does.
/// \errors Those of `page.scene.pose`.
Shown write_page(std::ostream& out, const Page& page, const SceneLimits& limits = {});

}  // namespace soms::report
