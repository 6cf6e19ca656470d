/// \file
/// Rows of points or rays beside one model: what `closest`, `contains` and `ray` share.
#pragma once

#include "soms/base/pose.h"
#include "soms/geometry/mesh.h"

#include "apps/cli/console.h"
#include "apps/cli/text.h"
#include "apps/model/georeference.h"
#include "apps/output/json.h"
#include "apps/rows/row_run.h"
#include "apps/soms/pairs/pair_report.h"
#include "apps/soms/probes/probe_options.h"

#include <fmt/format.h>

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace soms::command {

/// What a verb says of its question.
struct ProbeQuestion {
  std::string verb;            ///< as messages name it
  bool fail_if_found = false;  ///< --fail-if is given
  bool has_files = false;      ///< answers go to files, too
};

/// A run whose rows come from a `Source`: a `RowSource` that has a `Row`, a `kNoun`, and gives the
/// rows by `next`.
template <class Source>
class ProbeRun : public RowRun {
 protected:
  using Row = typename Source::Row;

  /// Opens the rows.
  ProbeRun(const ProbeOptions& options, const std::string& rows, ProbeQuestion question,
           Console& console)
      : RowRun({.verb = question.verb,
                .noun = std::string(Source::kNoun),
                .verify = options.verify,
                .fail_if_found = question.fail_if_found,
                .has_files = question.has_files},
               console),
        verb_(std::move(question.verb)),
        verified_(options.verify),
        posed_(options.pose.has_value()),
        rows_(rows, console),
        pose_(stated_pose(options, console)) {}

  /// Of the model.
  [[nodiscard]] const Pose& pose() const { return pose_; }

  /// Of coordinates in answers about a mesh: none where a pose moves it.
  [[nodiscard]] Georeference georeference(const MeshView& mesh) const {
    return posed_ ? Georeference{} : mesh.georeference;
  }

  /// The rows to answer.
  [[nodiscard]] const std::vector<Row>& block() const { return block_; }

  /// True if there is one row. Reads the second one, and waits for it.
  [[nodiscard]] bool read_single() { return rows_.is_single(); }

  /// Prints the object of row number `totals().rows`. `keys` begin with a comma.
  void print_json(const MeshView& mesh, std::string_view key, std::string_view keys, bool right,
                  bool last) const {
    std::string more;
    if (verified_) {
      more += right ? ",\"verified\":true" : ",\"verified\":false";
    }
    more += last ? ",\"timed_out\":true" : "";
    if (totals().rows == 0) {
      const std::vector<std::string> notes = notes_of({&mesh, 1});
      const Georeference place = georeference(mesh);
      more += place.empty() ? "" : ",\"georeference\":" + json_text(georeference_json(place));
      more += notes.empty() ? "" : ",\"notes\":" + json_text(notes);
    }
    console().print(fmt::format("{{\"schema\":\"soms.{}/2\",\"{}\":{}{}{}}}\n", verb_, key,
                                totals().rows, keys, more));
  }

  /// Says how many rows the table for people leaves out.
  void print_left_out() const {
    if (totals().rows > kProbesInText) {
      console().print(
          fmt::format("   and {} more; --json lists all\n",
                      counted(totals().rows - kProbesInText, std::string(Source::kNoun))));
    }
  }

 private:
  void begin() override {}

  /// Whoever reads a program's answers needs no other form for a single row.
  [[nodiscard]] bool is_single() const override { return false; }

  void clear_block() final { block_.clear(); }

  bool ready() final { return rows_.ready(); }

  bool read_row() final {
    const std::optional<Row> row = rows_.next();
    if (row) {
      block_.push_back(*row);
    }
    return row.has_value();
  }

  void doubt() final {}

  std::string verb_;
  bool verified_;
  bool posed_;
  Source rows_;
  Pose pose_;
  std::vector<Row> block_;
};

}  // namespace soms::command
