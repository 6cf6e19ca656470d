/// \file
/// Rows of points or rays beside one model: what `closest`, `contains` and `ray` share.
#pragma once

#include "soms/geometry/mesh.h"

#include "apps/cli/console.h"
#include "apps/rows/row_run.h"
#include "apps/rows/sinks.h"
#include "apps/soms/probes/probe_options.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace soms::command {

/// What is reported beside the answers about a model. Its mesh must stay.
class ProbeReport {
 public:
  ProbeReport(const ProbeOptions& options, const MeshView& mesh)
      : verified_(options.verify), posed_(options.pose.has_value()), mesh_(mesh) {}

  [[nodiscard]] const MeshView& mesh() const { return mesh_; }

  /// Of coordinates in answers: none where a pose moves the model.
  [[nodiscard]] Georeference georeference() const;

  /// Keys of JSON, each with a comma before.
  [[nodiscard]] std::string keys(const AnsweredRow& row) const;

 private:
  bool verified_;
  bool posed_;
  MeshView mesh_;
};

/// Rows of a `Source`: a `RowSource` that has a `Row`, a `kNoun`, and gives the rows by `next`.
template <class Source>
class ProbeRows : public Rows {
 public:
  using Row = typename Source::Row;

  /// `says_one`: a single row is reported at length.
  ProbeRows(const std::string& file, bool says_one, const Console& console)
      : source_(file, console), says_one_(says_one) {}

  [[nodiscard]] const std::vector<Row>& block() const { return block_; }

  void begin() override { single_ = says_one_ && source_.is_single(); }

  [[nodiscard]] bool is_single() const override { return single_; }

  void clear() override { block_.clear(); }

  bool ready() override { return source_.ready(); }

  bool read() override {
    const std::optional<Row> row = source_.next();
    if (row) {
      block_.push_back(*row);
    }
    return row.has_value();
  }

 private:
  Source source_;
  bool says_one_;
  bool single_ = false;
  std::vector<Row> block_;
};

/// What a verb says of its question.
struct ProbeTerms {
  std::string verb;            ///< as messages name it
  bool fail_if_found = false;  ///< --fail-if is given
  bool says_one = false;       ///< without --json, a single row is reported at length
};

/// Puts the question that `make(rows, pose)` gives to every row of a file; the exit status.
template <class Source, class Make>
int run_probes(const ProbeOptions& options, const std::string& file, const ProbeTerms& terms,
               Console& console, const Make& make) {
  Sinks sinks(options.outputs, console);
  ProbeRows<Source> rows(file, terms.says_one && !console.shared().json, console);
  auto question = make(rows, stated_pose(options, console));
  return RowRun({.verb = terms.verb,
                 .noun = std::string(Source::kNoun),
                 .verify = options.verify,
                 .fail_if_found = terms.fail_if_found},
                rows, question, sinks, console)
      .run();
}

}  // namespace soms::command
