/// \file
/// A run whose rows are rays, or segments, beside a model.
#pragma once

#include "soms/query/ray.h"
#include "soms/query/reference/ray.h"
#include "soms/tiles/tiled_queries.h"

#include "apps/soms/answers/answer_columns.h"
#include "apps/soms/probes/probe_run.h"
#include "apps/soms/probes/ray.h"
#include "apps/soms/probes/ray_output.h"
#include "apps/store/probed_model.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace soms::command {

/// What brute force finds otherwise than `answer`; nothing if it agrees. Of an answer that was cut,
/// only what it says is compared.
[[nodiscard]] std::optional<std::string> difference_of(const RayAnswer& answer,
                                                       const RayAnswer& truth);

/// Files of answers, opened before the model is read.
struct RayFiles {
  explicit RayFiles(const RayVerbOptions& options) : csv(options.csv), columns(options.binary) {}

  RayCsv csv;
  RayColumns columns;
};

/// `Source` gives rays or segments.
template <class Source>
class RayRun : public ProbeRun<Source> {
 public:
  RayRun(const RayVerbOptions& options, const std::string& rows, RayFiles& files, Console& console)
      : ProbeRun<Source>(options, rows,
                         {.verb = "ray",
                          .fail_if_found = options.fail_if_hit,
                          .has_files = !options.csv.empty() || !options.binary.empty()},
                         console),
        options_(options),
        files_(files),
        model_(options.model, options.reading, options.build, this->pose(),
               {refused_verify(options.verify),
                {options.all, "--all", "a crossing through an edge may be of two of them"}},
               console),
        question_{.skip = options.skip, .deadline = console.deadline()} {
    const RayAnswer like = options.all   ? RayAnswer(Crossings())
                           : options.any ? RayAnswer(AnyHit())
                                         : RayAnswer(ClosestHit());
    files_.csv.begin(mesh(), this->georeference(mesh()), like);
    files_.columns.begin(like);
    files_.columns.state(this->georeference(mesh()));
  }

 private:
  using Outcome = RowRun::Outcome;

  [[nodiscard]] const MeshView& mesh() const { return model_.mesh(); }

  std::uint64_t answer_block() override {
    answers_.clear();
    const Parallel parallel = this->console().parallel();
    if (options_.all) {
      const AllHits hits = all_hits(model_.body(), this->block(), question_, parallel);
      for (std::size_t k = 0; k < hits.size(); ++k) {
        answers_.emplace_back(crossings_of(hits, k));
      }
      return hits.triangle.size();
    }
    model_.visit([&](const auto& body) {
      const std::span<const typename Source::Row> rows(this->block());
      if (options_.any) {
        add(any_hit(body, rows, question_, parallel));
      } else {
        add(closest_hit(body, rows, question_, parallel));
      }
    });
    return 0;
  }

  template <class Batch>
  void add(const Batch& batch) {
    for (std::size_t k = 0; k < batch.size(); ++k) {
      answers_.emplace_back(batch.at(k));
    }
  }

  [[nodiscard]] Outcome outcome(std::size_t k) const override {
    const RayAnswer& answer = answers_[k];
    return {.found = is_hit(answer),
            .undecided = is_cut(answer) && !is_hit(answer),
            .cut = is_cut(answer)};
  }

  [[nodiscard]] std::optional<std::string> difference(std::size_t k) override {
    return difference_of(answers_[k], this->console().run("verifying", [&](const Parallel&) {
      return truth(this->block()[k]);
    }));
  }

  [[nodiscard]] RayAnswer truth(const typename Source::Row& row) const {
    if (options_.all) {
      return crossings_of(reference::all_hits_by_brute_force(model_.body(), row, options_.skip), 0);
    }
    return reference::closest_hit_by_brute_force(model_.body(), row, options_.skip);
  }

  void print_row(std::size_t k, bool right, bool last) override {
    const RayAnswer& answer = answers_[k];
    if (this->console().shared().json) {
      this->print_json(mesh(), "ray", ray_keys(answer), right, last);
    } else {
      table_.add(Source::kNoun, answer, mesh(), this->console());
    }
    files_.csv.add(this->totals().rows, answer);
    files_.columns.add(answer);
    if (const auto* all = std::get_if<Crossings>(&answer)) {
      crossings_ += all->places.size();
      triangles_ += all->count();
    }
  }

  void print_totals() override {
    this->print_left_out();
    const RowTotals& totals = this->totals();
    std::string line = fmt::format(
        "{}: {} hit, {} free", counted(totals.rows, std::string(Source::kNoun)),
        with_commas(totals.found), with_commas(totals.rows - totals.found - totals.undecided));
    if (totals.undecided != 0) {
      line += fmt::format(", {} undecided", with_commas(totals.undecided));
    }
    if (options_.all) {
      line +=
          fmt::format("; {}, {}", counted(crossings_, "crossing"), counted(triangles_, "triangle"));
    }
    this->console().print(line + "\n");
  }

  void finish(RowRun::End /*end*/) override {
    files_.csv.finish();
    files_.columns.finish();
  }

  const RayVerbOptions& options_;
  RayFiles& files_;
  ProbedModel model_;
  RayOptions question_;
  std::vector<RayAnswer> answers_;
  RayTable table_;
  std::uint64_t crossings_ = 0;
  std::uint64_t triangles_ = 0;  // that are hit, in all crossings
};

}  // namespace soms::command
