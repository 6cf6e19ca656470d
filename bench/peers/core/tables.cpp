#include "bench/peers/core/tables.h"

#include "soms/base/error.h"
#include "soms/base/text.h"

#include "bench/peers/core/machine.h"

#include <algorithm>
#include <fstream>
#include <iomanip>
#include <set>
#include <sstream>

namespace soms::bench {

namespace {

std::string fixed(double value, int digits) {
  std::ostringstream text;
  text << std::fixed << std::setprecision(digits) << value;
  return text.str();
}

/// Three digits that matter, in microseconds.
std::string micro(double seconds) {
  const double us = 1e6 * seconds;
  return fixed(us, us < 1 ? 3 : us < 10 ? 2 : us < 100 ? 1 : 0);
}

std::string times(const std::optional<double>& value) {
  return value ? fixed(*value, 2) : "void";
}

/// Counts are whole numbers; distances are not, and may be of any size.
std::string sum_of(const Cell& cell) {
  if (cell.job != Job::distance && cell.job != Job::closest && cell.job != Job::closest_hit) {
    return fixed(cell.sum, 0);
  }
  std::ostringstream text;
  text << std::setprecision(7) << cell.sum;
  return text.str();
}

std::string where(const Cell& cell) {
  return "| " + name(cell.job) + " | " + cell.scene + " | " + cell.set + " | " +
         std::to_string(cell.triangles);
}

const Entry* entry_of(const Cell& cell, const std::string& library) {
  const auto found = std::find_if(cell.entries.begin(), cell.entries.end(),
                                  [&](const Entry& e) { return e.library == library; });
  return found == cell.entries.end() ? nullptr : &*found;
}

std::string verdict(const std::optional<double>& reached, double goal) {
  if (!reached) {
    return "void";
  }
  return *reached >= goal ? "met" : "missed: " + fixed(100 * *reached / goal, 0) + " % of it";
}

std::string goal_text(double goal) {
  return fixed(goal, goal < 0.5 ? 2 : 1);
}

std::string kind(Against against) {
  return against == Against::keeps_tree     ? " (keeps its tree)"
         : against == Against::from_scratch ? " (from scratch)"
         : against == Against::watertight   ? " (watertight)"
                                            : "";
}

/// A row of the first table: soms in one manner against the best peer of a kind.
void goal_row(std::ostream& out, const Cell& cell, const Goal& goal) {
  const Entry* own = entry_of(cell, goal.library);
  const Entry* peer = best_peer(cell, goal.against);
  if (goal.against == Against::clock) {
    out << where(cell) << " | (a million answers a second) | 1.00 | ";
  } else if (peer != nullptr) {
    out << where(cell) << " | " << peer->library << kind(goal.against) << " | "
        << micro(peer->timing.median) << " | ";
  } else {
    return;
  }
  if (own == nullptr) {
    out << "no soms | | | " << (goal.times > 0 ? goal_text(goal.times) : "") << " | |\n";
    return;
  }
  const auto reached = ratio(cell, goal.library, goal.against);
  out << goal.library << " | " << micro(own->timing.median) << " | " << times(reached) << " | "
      << (goal.times > 0 ? goal_text(goal.times) + " | " + verdict(reached, goal.times) : " | ")
      << " |\n";
}

void goals(std::ostream& out, const std::vector<Cell>& cells, const std::string& isa) {
  out << "## soms against the best peer\n\nMicroseconds of processor time per answer. The goal is "
         "the ratio to reach"
      << (isa == "avx512" ? "" : " (half, without AVX-512)")
      << "; `void`: a wrong answer was given.\n\n"
         "| job | scene | set | triangles | best peer | its us | soms | us | ratio | goal | |\n"
         "|---|---|---|---:|---|---:|---|---:|---:|---:|---|\n";
  for (const Cell& cell : cells) {
    std::vector<Goal> wanted = goals_of(cell.job, cell.scene, cell.set, cell.triangles, isa);
    for (const Entry& entry : cell.entries) {
      const bool named = std::any_of(wanted.begin(), wanted.end(),
                                     [&](const Goal& g) { return g.library == entry.library; });
      if (is_ours(entry.library) && !is_measure(entry.library) && !named) {
        wanted.push_back({entry.library, 0});
      }
    }
    for (const Goal& goal : wanted) {
      goal_row(out, cell, goal);
    }
  }
}

/// Of scenes that have a goal for all of them.
void medians(std::ostream& out, const std::vector<Cell>& cells, const std::string& isa) {
  bool first = true;
  for (const MedianGoal& goal : median_goals(isa)) {
    const Median median = median_ratio(cells, goal);
    if (median.rows == 0) {
      continue;
    }
    out << (first ? "\nMedians of such rows:\n\n| job | scenes | rows | soms | median ratio | goal "
                    "| |\n|---|---|---:|---|---:|---:|---|\n"
                  : "")
        << "| " << name(goal.job) << " | " << goal.scenes << " | " << median.rows << " | "
        << goal.library << " | " << times(median.ratio) << " | " << goal_text(goal.times) << " | "
        << verdict(median.ratio, goal.times) << " |\n";
    first = false;
  }
}

std::string mark(const Cell& cell, const Entry& entry) {
  if (entry.verdict.wrong != 0) {
    return " wrong in " + std::to_string(entry.verdict.wrong) + " of " +
           std::to_string(entry.verdict.checked) + (ranked(cell, entry) ? "" : ": void");
  }
  return entry.answered == cell.questions ? "" : " first " + std::to_string(entry.answered);
}

void builds(std::ostream& out, const std::vector<Cell>& cells) {
  out << "\n## Building and memory\n\nAll bodies, ready to be queried; bytes for each triangle of "
         "them, own copies of the meshes included. Goal of soms: "
      << fixed(kMostBytes, 0)
      << " bytes.\n\n| scene | triangles | library | build ms | bytes a triangle | |\n"
         "|---|---:|---|---:|---:|---|\n";
  std::set<std::string> reported;
  for (const Cell& cell : cells) {
    for (const Entry& e : cell.entries) {
      const std::string row =
          "| " + cell.scene + " | " + std::to_string(cell.triangles) + " | " + e.library + " | ";
      const bool bodies_move = cell.job != Job::still && cell.job != Job::broad;
      if (!bodies_move || !reported.insert(row).second) {
        continue;
      }
      out << row << fixed(1e3 * e.build, e.build < 0.1 ? 2 : 0) << " | " << fixed(e.bytes, 0)
          << " | "
          << (!is_ours(e.library)     ? ""
              : e.bytes <= kMostBytes ? "met"
                                      : "missed by " + fixed(e.bytes - kMostBytes, 0))
          << " |\n";
    }
  }
}

void wrong_answers(std::ostream& out, const std::vector<Cell>& cells) {
  out << "\n## Wrong answers\n\nFor each set, an exact judge decides every query on which two "
         "libraries differ, and a sample of the others. A peer that is wrong in more than 2 % of "
         "its answers is not ranked. A single wrong answer of soms voids its ratio.\n\n";
  bool none = true;
  for (const Cell& cell : cells) {
    for (const Entry& e : cell.entries) {
      if (e.verdict.wrong != 0) {
        none = false;
        out << "- " << name(cell.job) << ", " << cell.scene << ' ' << cell.set << ' '
            << cell.triangles << ": " << e.library << " is wrong in " << e.verdict.wrong << " of "
            << e.verdict.checked << ", first at " << question(cell.job) << ' '
            << e.verdict.wrong_questions.front() << '\n';
      }
    }
  }
  out << (none ? "None.\n" : "");
}

void versions(std::ostream& out, const std::vector<Cell>& cells) {
  std::set<std::string> all;
  for (const Cell& cell : cells) {
    for (const Entry& e : cell.entries) {
      all.insert(e.library.substr(0, e.library.find('-')) + " " + e.version);
    }
  }
  std::string list;
  for (const std::string& version : all) {
    list += (list.empty() ? "" : ", ") + version;
  }
  out << "- Versions: " << list << ".\n";
}

std::ofstream open(const std::filesystem::path& path) {
  std::ofstream out(path);
  if (!out) {
    throw Error(ErrorKind::cannot_write, path.string(), "choose a folder that can be written to");
  }
  return out;
}

void close(std::ofstream& out, const std::filesystem::path& path) {
  out.flush();
  if (!out) {
    throw Error(ErrorKind::cannot_write, path.string(), "free some space");
  }
}

}  // namespace

void write_csv(const std::filesystem::path& path, const std::vector<Cell>& cells) {
  std::ofstream out = open(path);
  out << "job,scene,set,triangles,mover_triangles,questions,sum,library,version,build_s,"
         "bytes_a_triangle,answered,median_us,least_us,most_us,checked,wrong,ratio\n";
  for (const Cell& cell : cells) {
    for (const Entry& e : cell.entries) {
      const auto reached = ratio(cell, e.library);
      out << name(cell.job) << ',' << csv_field(cell.scene) << ',' << csv_field(cell.set) << ','
          << cell.triangles << ',' << cell.mover << ',' << cell.questions << ',' << sum_of(cell)
          << ',' << csv_field(e.library) << ',' << csv_field(e.version) << ',' << fixed(e.build, 6)
          << ',' << fixed(e.bytes, 1) << ',' << e.answered << ',' << fixed(1e6 * e.timing.median, 4)
          << ',' << fixed(1e6 * e.timing.least, 4) << ',' << fixed(1e6 * e.timing.most, 4) << ','
          << e.verdict.checked << ',' << e.verdict.wrong << ','
          << (reached ? fixed(*reached, 3) : "") << '\n';
    }
  }
  close(out, path);
}

void print_times(std::ostream& out, const std::vector<Cell>& cells) {
  out << "| job | scene | set | triangles | queries | sum | library | us (least - most) | ratio | "
         "checked | |\n|---|---|---|---:|---:|---:|---|---:|---:|---:|---|\n";
  for (const Cell& cell : cells) {
    for (const Entry& e : cell.entries) {
      const auto reached = ratio(cell, e.library);
      const std::string reported = best_peer(cell) == nullptr ? "" : times(reached);
      out << where(cell) << " | " << cell.questions << " | " << sum_of(cell) << " | " << e.library
          << " | " << micro(e.timing.median) << " (" << micro(e.timing.least) << " - "
          << micro(e.timing.most) << ") | " << (e.answered == cell.questions ? reported : "")
          << " | " << e.verdict.checked << " |" << mark(cell, e) << " |\n";
    }
  }
}

void write_markdown(const std::filesystem::path& path, const std::vector<Cell>& cells,
                    const RunFacts& facts) {
  std::ofstream out = open(path);
  out << "# soms and its peers, " << today() << "\n\n- Machine: " << processor() << "; soms on "
      << facts.isa << "; one thread"
      << (facts.processor < 0 ? "" : ", bound to processor " + std::to_string(facts.processor))
      << ".\n- Compiler: " << SOMS_BENCH_COMPILER << ", " << SOMS_BENCH_BUILD
      << "; peers' code of this build with -march=native besides.\n";
  versions(out, cells);
  out << "- Selection: " << facts.selection << "; median of " << facts.rounds
      << " rounds in turn, processor time.\n\n";
  goals(out, cells, facts.isa);
  medians(out, cells, facts.isa);
  out << "\n## Every library\n\n`sum`: of the answers: touching or near poses, pairs, distances, "
         "points "
         "inside, hits, numbers of relations. `ratio`: the "
         "best peer's time over this one's. `first n`: too slow for the whole set, not "
         "ranked.\n\n";
  print_times(out, cells);
  builds(out, cells);
  wrong_answers(out, cells);
  close(out, path);
}

void print_json(std::ostream& out, const std::vector<Cell>& cells,
                const std::vector<FrameDoubt>& doubts) {
  std::string warnings;
  for (const FrameDoubt doubt : doubts) {
    warnings += warnings.empty() ? ",\"warnings\":[" : ",";
    warnings += "{\"kind\":\"" + std::string(name(doubt)) + "\"}";
  }
  warnings += warnings.empty() ? "" : "]";
  for (const Cell& cell : cells) {
    for (const Entry& e : cell.entries) {
      const auto reached = ratio(cell, e.library);
      out << R"({"schema":"soms.bench/2","job":")" << name(cell.job) << R"(","set":")" << cell.set
          << R"(","library":")" << e.library << R"(","version":")" << e.version << R"(","queried":)"
          << cell.questions << R"(,"answered":)" << e.answered << R"(,"sum":)" << sum_of(cell)
          << R"(,"median_us":)" << fixed(1e6 * e.timing.median, 4) << R"(,"least_us":)"
          << fixed(1e6 * e.timing.least, 4) << R"(,"most_us":)" << fixed(1e6 * e.timing.most, 4)
          << R"(,"build_ms":)" << fixed(1e3 * e.build, 4) << R"(,"bytes_a_triangle":)"
          << fixed(e.bytes, 1) << R"(,"checked":)" << e.verdict.checked << R"(,"wrong":)"
          << e.verdict.wrong << R"(,"ratio":)" << (reached ? fixed(*reached, 3) : "null")
          << warnings << "}\n";
    }
  }
}

}  // namespace soms::bench
