#include "soms/motion/first_contact.h"

#include "soms/motion/print_motion.h"

#include "python/src/call.h"
#include "python/src/described.h"
#include "python/src/function.h"
#include "python/src/objects.h"
#include "python/src/poses.h"
#include "python/src/scene/bodies.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace soms::python {

namespace {

constexpr const char* kFirstContactDoc =
    R"(first_contact(shape, start, end, body, *, pivot=None, by=None, within=0.0, parting=False, timeout=None, threads=1, progress=None)

When does shape, on its way from start to end, first touch body, which rests? Proved for all times of
the way, not for samples. Surfaces only, as for overlap.

shape: Body, Shape or Mesh; the pose of a Body is not used. body: the same, where it stands. start,
end: a pose as for overlap, or n of them; one goes with n others. The pivot goes straight at constant
speed, and shape turns about it the shorter way (a half turn: either way). pivot: (3,), a point of
shape; else its origin. by: (3,) or (n, 3), in world: a straight shift in place of end, which is None
then. Without a clearance its time is exact; that of two poses with one rotation has a bracket.
Or first_contact(shape, motion, body): a RigidMotion or a list of them in place of start and end.
Or first_contact(shape, motion, body, motion_of_body): both move, each by a RigidMotion; the pose of body
is not used. Then two shifts have a bracket, too, and what is next to rounding is 'grazing'.
within: being this near is a contact, from 0 on. parting: pairs of triangles in contact at the start
are left out; verdict stays 'started', and lower and upper are of the first contact of another pair. timeout: seconds after which the call ends, with
coverage 'cut'. threads: 0 for all processors. progress: called with the share done.

Returns FirstContact, or for n motions FirstContactBatch, the answers of single calls. verdict 'free':
no contact at any time. 'contact': free until lower, in contact at upper, which are parts of the way.
'started': in contact at the start. 'grazing': neither is proved, so treat it as a contact. Raises
Error of kind not_rigid, not_finite, out_of_range (motions, named by index), usage.
Cost: typically a few times that of distance for each motion.)";

constexpr const char* kFreeDoc =
    R"(free(shape, starts, ends, body, *, pivot=None, by=None, within=0.0, timeout=None, threads=1, progress=None) -> numpy.ndarray

Which motions are free of contact all the way, as the edges of a roadmap? (n,) bool. True is proved;
False is a contact, or what could not be decided: next to rounding, or where the timeout came first.

starts, ends, and all others: as start and end of first_contact; or free(shape, motions, body), or
free(shape, motion, body, motion_of_body).
Returns a bool for one motion. Raises
Error as first_contact does.
Cost: that of first_contact.)";

/// A list or tuple whose first entry is a T.
template <class T>
bool begins_with(py::handle given) {
  return (py::isinstance<py::list>(given) || py::isinstance<py::tuple>(given)) &&
         py::len(given) > 0 && py::isinstance<T>(py::object(given[py::int_(0)]));
}

/// A motion, or a list of them.
bool are_motions(py::handle given) {
  return py::isinstance<RigidMotion>(given) || begins_with<RigidMotion>(given);
}

/// One pose or n of them, as `pose_of` and `poses_of` take them.
struct GivenPoses {
  std::vector<Pose> poses;
  bool is_one;
};

/// The place of an error begins with the argument.
template <class Function>
auto with_name(const std::string& name, const Function& function) {
  try {
    return function();
  } catch (const Error& error) {
    throw Error(error.kind(), name + ": " + error.place(), error.remedy());
  }
}

/// \shape A matrix, which is one pose, has 4 columns; others of two axes are rows of poses.
bool is_one_pose(py::handle given) {
  if (py::isinstance<Pose>(given)) {
    return true;
  }
  if (begins_with<Pose>(given)) {
    return false;
  }
  const Doubles numbers = doubles_of(given, "pose");
  return numbers.ndim() < 2 || (numbers.ndim() == 2 && numbers.shape(1) == 4);
}

GivenPoses given_poses(const py::object& given, const char* name) {
  return with_name(name, [&] {
    const bool is_one = is_one_pose(given);
    return is_one ? GivenPoses{{pose_of(given)}, is_one}
                  : GivenPoses{poses_of(given).copied(), is_one};
  });
}

