/// \file
/// Rows of points beside one model, of which the answer says a side each.
#pragma once

#include "soms/query/contains.h"

#include "apps/rows/point_source.h"
#include "apps/soms/probes/contains.h"
#include "apps/soms/probes/contains_output.h"
#include "apps/soms/probes/probe_run.h"
#include "apps/soms/solid/closed_body.h"

#include <fmt/format.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

namespace soms::command {

/// What the runs of `contains` that answer for the model as a whole share.
class SideRun : public ProbeRun<PointSource> {
 protected:
  SideRun(const ContainsVerbOptions& options, SideFiles& files, Console& console)
      : ProbeRun(options, options.points,
                 {.verb = "contains", .has_files = !options.csv.empty() || !options.binary.empty()},
                 console),
        files_(files) {}

 private:
  [[nodiscard]] virtual const MeshView& mesh() const = 0;
  [[nodiscard]] virtual Side side(std::size_t k) const = 0;
  [[nodiscard]] virtual bool is_cut(std::size_t k) const = 0;
  /// Writes an answer to files.
  virtual void put(std::size_t k, SideFiles& files) const = 0;
  /// Keys of a JSON row, each after a comma.
  [[nodiscard]] virtual std::string keys(std::size_t k) const = 0;

  /// What stands between side and point in the table for people, and above it.
  [[nodiscard]] virtual std::string column(std::size_t) const { return ""; }

  [[nodiscard]] virtual std::string column_head() const { return ""; }

  [[nodiscard]] Outcome outcome(std::size_t k) const override {
    return {.found = side(k) == Side::inside,
            .undecided = side(k) == Side::undecided,
            .cut = is_cut(k)};
  }

  void print_row(std::size_t k, bool right, bool last) override {
    ++counts_[static_cast<std::size_t>(side(k))];
    put(k, files_);
    if (console().shared().json) {
      print_json(mesh(), "row", keys(k), right, last);
      return;
    }
    if (totals().rows == 0) {
      console().print(fmt::format("{:>6}  {:<9}  {}at\n", "point", "side", column_head()));
    }
    if (totals().rows < kProbesInText) {
      console().print(fmt::format("{:>6}  {:<9}  {}{}\n", totals().rows, name(side(k)), column(k),
                                  point_in_text(block()[k])));
    }
  }

  void print_totals() override {
    print_left_out();
    const auto count = [&](Side side) {
      return with_commas(counts_[static_cast<std::size_t>(side)]);
    };
    std::string line =
        fmt::format("{}: {} inside, {} outside, {} on the surface", counted(totals().rows, "point"),
                    count(Side::inside), count(Side::outside), count(Side::on));
    if (totals().undecided != 0) {
      line += fmt::format(", {} undecided", count(Side::undecided));
    }
    console().print(line + "\n");
  }

  void finish(End) override {
    files_.csv.finish();
    files_.columns.finish();
  }

  SideFiles& files_;
  std::array<std::uint64_t, 4> counts_ = {};  // of each side
};

}  // namespace soms::command
