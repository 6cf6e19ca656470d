#include "soms/scene/recording.h"

#include "soms/base/error.h"
#include "soms/base/portable.h"
#include "soms/base/text.h"
#include "soms/scene/detail/recording_format.h"
#include "soms/scene/detail/recording_reader.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

namespace soms {

namespace {

using detail::put;
using detail::put_text;

void put_mesh(std::string& bytes, const RecordedMesh& mesh) {
  put_text(bytes, mesh.name);
  put(bytes, static_cast<std::uint8_t>(mesh.origin));
  put(bytes, static_cast<std::uint8_t>(mesh.up));
  put_text(bytes, mesh.source);
  put(bytes, mesh.file_size);
  put(bytes, mesh.scale);
  put(bytes, mesh.city_triangles);
  put(bytes, mesh.city_size);
  put(bytes, mesh.city_seed);
  put(bytes, mesh.triangles);
  put(bytes, mesh.hash);
}

std::string bytes_of(const RecordingHead& head) {
  std::string bytes;
  put_text(bytes, head.title);
  put(bytes, head.frames_a_second);
  put(bytes, head.frames_requested);
  put(bytes, static_cast<std::uint32_t>(head.environment.size()));
  for (const RecordedBody& body : head.environment) {
    put_mesh(bytes, body.mesh);
    for (const double entry : body.pose.m) {
      put(bytes, entry);
    }
  }
  put(bytes, static_cast<std::uint32_t>(head.models.size()));
  for (const RecordedMesh& mesh : head.models) {
    put_mesh(bytes, mesh);
  }
  put(bytes, static_cast<std::uint32_t>(head.movers.size()));
  for (const std::uint32_t model : head.movers) {
    put(bytes, model);
  }
  if (head.clearance > 0 || head.swept) {
    put(bytes, head.clearance);
  }
  return bytes;
}

std::string file_head(const RecordingHead& head) {
  std::string bytes(detail::kRecordingMagic);
  put(bytes, head.swept           ? detail::kPassagesVersion
             : head.clearance > 0 ? detail::kGapsVersion
                                  : detail::kContactsVersion);
  put(bytes, static_cast<std::uint32_t>(detail::hash_of(bytes)));
  return bytes;
}

std::string chunk_head(std::string_view tag, std::uint32_t frames, std::uint64_t first,
                       std::uint64_t length) {
  std::string bytes(tag);
  put(bytes, frames);
  put(bytes, first);
  put(bytes, length);
  put(bytes, detail::hash_of(bytes));
  return bytes;
}

/// The entries in which a pose differs from the one before, bit by bit.
void put_pose(std::string& bytes, const Pose& pose, const Pose& before) {
  std::uint16_t changed = 0;
  for (std::size_t k = 0; k < pose.m.size(); ++k) {
    if (bit_cast<std::uint64_t>(pose.m[k]) != bit_cast<std::uint64_t>(before.m[k])) {
      changed = static_cast<std::uint16_t>(changed | (1U << k));
    }
  }
  put(bytes, changed);
  for (std::size_t k = 0; k < pose.m.size(); ++k) {
    if ((std::uint32_t{changed} >> k & 1U) != 0) {
      put(bytes, pose.m[k]);
    }
  }
}

template <class Contact>
void put_contact(std::string& bytes, std::uint32_t first, std::uint32_t second,
                 const Contact& contact) {
  put(bytes, first);
  put(bytes, second);
  put(bytes, contact.i);
  put(bytes, contact.j);
}

void put_point(std::string& bytes, const Vec3& point) {
  put(bytes, point.x);
  put(bytes, point.y);
  put(bytes, point.z);
}

template <class Gap>
void put_gap(std::string& bytes, std::uint32_t first, std::uint32_t second, const Gap& gap) {
  put_contact(bytes, first, second, gap);
  put(bytes, gap.distance.lower);
  put(bytes, gap.distance.upper);
  put_point(bytes, gap.point_a);
  put_point(bytes, gap.point_b);
}

template <class Passage>
void put_passage(std::string& bytes, std::uint32_t first, std::uint32_t second,
                 const Passage& passage) {
  put_contact(bytes, first, second, passage);
  put(bytes, static_cast<std::uint8_t>(passage.verdict));
  put(bytes, passage.t.lower);
  put(bytes, passage.t.upper);
  put_point(bytes, passage.point);
}

void check_poses(std::span<const Pose> poses, std::uint64_t frame) {
  for (std::size_t k = 0; k < poses.size(); ++k) {
    try {
      detail::check_recordable(poses[k]);
    } catch (const Error& error) {
      throw Error(error.kind(),
                  "recording: frame " + std::to_string(frame) + ", mover " + std::to_string(k) +
                      ": " + error.place(),
                  error.remedy());
    }
  }
}

[[noreturn]] void refuse(const std::string& what) {
  throw Error(ErrorKind::usage, "recording: " + what, "give a valid value");
}

bool positive(double value) {
  return std::isfinite(value) && value > 0;
}

void check_mesh(const RecordedMesh& mesh) {
  if (!positive(mesh.scale)) {
    refuse("a scale is not positive");
  }
  if (!std::isfinite(mesh.city_size)) {
    refuse("the size of a city is not finite");
  }
  if (mesh.triangles > kMaxPrimitives) {
    refuse("a mesh of " + std::to_string(mesh.triangles) + " triangles");
  }
}

void check(const RecordingHead& head) {
  if (!positive(head.frames_a_second)) {
    refuse("the frame rate is not positive");
  }
  for (const RecordedMesh& mesh : head.models) {
    check_mesh(mesh);
  }
  for (const RecordedBody& body : head.environment) {
    check_mesh(body.mesh);
    try {
      detail::check_recordable(body.pose);
    } catch (const Error& error) {
      refuse("a body of the environment: " + error.place());
    }
  }
  if (!std::isfinite(head.clearance) || head.clearance < 0) {
    refuse("the clearance is not a length of 0 or more");
  }
  if (std::any_of(head.movers.begin(), head.movers.end(),
                  [&](std::uint32_t model) { return model >= head.models.size(); })) {
    refuse("a mover refers to a model that does not exist");
  }
}

}  // namespace

RecordingWriter::RecordingWriter(std::ostream& out, RecordingHead head)
    : out_(out), clearance_(head.clearance), swept_(head.swept) {
  check(head);
  before_.resize(head.movers.size());
  const std::string content = bytes_of(head);
  write(file_head(head));
  write(chunk_head(detail::kHeadTag, 0, 0, content.size()));
  write(content);
  std::string sum;
  put(sum, detail::hash_of(content));
  write(sum);
}

void RecordingWriter::write(const std::string& bytes) {
  if (!out_.write(bytes.data(), static_cast<std::streamsize>(bytes.size()))) {
    throw Error(ErrorKind::cannot_write, "recording: cannot write",
                "free some space, or choose another location");
  }
}

void RecordingWriter::add(std::span<const Pose> poses, const StepReport& report) {
  if (poses.size() != before_.size()) {
    throw Error(ErrorKind::usage,
                "recording: " + std::to_string(poses.size()) + " poses of " +
                    std::to_string(before_.size()) + " movers",
                "give the pose of each mover");
  }
  check_poses(poses, end_.frames);
  if (report.scope != StepScope::every_pair) {
    throw Error(ErrorKind::usage,
                "recording: the report of a step with StepScope::first_contact lacks contacts",
                "step with StepScope::every_pair");
  }
  if (report.clearance != clearance_) {
    throw Error(ErrorKind::usage,
                "recording: the report of a step with a clearance of " +
                    shortest(report.clearance) + ", where the head says " + shortest(clearance_),
                "step with the clearance of RecordingHead");
  }
  if (swept_ && !report.swept) {
    throw Error(ErrorKind::usage, "recording: the report of a step that is not swept",
                "step with StepOptions::swept, as RecordingHead says");
  }
  if (end_.frames > 0 && report.shapes_set != shapes_set_) {
    throw Error(
        ErrorKind::usage,
        "recording: frame " + std::to_string(end_.frames) +
            ": a shape was set in the scene since the frame before, and a recording holds one "
            "mesh for each mover",
        "finish the recording here, or set shapes before its first frame only");
  }
  const std::size_t whole = chunk_.size();
  try {
    put_frame(poses, report);
  } catch (...) {  // memory ran short: frames before this one stay good
    chunk_.resize(whole);
    throw;
  }
  std::copy(poses.begin(), poses.end(), before_.begin());
  shapes_set_ = report.shapes_set;
  ++chunk_frames_;
  ++end_.frames;
  end_.environment_contacts += report.environment.size();
  end_.mover_contacts += report.movers.size();
  hash_.add(report.hash());
  end_.hash = hash_.value();
  if (chunk_.size() >= detail::kChunkBytes || chunk_frames_ >= detail::kChunkFrames) {
    flush();
  }
}

void RecordingWriter::put_frame(std::span<const Pose> poses, const StepReport& report) {
  for (std::size_t k = 0; k < poses.size(); ++k) {
    put_pose(chunk_, poses[k], before_[k]);
  }
  put(chunk_, static_cast<std::uint64_t>(report.environment.size()));
  for (const EnvironmentContact& contact : report.environment) {
    put_contact(chunk_, contact.mover, contact.part, contact);
  }
  put(chunk_, static_cast<std::uint64_t>(report.movers.size()));
  for (const MoverContact& contact : report.movers) {
    put_contact(chunk_, contact.a, contact.b, contact);
  }
  if (clearance_ > 0) {
    put(chunk_, static_cast<std::uint64_t>(report.environment_gaps.size()));
    for (const EnvironmentGap& gap : report.environment_gaps) {
      put_gap(chunk_, gap.mover, gap.part, gap);
    }
    put(chunk_, static_cast<std::uint64_t>(report.mover_gaps.size()));
    for (const MoverGap& gap : report.mover_gaps) {
      put_gap(chunk_, gap.a, gap.b, gap);
    }
  }
  if (swept_) {
    put_passages(report);
  }
}

void RecordingWriter::put_passages(const StepReport& report) {
  // The recording has no way to its first frame.
  const bool is_first = end_.frames == 0;
  const std::span environment(report.environment_passages.data(),
                              is_first ? 0 : report.environment_passages.size());
  put(chunk_, static_cast<std::uint64_t>(environment.size()));
  for (const EnvironmentPassage& passage : environment) {
    put_passage(chunk_, passage.mover, passage.part, passage);
  }
  const std::span movers(report.mover_passages.data(), is_first ? 0 : report.mover_passages.size());
  put(chunk_, static_cast<std::uint64_t>(movers.size()));
  for (const MoverPassage& passage : movers) {
    put_passage(chunk_, passage.a, passage.b, passage);
  }
}

void RecordingWriter::flush() {
  if (chunk_frames_ == 0) {
    return;
  }
  const std::string head =
      chunk_head(detail::kFramesTag, chunk_frames_, end_.frames - chunk_frames_, chunk_.size());
  std::string sum;
  put(sum, detail::hash_of(chunk_));
  write(head);
  write(chunk_);
  write(sum);
  chunk_.clear();
  chunk_frames_ = 0;
  std::fill(before_.begin(), before_.end(), Pose{});
}

void RecordingWriter::finish(RecordingEnding ending) {
  flush();
  end_.ending = ending;
  end_.hash = hash_.value();
  std::string content;
  put(content, static_cast<std::uint8_t>(ending));
  put(content, end_.environment_contacts);
  put(content, end_.mover_contacts);
  put(content, end_.hash);
  write(chunk_head(detail::kEndTag, 0, end_.frames, content.size()));
  put(content, detail::hash_of(content));
  write(content);
  if (!out_.flush()) {
    throw Error(ErrorKind::cannot_write, "recording: cannot write",
                "free some space, or choose another location");
  }
}

}  // namespace soms
