#include "apps/view/control/panels.h"

#include "apps/cli/text.h"
#include "apps/view/control/help.h"
#include "apps/view/control/imgui_input.h"
#include "apps/view/control/panel_text.h"
#include "apps/view/scene/orientation_menu.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string_view>

namespace soms::view {

namespace {

constexpr float kSidebar = 19.5F;  ///< width in heights of a line of text

void row(const char* label, const std::string& value) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::TextUnformatted(label);
  ImGui::TableNextColumn();
  const float free = ImGui::GetContentRegionAvail().x - ImGui::CalcTextSize(value.c_str()).x;
  ImGui::SetCursorPosX(ImGui::GetCursorPosX() + std::max(free, 0.0F));
  ImGui::TextWrapped("%s", value.c_str());
}

bool begin_rows(const char* name) {
  if (!ImGui::BeginTable(name, 2, ImGuiTableFlags_SizingFixedFit)) {
    return false;
  }
  ImGui::TableSetupColumn("label", ImGuiTableColumnFlags_WidthFixed);
  ImGui::TableSetupColumn("value", ImGuiTableColumnFlags_WidthStretch);
  return true;
}

void help_cells(const HelpLine& line) {
  ImGui::TableNextColumn();
  if (line.text.empty()) {
    ImGui::TextDisabled("%s", line.keys.c_str());
  } else {
    ImGui::TextUnformatted(line.keys.c_str());
  }
  ImGui::TableNextColumn();
  ImGui::TextUnformatted(line.text.c_str());
}

}  // namespace

void Panels::draw(Session& session, const FrameTimes& times, const FrameRates& rates,
                  const DrawStatistics& drawn) {
  widgets_.begin_frame();
  const ViewState& state = session.state();
  const float line = state.panels ? ImGui::GetFontSize() : 0;
  const double right = kRightColumn * line;
  const bool is_right_open = state.events || state.learn || session.picked();
  session.set_covered({kSidebar * line, is_right_open ? right : 0}, right);
  axis_letters(session);
  if (state.panels) {
    menu_bar(session);
    sidebar(session, times, rates, drawn);
    right_top_ = ImGui::GetFrameHeight();
    events(session);
    learn(session);
    picked_panel(session);
  }
  message_line(session);
  files(session.state());
  help(session.state());
}

void Panels::menu_bar(Session& session) {
  if (!ImGui::BeginMainMenuBar()) {
    return;
  }
  ViewState& state = session.state();
  const auto item = [&](const char* label, Action action, bool ticked = false) {
    on_press(widgets_.menu_item(label, ticked, action), state, action);
  };
  if (widgets_.begin_menu("File")) {
    item("Open...", Action::open);
    item("Save picture", Action::screenshot);
    item("Save with panels", Action::screenshot_panels);
    item("Full screen", Action::fullscreen);
    item("Quit", Action::quit);
    ImGui::EndMenu();
  }
  if (widgets_.begin_menu("Camera")) {
    item("Show everything", Action::reset_camera);
    item("Go to the selection", Action::focus);
    item("Go to the gap", Action::focus_gap);
    item("Front", Action::view_front);
    item("Right", Action::view_right);
    item("Above", Action::view_top);
    item("Corner", Action::view_corner);
    ImGui::Separator();
    for (const CameraMode mode : {CameraMode::orbit, CameraMode::fly, CameraMode::follow}) {
      const bool possible = mode != CameraMode::follow || state.limits.movers > 0;
      if (possible && widgets_.menu_item(name(mode), state.camera == mode)) {
        state.camera = mode;
      }
    }
    ImGui::EndMenu();
  }
  if (widgets_.begin_menu("Events")) {
    item("List", Action::events, state.events);
    item("Next event", Action::event_next);
    item("Previous event", Action::event_previous);
    ImGui::EndMenu();
  }
  if (widgets_.begin_menu("Learn")) {
    item("Traversal, test by test", Action::learn, state.learn);
    item("Next", Action::learn_next);
    item("Previous one", Action::learn_previous);
    ImGui::EndMenu();
  }
  if (widgets_.begin_menu("Orientation test")) {
    if (widgets_.menu_item("none", !state.orientation_test)) {
      set_orientation_test(state, std::nullopt);
    }
    const auto tests = orientation_tests();
    for (std::size_t i = 0; i < tests.size(); ++i) {
      const std::string label(tests[i].title);
      if (state.limits.has_object &&
          widgets_.menu_item(label.c_str(), state.orientation_test == i)) {
        set_orientation_test(state, i);
      }
    }
    ImGui::EndMenu();
  }
  if (widgets_.begin_menu("Help")) {
    item("Keys", Action::help, state.help);
    ImGui::EndMenu();
  }
  ImGui::TextDisabled("  %s", session.facts().name.c_str());
  ImGui::EndMainMenuBar();
}

