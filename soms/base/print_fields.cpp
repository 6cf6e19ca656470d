#include "soms/base/print_fields.h"

namespace soms {

std::string printed_count(std::size_t count, std::string_view singular, std::string_view plural) {
  return std::to_string(count) + " " + std::string(count == 1 ? singular : plural);
}

std::string printed_name(std::string_view type, int value,
                         std::initializer_list<std::string_view> names) {
  if (value < 0 || static_cast<std::size_t>(value) >= names.size()) {
    return std::string(type) + "(" + std::to_string(value) + ")";
  }
  return std::string(names.begin()[value]);
}

PrintedFields& PrintedFields::item(std::string_view words) {
  text_ += empty_ ? "" : ", ";
  text_ += words;
  empty_ = false;
  return *this;
}

}  // namespace soms
