#include "apps/soms/clash/clash_rows.h"

#include "soms/base/error.h"
#include "soms/io/encoding.h"

#include "apps/cli/text.h"
#include "apps/soms/clash/clash_sets.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <numeric>
#include <optional>
#include <tuple>

namespace soms::command {

namespace {

std::ifstream opened(const std::string& file, const std::string& option) {
  std::ifstream in(file, std::ios::binary);
  if (!in || in.peek() == std::ifstream::traits_type::eof()) {
    if (!in.eof()) {
      throw Error(ErrorKind::cannot_open, option + " " + file + ": cannot be read",
                  "give a file that exists and can be read");
    }
  }
  return in;
}

void trim_end(std::string& line) {
  while (!line.empty() && (line.back() == '\r' || line.back() == ' ' || line.back() == '\t')) {
    line.pop_back();
  }
}

/// The field that begins at `at`, and where the next one begins; nothing where a quote is open.
std::optional<std::string> field_at(const std::string& line, std::size_t& at) {
  std::string field;
  while (at < line.size() && (line[at] == ' ' || line[at] == '\t')) {
    ++at;
  }
  if (at < line.size() && line[at] == '"') {
    for (++at; at < line.size(); ++at) {
      if (line[at] != '"') {
        field += line[at];
      } else if (at + 1 < line.size() && line[at + 1] == '"') {
        field += line[++at];
      } else {
        ++at;
        while (at < line.size() && (line[at] == ' ' || line[at] == '\t')) {
          ++at;
        }
        return field;
      }
    }
    return std::nullopt;
  }
  while (at < line.size() && line[at] != ',') {
    field += line[at++];
  }
  trim_end(field);
  return field;
}

std::optional<std::pair<std::string, std::string>> two_patterns(const std::string& line) {
  std::size_t at = 0;
  const std::optional<std::string> first = field_at(line, at);
  if (!first || first->empty() || at >= line.size() || line[at] != ',') {
    return std::nullopt;
  }
  ++at;
  const std::optional<std::string> second = field_at(line, at);
  if (!second || second->empty() || at != line.size()) {
    return std::nullopt;
  }
  return std::pair(*first, *second);
}

}  // namespace

IgnoredPairs::IgnoredPairs(const std::string& file) {
  std::ifstream in = opened(file, "--ignore-pairs");
  std::string line;
  for (std::size_t number = 1; std::getline(in, line); ++number) {
    if (number == 1) {
      refuse_utf16(line, "--ignore-pairs " + file);
    }
    constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";
    if (number == 1 && line.starts_with(kByteOrderMark)) {
      line.erase(0, kByteOrderMark.size());
    }
    trim_end(line);
    if (line.empty() || line.front() == '#') {
      continue;
    }
    const auto pair = two_patterns(line);
    if (!pair) {
      throw Error(
          ErrorKind::bad_file, fmt::format("{}, line {}: no pair of patterns", file, number),
          "give two patterns with a comma between, each in quotes if it has a comma itself");
    }
    pairs_.push_back(*pair);
  }
}

bool IgnoredPairs::match(const ClashModels& models, const Clash& clash) const {
  return of_all_parts(models, clash, [&](std::uint32_t a, std::uint32_t b) {
    const auto fit = [&](const std::string& first, const std::string& second) {
      return is_called(models.a, a, first) && is_called(models.second(), b, second);
    };
    return std::any_of(pairs_.begin(), pairs_.end(), [&](const auto& pair) {
      return fit(pair.first, pair.second) || fit(pair.second, pair.first);
    });
  });
}

std::string_view status_name(ClashStatus status) {
  return status == ClashStatus::fresh ? "new" : status == ClashStatus::active ? "active" : "";
}

std::string key_text(std::uint64_t key) {
  return fmt::format("{:016x}", key);
}

std::vector<std::pair<std::pair<std::string, std::string>, ClashCounts>> counts_by_sets(
    const ClashReport& report) {
  std::map<std::pair<std::string, std::string>, ClashCounts> cells;
  for (const ClashRow& row : report.rows) {
    std::pair sets{report.models.a.sets[row.clash.a], report.models.second().sets[row.clash.b]};
    if (!report.models.two_sets && sets.second < sets.first) {
      std::swap(sets.first, sets.second);
    }
    ++cells[sets][static_cast<std::size_t>(row.clash.kind)];
  }
  return {cells.begin(), cells.end()};
}

std::vector<std::pair<std::string, ClashCounts>> counts_by_group(const ClashReport& report) {
  std::map<std::string, ClashCounts> groups;
  for (const ClashRow& row : report.rows) {
    ++groups[row.group][static_cast<std::size_t>(row.clash.kind)];
  }
  std::vector<std::pair<std::string, ClashCounts>> sorted(groups.begin(), groups.end());
  const auto size = [](const ClashCounts& counts) {
    return std::accumulate(counts.begin(), counts.end(), std::uint64_t{0});
  };
  std::stable_sort(sorted.begin(), sorted.end(),
                   [&](const auto& x, const auto& y) { return size(x.second) > size(y.second); });
  return sorted;
}

void sort_rows(const ClashModels& models, std::vector<ClashRow>& rows) {
  const ClashSet& a = models.a;
  const ClashSet& b = models.second();
  const auto place = [&](const ClashRow& row) {
    const Clash& clash = row.clash;
    return std::tie(clash.kind, a.labels[clash.a], b.labels[clash.b], a.mesh[clash.a],
                    b.mesh[clash.b], clash.a, clash.b);
  };
  std::sort(rows.begin(), rows.end(),
            [&](const ClashRow& x, const ClashRow& y) { return place(x) < place(y); });
}

std::vector<const ClashRow*> worst_first(const std::vector<ClashRow>& rows) {
  std::vector<const ClashRow*> sorted;
  for (const ClashRow& row : rows) {
    sorted.push_back(&row);
  }
  const auto badness = [](const ClashRow& row) {
    const Clash& clash = row.clash;
    return std::tuple(clash.kind, clash.penetration ? -clash.penetration->depth : 0.0,
                      clash.gap.lower, -static_cast<double>(clash.triangle_pairs));
  };
  std::stable_sort(sorted.begin(), sorted.end(),
                   [&](const ClashRow* a, const ClashRow* b) { return badness(*a) < badness(*b); });
  return sorted;
}

}  // namespace soms::command
