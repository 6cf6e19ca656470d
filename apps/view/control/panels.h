/// \file
/// The panels: what runs, what is shown, what it took, what was picked, which keys there are.
#pragma once

#include "apps/view/control/frame_rates.h"
#include "apps/view/control/frame_times.h"
#include "apps/view/control/row_filter.h"
#include "apps/view/control/session.h"
#include "apps/view/control/widgets.h"
#include "apps/view/drawing/renderer.h"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>

namespace soms::view {

/// Draws all panels between ImGui::NewFrame and ImGui::Render, and writes what the user chooses to
/// the session's state. Knows no window and no OpenGL.
class Panels {
 public:
  /// `drawn` is of the last frame. \pre A context of Dear ImGui with a frame begun.
  void draw(Session& session, const FrameTimes& times, const FrameRates& rates,
            const DrawStatistics& drawn);

  /// Where each widget stood in the last frame.
  [[nodiscard]] const std::vector<WidgetPlace>& places() const { return widgets_.places(); }

 private:
  void menu_bar(Session& session);
  void sidebar(Session& session, const FrameTimes& times, const FrameRates& rates,
               const DrawStatistics& drawn);
  static void rates_panel(const Facts& facts, const Rates& rates);
  void time_panel(Session& session);
  void tree_panel(ViewState& state);
  void presets(ViewState& state);
  void traversal_choice(ViewState& state);
  void tree_options(ViewState& state);
  void level_boxes(ViewState& state);
  void show_panel(ViewState& state);
  void counts_panel(const Facts& facts);
  void frame_panel(const Facts& facts, const FrameTimes& times, const DrawStatistics& drawn);
  void picked_panel(Session& session);
  [[nodiscard]] static std::string message(const Session& session);
  void message_line(const Session& session);

  /// What a click means, done as its key would be.
  static void on_press(bool pressed, ViewState& state, Action action) {
    if (pressed) {
      apply(state, action);
    }
  }

  /// A panel of the right column, below those before; of a height, or as high as what it holds.
  void begin_right(const char* name, float height);
  void end_right();
  void files(ViewState& state);
  [[nodiscard]] bool path_field(ViewState& state);
  void events(Session& session);
  void event_rows(Session& session);
  void learn(Session& session);
  void help(ViewState& state);
  void axis_letters(const Session& session);

  static constexpr float kRightColumn = 26;  ///< width in heights of a line of text

  Widgets widgets_;
  std::size_t shown_file_ = 0;     ///< that was scrolled to
  std::filesystem::path path_of_;  ///< the folder that the field of the path began with
  std::string typed_path_;
  std::optional<std::size_t> shown_event_;
  std::string wanted_;  ///< words of events to be listed
  RowFilter listed_;
  float right_top_ = 0;  ///< where the next panel of the right column begins
};

/// What the panels keep for themselves, by the frame begun.
[[nodiscard]] Captured captured();

}  // namespace soms::view
