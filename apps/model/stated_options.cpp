#include "apps/model/stated_options.h"

#include "apps/model/models.h"

#include <fmt/format.h>

#include <string_view>

namespace soms::command {

char axis_letter(UpAxis axis) {
  return axis == UpAxis::x ? 'x' : axis == UpAxis::y ? 'y' : 'z';
}

std::string crs_option(const std::string& up_name) {
  constexpr std::string_view kUp = "--up";
  return up_name.starts_with(kUp) ? "--crs" + up_name.substr(kUp.size()) : std::string();
}

std::string stated_options(const ModelOptions& options, const std::string& scale_name,
                           const std::string& up_name) {
  std::string text;
  if (options.scale_is_given) {
    text += fmt::format(", {} {}", scale_name, options.scale);
  }
  if (options.up != UpAxis::unknown) {
    text += fmt::format(", {} {}", up_name, axis_letter(options.up));
  }
  if (!options.crs.empty()) {
    text += fmt::format(", {} {}", crs_option(up_name), options.crs);
  }
  return text;
}

}  // namespace soms::command
