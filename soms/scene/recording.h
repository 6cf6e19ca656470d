/// \file
/// Writing down what happens in a scene, frame by frame; `replay.h` reads it. The bytes are
/// described in docs/recording.md.
///
/// \code
/// const soms::Shape drone{soms::generate_mover(soms::MoverKind::drone)};
/// soms::Scene scene;
/// scene.add_mover(soms::Body(drone));
/// soms::RecordingHead head;
/// head.models = {{.name = "drone", .origin = soms::RecordedMesh::Origin::mover, .source = "drone",
///                 .triangles = drone.mesh().triangles.size(), .hash = corner_hash(drone.mesh())}};
/// head.movers = {0};  // mover 0 is of model 0
/// std::ostringstream out;
/// soms::RecordingWriter writer(out, head);
/// writer.add(std::vector{soms::Pose{}}, scene.step());
/// writer.finish(soms::RecordingEnding::complete);
/// std::cout << writer.so_far().frames << " frame recorded\n";
/// \endcode
/// It prints:
/// \verbatim
/// 1 frame recorded
/// \endverbatim
#pragma once

#include "soms/base/hash.h"
#include "soms/base/pose.h"
#include "soms/base/words.h"
#include "soms/geometry/mesh.h"
#include "soms/scene/scene.h"

#include <cstddef>
#include <cstdint>
#include <ostream>
#include <span>
#include <string>
#include <vector>

namespace soms {

/// How to come by a mesh again, and how to tell that it is the same.
struct RecordedMesh {
  enum class Origin : std::uint8_t {
    file,   ///< read from `source`
    city,   ///< made by `generate_city` of `city_triangles`, `city_size`, `city_seed`
    mover,  ///< made by `generate_mover`; `source` is car, person or drone
  };

  std::string name;  ///< as the body is called
  Origin origin = Origin::file;
  std::string source;           ///< path of the file as it was given, or what was made
  std::uint64_t file_size = 0;  ///< bytes; 0 where there is no file
  double scale = 1;             ///< coordinates were multiplied by this
  UpAxis up = UpAxis::unknown;  ///< and turned to z from this axis; unknown: not turned
  std::uint64_t city_triangles = 0;
  double city_size = 0;
  std::uint64_t city_seed = 0;
  std::uint64_t triangles = 0;  ///< of the mesh
  std::uint64_t hash = 0;       ///< `corner_hash` of the mesh, scaled and turned

  [[nodiscard]] bool operator==(const RecordedMesh&) const = default;
};

template <>
inline constexpr auto kWords<RecordedMesh::Origin> =
    words("RecordedOrigin",
          "What a recorded mesh is from: a file, or generate(\"city\"), or generate of a mover.",
          "file", "city", "mover");

/// A body that stands still; part k of the environment is body k.
struct RecordedBody {
  RecordedMesh mesh;
  Pose pose;

  [[nodiscard]] bool operator==(const RecordedBody&) const = default;
};

/// What a recording starts with: all that a player needs besides frames.
struct RecordingHead {
  std::string title;
  double frames_a_second = 60;
  std::uint64_t frames_requested = 0;
  std::vector<RecordedBody> environment;
  std::vector<RecordedMesh> models;
  std::vector<std::uint32_t> movers;  ///< model of each mover; mover k is the k-th
  /// `StepOptions::clearance` of every frame, meters. 0: frames have no gaps.
  double clearance = 0;
  /// Frames hold the passages of swept steps (`StepOptions::swept`). The file is then of version 3;
  /// else of version 2 with a clearance, and of version 1, which older programs read, without one.
  bool swept = false;

  [[nodiscard]] bool operator==(const RecordingHead&) const = default;
};

/// One frame: where the movers are, what they touch, what they are near, and what they touched on
/// the way from the frame before.
struct RecordedFrame {
  std::vector<Pose> poses;                            ///< of each mover
  std::vector<EnvironmentContact> environment;        ///< sorted, as in StepReport
  std::vector<MoverContact> movers;                   ///< sorted, as in StepReport
  std::vector<EnvironmentGap> environment_gaps = {};  ///< likewise; empty without a clearance
  std::vector<MoverGap> mover_gaps = {};              ///< likewise
  std::vector<EnvironmentPassage> environment_passages = {};  ///< likewise; empty unless swept
  std::vector<MoverPassage> mover_passages = {};              ///< likewise

  [[nodiscard]] bool operator==(const RecordedFrame&) const = default;
};

/// How a recording came to its end.
enum class RecordingEnding : std::uint8_t { complete, timed_out, interrupted };

template <>
inline constexpr auto kWords<RecordingEnding> = words("RecordingEnding",
                                                      "How a recording came to its end.",
                                                      "complete", "timed_out", "interrupted");

/// What a whole recording ends with.
struct RecordingEnd {
  RecordingEnding ending = RecordingEnding::complete;
  std::uint64_t frames = 0;
  std::uint64_t environment_contacts = 0;  ///< triangle pairs, summed over frames
  std::uint64_t mover_contacts = 0;        ///< likewise
  std::uint64_t hash =
      0;  ///< FNV-1a 64 over `StepReport::hash` of each frame, as little-endian u64

  [[nodiscard]] bool operator==(const RecordingEnd&) const = default;
};

/// Writes a recording to a stream as it happens. Frames gather until a chunk is full (1 MiB or 64
/// frames) and are then written with their checksum, so that memory does not grow with frames. A
/// recording that was not finished is a cut file, which plays up to its last whole chunk.
class RecordingWriter {
 public:
  /// Writes the head. `out` must live as long as the writer.
  /// \errors  ErrorKind::usage for a mover of no model, and for numbers that no recording can have.
  ///          Such are a scale or frame rate that is not positive, a clearance below 0, and a pose
  ///          of the environment that is none. cannot_write.
  RecordingWriter(std::ostream& out, RecordingHead head);

  /// Adds the next frame.
  /// \pre     `report` is of the bodies that the head names: movers 0 to n-1.
  /// \errors  ErrorKind::usage where there are not as many poses as movers, and for the report of a
  ///          step with StepScope::first_contact or with another clearance than the head's. A head
  ///          with `swept` takes reports of swept steps alone; one without leaves passages out.
  ///          Also where a shape was set in the scene since the frame before (`Scene::set_shape`):
  ///          a recording holds one mesh for each mover. not_finite, not_rigid, out_of_range for a
  ///          pose that no body of a scene can have, which no replay would play. cannot_write.
  ///          Frames before stay good. Where memory runs short, `so_far` tells whether the frame
  ///          was added.
  void add(std::span<const Pose> poses, const StepReport& report);

  /// Writes what is held back, and the end. Call it once, last. \errors ErrorKind::cannot_write.
  void finish(RecordingEnding ending);

  /// What the recording holds so far.
  [[nodiscard]] const RecordingEnd& so_far() const { return end_; }

 private:
  void put_frame(std::span<const Pose> poses, const StepReport& report);
  void put_passages(const StepReport& report);
  void flush();
  void write(const std::string& bytes);

  std::ostream& out_;
  std::vector<Pose> before_;  ///< poses of the frame before in this chunk
  std::string chunk_;
  std::uint32_t chunk_frames_ = 0;
  std::uint64_t shapes_set_ = 0;  ///< in the scene, at the frame before
  double clearance_ = 0;          ///< as of the head
  bool swept_ = false;            ///< likewise
  RecordingEnd end_;
  Fnv1a hash_;
};

}  // namespace soms
