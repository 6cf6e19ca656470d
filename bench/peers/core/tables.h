/// \file
/// The results on paper: CSV for machines, Markdown for people, JSON Lines for scripts.
#pragma once

#include "soms/geometry/frames.h"

#include "bench/peers/core/report.h"

#include <filesystem>
#include <ostream>
#include <string>
#include <vector>

namespace soms::bench {

/// What a run was, for the head of its tables.
struct RunFacts {
  std::string isa;
  int processor = -1;  ///< the one it was bound to; -1: none
  int rounds = 0;
  std::string selection;
};

/// One row a library and cell. \errors ErrorKind::cannot_write.
void write_csv(const std::filesystem::path& path, const std::vector<Cell>& cells);

/// Goals and whether they are met, every library's times, builds and memory, wrong answers.
/// \errors ErrorKind::cannot_write.
void write_markdown(const std::filesystem::path& path, const std::vector<Cell>& cells,
                    const RunFacts& facts);

/// The times of every library and what was wrong: what a single comparison shows.
void print_times(std::ostream& out, const std::vector<Cell>& cells);

/// One object a library and cell, schema soms.bench/1, each with the doubts about the models.
void print_json(std::ostream& out, const std::vector<Cell>& cells,
                const std::vector<FrameDoubt>& doubts = {});

}  // namespace soms::bench
