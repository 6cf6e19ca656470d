#include "thesis/program/reproduce.h"

#include "soms/base/error.h"

#include "apps/cli/console.h"
#include "apps/cli/exit_status.h"
#include "apps/cli/parse.h"
#include "apps/cli/parser.h"
#include "apps/cli/suggest.h"
#include "apps/cli/text.h"
#include "apps/output/output.h"
#include "thesis/claims/nearest_verdict.h"
#include "thesis/page/report.h"
#include "thesis/program/draw_frames.h"
#include "thesis/program/print_pdf.h"
#include "thesis/program/timing_process.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <set>
#include <string_view>
#include <system_error>

namespace soms::command {

namespace {

namespace fs = std::filesystem;

std::string help_of_items() {
  std::string text = "Items:\n";
  for (const reproduce::Experiment& experiment : reproduce::experiments()) {
    text += fmt::format("  {:<28}{}\n", experiment.item, experiment.title);
  }
  return text;
}

/// The words of --item, which may hold several with commas between.
std::vector<std::string_view> words_of(const std::vector<std::string>& items) {
  constexpr std::string_view kBetween = ", ";
  std::vector<std::string_view> words;
  for (const std::string_view item : items) {
    std::size_t begin = item.find_first_not_of(kBetween);
    while (begin != std::string_view::npos) {
      const std::size_t end = std::min(item.size(), item.find_first_of(kBetween, begin));
      words.push_back(item.substr(begin, end - begin));
      begin = item.find_first_not_of(kBetween, end);
    }
  }
  return words;
}

/// The item that was meant by the first word that names none; empty if none is near.
std::string meant_item(const std::vector<std::string_view>& words) {
  std::vector<std::string> items;
  for (const reproduce::Experiment& experiment : reproduce::experiments()) {
    items.emplace_back(experiment.item);
  }
  for (const std::string_view& word : words) {
    try {
      static_cast<void>(reproduce::experiments_named({&word, 1}));
    } catch (const Error&) {
      return nearest_words(word, items);
    }
  }
  return {};
}

std::vector<const reproduce::Experiment*> chosen(const ReproduceOptions& options) {
  const std::vector<std::string_view> words = words_of(options.items);
  if (words.empty() && !options.items.empty()) {
    throw Error(ErrorKind::usage, "--item: the list is empty", "leave it out to run everything");
  }
  try {
    return reproduce::experiments_named(words);
  } catch (const Error& error) {
    const std::string near = meant_item(words);
    throw Error(error.kind(), "--item: " + error.place(),
                (near.empty() ? "" : "did you mean " + near + "? ") + error.remedy());
  }
}

void make_folder(const fs::path& folder) {
  std::error_code failed;
  fs::create_directories(folder, failed);
  if (failed || !fs::is_directory(folder)) {
    throw Error(ErrorKind::cannot_write,
                fmt::format("{}: cannot create the folder: {}", folder.string(),
                            failed ? failed.message() : "a file has this name"),
                "choose another location for the output");
  }
}

void write_whole(const fs::path& path, std::string_view bytes) {
  OutputFile file(path);
  file.stream().write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  file.commit();
}

/// A line on standard error that --quiet does not leave out.
void tell_fault(std::string_view line) {
  print_error("soms reproduce", line);
}

/// Names each model that another one stands in for, with the reason, and files that were not used.
void tell_models(const reproduce::Models& models, const ReproduceOptions& options,
                 const Console& console) {
  if (options.models.empty()) {
    console.note("no --models: generated stand-ins replace the models of the thesis");
    return;
  }
  std::set<std::string> reported;  // of a broken scene in place of all three
  for (const auto* const kind : {&models.objects, &models.scenes}) {
    for (const reproduce::Model& model : *kind) {
      if (!model.trouble.empty() && reported.insert(model.trouble).second) {
        tell_fault(fmt::format("{}: {}; instead: {}", model.name, model.trouble, model.title));
      }
    }
  }
  for (const std::string& remark : models.remarks) {
    tell_fault(remark);
  }
}

/// Warns of times measured on a busy machine.
void tell_load(const reproduce::Load& load, const Console& console) {
  const std::vector<std::string> signs = reproduce::signs_of_load(load);
  if (!signs.empty()) {
    console.note(
        fmt::format("the machine was busy, so times may be too long: {}", fmt::join(signs, "; ")));
  }
}

reproduce::Report run_experiments(const ReproduceOptions& options, const reproduce::RunOptions& run,
                                  const Console& console) {
  const fs::path folder = options.output;
  Progress bar = console.progress("reproducing");
  reproduce::RunVisitor visitor;
  visitor.found = [&](const reproduce::Models& models) { tell_models(models, options, console); };
  visitor.write = [&](const fs::path& name, std::string_view bytes) {
    make_folder((folder / name).parent_path());
    write_whole(folder / name, bytes);
  };
  visitor.progress = [&](std::string_view now, double share) {
    bar.rename(fmt::format("{:<24}", now));
    bar.show(share);
  };
  return console.run("reproducing", [&](const Limits& limits) {
    const int processes = possible_timing_processes();
    reproduce::RaceLeader leader(processes, [&] {
      return start_timing_processes(processes - 1, {options.models, options.quick},
                                    console.shared(), limits);
    });
    return reproduce::run(run, visitor, limits, &leader);
  });
}

/// The verdicts, a line each: of the reading nearest to the text, and over all readings. What was
/// measured, and why, is on the page.
std::string summary(const reproduce::Report& report, const ReproduceOptions& options) {
  std::string text;
  for (const reproduce::Entry& entry : report.entries) {
    for (const reproduce::Claim& claim : entry.result.claims) {
      text += fmt::format("{:<19}{:<31}{:<24}{}\n", name(nearest_of(claim).stand),
                          name(verdict_of(claim)), entry.experiment->item, claim.statement);
    }
  }
  if (report.golden) {
    text += fmt::format("golden tables: {}\n", reproduce::summary_of(*report.golden));
  }
  const std::size_t items = report.entries.size() + report.missing.size();
  text += fmt::format("{} of {} written; see {}\n", report.entries.size(), counted(items, "item"),
                      printable((fs::path(options.output) / "index.html").string()));
  return text;
}

/// An option that names a folder to read.
void add_folder(Parser& parser, const std::string& option, std::string& folder,
                const std::string& help) {
  parser
      .add_option_function(
          option,
          [&folder, option](const std::string& name) {
            if (name.empty()) {
              throw Error(ErrorKind::usage, option + ": the name is empty",
                          "give the name of a folder, or leave it out");
            }
            folder = name;
          },
          help)
      ->option_text("DIR");
}

/// The tables to compare with, if any.
std::optional<reproduce::GoldenTables> golden_tables(const ReproduceOptions& options) {
  if (options.golden.empty()) {
    return std::nullopt;
  }
  try {
    return reproduce::read_golden(options.golden);
  } catch (const Error& error) {
    throw Error(error.kind(), "--golden: " + error.place(), error.remedy());
  }
}

/// Reports counts that differ from the golden tables; true if there are any.
bool tell_differences(const reproduce::Report& report) {
  if (!report.golden || report.golden->different() == 0) {
    return false;
  }
  for (const reproduce::GoldenDifference& difference : report.golden->differences) {
    tell_fault(reproduce::sentence_of(difference));
  }
  tell_fault("golden tables: " + reproduce::summary_of(*report.golden));
  return true;
}

/// The exit status, with a line on standard error for each one but 0.
int status_of(const reproduce::Report& report, const Console& console) {
  const bool differs = tell_differences(report);
  if (report.whole()) {
    return differs ? kDifference : 0;
  }
  tell_fault(
      fmt::format("ended early, before {}; the files written so far are complete",
                  report.missing.empty() ? "the last golden row" : report.missing.front()->item));
  return console.interrupted() ? kInterrupted : kOutOfTime;
}

}  // namespace

Action add_reproduce(Parser& parser, Shared&) {
  const auto options = std::make_shared<ReproduceOptions>();
  add_folder(parser, "--models", options->models,
             "folder of the thesis' models; missing models are generated; see below");
  parser
      .add_option("--item", options->items,
                  "run only these, separated by commas: table-5.3, figure-5.2,\n"
                  "5.3 for both, or a chapter: claims, thesis, beyond; see below")
      ->option_text("LIST");
  add_output(parser, "-o,--output", options->output,
             "folder to write, created if missing (default: soms-thesis)", "DIR");
  add_output(parser, "--report", options->report,
             "also write the page as a single, self-contained file");
  add_folder(parser, "--golden", options->golden,
             "compare all counts with thesis_counts.csv and\n"
             "thesis_traversal.csv in this folder; a difference gives exit status 6");
  add_output(parser, "--pdf", options->pdf, "also print the page as a PDF; needs Chromium");
  parser.add_flag("--latex", options->latex, "also write the tables for LaTeX, into DIR/latex");
  parser.add_flag("--quick", options->quick, "run a tenth of the repetitions and smaller sweeps");
  parser.footer(std::string(reproduce::kModelsHelp) + "\n" + help_of_items() +
                "\nWrites DIR/index.html, a page with all results, tables/*.csv, figures/*.svg,\n"
                "scenes/*.3ds and run.json. Counts are the same in every run; times depend on the\n"
                "machine. A full run takes some minutes, with --quick one to two.\n"
                "\nExample:\n  soms reproduce --quick --item 5.3,5.9 -o thesis");
  return [options](Console& console) { return run_reproduce(*options, console); };
}

int run_reproduce(const ReproduceOptions& options, Console& console) {
  const reproduce::RunOptions run{.models = options.models,
                                  .experiments = chosen(options),
                                  .quick = options.quick,
                                  .draw = draw_frames,
                                  .latex = options.latex,
                                  .golden = golden_tables(options)};
  check_outputs({{"--output", (fs::path(options.output) / "index.html").string()}},
                {{"--report", options.report}, {"--pdf", options.pdf}});
  check_extension("--report", options.report, {".html", ".htm"});
  check_extension("--pdf", options.pdf, {".pdf"});
  const fs::path chromium = options.pdf.empty() ? fs::path() : find_chromium();
  make_folder(options.output);
  std::optional<OutputFile> page;
  if (!options.report.empty()) {
    page.emplace(options.report);
  }
  std::optional<OutputFile> pdf;
  if (!options.pdf.empty()) {
    pdf.emplace(options.pdf);
  }
  const reproduce::Report report = run_experiments(options, run, console);
  tell_load(report.load, console);
  if (page) {
    page->stream() << reproduce::page(report, reproduce::PageFiles::inside);
    page->commit();
  }
  console.print(console.shared().json ? reproduce::manifest(report) : summary(report, options));
  console.flush();
  if (pdf && report.whole()) {
    pdf->stream() << printed_pdf(chromium, reproduce::page(report, reproduce::PageFiles::paper),
                                 console);
    pdf->commit();
  }
  return status_of(report, console);
}

}  // namespace soms::command