void Panels::sidebar(Session& session, const FrameTimes& times, const FrameRates& rates,
                     const DrawStatistics& drawn) {
  const float top = ImGui::GetFrameHeight();
  const ImVec2 display = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos(ImVec2(0, top));
  ImGui::SetNextWindowSize(ImVec2(kSidebar * ImGui::GetFontSize(), display.y - top));
  const auto flags = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize |
                     ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoNavInputs;
  if (ImGui::Begin("soms", nullptr, flags)) {
    ImGui::PushItemWidth(0.52F * kSidebar * ImGui::GetFontSize());
    rates_panel(session.facts(), rates.rates());
    time_panel(session);
    tree_panel(session.state());
    show_panel(session.state());
    counts_panel(session.facts());
    frame_panel(session.facts(), times, drawn);
    ImGui::PopItemWidth();
  }
  ImGui::End();
}

void Panels::rates_panel(const Facts& facts, const Rates& rates) {
  if (!ImGui::BeginTable("rates", 3, ImGuiTableFlags_SizingFixedFit)) {
    return;
  }
  ImGui::TableSetupColumn("what", ImGuiTableColumnFlags_WidthStretch);
  for (const RateRow& row : rate_rows(rates, facts)) {
    ImGui::TableNextRow();
    for (const std::string& cell : {row.what, row.ms, row.fps}) {
      ImGui::TableNextColumn();
      ImGui::TextUnformatted(cell.c_str());
    }
  }
  ImGui::EndTable();
  ImGui::TextDisabled("%s", rate_line(rates).c_str());
}

void Panels::time_panel(Session& session) {
  if (!widgets_.heading("Time")) {
    return;
  }
  ViewState& state = session.state();
  const float buttons = state.limits.can_seek ? 4 : 3;
  const float gaps = (buttons - 1) * ImGui::GetStyle().ItemSpacing.x;
  const float width = (ImGui::GetContentRegionAvail().x - gaps) / buttons;
  on_press(widgets_.button(state.paused ? "Run###run" : "Pause###run", Action::pause, width), state,
           Action::pause);
  ImGui::SameLine();
  on_press(widgets_.button("Step", Action::step, width), state, Action::step);
  if (state.limits.can_seek) {
    ImGui::SameLine();
    on_press(widgets_.button("Back", Action::step_back, width), state, Action::step_back);
  }
  ImGui::SameLine();
  on_press(widgets_.button("Start", Action::first_frame, width), state, Action::first_frame);
  widgets_.slide_factor("Speed", state.speed, kSlowest, kFastest, Action::faster);
  if (state.limits.can_seek && state.limits.frames > 1) {
    std::uint64_t frame = state.frame;
    if (widgets_.slide_frame("Frame", frame, state.limits.frames - 1)) {
      state.requests.seek = frame;
    }
  } else {
    ImGui::Text("frame %s", command::with_commas(state.frame).c_str());
  }
}

