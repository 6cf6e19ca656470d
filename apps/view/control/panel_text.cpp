#include "apps/view/control/panel_text.h"

#include "apps/support/look.h"
#include "apps/support/text.h"
#include "apps/view/scene/view_options.h"

#include <algorithm>
#include <cctype>
#include <sstream>

namespace soms::view {

namespace {

std::string in_lower_case(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](char c) {
    return static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  });
  return text;
}

}  // namespace

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
  return event.begin == event.end ? "frame " + command::with_commas(event.begin)
                                  : "frames " + command::with_commas(event.begin) + " to " +
                                        command::with_commas(event.end);
}

std::string words_of(const ContactEvent& event) {
  return event.title + "\n   " + times_of(event) + ", at most " +
         command::with_commas(event.most_pairs) + (event.most_pairs == 1 ? " pair" : " pairs") +
         ", in frame " + command::with_commas(event.most_frame);
}

std::string event_line(const ViewState& state, const EventList& list) {
  const auto count = [](std::uint64_t n) { return command::with_commas(n); };
  if (state.requests.event_step != 0) {
    return count(list.searched) + " of " + count(list.frames) + " frames searched";
  }
  if (!state.at_event || !state.event || *state.event >= list.rows.size()) {
    return {};
  }
  const ContactEvent& event = list.rows[*state.event];
  return "event " + count(*state.event + 1) + " of " + count(list.rows.size()) +
         (list.done() ? ": " : " so far: ") + event.title + ", " + times_of(event);
}

}  // namespace soms::view
