/// \file
/// Says where the numbers of two models may not mean the same, and which options settle it.
#pragma once

#include "soms/geometry/frames.h"

#include "apps/output/json.h"

#include <string>
#include <vector>

namespace soms::command {

class Console;
struct ModelOptions;

/// A model of a question, and the options that say more of it than its file does.
struct NamedFrame {
  std::string file;       ///< as messages call it
  std::string path = {};  ///< as commands must call it; empty if the same
  CoordinateFrame frame;
  std::string scale_option = {};  ///< "--scale-b"
  std::string up_option = {};     ///< "--up-b"
  std::string crs_option = {};    ///< "--crs-b"; empty where there is none
  bool built_in = false;  ///< made by soms in meters, z up; what declares nothing is taken for such
  bool is_shared = false;  ///< its options go to other files, too
  bool is_posed = false;   ///< poses place it, wherever on the Earth its file does
  bool in_meters = false;  ///< of a world, whose lengths are taken for meters
};

/// The frame of a model as it was read by `options`.
[[nodiscard]] NamedFrame named_frame(const MeshView& mesh, const ModelOptions& options,
                                     const std::string& scale_option, const std::string& up_option);

/// One reason why "no overlap" may not mean "free".
struct FrameWarning {
  FrameDoubt doubt = FrameDoubt::boxes_apart;
  std::string place;   ///< "the up axis is y in b.gltf, and unknown in a.obj"
  std::string remedy;  ///< "give --up-b y if ..."

  [[nodiscard]] std::string text() const { return place + "; " + remedy; }
};

/// Warnings about what two models declare (`compare_frames`).
[[nodiscard]] std::vector<FrameWarning> frame_warnings(const NamedFrame& a, const NamedFrame& b);

/// Warnings about the models of a world: files of the city among themselves, movers against the
/// city; georeferences of all that no pose places. Each is compared with the first one that
/// declares what is compared: where none differs from it, none do. \pre `city` is not empty.
[[nodiscard]] std::vector<FrameWarning> world_warnings(const std::vector<NamedFrame>& city,
                                                       const std::vector<NamedFrame>& movers);

/// The warning that the boxes of two bodies are `gap` apart, `where` ("at every pose ") or just so.
[[nodiscard]] FrameWarning apart_warning(const std::string& a, const std::string& b, double gap,
                                         const std::string& where);

/// Looks at boxes of two bodies, of pose after pose, or frame after frame: do they ever come near?
class BoxWatch {
 public:
  void look(const Box& a, const Box& b);

  /// Of the last two boxes: their gap, and whether it is a doubt.
  [[nodiscard]] double gap() const { return gap_; }

  [[nodiscard]] bool apart() const { return apart_; }

  /// Of all boxes; false before the first.
  [[nodiscard]] bool always_apart() const { return always_apart_; }

  /// The least gap of all boxes.
  [[nodiscard]] double least_gap() const { return least_gap_; }

 private:
  double gap_ = 0;
  double least_gap_ = 0;
  bool apart_ = false;
  bool always_apart_ = false;
  bool looked_ = false;
};

/// Each on a line of standard error.
/// \errors ErrorKind::bad_file that says them all, where there is one and `strict` is set.
void tell_warnings(const std::vector<FrameWarning>& warnings, bool strict, const Console& console);

/// `[{"kind":"axis_unknown","message":"..."}]`.
[[nodiscard]] Json warnings_json(const std::vector<FrameWarning>& warnings);

}  // namespace soms::command
