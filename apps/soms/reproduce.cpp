#include "apps/soms/reproduce.h"

#include "soms/base/error.h"

#include "apps/soms/console.h"
#include "apps/soms/output.h"
#include "apps/soms/text.h"
#include "reproduce/report.h"

#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <string_view>
#include <system_error>

namespace soms::command {

namespace {

namespace fs = std::filesystem;

constexpr int kOutOfTime = 4;
constexpr int kInterrupted = 130;

std::string help_of_items() {
  std::string text = "Items:\n";
  for (const reproduce::Experiment& experiment : reproduce::experiments()) {
    text += fmt::format("  {:<28}{}\n", experiment.item, experiment.title);
  }
  return text;
}

/// The words of --item, which may hold several with commas between.
std::vector<std::string_view> words_of(const std::vector<std::string>& items) {
  std::vector<std::string_view> words;
  for (std::string_view rest : items) {
    while (!rest.empty()) {
      const std::string_view word = rest.substr(0, rest.find(','));
      rest.remove_prefix(std::min(rest.size(), word.size() + 1));
      if (!word.empty()) {
        words.push_back(word);
      }
    }
  }
  return words;
}

std::vector<const reproduce::Experiment*> chosen(const ReproduceOptions& options) {
  try {
    return reproduce::experiments_named(words_of(options.items));
  } catch (const Error& error) {
    throw Error(error.kind(), "--item: " + error.place(), error.remedy());
  }
}

void make_folder(const fs::path& folder) {
  std::error_code failed;
  fs::create_directories(folder, failed);
  if (failed || !fs::is_directory(folder)) {
    throw Error(ErrorKind::cannot_write,
                fmt::format("{}: cannot make the folder: {}", folder.string(),
                            failed ? failed.message() : "a file has this name"),
                "choose another place for the output");
  }
}

void write_whole(const fs::path& path, std::string_view bytes) {
  OutputFile file(path);
  file.stream().write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  file.commit();
}

/// Names each model that another one stands in for, with the reason.
void tell_models(const std::vector<reproduce::Model>& models, const Console& console) {
  for (const reproduce::Model& model : models) {
    if (!model.trouble.empty()) {
      console.complain(
          fmt::format("{}: {}; in its place: {}", model.name, model.trouble, model.title));
    }
  }
}

reproduce::Report run_experiments(const ReproduceOptions& options, const Console& console) {
  const fs::path folder = options.output;
  Progress bar = console.progress("reproducing");
  const reproduce::RunVisitor visitor{.write =
                                          [&](const fs::path& name, std::string_view bytes) {
                                            make_folder((folder / name).parent_path());
                                            write_whole(folder / name, bytes);
                                          },
                                      .progress =
                                          [&](const reproduce::Experiment& now, double share) {
                                            bar.rename(fmt::format("{:<18}", now.item));
                                            bar.show(share);
                                          }};
  const reproduce::RunOptions run{
      .models = options.models, .experiments = chosen(options), .quick = options.quick};
  return console.run("reproducing", [&](const Parallel& limits) {
    Parallel one_thread = limits;
    one_thread.threads = 1;
    return reproduce::run(run, visitor, one_thread);
  });
}

/// The verdicts, a line each; what was measured, and why, is on the page.
std::string summary(const reproduce::Report& report, const ReproduceOptions& options) {
  std::string text;
  for (const reproduce::Entry& entry : report.entries) {
    for (const reproduce::Finding& finding : entry.result.findings) {
      text += fmt::format("{:<20}{:<13}{}\n", name(finding.verdict), entry.experiment->item,
                          finding.claim);
    }
  }
  const std::size_t items = report.entries.size() + report.missing.size();
  text += fmt::format("{} of {} written; see {}\n", report.entries.size(), counted(items, "item"),
                      (fs::path(options.output) / "index.html").string());
  return text;
}

}  // namespace

Action add_reproduce(CLI::App& app, Shared&) {
  const auto options = std::make_shared<ReproduceOptions>();
  app.add_option("--models", options->models,
                 "folder of the thesis' models; what is missing is generated; see below")
      ->option_text("DIR");
  app.add_option("--item", options->items,
                 "only these, with commas between: table-5.3, figure-5.2,\n"
                 "5.3 for both, thesis, beyond; see below")
      ->option_text("LIST");
  app.add_option("-o,--output", options->output,
                 "folder to write; made if missing (default: soms-thesis)")
      ->option_text("DIR");
  app.add_flag("--quick", options->quick, "a tenth of the repetitions, smaller sweeps");
  app.footer(std::string(reproduce::kModelsHelp) + "\n" + help_of_items() +
             "\nWrites DIR/index.html, a page of all that was found, tables/*.csv, figures/*.svg,\n"
             "scenes/*.3ds and run.json. Counts are the same in every run; times are of this\n"
             "machine. Everything takes some minutes, with --quick less than two.\n"
             "\nExample:\n  soms reproduce --quick --item 5.3,5.9 -o thesis");
  return [options](Console& console) { return run_reproduce(*options, console); };
}

int run_reproduce(const ReproduceOptions& options, Console& console) {
  make_folder(options.output);
  const reproduce::Report report = run_experiments(options, console);
  if (options.models.empty()) {
    console.note("no --models: generated stand-ins take the place of the thesis' models");
  } else {
    tell_models(report.models.objects, console);
    tell_models(report.models.scenes, console);
  }
  for (const std::string& remark : report.models.remarks) {
    console.note(remark);
  }
  console.print(console.shared().json ? reproduce::manifest(report) : summary(report, options));
  if (report.missing.empty()) {
    return 0;
  }
  console.complain(fmt::format("ended early, before {}; what is written is whole",
                               report.missing.front()->item));
  return console.interrupted() ? kInterrupted : kOutOfTime;
}

}  // namespace soms::command
