/// \file
/// The XML files of a BCF archive, versions 2.1 and 3.0.
#pragma once

#include "soms/base/vector.h"

#include <array>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace soms::command {

enum class BcfVersion : unsigned char { v2_1, v3_0 };

/// A part as a viewer may know it.
struct BcfComponent {
  std::string id = {};  ///< of its file; written as an IFC GUID where it is one
  std::string file = {};
  std::string label = {};
  std::string color = {};  ///< RRGGBB
};

/// Lengths are meters.
struct BcfCamera {
  Vec3 eye = {};
  Vec3 direction = {};  ///< unit vector
  Vec3 up = {};         ///< unit vector
  double field_of_view = 45;
  double aspect = 1;                               ///< width over height
  std::vector<std::array<Vec3, 2>> clipping = {};  ///< a point, and the direction that is hidden
};

/// All that an archive says of a clash. Texts are plain.
struct BcfTopic {
  std::string guid = {};
  std::string viewpoint_guid = {};  ///< empty: no viewpoint
  bool has_snapshot = false;
  std::size_t index = 0;
  std::string title = {};
  std::string status = {};
  std::vector<std::string> labels = {};
  std::string description = {};
  std::vector<std::string> files = {};  ///< models
  std::vector<BcfComponent> components = {};
  std::optional<BcfCamera> camera = std::nullopt;
};

/// What all topics of an archive share.
struct BcfHead {
  BcfVersion version = BcfVersion::v2_1;
  std::string date = {};  ///< of creation, as XML writes it: "2026-01-31T12:00:00Z"
  std::string author = {};
  std::string project_guid = {};
  std::string project_name = {};
};

/// Name of a topic's viewpoint beside its "markup.bcf".
inline constexpr const char* kBcfViewpoint = "viewpoint.bcfv";
inline constexpr const char* kBcfSnapshot = "snapshot.png";
inline constexpr const char* kBcfTopicType = "Clash";

/// The file "bcf.version".
[[nodiscard]] std::string bcf_version_xml(const BcfHead& head);

/// The file "project.bcfp".
[[nodiscard]] std::string bcf_project_xml(const BcfHead& head);

/// The file "extensions.xml" of version 3.0: all statuses and labels that topics have.
[[nodiscard]] std::string bcf_extensions_xml(const BcfHead& head,
                                             const std::set<std::string>& statuses,
                                             const std::set<std::string>& labels);

/// The file "markup.bcf" of a topic.
[[nodiscard]] std::string bcf_markup_xml(const BcfHead& head, const BcfTopic& topic);

/// The file "viewpoint.bcfv" of a topic. \pre `topic.camera` is there.
[[nodiscard]] std::string bcf_viewpoint_xml(const BcfHead& head, const BcfTopic& topic);

}  // namespace soms::command
