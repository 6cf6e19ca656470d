#include "apps/soms/near_options.h"

#include "apps/soms/answer_columns.h"
#include "apps/support/parse.h"

namespace soms::command {

void add_near_options(CLI::App& app, NearOptions& options) {
  add_output(app, "--report", options.report,
             "write an HTML report with figures and a 3-D view of the nearest points")
      ->group(kQuestionGroup);
  add_output(app, "--csv", options.csv, "write the answers as CSV, one row per pose")
      ->group(kQuestionGroup);
  add_binary(app, options.binary);
  add_verify(app, options);
  add_model_reading(app, options);
}

}  // namespace soms::command
