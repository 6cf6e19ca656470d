#include "apps/soms/pairs/near_options.h"

#include "apps/shards/shard_files.h"

namespace soms::command {

void add_near_options(Parser& parser, PairOptions& options) {
  add_renamed_outputs(
      parser, options.outputs,
      {AnswerFile::csv, AnswerFile::npz, AnswerFile::json, AnswerFile::lines, AnswerFile::page},
      kQuestionGroup);
  add_shard(parser, options, kQuestionGroup);
  add_verify(parser, options);
  add_model_reading(parser, options);
}

}  // namespace soms::command
