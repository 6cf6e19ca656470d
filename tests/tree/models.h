/// \file
/// The models whose counts thesis_counts.csv holds.
#pragma once

#include "tests/support/support.h"

#include <array>
#include <optional>
#include <string>

namespace soms::test {

/// A model of the golden counts.
struct GoldenModel {
  const char* name;
  const char* file;       ///< below SOMS_DATA; nullptr for stand-in scenes, which are generated
  std::uint64_t corners;  ///< corner_hash
};

inline constexpr std::array<GoldenModel, 7> kGoldenModels{{
    {"bunny", "ply/bun_zipper_res4.ply", 0x23e1390559ce62edULL},
    {"u_boxes", nullptr, 0x57cb92e64471a071ULL},
    {"u_mixed", nullptr, 0x5e44b5637f4cb56cULL},
    {"u_plain", nullptr, 0xb2dc50f5a09a47cdULL},
    {"venus", "ply/venus.ply", 0xb4c5b8d4374d26cdULL},
    {"teapot_1177", "ply/teapot_1177.ply", 0x443d997a2f94d83aULL},
    {"teapot", "ply/teapot.ply", 0x3d13e5f55250fafcULL},
}};

/// The model, or nothing where it needs SOMS_DATA and that is unset.
[[nodiscard]] std::optional<Mesh> golden_mesh(const GoldenModel& model);

/// Triangles and vertices of an ascii PLY whose coordinates are floats: a reader of a few lines,
/// independent of soms/io.
[[nodiscard]] Mesh read_plain_ply(const std::filesystem::path& path);

}  // namespace soms::test
