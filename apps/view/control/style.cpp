#include "apps/view/control/style.h"

#include "apps/draw/look.h"
#include "apps/view/control/imgui_input.h"

#include <array>
#include <cmath>
#include <initializer_list>

namespace soms::view {

namespace {

/// Height of a line of text in points.
constexpr double kLetters = 14;

/// What names of files and models are written in: Latin, Greek, Cyrillic, and the marks and arrows
/// of texts. Pairs of first and last, ended by a zero.
constexpr std::array<ImWchar, 9> kLetterRanges{0x20,   0x24F,  0x370,  0x52F, 0x2010,
                                               0x206F, 0x2190, 0x21FF, 0};

ImVec4 color_in(look::Rgb rgb, float opacity = 1) {
  return {static_cast<float>(rgb.r) / 255, static_cast<float>(rgb.g) / 255,
          static_cast<float>(rgb.b) / 255, opacity};
}

/// Paper, ink and lines of pages, and one accent in three strengths.
void set_colors(ImGuiStyle& style) {
  const ImVec4 paper = color_in(look::kPaper.light);
  const ImVec4 soft = color_in(look::kSoft.light);
  const ImVec4 line = color_in(look::kLine.light);
  const look::Rgb accent = look::kLink.light;
  const auto set = [&style](std::initializer_list<int> which, const ImVec4& color) {
    for (const int i : which) {
      style.Colors[i] = color;
    }
  };
  set({ImGuiCol_Text}, color_in(look::kInk.light));
  set({ImGuiCol_TextDisabled}, color_in(look::kFaint.light));
  set({ImGuiCol_WindowBg, ImGuiCol_MenuBarBg, ImGuiCol_TitleBg, ImGuiCol_TitleBgActive,
       ImGuiCol_TitleBgCollapsed, ImGuiCol_TableHeaderBg},
      soft);
  set({ImGuiCol_PopupBg, ImGuiCol_FrameBg, ImGuiCol_Button}, paper);
  set({ImGuiCol_Border, ImGuiCol_Separator, ImGuiCol_TableBorderLight, ImGuiCol_TableBorderStrong},
      line);
  set({ImGuiCol_Header, ImGuiCol_ButtonHovered, ImGuiCol_FrameBgHovered, ImGuiCol_HeaderHovered},
      color_in(accent, 0.12F));
  set({ImGuiCol_ButtonActive, ImGuiCol_FrameBgActive, ImGuiCol_HeaderActive,
       ImGuiCol_TextSelectedBg},
      color_in(accent, 0.25F));
  set({ImGuiCol_SliderGrab, ImGuiCol_SliderGrabActive}, color_in(accent, 0.45F));
  set({ImGuiCol_CheckMark, ImGuiCol_PlotLines, ImGuiCol_NavHighlight}, color_in(accent));
}

void set_sizes(ImGuiStyle& style) {
  style.WindowRounding = 0;
  style.PopupRounding = 5;
  style.FrameRounding = 4;
  style.GrabRounding = 4;
  style.ScrollbarRounding = 6;
  style.FrameBorderSize = 1;  // white boxes on a light ground
  style.WindowBorderSize = 1;
  style.WindowPadding = ImVec2(10, 8);
  style.ItemSpacing = ImVec2(8, 4);
  style.ItemInnerSpacing = ImVec2(6, 4);
  style.FramePadding = ImVec2(6, 3);
  style.CellPadding = ImVec2(4, 1);
  style.ScrollbarSize = 12;
  style.GrabMinSize = 12;
}

void set_font(double scale) {
  ImFontConfig font;
  font.FontDataOwnedByAtlas = false;
  font.OversampleH = 2;
  font.PixelSnapH = true;
  const std::string_view bytes = panel_font();
  // The atlas only reads what it does not own, and takes no pointer to const.
  ImGui::GetIO().Fonts->AddFontFromMemoryTTF(
      const_cast<char*>(bytes.data()), static_cast<int>(bytes.size()),
      static_cast<float>(std::floor(kLetters * scale)), &font, kLetterRanges.data());
}

}  // namespace

void set_style(double scale) {
  ImGui::StyleColorsLight();
  ImGuiStyle& style = ImGui::GetStyle();
  set_colors(style);
  set_sizes(style);
  style.ScaleAllSizes(static_cast<float>(scale));
  set_font(scale);
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;  // the viewer leaves no files where it was started
  io.LogFilename = nullptr;
}

}  // namespace soms::view
