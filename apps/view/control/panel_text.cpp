#include "apps/view/control/panel_text.h"

#include "soms/thesis/traversals.h"
#include "soms/tree/option_names.h"

#include "apps/cli/text.h"
#include "apps/draw/look.h"
#include "apps/view/scene/view_options.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdio>
#include <sstream>

namespace soms::view {

namespace {

std::string in_lower_case(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](char c) {
    return static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  });
  return text;
}

std::string milliseconds(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.3g ms", value);
  return text.data();
}

}  // namespace

std::vector<std::pair<std::string, std::string>> cost_rows(const Facts& facts) {
  const auto counted = [](bool cut, std::uint64_t count) {
    return (cut ? "at least " : "") + command::with_commas(count);
  };
  const bool cut = facts.cost_cut;
  std::vector<std::pair<std::string, std::string>> rows{
      {"Collision", (cut ? "at least " : "") + milliseconds(facts.collision_ms)},
      {"Box tests", counted(cut, facts.cost.node_tests)},
      {"Triangle tests", counted(cut, facts.cost.triangle_tests)},
      {"Exact tests", counted(cut, facts.cost.exact_tests)}};
  if (facts.entered) {
    rows.emplace_back("Pairs entered", counted(cut, *facts.entered));
  }
  if (facts.traversed) {
    rows.emplace_back("Object: entered", counted(facts.trace_cut, facts.visited));
    rows.emplace_back("Object: pruned", counted(facts.trace_cut, facts.pruned));
    rows.emplace_back("Object: leaf pairs", counted(facts.trace_cut, facts.found));
  }
  return rows;
}

std::string tree_line(const ViewState& state) {
  std::vector<std::string> parts;
  if (has_descent(state.traversal)) {
    parts.push_back(fmt::format("descent {}", entry(descent_of(state)).kebab));
  }
  BuildOptions tree = state.tree;
  tree.rule = state.rule;
  tree = without_idle(tree);
  const BuildOptions usual;
  if (tree.per_leaf != usual.per_leaf) {
    parts.push_back(fmt::format("leaf {}", tree.per_leaf));
  }
  if (tree.level != usual.level) {
    parts.push_back(command::counted(static_cast<std::uint64_t>(tree.level), "level"));
  }
  if (tree.midpoint != usual.midpoint) {
    parts.push_back(fmt::format("midpoint {}", soms::name(tree.midpoint)));
  }
  if (tree.empty_side != usual.empty_side) {
    parts.push_back(fmt::format("empty side {}", soms::name(tree.empty_side)));
  }
  return fmt::format("{}", fmt::join(parts, ", "));
}

bool has_words(const std::string& text, const std::string& wanted) {
  const std::string all = in_lower_case(text);
  std::istringstream words(in_lower_case(wanted));
  for (std::string word; words >> word;) {
    if (all.find(word) == std::string::npos) {
      return false;
    }
  }
  return true;
}

Color color_of(const TreeBars& tree, TreeBars::Look state) {
  const ViewColors colors;
  switch (state) {
    case TreeBars::Look::untouched:
      return color_of(look::kLine.light);
    case TreeBars::Look::pruned:
      return colors.pruned;
    case TreeBars::Look::visited:
      return colors.visited;
    case TreeBars::Look::found:
      return colors.found;
    case TreeBars::Look::now:
      return tree.now;
  }
  return {};
}

std::string times_of(const ContactEvent& event) {
  if (event.after > 0) {
    return fmt::format("frame {} + {:.2f}", command::with_commas(event.begin), event.after);
  }
  return event.begin == event.end ? "frame " + command::with_commas(event.begin)
                                  : "frames " + command::with_commas(event.begin) + " to " +
                                        command::with_commas(event.end);
}

std::string words_of(const ContactEvent& event) {
  if (event.after > 0) {
    return event.title + "\n   " + times_of(event) + ", between two frames";
  }
  return event.title + "\n   " + times_of(event) + ", at most " +
         command::with_commas(event.most_pairs) + (event.most_pairs == 1 ? " pair" : " pairs") +
         ", in frame " + command::with_commas(event.most_frame);
}

bool awaits_event(const ViewState& state) {
  return state.requests.event_step != 0 || state.requests.event;
}

std::string event_line(const ViewState& state, const EventList& list) {
  const auto count = [](std::uint64_t n) { return command::with_commas(n); };
  if (awaits_event(state)) {
    return count(list.searched) + " of " + count(list.frames) + " frames searched" +
           (state.requests.event ? "; this contact still goes on" : "");
  }
  if (!state.at_event || !state.event || *state.event >= list.rows.size()) {
    return {};
  }
  const ContactEvent& event = list.rows[*state.event];
  return "event " + count(*state.event + 1) + " of " + count(list.rows.size()) +
         (list.done() ? ": " : " so far: ") + event.title + ", " + times_of(event);
}

}  // namespace soms::view