/// The motions that a call is about.
class GivenMotions {
 public:
  GivenMotions(const py::object& start, const py::object& end, const py::object& pivot,
               const py::object& by)
      : starts_(given_poses(start, "start")) {
    if (by.is_none() == end.is_none()) {
      throw usage(by.is_none() ? "motion: neither end nor by is given"
                               : "motion: both end and by are given",
                  "give one of them, and None for the other");
    }
    if (by.is_none()) {
      ends_ = given_poses(end, "end");
      if (!pivot.is_none()) {
        pivot_ = point_of(doubles_of(pivot, "pivot"), "pivot");
      }
      pair_up(ends_.poses.size(), ends_.is_one, "end");
    } else {
      if (!pivot.is_none()) {
        throw usage("pivot: a shift by a vector turns nothing", "leave the pivot out, or give end");
      }
      const Doubles numbers = doubles_of(by, "by");
      const bool one_shift = is_point(numbers);
      shifts_ = one_shift ? std::vector<Vec3>{point_of(numbers, "by")}
                          : points_of(numbers, "by").copied();
      pair_up(shifts_.size(), one_shift, "by");
    }
  }

  /// \pre `are_motions(given)`. \errors py::type_error for an entry that is none.
  explicit GivenMotions(const py::object& given)
      : ready_(py::isinstance<RigidMotion>(given)
                   ? std::vector<RigidMotion>{given.cast<RigidMotion>()}
                   : entries_of(given)),
        is_one_(py::isinstance<RigidMotion>(given)) {}

  [[nodiscard]] bool is_one() const { return is_one_; }

  /// \errors As RigidMotion; for n motions, one at fault is named by its index.
  [[nodiscard]] std::vector<RigidMotion> made() const {
    if (!ready_.empty()) {
      return ready_;
    }
    std::vector<RigidMotion> motions;
    motions.reserve(count_);
    for (std::size_t i = 0; i < count_; ++i) {
      if (is_one_) {
        motions.push_back(motion(i));
      } else {
        motions.push_back(with_name("motion " + std::to_string(i), [&] { return motion(i); }));
      }
    }
    return motions;
  }

 private:
  /// So many ends, or shifts, with the starts: one goes with any number.
  void pair_up(std::size_t others, bool one_other, const char* name) {
    is_one_ = starts_.is_one && one_other;
    if (!starts_.is_one && !one_other && starts_.poses.size() != others) {
      throw usage("start and " + std::string(name) + ": " + std::to_string(starts_.poses.size()) +
                      " and " + std::to_string(others) + " of them",
                  "give as many of both, or one of either");
    }
    count_ = starts_.is_one ? others : starts_.poses.size();
  }

  template <class T>
  [[nodiscard]] static const T& entry(const std::vector<T>& of, bool is_only, std::size_t i) {
    return of[is_only ? 0 : i];
  }

  [[nodiscard]] RigidMotion motion(std::size_t i) const {
    const Pose& start = entry(starts_.poses, starts_.is_one, i);
    return shifts_.empty()
               ? RigidMotion::between(start, entry(ends_.poses, ends_.is_one, i), pivot_)
               : RigidMotion::along(start, entry(shifts_, shifts_.size() == 1, i));
  }

  [[nodiscard]] static std::vector<RigidMotion> entries_of(const py::object& given) {
    std::vector<RigidMotion> motions;
    for (const py::handle entry : given) {
      if (!py::isinstance<RigidMotion>(entry)) {
        throw py::type_error("motion " + std::to_string(motions.size()) + " is no RigidMotion");
      }
      motions.push_back(entry.cast<RigidMotion>());
    }
    return motions;
  }

  std::vector<RigidMotion> ready_;
  GivenPoses starts_{{}, true};
  GivenPoses ends_{{}, true};
  std::vector<Vec3> shifts_;
  Vec3 pivot_;
  std::size_t count_ = 0;
  bool is_one_ = true;
};

/// Motions by poses, or as they are: then the body comes in place of the end.
class MotionArguments {
 public:
  MotionArguments(const char* function, const py::object& start, const py::object& end,
                  const py::object& body, const py::object& pivot, const py::object& by)
      : motions_(are_motions(start) ? as_they_are(start, pivot, by)
                                    : GivenMotions(start, end, pivot, by)),
        body_(body) {
    const bool is_second = are_motions(start) && body.is_none();
    if (are_motions(start) && !is_second && !end.is_none()) {
      throw usage("motion: an end is given, and the motions have theirs", "leave it out");
    }
    if (is_second) {
      body_ = end;
    }
    if (body_.is_none()) {
      throw py::type_error(std::string(function) + "(): the argument body is missing");
    }
  }

  [[nodiscard]] const GivenMotions& motions() const { return motions_; }

  [[nodiscard]] const py::object& body() const { return body_; }

 private:
  static GivenMotions as_they_are(const py::object& given, const py::object& pivot,
                                  const py::object& by) {
    if (!pivot.is_none() || !by.is_none()) {
      throw usage("motion: pivot and by go with poses", "leave them out");
    }
    return GivenMotions(given);
  }

  GivenMotions motions_;
  py::object body_;
};

