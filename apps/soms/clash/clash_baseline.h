/// \file
/// Older clash lists, with which a new one is compared.
#pragma once

#include "apps/soms/clash/clash_rows.h"

#include <cstdint>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace soms::command {

class ListedObject;

/// Older lists, by their keys.
class ClashBaseline {
 public:
  /// Reads what `clash --json` printed, or wrote to a .json or .jsonl file. `filters` are the
  /// options that leave rows out of the new list, as `removed` of a list names them.
  /// \errors ErrorKind::cannot_open; bad_file, with the line: a row that cannot be read, a list
  ///         without its end, or that was cut; usage for one that lacks rows by another filter.
  ClashBaseline(const std::string& file, const std::vector<std::string>& filters);

  /// Gives each row its status, and adds what is resolved: of a list that is complete, the clashes
  /// that it has not, though it `looked_at` them. `found` are the keys of all clashes, those that
  /// were removed, too.
  void compare(const std::set<std::uint64_t>& found,
               const std::function<bool(const Json&)>& looked_at, ClashReport& report) const;

 private:
  /// Takes a row; false if it is resolved, so that it counts no more.
  bool add(const ListedObject& row);

  std::map<std::string, Json> rows_;
};

}  // namespace soms::command