void Panels::show_panel(ViewState& state) {
  if (!widgets_.heading("Show")) {
    return;
  }
  if (!ImGui::BeginTable("show", 2, ImGuiTableFlags_SizingStretchSame)) {
    return;
  }
  Shown& shown = state.shown;
  const auto cell = [&](const char* label, bool& flag, Action action) {
    ImGui::TableNextColumn();
    widgets_.check(label, flag, action);
  };
  cell("Touching", shown.contact_triangles, Action::contact_triangles);
  cell("Visited", shown.visited, Action::visited);
  cell("Crossings", shown.crossing_segments, Action::crossing_segments);
  cell("Pruned", shown.pruned, Action::pruned);
  cell("Lines", shown.contact_lines, Action::contact_lines);
  cell("Found", shown.found, Action::found);
  cell("Parts", shown.contact_parts, Action::contact_parts);
  cell("On top", shown.contacts_on_top, Action::contacts_on_top);
  cell("Movers", shown.movers, Action::movers);
  cell("Pruning", state.prune, Action::pruning);
  cell("Edges", shown.edges, Action::edges);
  cell("Handles", shown.gizmo, Action::gizmo);
  cell("Gap", shown.gap, Action::gap);
  ImGui::EndTable();
}

void Panels::counts_panel(const Facts& facts) {
  if (!widgets_.heading("Counts") || !begin_rows("counts")) {
    return;
  }
  row("Triangles", command::with_commas(facts.triangles));
  row("Movers", command::with_commas(facts.movers));
  row("Touching movers", command::with_commas(facts.bodies));
  row("Touching pairs", command::with_commas(facts.contacts));
  if (!facts.clearance.empty()) {
    row("Near", command::with_commas(facts.gaps) + " within " + facts.clearance);
    row("Least gap", facts.least_gap.empty() ? "none" : facts.least_gap);
  }
  if (facts.gap) {
    for (const auto& [label, value] : facts.gap->numbers) {
      row(label.c_str(), value);
    }
  }
  for (const auto& [label, value] : cost_rows(facts)) {
    row(label.c_str(), value);
  }
  ImGui::EndTable();
}

void Panels::frame_panel(const Facts& facts, const FrameTimes& times, const DrawStatistics& drawn) {
  if (!widgets_.heading("Drawing", false)) {
    return;
  }
  const double rate = times.frames_a_second();
  if (rate > 0) {
    ImGui::Text("%.1f ms a frame, %.0f FPS", times.last(), rate);
  } else {
    ImGui::Text("%.1f ms a frame, at rest", times.last());
  }
  const auto graph = times.graph();
  const auto top = static_cast<float>(1.1 * std::max(times.greatest(), 1.0));
  ImGui::PlotLines("##ms", graph.data(), static_cast<int>(graph.size()), 0, nullptr, 0, top,
                   ImVec2(ImGui::GetContentRegionAvail().x, 2.6F * ImGui::GetFontSize()));
  ImGui::Text("%s draw calls, %s triangles", command::with_commas(drawn.draw_calls).c_str(),
              command::with_commas(drawn.triangles).c_str());
  if (drawn.triangles_left > 0) {
    ImGui::Text("%s more when the view rests", command::with_commas(drawn.triangles_left).c_str());
  }
  for (const std::string& line : facts.left_out) {
    ImGui::TextWrapped("%s", line.c_str());
  }
}

void Panels::picked_panel(Session& session) {
  if (!session.picked()) {
    return;
  }
  const PickedFacts& picked = *session.picked();
  begin_right("picked", 0);
  {
    ImGui::TextWrapped("%s", picked.title.c_str());
    ImGui::Separator();
    if (begin_rows("numbers")) {
      for (const auto& [label, value] : picked.numbers) {
        row(label.c_str(), value);
      }
      ImGui::EndTable();
    }
    for (const std::string& sentence : picked.why) {
      ImGui::TextWrapped("%s", sentence.c_str());
    }
    ViewState& state = session.state();
    on_press(widgets_.button("Go there", Action::focus), state, Action::focus);
    ImGui::SameLine();
    if (widgets_.button("Close")) {
      state.requests.deselect = true;
    }
  }
  end_right();
}

