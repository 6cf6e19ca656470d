/// \file
/// Words and colors of the panels.
#pragma once

#include "apps/view/control/subject.h"
#include "apps/view/control/view_state.h"

#include <string>
#include <utility>
#include <vector>

namespace soms::view {

/// Labels and values of what the last step took, and of what the boxes shown stand for.
[[nodiscard]] std::vector<std::pair<std::string, std::string>> cost_rows(const Facts& facts);

/// E-Node's descent where that is chosen, and what of the trees is not as by default.
[[nodiscard]] std::string tree_line(const ViewState& state);

/// True if all of the words in `wanted`, in either case, are in `text`.
[[nodiscard]] bool has_words(const std::string& text, const std::string& wanted);

/// The color of a bar: that of what it stands for in the scene.
[[nodiscard]] Color color_of(const TreeBars& tree, TreeBars::Look state);

/// When an event is: "frame 7" or "frames 3 to 9".
[[nodiscard]] std::string times_of(const ContactEvent& event);

/// An event in two lines: who touches whom, and when and how much.
[[nodiscard]] std::string words_of(const ContactEvent& event);

/// True while an event was wished for that is not yet found, or not yet over.
[[nodiscard]] bool awaits_event(const ViewState& state);

/// What a window without panels says of events: how far the search for the next is, or the event
/// that is looked at; else nothing.
[[nodiscard]] std::string event_line(const ViewState& state, const EventList& list);

}  // namespace soms::view
