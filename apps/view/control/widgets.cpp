#include "apps/view/control/widgets.h"

#include "apps/view/control/imgui_input.h"

#include <array>

namespace soms::view {

namespace {

/// Lists and menus close by Escape, as everywhere.
void close_by_escape() {
  const int escape = ImGui::GetKeyIndex(ImGuiKey_Escape);
  if (escape >= 0 && ImGui::IsKeyPressed(escape, false)) {
    ImGui::CloseCurrentPopup();
  }
}

}  // namespace

void Widgets::note(const char* label, std::optional<Action> action) {
  const ImVec2 lower = ImGui::GetItemRectMin();
  const ImVec2 upper = ImGui::GetItemRectMax();
  places_.push_back({label, static_cast<double>(lower.x), static_cast<double>(lower.y),
                     static_cast<double>(upper.x), static_cast<double>(upper.y)});
  if (action && ImGui::IsItemHovered()) {
    const ActionRow& row = actions()[static_cast<std::size_t>(*action)];
    ImGui::SetTooltip("%s\nkey: %s", std::string(row.help).c_str(), keys_of(*action).c_str());
  }
}

bool Widgets::button(const char* label, std::optional<Action> action, float width) {
  const bool pressed = ImGui::Button(label, ImVec2(width, 0));
  note(label, action);
  return pressed;
}

bool Widgets::check(const char* label, bool& value, std::optional<Action> action) {
  const bool changed = ImGui::Checkbox(label, &value);
  note(label, action);
  return changed;
}

bool Widgets::choose(const char* label, int& chosen, std::span<const std::string_view> names,
                     std::optional<Action> action) {
  const std::string now(names[static_cast<std::size_t>(chosen)]);
  bool changed = false;
  const bool open = ImGui::BeginCombo(label, now.c_str(), ImGuiComboFlags_HeightLargest);
  if (!open) {
    note(label, action);
    return false;
  }
  for (std::size_t i = 0; i < names.size(); ++i) {
    const std::string name(names[i]);
    const int number = static_cast<int>(i);
    if (ImGui::Selectable(name.c_str(), number == chosen) && number != chosen) {
      chosen = number;
      changed = true;
    }
    note(name.c_str(), std::nullopt);
  }
  close_by_escape();
  ImGui::EndCombo();
  return changed;
}

bool Widgets::radio(const char* label, bool chosen, std::optional<Action> action) {
  const bool pressed = ImGui::RadioButton(label, chosen);
  note(label, action);
  return pressed && !chosen;
}

bool Widgets::slide(const char* label, int& value, int least, int most,
                    std::optional<Action> action) {
  const bool changed =
      ImGui::SliderInt(label, &value, least, most, "%d", ImGuiSliderFlags_AlwaysClamp);
  note(label, action);
  return changed;
}

bool Widgets::slide_frame(const char* label, std::uint64_t& value, std::uint64_t most) {
  const std::uint64_t least = 0;
  const bool changed = ImGui::SliderScalar(label, ImGuiDataType_U64, &value, &least, &most, "%llu",
                                           ImGuiSliderFlags_AlwaysClamp);
  note(label, std::nullopt);
  return changed;
}

bool Widgets::slide_factor(const char* label, double& value, double least, double most,
                           std::optional<Action> action) {
  const bool changed =
      ImGui::SliderScalar(label, ImGuiDataType_Double, &value, &least, &most, "%.3gx",
                          ImGuiSliderFlags_Logarithmic | ImGuiSliderFlags_AlwaysClamp);
  note(label, action);
  return changed;
}

bool Widgets::menu_item(const char* label, bool ticked, std::optional<Action> action) {
  const std::string key = action ? keys_of(*action) : std::string();
  const bool pressed = ImGui::MenuItem(label, key.empty() ? nullptr : key.c_str(), ticked);
  note(label, std::nullopt);
  return pressed;
}

bool Widgets::begin_menu(const char* label) {
  const bool open = ImGui::BeginMenu(label);
  if (open) {
    close_by_escape();
  } else {
    note(label, std::nullopt);
  }
  return open;
}

Widgets::RowPress Widgets::row(const std::string& text, std::size_t number, bool chosen) {
  ImGui::PushID(static_cast<int>(number));
  const ImVec2 at = ImGui::GetCursorPos();
  const bool pressed =
      ImGui::Selectable("##row", chosen, ImGuiSelectableFlags_AllowDoubleClick,
                        ImVec2(0, ImGui::CalcTextSize(text.c_str(), text.c_str() + text.size()).y));
  note(text.c_str(), std::nullopt);
  const bool twice = pressed && ImGui::IsMouseDoubleClicked(0);
  const ImVec2 below = ImGui::GetCursorPos();
  ImGui::SetCursorPos(at);
  ImGui::TextUnformatted(text.c_str(), text.c_str() + text.size());
  ImGui::SetCursorPos(below);
  ImGui::PopID();
  return twice ? RowPress::twice : pressed ? RowPress::once : RowPress::none;
}

bool Widgets::write(const char* label, const char* hint, std::string& value) {
  return input(label, hint, value, false);
}

bool Widgets::enter(const char* label, const char* hint, std::string& value) {
  return input(label, hint, value, true);
}

bool Widgets::input(const char* label, const char* hint, std::string& value, bool until_enter) {
  std::array<char, 1024> text{};
  value.copy(text.data(), text.size() - 1);
  ImGui::SetNextItemWidth(-1);
  const bool done = ImGui::InputTextWithHint(
      label, hint, text.data(), text.size(),
      until_enter ? ImGuiInputTextFlags_EnterReturnsTrue : ImGuiInputTextFlags_None);
  note(label, std::nullopt);
  value = text.data();
  return done;
}

bool Widgets::heading(const char* label, bool open) {
  const bool is_open = ImGui::CollapsingHeader(
      label, open ? ImGuiTreeNodeFlags_DefaultOpen : ImGuiTreeNodeFlags_None);
  note(label, std::nullopt);
  return is_open;
}

}  // namespace soms::view
