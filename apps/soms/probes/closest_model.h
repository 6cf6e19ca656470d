/// \file
/// What the questions of `closest` share, and that of --nearest and --radius.
#pragma once

#include "soms/geometry/parts_of.h"
#include "soms/query/closest.h"

#include "apps/rows/point_source.h"
#include "apps/soms/answers/array_columns.h"
#include "apps/soms/probes/closest.h"
#include "apps/soms/probes/closest_output.h"
#include "apps/soms/probes/probe_rows.h"
#include "apps/store/probed_model.h"
#include "apps/world/part_names.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace soms::command {

/// The model of `closest`, and what its questions share.
class ClosestModel {
 public:
  ClosestModel(const ClosestVerbOptions& options, const Pose& pose, const Console& console);

  [[nodiscard]] const ProbedModel& model() const { return model_; }

  [[nodiscard]] const ProbeReport& report() const { return report_; }

  [[nodiscard]] const MeshView& mesh() const { return report_.mesh(); }

  [[nodiscard]] const ClosestOptions& query() const { return query_; }

  [[nodiscard]] const Console& console() const { return console_; }

  [[nodiscard]] std::string cells(std::optional<TriangleId> triangle) const {
    return triangle_csv_fields(mesh(), parts_, triangle);
  }

 private:
  ProbedModel model_;
  ProbeReport report_;
  PartsOf parts_;
  ClosestOptions query_;
  const Console& console_;
};

/// "2 points: ...", of these parts, with a line break.
[[nodiscard]] std::string closest_totals(const RowTotals& totals, std::vector<std::string> parts);

/// Which triangles are near to each point?
class NearListsQuestion : public Question {
 public:
  NearListsQuestion(const ClosestVerbOptions& options, const ProbeRows<PointSource>& rows,
                    const Pose& pose, const Console& console);

  std::uint64_t answer(const ShowProgress& show) override;
  [[nodiscard]] RowOutcome outcome(std::size_t k) const override;
  [[nodiscard]] std::optional<std::string> difference(std::size_t k) override;
  void count(const AnsweredRow& row) override;
  void json(const AnsweredRow& row, JsonRows& rows) const override;
  [[nodiscard]] std::string sentence(std::size_t k) const override;
  [[nodiscard]] std::string text_head() const override;
  [[nodiscard]] std::string text(const AnsweredRow& row) const override;
  [[nodiscard]] std::string totals(const RowTotals& totals) const override;
  [[nodiscard]] std::string csv_head() const override;
  void csv(const AnsweredRow& row, CsvFile& file) const override;
  void begin_columns(NpzFile& file) override;
  void add_columns(std::size_t rows) override;

 private:
  [[nodiscard]] bool is_cut(std::size_t k) const { return lists_.coverage[k] == Coverage::cut; }

  [[nodiscard]] std::vector<ListedTriangle> hits_of(std::size_t k) const {
    std::vector<ListedTriangle> hits;
    for (std::size_t i = lists_.offsets[k]; i < lists_.offsets[k + 1]; ++i) {
      hits.push_back({lists_.triangle[i], {lists_.lower[i], lists_.upper[i]}});
    }
    return hits;
  }

  /// The same with the numbers of the file.
  [[nodiscard]] std::vector<ListedTriangle> shown(std::size_t k) const {
    std::vector<ListedTriangle> hits = hits_of(k);
    for (ListedTriangle& hit : hits) {
      hit.triangle = model_.model().numbers()(hit.triangle);
    }
    return hits;
  }

  std::size_t most_;
  const ProbeRows<PointSource>& rows_;
  ClosestModel model_;
  NearTriangles lists_;
  std::uint64_t hits_ = 0;
  OffsetColumn offsets_;
  NpzColumn* lower_ = nullptr;
  NpzColumn* upper_ = nullptr;
  NpzColumn* triangle_ = nullptr;
  NpzColumn* coverage_ = nullptr;
};

}  // namespace soms::command
