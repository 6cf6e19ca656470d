/// \file
/// What `clearance` tells: a table for people, an object for each station, rows of CSV.
#pragma once

#include "soms/scene/clearance_along.h"

#include "apps/output/json.h"
#include "apps/soms/clearance/clearance_path.h"
#include "apps/world/world.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace soms::command {

class JsonListWriter;

/// What was found along a path.
struct ClearanceReport {
  const World& world;
  const ProfilePath& path;
  ClearanceOptions options;
  Clearance answer;
  std::string path_file;
  std::vector<std::string> only = {};     ///< patterns of parts
  std::vector<std::string> ignored = {};  ///< likewise
  double unit = 0;                        ///< meters a unit, 0: not known
  bool interrupted = false;
  bool timed_out = false;
  bool verified = false;  ///< brute force agreed

  [[nodiscard]] const Model& profile() const { return world.models.front(); }

  /// From the first pose of the path to the last, or to the last station that was reached.
  [[nodiscard]] double length() const;

  /// That of all stretches, the worst of them.
  [[nodiscard]] ClearanceVerdict verdict() const;
};

/// The worse of two: contact, below, undecided, ok.
[[nodiscard]] ClearanceVerdict worse(ClearanceVerdict a, ClearanceVerdict b);

/// Consecutive stretches with one verdict.
struct VerdictRun {
  ClearanceVerdict verdict = ClearanceVerdict::ok;
  std::size_t first = 0;  ///< stretch
  std::size_t last = 0;
};

[[nodiscard]] std::vector<VerdictRun> verdict_runs(const ClearanceReport& report);

/// Names of what is nearest, from the files.
class NearestNames {
 public:
  explicit NearestNames(const World& world) : world_(world), parts_(world) {}

  /// The number in its file of the triangle of the city. \pre The station has one.
  [[nodiscard]] TriangleId triangle(const ClearanceStation& station) const {
    return world_.numbers[*station.body](station.triangles->b);
  }

  /// "roof 12 of town", "town"; empty where nothing is near. Printable.
  [[nodiscard]] std::string text(const ClearanceStation& station) const;

  /// File, part, id, type and triangle.
  [[nodiscard]] Json json(const ClearanceStation& station) const;

  /// File, part and triangle as fields.
  [[nodiscard]] std::string csv(const ClearanceStation& station) const;

 private:
  [[nodiscard]] const Part* part(const ClearanceStation& station) const;

  const World& world_;
  CityParts parts_;
};

/// "0.42 m", "contact", "nothing near".
[[nodiscard]] std::string gap_in_text(const Bracket& gap, double unit);

/// Figures of the whole path, name and value.
[[nodiscard]] std::vector<std::pair<std::string, std::string>> clearance_figures(
    const ClearanceReport& report, const NearestNames& names);

/// The table along the path, some stretches a line, and the figures.
[[nodiscard]] std::string clearance_in_text(const ClearanceReport& report,
                                            const NearestNames& names);

/// A row for each station, and an end over all (soms.clearance/1).
void write_clearance_as_json(const ClearanceReport& report, const NearestNames& names,
                             JsonListWriter& list);

/// A header, and a row for each station.
[[nodiscard]] std::string clearance_as_csv(const ClearanceReport& report,
                                           const NearestNames& names);

}  // namespace soms::command
