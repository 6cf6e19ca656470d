#include "thesis/page/report.h"

#include "soms/base/error.h"

#include "thesis/page/latex.h"
#include "thesis/races/touching_drive.h"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <numeric>

namespace soms::reproduce {

namespace {

/// Share of a comparison with golden tables beside the weights of the experiments.
constexpr int kGoldenWeight = 30;

Needs all_needs(const RunOptions& options) {
  Needs needs{.objects = options.golden.has_value(), .scenes = options.golden.has_value()};
  for (const Experiment* experiment : options.experiments) {
    needs.objects |= experiment->needs.objects;
    needs.scenes |= experiment->needs.scenes;
    needs.cities |= experiment->needs.cities;
  }
  return needs;
}

std::string now() {
  const std::time_t seconds =
      std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
  return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(seconds));
}

/// Wall and processor time since it was made.
class Stopwatch {
 public:
  /// Also of the processes of a leader; may be null.
  explicit Stopwatch(const RaceLeader* leader)
      : leader_(leader), processor_start_(processor_seconds_of_all()) {}

  [[nodiscard]] double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }

  [[nodiscard]] double processor_seconds() const {
    return processor_seconds_of_all() - processor_start_;
  }

 private:
  [[nodiscard]] double processor_seconds_of_all() const {
    return reproduce::processor_seconds() + (leader_ == nullptr ? 0 : leader_->processor_seconds());
  }

  const RaceLeader* leader_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  double processor_start_;
};

/// Fills in what is known at the end of a run only.
void close(Report& report, const Stopwatch& watch) {
  report.ended = now();
  report.seconds = watch.seconds();
  report.processor_seconds = watch.processor_seconds();
  report.load.end = load_averages();
  for (const Entry& entry : report.entries) {
    if (shows_times(entry.result)) {
      report.load.timed_seconds += entry.seconds;
      report.load.timed_processor_seconds += entry.processor_seconds;
    }
  }
}

void write_files(const Result& result, bool latex, const RunVisitor& visitor) {
  for (const Table& table : result.tables) {
    visitor.write(file_of(table), to_csv(table));
    if (latex) {
      visitor.write(latex_file_of(table), to_latex(table));
    }
  }
  for (const Figure& figure : result.figures) {
    visitor.write(file_of(figure), figure.svg);
  }
}

void write_scenes(Report& report, const RunVisitor& visitor) {
  for (const Model& scene : report.models.scenes) {
    if (scene.stand_in) {
      report.model_files.push_back(fmt::format("scenes/{}.3ds", scene.name));
      visitor.write(report.model_files.back(), scene_file(scene));
    }
  }
}

/// Runs experiments one by one and knows the share of all that is done.
class Runner {
 public:
  Runner(const RunOptions& options, const RunVisitor& visitor, const Limits& limits,
         RaceLeader* leader)
      : options_(options), visitor_(visitor), limits_(limits), leader_(leader) {
    for (const Experiment* experiment : options.experiments) {
      all_ += experiment->weight;
    }
    all_ += options.golden ? kGoldenWeight : 0;
  }

  Entry operator()(const Experiment& experiment, const Models& models) {
    Context context{
        .models = models, .quick = options_.quick, .draw = options_.draw, .touching = &touching_};
    context.limits = watched(experiment.item, experiment.weight);
    context.counting_threads = limits_.threads;
    if (leader_ != nullptr) {
      leader_->begin(experiment.item);
      context.races = leader_;
    }
    const Stopwatch watch(leader_);
    Entry entry{.experiment = &experiment, .result = experiment.run(context)};
    for (const Claim& claim : entry.result.claims) {
      entry.result.tables.push_back(claim_table(claim));
    }
    entry.seconds = watch.seconds();
    entry.processor_seconds = watch.processor_seconds();
    done_ += experiment.weight;
    return entry;
  }

  /// \pre The tables are there.
  GoldenComparison compare(const Models& models) const {
    return compare_with_golden(*options_.golden, models, watched("golden tables", kGoldenWeight));
  }

 private:
  /// What work of this weight gets; its start is shown.
  [[nodiscard]] Limits watched(std::string_view now, int weight) const {
    const auto show = [this, now, weight](double share) {
      if (visitor_.progress) {
        visitor_.progress(now, (done_ + share * weight) / std::max(1, all_));
      }
    };
    show(0);
    Limits limits = limits_;
    limits.threads = 1;
    limits.progress = show;
    return limits;
  }

  const RunOptions& options_;
  const RunVisitor& visitor_;
  const Limits& limits_;
  RaceLeader* leader_;
  TouchingDrives touching_;
  int all_ = 0;
  int done_ = 0;
};

}  // namespace

std::filesystem::path file_of(const Table& table) {
  return std::filesystem::path("tables") / (table.id + ".csv");
}

std::filesystem::path file_of(const Figure& figure) {
  return std::filesystem::path("figures") / (figure.id + ".svg");
}

Report run(const RunOptions& options, const RunVisitor& visitor, const Limits& limits,
           RaceLeader* leader) {
  const Stopwatch watch(leader);
  Report report{.machine = this_machine(), .date = now(), .quick = options.quick};
  report.missing = options.experiments;
  report.command = command_line();
  report.load = {.start = load_averages(), .processors = report.machine.processors};
  report.latex = options.latex;
  Runner runner(options, visitor, limits, leader);
  try {
    report.models = find_models(options.models, all_needs(options), limits);
    if (visitor.found) {
      visitor.found(report.models);
    }
    write_scenes(report, visitor);
    while (!report.missing.empty()) {
      check_stop(limits);
      report.entries.push_back(runner(*report.missing.front(), report.models));
      report.missing.erase(report.missing.begin());
      write_files(report.entries.back().result, options.latex, visitor);
    }
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::cancelled) {
      throw;
    }
  }
  if (options.golden) {
    report.golden = runner.compare(report.models);
  }
  close(report, watch);
  if (report.latex) {
    visitor.write(kLatexOfAll, latex_of_all(report));
  }
  visitor.write("index.html", page(report));
  visitor.write("run.json", manifest(report));
  return report;
}

}  // namespace soms::reproduce
