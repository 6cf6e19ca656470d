#include "apps/soms/thesis/thesis_output.h"

#include "soms/base/text.h"
#include "soms/thesis/thesis_frames.h"
#include "soms/thesis/traversals.h"
#include "soms/tree/option_names.h"
#include "soms/tree/rule/rules.h"

#include "apps/cli/kebab.h"
#include "apps/cli/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string_view>

namespace soms::command {

namespace {

std::string cell(const std::optional<std::size_t>& frame) {
  return frame ? std::to_string(*frame) : std::string("-");
}

/// Times are of microseconds and more.
std::string time_cell(double ms) {
  return ms > 0 ? fmt::format("{:.3f}", ms) : std::string("-");
}

std::string rate_cell(double fps) {
  return fps > 0 ? fmt::format("{:.{}f}", fps, fps < 100 ? 1 : 0) : std::string("-");
}

std::string model_in_words(const std::string& title, const Shape& shape) {
  return fmt::format("{}, {}", printable(title),
                     counted(shape.mesh().triangles.size(), "triangle"));
}

std::string which_moves(const ThesisTrip& what) {
  const reproduce::Trip& trip = what.trip;
  const std::string still = model_in_words(what.still_title, trip.a);
  const std::string moving = model_in_words(what.moving_title, trip.b);
  if (trip.test == kDriveTest) {
    return fmt::format("{}\n  drives through {}\n", moving, still);
  }
  const std::string side = trip.test == "top"      ? "from above"
                           : trip.test == "bottom" ? "from below"
                                                   : "from the " + trip.test;
  return fmt::format("{}\n  comes {} at {}\n", moving, side,
                     what.moving_title == what.still_title ? "its like" : still);
}

std::string tree_line(const std::string& name, const Shape& shape, const LevelsOfTree& levels) {
  const LevelOfTree last = last_level(*shape.tree(), levels);
  return fmt::format(
      "  tree of {}: level {} has {}, levels above have {}\n", printable(name), last.level,
      last.boxes == 1 ? "1 box" : with_commas(last.boxes) + " boxes",
      last.leaves_above == 1 ? "1 leaf" : with_commas(last.leaves_above) + " leaves");
}

std::string trees(const ThesisTrip& what) {
  const reproduce::Trip& trip = what.trip;
  return tree_line(trip.still, trip.a, what.still_levels) +
         (trip.a.tree() == trip.b.tree() ? std::string()
                                         : tree_line(trip.moving, trip.b, what.moving_levels));
}

constexpr const char* kFrameForm = "{:>7}{:>13}{:>15}{:>12}{:>16}{:>10}{:>11}{:>10}";

std::string frame_table(const ThesisResult& result, bool all) {
  std::string text =
      table_line(fmt::format(kFrameForm, "frame", "box tests", "pairs entered", "leaf pairs",
                             "triangle tests", "contacts", "ms", "FPS"));
  for (std::size_t k = 0; k < result.frames.size(); ++k) {
    const reproduce::Frame& frame = result.frames[k];
    if (all || frame.roots_overlap) {
      const double ms = result.ms[k];
      text += table_line(fmt::format(
          kFrameForm, k, with_commas(frame.counts.box_tests), with_commas(frame.counts.entered),
          with_commas(frame.counts.leaf_pairs), with_commas(frame.triangle_tests),
          with_commas(frame.contacts.size()), time_cell(ms), rate_cell(ms > 0 ? 1000 / ms : 0)));
    }
  }
  return text;
}

std::string event(const std::string& what, const std::optional<std::size_t>& frame) {
  return frame ? fmt::format("{} in frame {}", what, *frame) : what + " in no frame";
}

std::string sentence_of_rate(double fps) {
  const std::string_view word = interactive_word(fps);
  return word == "within" ? std::string("within the 30 to 60 that the thesis calls interactive")
                          : fmt::format("{} the 30 to 60 that the thesis calls interactive", word);
}

std::string summary_in_text(const ThesisResult& result) {
  const ThesisSummary& summary = result.summary;
  const std::size_t last = result.frames.size() - 1;
  std::string text = fmt::format("{}, {}, {}\n", event("roots overlap first", summary.first_root),
                                 event("leaves", summary.first_leaf),
                                 event("triangles touch", summary.first_contact));
  text += fmt::format("contacts: {} of triangles in the last frame, {}\n",
                      counted(summary.last_contacts, "pair"), last);
  if (summary.mean_ms > 0) {
    text += fmt::format(
        "collision in frames with overlapping roots: mean {:.3f} ms, median {:.3f} ms, longest "
        "{:.3f} ms\n"
        "that is {} FPS, {}\n",
        summary.mean_ms, summary.median_ms, summary.max_ms, rate_cell(summary.fps()),
        sentence_of_rate(summary.fps()));
  }
  return text;
}

constexpr const char* kSummaryForm =
    "{:<{}}  {:<7}{:>7}{:>6}{:>6}{:>9}{:>12}{:>15}{:>12}{:>16}{:>10}{:>10}{:>11}{:>10}{:>9}";

std::string summary_table(const ThesisReport& report) {
  std::size_t width = 5;
  for (const ThesisResult& result : report.results) {
    width = std::max(width, result.what.trip.moving.size());
  }
  std::string text = table_line(fmt::format(kSummaryForm, "model", width, "test", "frames", "root",
                                            "leaf", "contact", "box tests", "pairs entered",
                                            "leaf pairs", "triangle tests", "contacts", "mean ms",
                                            "median ms", "max ms", "FPS"));
  for (const ThesisResult& result : report.results) {
    const ThesisSummary& summary = result.summary;
    text += table_line(fmt::format(
        kSummaryForm, printable(result.what.trip.moving), width, result.what.trip.test,
        result.frames.size(), cell(summary.first_root), cell(summary.first_leaf),
        cell(summary.first_contact), with_commas(summary.sums.counts.box_tests),
        with_commas(summary.sums.counts.entered), with_commas(summary.sums.counts.leaf_pairs),
        with_commas(summary.sums.triangle_tests), with_commas(summary.last_contacts),
        time_cell(summary.mean_ms), time_cell(summary.median_ms), time_cell(summary.max_ms),
        rate_cell(summary.fps())));
  }
  return text +
         "root, leaf, contact: the first frame in which roots overlap, leaves overlap, "
         "triangles touch; contacts: pairs of triangles that touch in the last frame\n";
}

/// How many tests are below, within and above what the thesis calls interactive.
std::string rates_in_text(const std::vector<ThesisResult>& results) {
  std::size_t below = 0;
  std::size_t above = 0;
  std::size_t timed = 0;
  for (const ThesisResult& result : results) {
    const double fps = result.summary.fps();
    timed += fps > 0 ? 1U : 0U;
    below += fps > 0 && interactive_word(fps) == "below" ? 1U : 0U;
    above += fps > 0 && interactive_word(fps) == "above" ? 1U : 0U;
  }
  return fmt::format(
      "of {}, {} below, {} within and {} above the 30 to 60 FPS that the thesis "
      "calls interactive\n",
      counted(timed, "test"), below, timed - below - above, above);
}

/// Models by their titles, each once.
std::string titles_in_text(const std::vector<ThesisResult>& results) {
  std::vector<std::string> lines;
  const auto add = [&](const std::string& name, const std::string& title, const Shape& shape) {
    const std::string line = fmt::format("{}: {}\n", printable(name), model_in_words(title, shape));
    if (std::find(lines.begin(), lines.end(), line) == lines.end()) {
      lines.push_back(line);
    }
  };
  for (const ThesisResult& result : results) {
    const ThesisTrip& what = result.what;
    add(what.trip.still, what.still_title, what.trip.a);
    add(what.trip.moving, what.moving_title, what.trip.b);
  }
  std::string text;
  for (const std::string& line : lines) {
    text += line;
  }
  return text;
}

std::string about_times(const ThesisOptions& options) {
  return fmt::format(
      "times are those of this machine: processor time of one thread for traversal "
      "and triangle tests, without moving boxes and drawing, median of {}\n",
      counted(static_cast<std::uint64_t>(options.repetitions), "run"));
}

}  // namespace

std::string thesis_options_in_words(const ThesisOptions& options) {
  const BuildOptions& build = options.build;
  std::string text = fmt::format("rule {}", entry(build.rule).kebab);
  const auto uses = [&](std::string_view field) {
    const std::vector<IdleOption> idle = idle_options(BuildOptions{.rule = build.rule,
                                                                   .midpoint = Midpoint::thesis,
                                                                   .c_vertex = 1,
                                                                   .empty_side = EmptySide::stop});
    return std::none_of(idle.begin(), idle.end(),
                        [&](const IdleOption& option) { return option.name == field; });
  };
  if (uses("midpoint")) {
    text += fmt::format(", midpoint {}, empty side {}", kebab(name(build.midpoint)),
                        kebab(name(build.empty_side)));
  }
  text += fmt::format(", {} of at most {}", "leaves",
                      counted(static_cast<std::uint64_t>(build.per_leaf), "triangle"));
  const TraversalOptions& traversal = options.traversal;
  text += fmt::format("; traversal {}", entry(traversal.traversal).kebab);
  if (has_descent(traversal.traversal)) {
    text += fmt::format(", descent {}", entry(traversal.descent).kebab);
  }
  return text;
}

LevelOfTree last_level(const Tree& tree, const LevelsOfTree& levels) {
  int depth = 0;
  for (const Node& node : tree.nodes) {
    depth = std::max(depth, static_cast<int>(node.depth));
  }
  if (levels.last > 0) {
    depth = std::min(depth, levels.last - levels.root);
  }
  LevelOfTree last{.level = depth + levels.root};
  for (const Node& node : tree.nodes) {
    const int of_node = static_cast<int>(node.depth);
    last.boxes += of_node == depth ? 1U : 0U;
    last.leaves_above += of_node < depth && node.is_leaf() ? 1U : 0U;
  }
  return last;
}

std::string thesis_text(const ThesisReport& report) {
  const std::string options = "trees: " + thesis_options_in_words(report.options) + "\n";
  if (report.results.size() == 1) {
    const ThesisResult& result = report.results.front();
    return which_moves(result.what) + options + trees(result.what) +
           frame_table(result, report.options.all_frames) + summary_in_text(result) +
           about_times(report.options);
  }
  std::string text = titles_in_text(report.results) + options + summary_table(report) +
                     rates_in_text(report.results);
  return text + about_times(report.options);
}

}  // namespace soms::command