/// Both move: `first_contact(shape, motion, other, motion_of_other)`.
bool is_of_two(const py::object& start, const py::object& body) {
  return are_motions(start) && are_motions(body);
}

FirstContact answer_of_two(const py::object& shape, const py::object& motion,
                           const py::object& other, const py::object& motion_of_other,
                           const py::object& pivot, const py::object& by,
                           const FirstContactOptions& options, const CallLimits& allowed,
                           const py::object& progress) {
  if (!py::isinstance<RigidMotion>(motion) || !py::isinstance<RigidMotion>(motion_of_other)) {
    throw usage("motion: a list of motions, where both bodies move", "give one motion of each");
  }
  if (!pivot.is_none() || !by.is_none()) {
    throw usage("motion: pivot and by go with poses", "leave them out");
  }
  const BodyArgument mover(shape, "shape", allowed.threads);
  const BodyArgument second(other, "body", allowed.threads);
  const auto way = motion.cast<RigidMotion>();
  const auto way_of_other = motion_of_other.cast<RigidMotion>();
  return run(Work::one, allowed, progress, [&](const Limits& limits) {
    return first_contact(mover.get().shape, way, second.get().shape, way_of_other, options, limits);
  });
}

FirstContactBatch answers(const py::object& shape, const MotionArguments& given,
                          const FirstContactOptions& options, const CallLimits& allowed,
                          const py::object& progress) {
  const BodyArgument mover(shape, "shape", allowed.threads);
  const BodyArgument fixed(given.body(), "body", allowed.threads);
  return run(Work::many, allowed, progress, [&](const Limits& limits) {
    return first_contact(mover.get().shape, given.motions().made(), fixed.get(), options, limits);
  });
}

py::object query_first_contact(const py::object& shape, const py::object& start,
                               const py::object& end, const py::object& body,
                               const py::object& pivot, const py::object& by, double clearance,
                               bool parting, std::optional<double> timeout, int threads,
                               const py::object& progress) {
  const FirstContactOptions options{.within = clearance, .parting = parting};
  if (is_of_two(start, body)) {
    return made(
        answer_of_two(shape, start, end, body, pivot, by, options, {threads, timeout}, progress));
  }
  const MotionArguments given("first_contact", start, end, body, pivot, by);
  if (!given.motions().is_one()) {
    return made(answers(shape, given, options, {threads, timeout}, progress));
  }
  const CallLimits allowed(threads, timeout);
  const BodyArgument mover(shape, "shape", threads);
  const BodyArgument fixed(given.body(), "body", threads);
  return made(run(Work::one, allowed, progress, [&](const Limits& limits) {
    return first_contact(mover.get().shape, given.motions().made()[0], fixed.get(), options,
                         limits);
  }));
}

py::object query_free(const py::object& shape, const py::object& starts, const py::object& ends,
                      const py::object& body, const py::object& pivot, const py::object& by,
                      double clearance, std::optional<double> timeout, int threads,
                      const py::object& progress) {
  if (is_of_two(starts, body)) {
    return py::bool_(answer_of_two(shape, starts, ends, body, pivot, by, {.within = clearance},
                                   {threads, timeout}, progress)
                         .verdict == ContactVerdict::free);
  }
  const MotionArguments given("free", starts, ends, body, pivot, by);
  const FirstContactBatch batch =
      answers(shape, given, {.within = clearance}, {threads, timeout}, progress);
  if (given.motions().is_one()) {
    return py::bool_(batch.verdict[0] == ContactVerdict::free);
  }
  py::array_t<bool> flags(static_cast<py::ssize_t>(batch.size()));
  std::transform(batch.verdict.begin(), batch.verdict.end(), flags.mutable_data(),
                 [](ContactVerdict verdict) { return verdict == ContactVerdict::free; });
  return flags;
}

Parameters motion_parameters(const char* start, const char* end, Parameters more = {}) {
  Parameters all{{"shape"},
                 {start},
                 {end, py::none()},
                 {"body", py::none()},
                 {"pivot", py::none(), true},
                 {"by", py::none(), true},
                 {"within", py::float_(FirstContactOptions{}.within), true}};
  all.insert(all.end(), more.begin(), more.end());
  return with_limits(std::move(all));
}

}  // namespace

void bind_first_contact(py::module_& module) {
  bind_answer<FirstContact>(module);
  bind_batch<FirstContact>(module).derived(
      "first_blocked", &FirstContactBatch::first_blocked,
      "The first motion that is not proved to be free, or None: where a path ends.");
  def_function(module, "first_contact", &query_first_contact, kFirstContactDoc,
               motion_parameters("start", "end", {{"parting", py::bool_(false), true}}));
  def_function(module, "free", &query_free, kFreeDoc, motion_parameters("starts", "ends"));
}

}  // namespace soms::python