std::string Panels::message(const Session& session) {
  const ViewState& state = session.state();
  if (!session.message().empty()) {
    return session.message();
  }
  return state.panels && !awaits_event(state) ? session.facts().note
                                              : event_line(state, session.events());
}

void Panels::message_line(const Session& session) {
  const std::string text = message(session);
  if (text.empty()) {
    return;
  }
  const ImVec2 display = ImGui::GetIO().DisplaySize;
  const float left = session.state().panels ? kSidebar * ImGui::GetFontSize() : 0;
  ImGui::SetNextWindowPos(ImVec2(left, display.y), ImGuiCond_Always, ImVec2(0, 1));
  ImGui::SetNextWindowSize(ImVec2(display.x - left, 0));
  ImGui::SetNextWindowBgAlpha(0.85F);
  const auto flags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_NoInputs | ImGuiWindowFlags_NoFocusOnAppearing;
  if (ImGui::Begin("message", nullptr, flags)) {
    ImGui::TextWrapped("%s", text.c_str());
  }
  ImGui::End();
}

void Panels::help(ViewState& state) {
  if (!state.help) {
    return;
  }
  const ImVec2 display = ImGui::GetIO().DisplaySize;
  const float line = ImGui::GetFontSize();
  ImGui::SetNextWindowPos(ImVec2(display.x / 2, display.y / 2), ImGuiCond_Always,
                          ImVec2(0.5F, 0.5F));
  ImGui::SetNextWindowSize(
      ImVec2(std::min(64 * line, display.x - line), std::min(41 * line, display.y - line)));
  ImGui::SetNextWindowBgAlpha(1);
  ImGui::PushStyleVar(ImGuiStyleVar_CellPadding, ImVec2(0.5F * line, 0.02F * line));
  const auto flags = ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoResize |
                     ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_NoNavInputs;
  if (ImGui::Begin("Keys and mouse", &state.help, flags) &&
      ImGui::BeginTable("keys", 4, ImGuiTableFlags_SizingFixedFit)) {
    // Two columns of rows, each filled from top to bottom.
    const std::vector<HelpLine> lines = help_lines();
    std::size_t half = (lines.size() + 1) / 2;
    while (half > 1 && lines[half - 1].text.empty()) {
      --half;  // a heading goes with what it heads
    }
    for (std::size_t i = 0; i < std::max(half, lines.size() - half); ++i) {
      ImGui::TableNextRow();
      help_cells(i < half ? lines[i] : HelpLine{});
      help_cells(half + i < lines.size() ? lines[half + i] : HelpLine{});
    }
    ImGui::EndTable();
  }
  ImGui::End();
  ImGui::PopStyleVar();
}

void Panels::axis_letters(const Session& session) {
  const auto gizmo = session.gizmo();
  if (!gizmo) {
    return;
  }
  constexpr std::array<const char*, 3> kLetters{"x", "y", "z"};
  const auto ends = tips(*gizmo);
  for (std::size_t i = 0; i < ends.size(); ++i) {
    if (const auto seen = project(session.camera(), session.window(), ends[i])) {
      const ImVec2 half = ImGui::CalcTextSize(kLetters[i]);
      const ImVec2 at(static_cast<float>(seen->pixel.x) - half.x / 2,
                      static_cast<float>(seen->pixel.y) - half.y / 2);
      ImGui::GetBackgroundDrawList()->AddText(at, IM_COL32(20, 20, 20, 255), kLetters[i]);
    }
  }
}

Captured captured() {
  const ImGuiIO& io = ImGui::GetIO();
  const bool open =
      ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel);
  return {io.WantCaptureMouse, io.WantTextInput || open};
}

}  // namespace soms::view
