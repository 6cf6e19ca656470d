#include "apps/soms/pairs/near_options.h"

#include "apps/cli/parse.h"
#include "apps/shards/shard_files.h"
#include "apps/soms/answers/answer_columns.h"

namespace soms::command {

void add_near_options(Parser& parser, NearOptions& options) {
  add_output(parser, "--report", options.report,
             "write an HTML report with figures and a 3-D view of the nearest points")
      ->group(kQuestionGroup);
  add_output(parser, "--csv", options.csv, "write the answers as CSV, one row per pose")
      ->group(kQuestionGroup);
  add_binary(parser, options.binary);
  add_shard(parser, options, kQuestionGroup);
  add_verify(parser, options);
  add_model_reading(parser, options);
}

}  // namespace soms::command
