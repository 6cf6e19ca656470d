/// \file
/// Columns of several files of answers, one after the other in one file.
#pragma once

#include <filesystem>
#include <span>
#include <string>

namespace soms::command {

/// Writes what `NpzFile` wrote for each part of the rows as it would have written all rows: columns
/// follow each other, offsets count on, and arrays of words stay, as they are the same in each.
/// \errors ErrorKind::bad_file for a file of other columns, cannot_open, cannot_write.
void join_npz(std::span<const std::filesystem::path> parts, const std::string& path);

}  // namespace soms::command
