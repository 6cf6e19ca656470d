#include "apps/view/control/opening_panel.h"

#include "apps/view/control/imgui_input.h"

#include <algorithm>

namespace soms::view {

void draw_opening(const std::string& doing, double share) {
  const ImVec2 display = ImGui::GetIO().DisplaySize;
  const float line = ImGui::GetFontSize();
  const float width = std::min(30 * line, display.x);
  ImGui::SetNextWindowPos(ImVec2(0.5F * display.x, 0.45F * display.y), ImGuiCond_Always,
                          ImVec2(0.5F, 0.5F));
  ImGui::SetNextWindowSize(ImVec2(width, 0));
  const auto flags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_NoInputs | ImGuiWindowFlags_NoBackground;
  if (ImGui::Begin("opening", nullptr, flags)) {
    ImGui::TextWrapped("%s ...", doing.c_str());
    if (share >= 0) {
      ImGui::ProgressBar(static_cast<float>(std::min(share, 1.0)), ImVec2(-1, 0.4F * line), "");
    }
  }
  ImGui::End();
}

}  // namespace soms::view
