// The panels of `Panels` that are lists: files to open, events, the tests of a traversal.
#include "apps/cli/text.h"
#include "apps/view/control/imgui_input.h"
#include "apps/view/control/panel_text.h"
#include "apps/view/control/panels.h"

#include <algorithm>
#include <string>
#include <utility>

namespace soms::view {

namespace {

/// Flags of a panel that stands where it is put.
constexpr ImGuiWindowFlags kFixed = ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                                    ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoCollapse |
                                    ImGuiWindowFlags_NoNavInputs;

constexpr int kLinesOfEvent = 2;  ///< of text in a row

ImU32 packed(Color color) {
  return IM_COL32(color.r, color.g, color.b, color.a);
}

/// A square in a color, and what it means, in the line of those before.
void legend(Color color, const char* words) {
  const float side = 0.7F * ImGui::GetFontSize();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float top = at.y + 0.2F * ImGui::GetFontSize();
  ImGui::GetWindowDrawList()->AddRectFilled(ImVec2(at.x, top), ImVec2(at.x + side, top + side),
                                            packed(color));
  ImGui::Dummy(ImVec2(side, ImGui::GetFontSize()));
  ImGui::SameLine(0, 0.3F * ImGui::GetFontSize());
  ImGui::TextDisabled("%s", words);
}

/// A tree as rows of bars over the width that is left.
void draw_bars(const TreeBars& tree) {
  ImGui::TextDisabled("%s", tree.name.c_str());
  const float line = ImGui::GetFontSize();
  const float rows = static_cast<float>(tree.levels);
  const float height = std::clamp(8 * line / rows, 0.25F * line, 0.8F * line);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x;
  ImDrawList* const draw = ImGui::GetWindowDrawList();
  for (const TreeBars::Bar& bar : tree.bars) {
    const float top = at.y + height * static_cast<float>(bar.level);
    const float left = at.x + width * bar.left;
    // A gap of a pixel sets neighbors apart where there is room for it.
    const float right = std::max(at.x + width * bar.right - 1, left + 1);
    draw->AddRectFilled(ImVec2(left, top), ImVec2(right, top + height - 1),
                        packed(color_of(tree, bar.look)));
  }
  ImGui::Dummy(ImVec2(width, height * rows));
}

}  // namespace

void Panels::files(ViewState& state) {
  if (!state.files) {
    return;
  }
  FileList& files = *state.files;
  const ImVec2 display = ImGui::GetIO().DisplaySize;
  const float line = ImGui::GetFontSize();
  ImGui::SetNextWindowPos(ImVec2(display.x / 2, display.y / 2), ImGuiCond_Always,
                          ImVec2(0.5F, 0.5F));
  ImGui::SetNextWindowSize(ImVec2(std::min(40 * line, display.x), std::min(32 * line, display.y)));
  ImGui::SetNextWindowBgAlpha(1);
  bool open = true;
  if (ImGui::Begin("Open a model", &open, kFixed)) {
    open = !path_field(state) && open;
    ImGui::BeginChild("rows", ImVec2(0, -2.2F * line), true);
    for (std::size_t i = 0; i < files.rows().size(); ++i) {
      const bool chosen = i == files.chosen();
      const auto press = widgets_.row(files.rows()[i].text, i, chosen);
      if (press != Widgets::RowPress::none) {
        files.choose(i);
        state.requests.open_chosen = press == Widgets::RowPress::twice;
      }
      if (chosen && shown_file_ != i) {
        ImGui::SetScrollHereY();
        shown_file_ = i;
      }
    }
    if (files.rows().empty()) {
      ImGui::TextDisabled(
          "%s", files.fault().empty() ? "no folders and no models here" : files.fault().c_str());
    }
    ImGui::EndChild();
    if (widgets_.button("Folder above")) {
      files.up();
    }
    ImGui::SameLine();
    state.requests.open_chosen |= widgets_.button("Open");
    ImGui::SameLine();
    open = !widgets_.button("Cancel") && open;
  }
  ImGui::End();
  if (!open) {
    state.files.reset();
  }
}

/// Shows the folder, and takes the path of another or of a model; true if it is to be opened.
bool Panels::path_field(ViewState& state) {
  FileList& files = *state.files;
  if (path_of_ != files.folder()) {
    path_of_ = files.folder();
    typed_path_ = path_of_.string();
  }
  if (!widgets_.enter("##path", "path of a folder or a model", typed_path_)) {
    return false;
  }
  const auto file = files.go_to(typed_path_);
  path_of_.clear();  // the field shows where that led
  if (file) {
    state.requests.open.push_back(file->string());
  }
  return file.has_value();
}

void Panels::begin_right(const char* name, float height) {
  const ImVec2 display = ImGui::GetIO().DisplaySize;
  const float width = kRightColumn * ImGui::GetFontSize();
  const float left = std::max(display.y - right_top_, 1.0F);
  ImGui::SetNextWindowPos(ImVec2(display.x - width, right_top_));
  ImGui::SetNextWindowSizeConstraints(ImVec2(width, 0), ImVec2(width, left));
  if (height > 0) {
    ImGui::SetNextWindowSize(ImVec2(width, std::min(height, left)));
  }
  ImGui::Begin(name, nullptr,
               kFixed | ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoFocusOnAppearing |
                   (height > 0 ? 0 : ImGuiWindowFlags_AlwaysAutoResize));
}

void Panels::end_right() {
  right_top_ += ImGui::GetWindowHeight();
  ImGui::End();
}

void Panels::events(Session& session) {
  ViewState& state = session.state();
  if (!state.events) {
    return;
  }
  begin_right("events", 0.42F * ImGui::GetIO().DisplaySize.y);
  const EventList& list = session.events();
  const bool done = list.done();
  ImGui::Text("%s %s in %s frames", command::with_commas(list.rows.size()).c_str(),
              list.rows.size() == 1 ? "event" : "events",
              command::with_commas(list.searched).c_str());
  if (!done) {
    ImGui::SameLine();
    ImGui::TextDisabled("of %s ...", command::with_commas(list.frames).c_str());
  }
  on_press(widgets_.button("Previous", Action::event_previous), state, Action::event_previous);
  ImGui::SameLine();
  on_press(widgets_.button("Next", Action::event_next), state, Action::event_next);
  ImGui::SameLine();
  (void)widgets_.write("##search", "search names", wanted_);
  event_rows(session);
  end_right();
}

void Panels::event_rows(Session& session) {
  ViewState& state = session.state();
  ImGui::BeginChild("list");
  const std::vector<ContactEvent>& all = session.events().rows;
  listed_.update(session.events(), wanted_);
  const std::vector<std::size_t>& rows = listed_.rows();
  const float height = kLinesOfEvent * ImGui::GetFontSize() + ImGui::GetStyle().ItemSpacing.y;
  if (state.event && shown_event_ != state.event) {
    const auto at = std::lower_bound(rows.begin(), rows.end(), *state.event);
    if (at != rows.end() && *at == *state.event) {
      const float middle = height * (static_cast<float>(at - rows.begin()) + 0.5F);
      ImGui::SetScrollY(std::max(0.0F, middle - 0.5F * ImGui::GetWindowHeight()));
    }
    shown_event_ = state.event;
  }
  ImGuiListClipper clipper;
  clipper.Begin(static_cast<int>(rows.size()), height);
  while (clipper.Step()) {
    for (int k = clipper.DisplayStart; k < clipper.DisplayEnd; ++k) {
      const std::size_t i = rows[static_cast<std::size_t>(k)];
      if (widgets_.row(words_of(all[i]), i, state.event == i) != Widgets::RowPress::none) {
        state.requests.event = i;
      }
    }
  }
  ImGui::EndChild();
}

void Panels::learn(Session& session) {
  ViewState& state = session.state();
  if (!state.learn) {
    return;
  }
  begin_right("learn", 0);
  const std::optional<LearnFacts>& facts = session.facts().learn;
  if (!facts) {
    ImGui::TextWrapped("A traversal needs two bodies, one of them a mover: open another model.");
    end_right();
    return;
  }
  ImGui::TextWrapped("%s", facts->title.c_str());
  on_press(widgets_.button("Previous test", Action::learn_previous), state, Action::learn_previous);
  ImGui::SameLine();
  on_press(widgets_.button("Next test", Action::learn_next), state, Action::learn_next);
  if (facts->tests > 1) {
    ImGui::SetNextItemWidth(-1);
    (void)widgets_.slide_frame("##test", state.learn_step, facts->tests - 1);
  }
  for (const std::string& sentence : facts->sentences) {
    ImGui::TextWrapped("%s", sentence.c_str());
  }
  if (facts->tests > 0) {
    draw_bars(facts->a);
    draw_bars(facts->b);
    legend(facts->a.now, "now, upper tree");
    ImGui::SameLine();
    legend(facts->b.now, "now, lower tree");
    const char* between = nullptr;
    for (const auto& [what, words] :
         {std::pair(TreeBars::Look::visited, "entered"), std::pair(TreeBars::Look::found, "found"),
          std::pair(TreeBars::Look::pruned, "pruned")}) {
      if (std::exchange(between, words) != nullptr) {
        ImGui::SameLine();
      }
      legend(color_of(facts->a, what), words);
    }
  }
  end_right();
}

}  // namespace soms::view
