/// \file
/// Widgets of the panels: each shows its key as a tip, and its position can be queried.
#pragma once

#include "apps/view/control/action.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace soms::view {

/// Where a widget stood in the last frame, in pixels of the window.
struct WidgetPlace {
  std::string label;
  double left = 0;
  double top = 0;
  double right = 0;
  double bottom = 0;
};

/// Draws widgets into the present window of Dear ImGui. One object lives as long as the panels.
class Widgets {
 public:
  /// Forgets the places of the frame before.
  void begin_frame() { places_.clear(); }

  /// A button; `action` gives the key of its tip. True when pressed.
  bool button(const char* label, std::optional<Action> action = std::nullopt, float width = 0);

  /// A box to tick, with an optional square of the color that it stands for.
  bool check(const char* label, bool& value, std::optional<Action> action = std::nullopt);

  /// A list to choose from; true when another was chosen. \pre 0 <= chosen < names.size().
  bool choose(const char* label, int& chosen, std::span<const std::string_view> names,
              std::optional<Action> action = std::nullopt);

  /// One of a row of choices.
  bool radio(const char* label, bool chosen, std::optional<Action> action = std::nullopt);

  bool slide(const char* label, int& value, int least, int most,
             std::optional<Action> action = std::nullopt);

  bool slide_frame(const char* label, std::uint64_t& value, std::uint64_t most);

  /// A factor, in steps by the eye of a logarithm.
  bool slide_factor(const char* label, double& value, double least, double most,
                    std::optional<Action> action = std::nullopt);

  /// A row of a menu.
  bool menu_item(const char* label, bool ticked, std::optional<Action> action = std::nullopt);

  /// A menu of the bar; false while closed. After true, end it with ImGui::EndMenu.
  bool begin_menu(const char* label);

  /// A heading that folds what follows; false while folded, as it is at first unless `open`.
  bool heading(const char* label, bool open = true);

  /// A row of a list; its text may be any. `number` tells it from others.
  enum class RowPress { none, once, twice };
  RowPress row(const std::string& text, std::size_t number, bool chosen);

  /// A field to write in, with a hint while it is empty. True when it changed.
  bool write(const char* label, const char* hint, std::string& value);

  /// The same. True when Enter was pressed in it.
  bool enter(const char* label, const char* hint, std::string& value);

  /// Where widgets stood in this frame, in order.
  [[nodiscard]] const std::vector<WidgetPlace>& places() const { return places_; }

 private:
  bool input(const char* label, const char* hint, std::string& value, bool until_enter);

  void note(const char* label, std::optional<Action> action);

  std::vector<WidgetPlace> places_;
};

}  // namespace soms::view
