#include "apps/view/control/help.h"

#include "apps/view/control/action.h"

#include <string_view>

namespace soms::view {

std::vector<HelpLine> help_lines() {
  std::vector<HelpLine> lines{{"Mouse", ""},
                              {"left drag", "turn (fly: look around)"},
                              {"Shift+left drag", "shift"},
                              {"middle drag", "shift"},
                              {"right drag, wheel", "nearer and farther"},
                              {"click", "pick a triangle or contact"},
                              {"double click", "set the pivot"},
                              {"drag a handle", "move the object"},
                              {"drop a file", "add the model"}};
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
  lines.push_back({"Shift+arrows", "a tenth as far, also Shift+PgUp, PgDn"});
  return lines;
}

}  // namespace soms::view
