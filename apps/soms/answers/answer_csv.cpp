#include "apps/soms/answers/answer_csv.h"

namespace soms::command {

AnswerCsv::AnswerCsv(const std::string& path, std::string_view columns) {
  if (!path.empty()) {
    file_.emplace(path);
    put(columns);
  }
}

void AnswerCsv::put(std::string_view rows) {
  if (file_) {
    file_->stream() << rows;
    if (!file_->stream().good()) {
      file_->check();
    }
  }
}

void AnswerCsv::finish() {
  if (file_) {
    file_->commit();
  }
}

}  // namespace soms::command
