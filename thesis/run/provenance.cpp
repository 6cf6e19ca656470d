#include "thesis/run/provenance.h"

#include "soms/base/text.h"

#include <fmt/format.h>

#include <cstdint>
#include <string_view>

namespace soms::reproduce {

namespace {

/// One row of a list of facts; none if the value is empty.
std::string row(std::string_view what, std::string_view value) {
  return value.empty() ? std::string()
                       : fmt::format("<dt>{}</dt><dd>{}</dd>\n", what, xml_text(value));
}

/// A commit as people write it: its first twelve digits, and whether files were changed.
std::string short_commit(const std::string& commit) {
  constexpr std::size_t kDigits = 12;
  constexpr std::string_view kDirty = "-dirty";
  const bool dirty = commit.ends_with(kDirty);
  return commit.substr(0, kDigits) +
         (dirty && commit.size() > kDigits ? " with local changes" : "");
}

std::string program(const Machine& machine) {
  return machine.commit.empty()
             ? "soms " + machine.version
             : fmt::format("soms {}, commit {}", machine.version, short_commit(machine.commit));
}

std::string averages(const LoadAverages& of) {
  return of ? fmt::format("{:.2f}, {:.2f}, {:.2f}", (*of)[0], (*of)[1], (*of)[2]) : "unknown";
}

std::string folded_facts(const Report& report) {
  const Machine& machine = report.machine;
  std::string rows = row("Command", report.command);
  rows += row("Commit", machine.commit);
  rows += row("Build type", machine.build_type);
  rows += row("Compiler flags", machine.flags);
  rows += row("Instruction set", machine.instruction_set);
  rows += row("Usable processors", machine.usable_processors);
  rows += row("Memory", machine.memory == 0 ? "" : readable_bytes(machine.memory));
  if (!report.ended.empty()) {
    rows += row("Ended", report.ended);
    rows += row("Time", fmt::format("{:.1f} s, {:.1f} s of processor time", report.seconds,
                                    report.processor_seconds));
    rows +=
        row("Load averages", fmt::format("{} at the start; {} at the end, with this run (means "
                                         "of 1, 5 and 15 minutes)",
                                         averages(report.load.start), averages(report.load.end)));
  }
  return rows.empty() ? rows
                      : "<details class=\"facts\">\n<summary>More about this run</summary>\n<dl "
                        "class=\"run\">\n" +
                            rows + "</dl>\n</details>\n";
}

}  // namespace

std::string run_facts(const Report& report) {
  const Machine& machine = report.machine;
  std::string text = "<dl class=\"run\">\n";
  text += row("Run", report.date);
  text += row("Options", report.quick ? "quick: fewer repetitions and smaller sweeps" : "full");
  text += row("Program", program(machine));
  text +=
      row("Processor", fmt::format("{} ({} processor{}; what is timed uses one)", machine.processor,
                                   machine.processors, machine.processors == 1 ? "" : "s"));
  text += row("System", machine.system);
  text += row("Compiler", machine.compiler);
  return text + "</dl>\n" + folded_facts(report);
}

std::string load_warning(const Load& load) {
  const std::vector<std::string> signs = signs_of_load(load);
  if (signs.empty()) {
    return {};
  }
  std::string text =
      "<p class=\"warn\"><strong>The machine was busy.</strong> Times may be too long, "
      "and verdicts on times may be wrong:";
  std::string_view comma = " ";
  for (const std::string& sign : signs) {
    text += comma;
    text += xml_text(sign);
    comma = "; ";
  }
  return text + ". Counts are not affected.</p>\n";
}

std::string model_files(const Models& models) {
  std::string rows;
  for (const auto* kind : {&models.objects, &models.scenes, &models.cities}) {
    for (const Model& model : *kind) {
      if (!model.sha256.empty()) {
        rows += fmt::format(
            "<tr><td>{}</td><td class=\"number\">{}</td><td><code>{}</code></td></tr>\n",
            xml_text(model.file.empty() ? "scenes/" + model.name + ".3ds" : model.file),
            to_text(static_cast<std::int64_t>(model.bytes)), model.sha256);
      }
    }
  }
  if (rows.empty()) {
    return {};
  }
  return "<details class=\"facts\">\n<summary>Files of the models: size and SHA-256</summary>\n"
         "<div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"Files of the "
         "models\">\n<table>\n<thead><tr><th>file</th><th class=\"number\">bytes</th><th>SHA-256"
         "</th></tr></thead>\n<tbody>\n" +
         rows + "</tbody>\n</table>\n</div>\n</details>\n";
}

}  // namespace soms::reproduce
