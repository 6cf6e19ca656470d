#include "apps/view/control/help.h"

#include "apps/view/control/action.h"

#include <string_view>

namespace soms::view {

std::vector<HelpLine> help_lines() {
  std::vector<HelpLine> lines{{"Mouse", ""},
                              {"left drag", "rotate (fly: look around)"},
                              {"Shift+left drag", "move the view"},
                              {"middle drag", "move the view"},
                              {"right drag, wheel", "zoom in and out"},
                              {"click", "select a triangle or contact"},
                              {"double click", "rotate around this point"},
                              {"drag a handle", "move the object"},
                              {"drop a file", "add the model to the scene"}};
  std::string_view group;
  for (const ActionRow& row : actions()) {
    if (row.group != group) {
      group = row.group;
      lines.push_back({std::string(group), ""});
    }
    if (is_fine(row.action)) {
      continue;
    }
    lines.push_back({keys_of(row.action), std::string(row.help)});
  }
  lines.push_back({"Shift+arrows", "a tenth of a step; also Shift+PgUp, Shift+PgDn"});
  return lines;
}

}  // namespace soms::view
