#include "apps/view/control/panel_text.h"

#include <algorithm>
#include <cctype>
#include <sstream>

namespace soms::view {

namespace {

std::string in_lower_case(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](char c) {
    return static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  });
  return text;
}

}  // namespace

bool has_words(const std::string& text, const std::string& wanted) {
  const std::string all = in_lower_case(text);
  std::istringstream words(in_lower_case(wanted));
  for (std::string word; words >> word;) {
    if (all.find(word) == std::string::npos) {
      return false;
    }
  }
  return true;
}

}  // namespace soms::view
