/// \file
/// The panels: what runs, what is shown, what it took, what was picked, which keys there are.
#pragma once

#include "apps/view/control/frame_times.h"
#include "apps/view/control/session.h"
#include "apps/view/control/widgets.h"
#include "apps/view/drawing/renderer.h"

#include <string>

namespace soms::view {

/// Draws all panels between ImGui::NewFrame and ImGui::Render, and writes what the user chooses to
/// the session's state. Knows no window and no OpenGL.
class Panels {
 public:
  /// `drawn` is of the last frame. \pre A context of Dear ImGui with a frame begun.
  void draw(Session& session, const FrameTimes& times, const DrawStatistics& drawn);

  /// Where each widget stood in the last frame.
  [[nodiscard]] const std::vector<WidgetPlace>& places() const { return widgets_.places(); }

 private:
  void menu_bar(Session& session);
  void sidebar(Session& session, const FrameTimes& times, const DrawStatistics& drawn);
  void time_panel(Session& session);
  void tree_panel(ViewState& state);
  void show_panel(ViewState& state);
  void counts_panel(const Facts& facts);
  void frame_panel(const Facts& facts, const FrameTimes& times, const DrawStatistics& drawn);
  void picked_panel(Session& session);
  void message_line(const Session& session);
  void help(ViewState& state);
  void axis_letters(const Session& session);

  Widgets widgets_;
};

/// What the panels keep for themselves, by the frame begun.
[[nodiscard]] Captured captured();

}  // namespace soms::view
