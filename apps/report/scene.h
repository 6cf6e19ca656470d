/// \file
/// What the view of a page shows: models, bodies at steps of time, where they touch, and how near
/// they come.
#pragma once

#include "soms/base/bracket.h"
#include "soms/base/pose.h"
#include "soms/geometry/mesh.h"
#include "soms/motion/rigid_motion.h"
#include "soms/query/overlap.h"

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace soms::report {

/// A mesh that may be drawn at many places. The page holds it once.
struct SceneModel {
  MeshView mesh;
  std::string name;
  /// What a page calls the triangles: their numbers in the file; empty: those in the mesh.
  std::span<const TriangleId> numbers = {};
};

/// A model at a place; one that moves is at another place at every step.
struct SceneBody {
  std::size_t model = 0;
  std::string name;
  bool moves = false;
};

/// A part of a model.
struct ScenePart {
  std::string name;       ///< as the file calls it, or what stands for a name
  std::string path = {};  ///< names from the outermost part on, with the part's own; may be empty
};

/// Bytes that a page takes of a name or a path.
inline constexpr std::size_t kLongestText = 200;

/// No part: the body as a whole.
inline constexpr std::uint32_t kNoPart = 0xffffffffU;

/// How two bodies of a row touch.
enum class Meeting : std::uint32_t {
  touch,          ///< in steps
  passage,        ///< between two steps, in neither of them
  may_be_passage  ///< the same, and it is not proved that they do
};

/// Two bodies, or parts of them, that touch: a row of the page's list.
struct SceneRow {
  std::uint32_t a = 0;
  std::uint32_t b = 0;
  std::uint32_t part_a = kNoPart;  ///< in `Scene::parts`
  std::uint32_t part_b = kNoPart;
  std::uint64_t count = 0;       ///< contacts in all
  std::uint64_t steps = 0;       ///< in which they touch
  std::uint64_t begin = 0;       ///< the first of them
  std::uint64_t end = 0;         ///< the last
  TrianglePair first = {};       ///< of the contacts' triangles; kNoTriangle where none is known
  Box box = {};                  ///< around where they touch, in the coordinates of the scene
  std::uint64_t most_pairs = 0;  ///< pairs of triangles in the step that has the most; 0: not known
  std::uint64_t most_step = 0;   ///< that step
  Vec3 place = {};               ///< a point that the two share in it, if they are known
  std::vector<TrianglePair> pairs = {};  ///< some that touch in it: the curve that is drawn
  Meeting meeting = Meeting::touch;
  double after = 0;  ///< of a passage: the part of the way from step `begin` to the next, 0 to 1
};

/// No triangle: of a body as a whole.
inline constexpr TriangleId kNoTriangle = 0xffffffffU;

/// Body `a` touches body `b` in each step from `begin` to `end`.
struct SceneContact {
  std::size_t row = 0;  ///< that it belongs to
  std::uint32_t a = 0;
  std::uint32_t b = 0;
  std::uint32_t part_a = kNoPart;  ///< in `Scene::parts`
  std::uint32_t part_b = kNoPart;
  std::uint64_t begin = 0;
  std::uint64_t end = 0;
  std::vector<TrianglePair> pairs = {};  ///< some, at step `begin`
  std::uint64_t pairs_in_all = 0;        ///< at step `begin`
  /// Of a passage: where `a` and `b` are then. Else nothing, as Scene::pose says where they are.
  std::optional<std::array<Pose, 2>> poses = std::nullopt;
};

/// Body `a` is near body `b` in each step from `begin` to `end`. What is drawn is a shortest
/// segment between the two at step `nearest`.
struct SceneGap {
  std::uint32_t a = 0;
  std::uint32_t b = 0;
  std::uint64_t begin = 0;
  std::uint64_t end = 0;
  std::uint64_t nearest = 0;
  Vec3 point_a = {};  ///< end of the segment on `a`, in the coordinates of the scene
  Vec3 point_b = {};
  std::string length = {};  ///< as it is written beside the segment
};

/// A motion of the first body, and when it first touches the second one, which stands still.
struct SceneMotion {
  RigidMotion motion = {};
  std::uint64_t number = 0;        ///< in the list that it is of
  bool blocked = false;            ///< it is not proved to be free
  Bracket t = {};                  ///< no contact before `lower`, a contact at `upper` if finite
  double moment = 1;               ///< the time that is shown first: of the contact, or the end
  std::optional<Vec3> place = {};  ///< the contact at `moment`
  std::string verdict = {};        ///< in a few words
  std::string words = {};          ///< in a sentence
};

/// Steps that a motion has: its start, its moment and its end.
inline constexpr std::uint64_t kStepsOfMotion = 3;

/// Steps of time, or poses one after the other.
struct Steps {
  std::uint64_t count = 1;
  std::string noun = "frame";
  double a_second = 0;  ///< of simulated time; 0: steps are no time
  bool smooth = true;   ///< places between two steps mean something
  /// Steps whose poses the page is to hold; empty: as many as it has room for, evenly spread.
  std::vector<std::uint64_t> kept = {};
};

/// A word for one and for many.
struct Noun {
  std::string one;
  std::string many;
};

/// A scene. Whoever draws it asks for poses when it needs them.
struct Scene {
  std::vector<SceneModel> models = {};
  std::vector<SceneBody> bodies = {};
  std::vector<ScenePart> parts = {};  ///< those of rows and contacts
  std::vector<SceneRow> rows = {};    ///< all of them: none is ever left out; passages come last
  std::vector<SceneContact> contacts = {};  ///< of all or some, in order of `begin`
  bool lists_contacts = true;               ///< false: what touches is not known
  bool complete = true;                     ///< false: the search ended early, there may be more
  std::uint64_t contacts_in_all = 0;        ///< the sum of `SceneRow::count`
  Noun contact = {"contact", "contacts"};   ///< what the page calls them
  /// What the page calls rows; empty: pairs of parts, or of bodies.
  Noun row = {};
  std::vector<SceneGap> gaps = {};  ///< of all or some, in the order of their table
  std::uint64_t gaps_in_all = 0;
  /// Not empty: the page is about motions. Motion k has the steps from 3 k on, and each motion with
  /// a place has a row and a contact.
  std::vector<SceneMotion> motions = {};
  std::uint64_t motions_in_all = 0;
  Steps steps = {};
  std::function<Pose(std::uint32_t body, std::uint64_t step)> pose = {};
  bool y_is_up = false;
};

/// Where the bodies of a contact are at its begin.
[[nodiscard]] std::array<Pose, 2> poses_of(const Scene& scene, const SceneContact& contact);

/// What a page has room for. With these it stays below 20 MB, the script and the plots included,
/// and 110 bytes a row, of which there may be any number.
struct SceneLimits {
  std::uint64_t triangles = 240'000;         ///< in the page
  std::uint64_t drawn_at_once = 1'500'000;   ///< on the screen: a model counts for each body
  std::uint64_t mesh_bytes = 8'000'000;      ///< likewise
  std::uint64_t pose_bytes = 2'000'000;      ///< before they are packed
  std::uint64_t exact_bytes = 2'000'000;     ///< of triangles as they are: all of them or none
  std::uint64_t exact_pose_bytes = 500'000;  ///< of poses as they are, likewise
  std::size_t bodies = 20'000;
  std::size_t contacts = 10'000;
  std::size_t gaps = 1000;
  std::size_t pairs = 10'000;
  std::size_t pairs_of_contact = 16;
  std::size_t lines = 40'000;        ///< of the curves of rows, together
  std::size_t pairs_of_row = 4'000;  ///< of the curve of a row
};

/// Shares of `most` for those who want these amounts: all of it for the modest, equal parts for
/// the others. Where not all can have one, those have it that want most.
[[nodiscard]] std::vector<std::uint64_t> fair_shares(std::span<const std::uint64_t> wanted,
                                                     std::uint64_t most);

/// First and last step of a contact.
struct Span {
  std::uint64_t begin = 0;
  std::uint64_t end = 0;
};

/// Numbers of the `most` longest spans, ascending; of equally long ones the first.
[[nodiscard]] std::vector<std::size_t> longest(std::span<const Span> spans, std::size_t most);

/// Steps evenly spread over `count`, the first and the last among them, at most `most`.
/// \pre most >= 2.
[[nodiscard]] std::vector<std::uint64_t> spread_steps(std::uint64_t count, std::uint64_t most);

/// Bodies to be drawn, ascending: all that stand still, those of contacts and gaps, then every so
/// many of the others, `most` in all or as many as the first are.
[[nodiscard]] std::vector<std::uint32_t> chosen_bodies(const Scene& scene, std::size_t most);

/// How many triangles of each model may be drawn: all of small ones, and what they leave over is
/// shared by the large ones. A model that moves in many bodies gets less.
[[nodiscard]] std::vector<std::uint64_t> shared_out(const Scene& scene,
                                                    std::span<const std::uint32_t> bodies,
                                                    const SceneLimits& limits);

}  // namespace soms::report
