#include "soms/base/print_fields.h"

namespace soms {

std::string printed_count(std::size_t count, std::string_view singular, std::string_view plural) {
  return std::to_string(count) + " " + std::string(count == 1 ? singular : plural);
}

PrintedFields& PrintedFields::item(std::string_view words) {
  text_ += empty_ ? "" : ", ";
  text_ += words;
  empty_ = false;
  return *this;
}

}  // namespace soms
