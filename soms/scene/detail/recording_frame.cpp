// Frames of a recording: poses, and lists of what touches, is near or was passed.
#include "soms/scene/detail/recording_reader.h"

#include <cmath>
#include <string>
#include <tuple>

namespace soms::detail {

namespace {

/// Two bodies and a triangle of each.
template <class Contact>
Contact read_ids(ChunkContent& content) {
  const auto first = content.number<std::uint32_t>();
  const auto second = content.number<std::uint32_t>();
  const auto i = content.number<std::uint32_t>();
  return {first, second, i, content.number<std::uint32_t>()};
}

/// Contacts in strictly ascending order, each of what there is.
template <class Contact, class Check>
void read_contacts(ChunkContent& content, std::vector<Contact>& contacts, const Check& exists) {
  const auto count = content.count<std::uint64_t>(kContactSize);
  contacts.clear();
  for (std::uint64_t k = 0; k < count; ++k) {
    const auto contact = read_ids<Contact>(content);
    if (!exists(contact)) {
      throw content.fault("a contact refers to a mover or part that does not exist");
    }
    if (!contacts.empty() && !(contacts.back() < contact)) {
      throw content.fault("the contacts are not sorted");
    }
    contacts.push_back(contact);
  }
}

Vec3 read_point(ChunkContent& content, const char* whose) {
  Vec3 point;
  for (double* const entry : {&point.x, &point.y, &point.z}) {
    *entry = content.real();
    if (!std::isfinite(*entry)) {
      throw content.fault("a point of a " + std::string(whose) + " is not finite");
    }
  }
  return point;
}

/// The distance of two bodies that are within the clearance and do not touch. The clearance is a
/// double, so no bracket's upper end is beyond it; the lower end is 0 where the distance is less
/// than any double.
Bracket read_distance(ChunkContent& content, double clearance) {
  const double lower = content.real();
  const double upper = content.real();
  if (!(0 <= lower && lower <= upper && 0 < upper && upper <= clearance)) {
    throw content.fault("the distance of a gap is no distance within the clearance");
  }
  return {lower, upper};
}

/// The two bodies of a gap or a contact.
template <class Pair>
auto bodies_of(const Pair& pair) {
  if constexpr (requires { pair.part; }) {
    return std::tuple(pair.mover, pair.part);
  } else {
    return std::tuple(pair.a, pair.b);
  }
}

/// Gaps in strictly ascending order of their bodies, each of what there is. `contacts` are those
/// of the frame: bodies that touch have no gap.
template <class Gap, class Contact, class Check>
void read_gaps(ChunkContent& content, double clearance, const std::vector<Contact>& contacts,
               std::vector<Gap>& gaps, const Check& exists) {
  const auto count = content.count<std::uint64_t>(kGapSize);
  gaps.clear();
  auto contact = contacts.begin();
  for (std::uint64_t k = 0; k < count; ++k) {
    const auto ids = read_ids<Contact>(content);
    if (!exists(ids)) {
      throw content.fault("a gap refers to a mover or part that does not exist");
    }
    const Bracket distance = read_distance(content, clearance);
    const Vec3 point_a = read_point(content, "gap");
    const auto [first, second] = bodies_of(ids);
    const Gap gap{first, second, ids.i, ids.j, distance, point_a, read_point(content, "gap")};
    if (!gaps.empty() && !(bodies_of(gaps.back()) < bodies_of(gap))) {
      throw content.fault("the gaps are not sorted");
    }
    while (contact != contacts.end() && bodies_of(*contact) < bodies_of(gap)) {
      ++contact;
    }
    if (contact != contacts.end() && bodies_of(*contact) == bodies_of(gap)) {
      throw content.fault("a gap between bodies that touch");
    }
    gaps.push_back(gap);
  }
}

/// What is said of a way that is not proved free: from 0 to 1, in contact there or never.
Bracket read_moment(ChunkContent& content) {
  const double lower = content.real();
  const double upper = content.real();
  if (!(0 <= lower && lower <= 1 && lower <= upper && (upper <= 1 || std::isinf(upper)))) {
    throw content.fault("the time of a passage is none on the way");
  }
  return {lower, upper};
}

/// Passages in strictly ascending order of their bodies, each of what there is.
template <class Passage, class Contact, class Check>
void read_passages(ChunkContent& content, std::vector<Passage>& passages, const Check& exists) {
  const auto count = content.count<std::uint64_t>(kPassageSize);
  passages.clear();
  for (std::uint64_t k = 0; k < count; ++k) {
    const auto ids = read_ids<Contact>(content);
    if (!exists(ids)) {
      throw content.fault("a passage refers to a mover or part that does not exist");
    }
    const auto verdict = read_choice(content, ContactVerdict::started, "verdict");
    if (verdict == ContactVerdict::free) {
      throw content.fault("a passage that is free");
    }
    const Bracket t = read_moment(content);
    const auto [first, second] = bodies_of(ids);
    const Passage passage{first, second, ids.i, ids.j, verdict, t, read_point(content, "passage")};
    if (!passages.empty() && !(bodies_of(passages.back()) < bodies_of(passage))) {
      throw content.fault("the passages are not sorted");
    }
    passages.push_back(passage);
  }
}

}  // namespace

void read_frame(ChunkContent& content, const RecordingHead& head, RecordedFrame& frame) {
  for (Pose& pose : frame.poses) {
    const auto changed = content.number<std::uint16_t>();
    if (changed >> pose.m.size() != 0) {
      throw content.fault("a pose has more than twelve entries");
    }
    for (std::size_t k = 0; k < pose.m.size(); ++k) {
      if ((changed >> k & 1) != 0) {
        pose.m[k] = content.real();
      }
    }
    if (changed != 0) {
      check_pose(content, pose);
    }
  }
  const std::size_t movers = head.movers.size();
  const auto triangles_of = [&](MoverId mover) {
    return head.models[head.movers[mover]].triangles;
  };
  const auto environment_exists = [&](const EnvironmentContact& c) {
    return c.mover < movers && c.part < head.environment.size() && c.i < triangles_of(c.mover) &&
           c.j < head.environment[c.part].mesh.triangles;
  };
  const auto movers_exist = [&](const MoverContact& c) {
    return c.a < c.b && c.b < movers && c.i < triangles_of(c.a) && c.j < triangles_of(c.b);
  };
  read_contacts(content, frame.environment, environment_exists);
  read_contacts(content, frame.movers, movers_exist);
  if (head.clearance > 0) {
    read_gaps(content, head.clearance, frame.environment, frame.environment_gaps,
              environment_exists);
    read_gaps(content, head.clearance, frame.movers, frame.mover_gaps, movers_exist);
  }
  if (head.swept) {
    read_passages<EnvironmentPassage, EnvironmentContact>(content, frame.environment_passages,
                                                          environment_exists);
    read_passages<MoverPassage, MoverContact>(content, frame.mover_passages, movers_exist);
  }
}

}  // namespace soms::detail
