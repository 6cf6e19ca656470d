/// \file
/// What of a model do rays hit, or segments? The closest hit, or --any.
#pragma once

#include "soms/geometry/parts_of.h"
#include "soms/query/ray.h"
#include "soms/query/reference/ray.h"
#include "soms/tiles/tiled_queries.h"

#include "apps/cli/text.h"
#include "apps/model/georeference.h"
#include "apps/rows/ray_source.h"
#include "apps/soms/answers/batch_question.h"
#include "apps/soms/probes/probe_rows.h"
#include "apps/soms/probes/ray.h"
#include "apps/soms/probes/ray_output.h"
#include "apps/store/probed_model.h"
#include "apps/world/part_names.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

namespace soms::command {

/// The model of rays of a `Source`, and what their questions share.
template <class Source>
class RayModel {
 public:
  RayModel(const RayVerbOptions& options, const ProbeRows<Source>& rows, const Pose& pose,
           const Console& console)
      : rows_(rows),
        model_(options.model, options.reading, options.build, pose,
               {refused_verify(options.verify),
                {options.all, "--all", "a crossing through an edge may be of two of them"}},
               console),
        report_(options, model_.mesh()),
        parts_(model_.mesh()),
        console_(console) {
    if (options.skip) {
      query_.skip = model_.numbers().in_shape(*options.skip);
    }
  }

  [[nodiscard]] const auto& rays() const { return rows_.block(); }

  [[nodiscard]] const ProbedModel& model() const { return model_; }

  [[nodiscard]] const ProbeReport& report() const { return report_; }

  [[nodiscard]] const RayOptions& query() const { return query_; }

  [[nodiscard]] const Console& console() const { return console_; }

  [[nodiscard]] std::string cells(std::optional<TriangleId> triangle) const {
    return triangle_csv_fields(report_.mesh(), parts_, triangle);
  }

  [[nodiscard]] ClosestHit closest_by_brute_force(std::size_t k) const {
    return console_.run("verifying", [&](const Limits&) {
      return reference::closest_hit_by_brute_force(model_.body(), rays()[k], query_.skip);
    });
  }

  /// "3 rays: 2 hit, 1 free", without a line break.
  [[nodiscard]] static std::string totals(const RowTotals& totals) {
    return fmt::format(
        "{}: {} hit, {} free{}", counted(totals.rows, std::string(Source::kNoun)),
        with_commas(totals.found), with_commas(totals.rows - totals.found - totals.undecided),
        totals.undecided == 0 ? "" : fmt::format(", {} undecided", with_commas(totals.undecided)));
  }

 private:
  const ProbeRows<Source>& rows_;
  ProbedModel model_;
  ProbeReport report_;
  PartsOf parts_;
  RayOptions query_;
  const Console& console_;
};

/// What brute force finds otherwise; nothing if it agrees. An answer that was cut is compared by
/// what it says alone.
[[nodiscard]] std::optional<std::string> difference_of(const ClosestHit& answer,
                                                       const ClosestHit& truth);
[[nodiscard]] std::optional<std::string> difference_of(const AnyHit& answer,
                                                       const ClosestHit& truth);

/// The answers T of each ray alone.
template <Described T, class Source>
class HitQuestion : public BatchQuestion<T> {
 public:
  HitQuestion(const RayVerbOptions& options, const ProbeRows<Source>& rows, const Pose& pose,
              const Console& console)
      : BatchQuestion<T>("ray", "ray"), model_(options, rows, pose, console) {
    if constexpr (kIsClosest) {
      georeference_ = GeoreferenceColumn(model_.report().georeference());
    }
  }

  std::uint64_t answer(const ShowProgress&) override {
    model_.model().visit([&](const auto& body) {
      const std::span<const typename Source::Row> rays(model_.rays());
      const Limits limits = model_.console().limits();
      if constexpr (kIsClosest) {
        this->set(closest_hit(body, rays, model_.query(), limits));
      } else {
        this->set(any_hit(body, rays, model_.query(), limits));
      }
    });
    return 0;
  }

  [[nodiscard]] std::optional<std::string> difference(std::size_t k) override {
    return difference_of(this->at(k), model_.closest_by_brute_force(k));
  }

  [[nodiscard]] std::string text_head() const override {
    return kIsClosest ? closest_hit_head(Source::kNoun) : any_hit_head(Source::kNoun);
  }

  [[nodiscard]] std::string text(const AnsweredRow& row) const override {
    if constexpr (kIsClosest) {
      return text_of(row.number, this->shown(row.k), model_.report().mesh(), this->digits());
    } else {
      return text_of(row.number, this->at(row.k));
    }
  }

  [[nodiscard]] std::string totals(const RowTotals& totals) const override {
    return model_.totals(totals) + "\n";
  }

  void begin_columns(NpzFile& file) override {
    hit_ = kIsClosest ? &file.column("hit", NpzColumn::Kind::flag) : nullptr;
    BatchQuestion<T>::begin_columns(file);
    add_georeference(file, model_.report().georeference());
  }

  void add_columns(std::size_t rows) override {
    BatchQuestion<T>::add_columns(rows);
    for (std::size_t k = 0; k < rows && hit_ != nullptr; ++k) {
      hit_->add(found(this->at(k)));
    }
  }

 private:
  static constexpr bool kIsClosest = std::is_same_v<T, ClosestHit>;

  [[nodiscard]] bool found(const T& answer) const override {
    if constexpr (kIsClosest) {
      return answer.triangle.has_value();
    } else {
      return answer.hit;
    }
  }

  [[nodiscard]] bool undecided(const T& answer) const override {
    return answer.coverage == Coverage::cut && !found(answer);
  }

  /// "true", "false", or `unknown` if time ended before a hit was found.
  [[nodiscard]] std::string word(const T& answer, const char* unknown) const {
    return found(answer) ? "true" : undecided(answer) ? unknown : "false";
  }

  [[nodiscard]] std::string lead_keys(const T& answer) const override {
    return kIsClosest ? ",\"hit\":" + word(answer, "null") : std::string();
  }

  [[nodiscard]] std::string row_keys(const AnsweredRow& row) const override {
    return model_.report().keys(row);
  }

  [[nodiscard]] std::string lead_head() const override { return kIsClosest ? ",hit" : ""; }

  [[nodiscard]] std::string lead_cells(std::size_t k) const override {
    return kIsClosest ? "," + word(this->at(k), "") : std::string();
  }

  [[nodiscard]] std::string more_head() const override { return std::string(georeference_.head()); }

  [[nodiscard]] std::string more_cells(std::size_t /*k*/) const override {
    return std::string(georeference_.field());
  }

  [[nodiscard]] std::string triangle_cells(int /*side*/,
                                           std::optional<TriangleId> triangle) const override {
    return model_.cells(triangle);
  }

  [[nodiscard]] const FileNumbers& numbers(int /*side*/) const override {
    return model_.model().numbers();
  }

  RayModel<Source> model_;
  GeoreferenceColumn georeference_;
  NpzColumn* hit_ = nullptr;
};

}  // namespace soms::command
