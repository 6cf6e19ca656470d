#include "apps/rows/json_rows.h"

#include "apps/cli/console.h"

#include <utility>

namespace soms::command {

JsonRows::JsonRows(const AnswerOutputs& outputs, Console& console) : console_(console) {
  for (const std::string& path : {outputs.json, outputs.lines}) {
    if (!path.empty()) {
      auto file = std::make_unique<OutputFile>(path);
      JsonListWriter list(file->stream(), path);
      files_.push_back({std::move(file), list});
    }
  }
}

bool JsonRows::is_wanted() const {
  return !files_.empty() || console_.shared().json;
}

void JsonRows::put(std::string_view piece) {
  if (console_.shared().json) {
    console_.print(piece);
  }
  for (File& file : files_) {
    file.list.put(piece);
  }
}

void JsonRows::end_row() {
  if (console_.shared().json) {
    console_.print("\n");
  }
  for (File& file : files_) {
    file.list.end_row();
    if (!file.file->stream().good()) {
      file.file->check();
    }
  }
}

void JsonRows::finish(const Json& totals) {
  if (!totals.is_null() && console_.shared().json) {
    console_.print(json_line(totals));
    console_.flush();
  }
  for (File& file : files_) {
    totals.is_null() ? file.list.finish() : file.list.finish(totals);
    file.file->commit();
  }
}

}  // namespace soms::command
