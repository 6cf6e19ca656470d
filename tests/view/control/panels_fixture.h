/// \file
/// Panels without a window.
#pragma once

#include "apps/view/control/imgui_input.h"
#include "apps/view/control/panels.h"
#include "apps/view/control/style.h"
#include "tests/view/control/mock_subject.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace soms::view {

/// Dear ImGui without a window or OpenGL: draws the panels of a session and clicks their widgets.
class PanelsTest : public testing::Test {
 protected:
  void SetUp() override {
    IMGUI_CHECKVERSION();
    context_ = ImGui::CreateContext();
    set_style(1);
    ImGuiIO& io = ImGui::GetIO();
    io.DisplaySize = ImVec2(1280, 720);
    io.DeltaTime = 1.0F / 60;
    io.KeyMap[ImGuiKey_Escape] = 1;
    unsigned char* pixels = nullptr;
    int width = 0;
    int height = 0;
    io.Fonts->GetTexDataAsRGBA32(&pixels, &width, &height);
    session_.state().paused = true;
    settle();
  }

  void TearDown() override { ImGui::DestroyContext(context_); }

  void frame() {
    ImGui::NewFrame();
    session_.handle(captured());
    session_.tick(1.0 / 60);
    rates_.add(state(), session_.facts(), 20);
    panels_.draw(session_, times_, rates_, drawn_);
    ImGui::Render();
  }

  void settle() {
    for (int i = 0; i < 3; ++i) {
      frame();
    }
  }

  [[nodiscard]] const WidgetPlace* find(const std::string& label) const {
    const auto& places = panels_.places();
    const auto found = std::find_if(places.begin(), places.end(),
                                    [&](const WidgetPlace& p) { return p.label == label; });
    return found == places.end() ? nullptr : &*found;
  }

  /// Presses and releases the left button over a part of a widget: 0 is its left end, 1 its right.
  void click(const std::string& label, double part = 0.5) {
    const WidgetPlace* const place = find(label);
    ASSERT_NE(place, nullptr) << label;
    ImGuiIO& io = ImGui::GetIO();
    io.MousePos = ImVec2(static_cast<float>(place->left + part * (place->right - place->left)),
                         static_cast<float>((place->top + place->bottom) / 2));
    frame();
    io.MouseDown[0] = true;
    frame();
    io.MouseDown[0] = false;
    settle();
  }

  void choose(const std::string& list, const std::string& row) {
    click(list, 0.2);
    click(row);
  }

  ViewState& state() { return session_.state(); }

  ImGuiContext* context_ = nullptr;
  MockSubject subject_;
  Session session_{subject_, {1280, 720}};
  FrameTimes times_;
  FrameRates rates_;
  DrawStatistics drawn_;
  Panels panels_;
};

}  // namespace soms::view
