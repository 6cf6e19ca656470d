#include "bench/peers/core/report.h"

#include "soms/base/error.h"

#include <ctime>
#include <fstream>
#include <iomanip>
#include <sstream>

namespace soms::bench {

namespace {

bool ranked(const Entry& entry) {
  const double most = entry.contestant.starts_with("soms")
                          ? 0
                          : kMostWrong * static_cast<double>(entry.verdict.checked);
  return static_cast<double>(entry.verdict.wrong) <= most;
}

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

std::string processor() {
  std::ifstream info("/proc/cpuinfo");
  std::string line;
  while (std::getline(info, line)) {
    if (line.starts_with("model name")) {
      return line.substr(line.find(':') + 2);
    }
  }
  return "unknown processor";
}

std::string today() {
  const std::time_t now = std::time(nullptr);
  std::tm parts{};
  gmtime_r(&now, &parts);
  std::ostringstream text;
  text << std::put_time(&parts, "%Y-%m-%d");
  return text.str();
}

std::ofstream open(const std::string& path) {
  std::ofstream out(path);
  if (!out) {
    throw Error(ErrorKind::cannot_write, path, "choose a folder that can be written to");
  }
  return out;
}

void close(std::ofstream& out, const std::string& path) {
  out.flush();
  if (!out) {
    throw Error(ErrorKind::cannot_write, path, "free some space");
  }
}

}  // namespace

double fastest(const Cell& cell, const std::string& family) {
  double least = 0;
  for (const Entry& entry : cell.entries) {
    if (entry.contestant.starts_with(family) && ranked(entry) &&
        (least == 0 || entry.timing.median < least)) {
      least = entry.timing.median;
    }
  }
  return least;
}

double ratio(const Cell& cell, const std::string& contestant) {
  const double rival = fastest(cell, "fcl");
  for (const Entry& entry : cell.entries) {
    if (entry.contestant == contestant && ranked(entry)) {
      return rival / entry.timing.median;
    }
  }
  return 0;
}

void write_csv(const std::string& path, const std::vector<Cell>& cells) {
  std::ofstream out = open(path);
  out << "scene,set,triangles,mover_triangles,poses,touching,contestant,build_s,median_us,least_us,"
         "most_us,checked,wrong,ratio_to_fcl\n";
  for (const Cell& cell : cells) {
    for (const Entry& e : cell.entries) {
      out << cell.scene << ',' << cell.set << ',' << cell.triangles << ',' << cell.mover << ','
          << cell.poses << ',' << cell.touching << ',' << e.contestant << ',' << fixed(e.build, 4)
          << ',' << fixed(1e6 * e.timing.median, 4) << ',' << fixed(1e6 * e.timing.least, 4) << ','
          << fixed(1e6 * e.timing.most, 4) << ',' << e.verdict.checked << ',' << e.verdict.wrong
          << ',' << fixed(ratio(cell, e.contestant), 2) << '\n';
    }
  }
  close(out, path);
}

void write_markdown(const std::string& path, const std::vector<Cell>& cells, int passes) {
  std::ofstream out = open(path);
  out << today() << ", " << processor() << ", " << SOMS_BENCH_COMPILER << ", " << SOMS_BENCH_BUILD
      << " (FCL: -march=native besides), one thread; microseconds of processor time a query, "
         "median of "
      << passes << " passes in turn, least to most in brackets. Ratio: the fastest FCL over it.\n\n"
      << "| scene | set | triangles | touching | contestant | us a query | ratio | build ms | "
         "checked, wrong |\n|---|---|---:|---:|---|---|---:|---:|---|\n";
  for (const Cell& cell : cells) {
    for (const Entry& e : cell.entries) {
      const double times = ratio(cell, e.contestant);
      out << "| " << cell.scene << " | " << cell.set << " | " << cell.triangles << " | "
          << cell.touching << " of " << cell.poses << " | " << e.contestant << " | "
          << micro(e.timing.median) << " (" << micro(e.timing.least) << " - "
          << micro(e.timing.most) << ") | " << (times > 0 ? fixed(times, 2) : "-") << " | "
          << fixed(1e3 * e.build, 0) << " | " << e.verdict.checked << ", " << e.verdict.wrong
          << " |\n";
    }
  }
  close(out, path);
}

}  // namespace soms::bench
