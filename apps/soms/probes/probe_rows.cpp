#include "apps/soms/probes/probe_rows.h"

#include "apps/model/georeference.h"
#include "apps/model/models.h"
#include "apps/output/json.h"

namespace soms::command {

Georeference ProbeReport::georeference() const {
  return posed_ ? Georeference{} : mesh_.georeference;
}

std::string ProbeReport::keys(const AnsweredRow& row) const {
  std::string keys;
  if (verified_) {
    keys += row.right ? ",\"verified\":true" : ",\"verified\":false";
  }
  keys += row.last ? ",\"timed_out\":true" : "";
  if (row.number == 0) {
    const std::vector<std::string> notes = notes_of({&mesh_, 1});
    const Georeference place = georeference();
    keys += place.empty() ? "" : ",\"georeference\":" + json_text(georeference_json(place));
    keys += notes.empty() ? "" : ",\"notes\":" + json_text(notes);
  }
  return keys;
}

}  // namespace soms::command
