#include "apps/soms/answers/answer_fields.h"

#include <cmath>

namespace soms::command {

std::string json_number(double x) {
  return std::isfinite(x) ? fmt::format("{}", x) : "null";
}

void add_georeference(NpzFile& file, const Georeference& georeference) {
  if (!georeference.empty()) {
    file.text("georeference", describe(georeference));
  }
}

}  // namespace soms::command
