#include "soms/scene/detail/recording_reader.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

namespace soms::detail {

namespace {

constexpr std::size_t kBuffer = std::size_t{1} << 16;
/// Least bytes of a mesh: lengths of two texts, two small numbers, seven large ones.
constexpr std::size_t kLeastMesh = 4 + 1 + 1 + 4 + 7 * 8;

Pose read_pose(ChunkContent& content) {
  Pose pose;
  for (double& entry : pose.m) {
    entry = content.real();
  }
  return pose;
}

double read_positive(ChunkContent& content, const char* what) {
  const double value = content.real();
  if (!std::isfinite(value) || value <= 0) {
    throw content.fault(std::string(what) + " that is not positive");
  }
  return value;
}

RecordedMesh read_mesh(ChunkContent& content) {
  RecordedMesh mesh;
  mesh.name = content.text();
  mesh.origin = read_choice(content, RecordedMesh::Origin::mover, "origin");
  mesh.up = read_choice(content, UpAxis::z, "axis");
  mesh.source = content.text();
  mesh.file_size = content.number<std::uint64_t>();
  mesh.scale = read_positive(content, "a scale");
  mesh.city_triangles = content.number<std::uint64_t>();
  mesh.city_size = content.real();
  mesh.city_seed = content.number<std::uint64_t>();
  mesh.triangles = content.number<std::uint64_t>();
  mesh.hash = content.number<std::uint64_t>();
  if (!std::isfinite(mesh.city_size)) {
    throw content.fault("a city of no size");
  }
  if (mesh.triangles > kMaxPrimitives) {
    throw content.fault("a mesh of " + std::to_string(mesh.triangles) + " triangles");
  }
  return mesh;
}

}  // namespace

RecordingBytes::RecordingBytes(std::unique_ptr<std::istream> in, std::string name)
    : in_(std::move(in)), name_(std::move(name)) {
  in_->seekg(0, std::ios::end);
  const std::istream::pos_type end = in_->tellg();
  if (!*in_ || end < 0) {
    throw Error(ErrorKind::cannot_open, name_ + ": cannot seek in it",
                "give the recording as a regular file");
  }
  size_ = static_cast<std::uint64_t>(end);
  seek(0);
}

void RecordingBytes::seek(std::uint64_t position) {
  in_->clear();
  in_->seekg(static_cast<std::istream::off_type>(position));
  position_ = position;
}

void RecordingBytes::read(char* to, std::size_t count) {
  if (!in_->read(to, static_cast<std::streamsize>(count))) {
    throw cut();
  }
  position_ += count;
}

Error RecordingBytes::fault(std::uint64_t byte, const std::string& what) const {
  return Error(ErrorKind::bad_file, name_ + ", byte " + std::to_string(byte) + ": " + what,
               "record it again; the frames before this place are intact");
}

Error RecordingBytes::cut() const {
  return fault(size_, "the recording is cut off here");
}

ChunkContent::ChunkContent(RecordingBytes& bytes, std::uint64_t length)
    : bytes_(&bytes),
      unread_(length),
      buffer_(static_cast<std::size_t>(std::min<std::uint64_t>(kBuffer, length))) {
}

/// Keeps what is left in the buffer and fills the rest of it.
void ChunkContent::refill() {
  std::copy(buffer_.begin() + static_cast<std::ptrdiff_t>(at_),
            buffer_.begin() + static_cast<std::ptrdiff_t>(end_), buffer_.begin());
  end_ -= at_;
  at_ = 0;
  const auto count =
      static_cast<std::size_t>(std::min<std::uint64_t>(unread_, buffer_.size() - end_));
  bytes_->read(buffer_.data() + end_, count);
  for (std::size_t k = 0; k < count; ++k) {
    hash_.add_byte(static_cast<std::uint8_t>(buffer_[end_ + k]));
  }
  end_ += count;
  unread_ -= count;
}

const char* ChunkContent::take(std::size_t count) {
  if (count > left()) {
    throw fault("the chunk is too short for its content");
  }
  if (count > end_ - at_) {
    refill();
  }
  return buffer_.data() + std::exchange(at_, at_ + count);
}

std::string ChunkContent::text() {
  std::string text;
  for (auto length = count<std::uint32_t>(1); length > 0;) {
    const auto some = static_cast<std::uint32_t>(
        std::min<std::size_t>(length, std::max<std::size_t>(end_ - at_, 1)));
    text.append(take(some), some);
    length -= some;
  }
  return text;
}

Error ChunkContent::fault(const std::string& what) const {
  return bytes_->fault(bytes_->position() - (end_ - at_), what);
}

bool ChunkContent::is_unaltered() {
  while (left() > 0) {
    at_ = end_;
    refill();
  }
  std::array<char, kCheckSize> check{};
  bytes_->read(check.data(), check.size());
  return get<std::uint64_t>(check.data()) == hash_.value();
}

void check_recordable(const Pose& pose) {
  check(pose);
  if (!(std::max({std::abs(pose.m[3]), std::abs(pose.m[7]), std::abs(pose.m[11])}) <=
        kMaxCoordinate)) {
    throw Error(ErrorKind::out_of_range, "pose: its shift exceeds 2^300",
                "use coordinates of magnitude at most 2^300");
  }
}

void check_pose(const ChunkContent& content, const Pose& pose) {
  try {
    check_recordable(pose);
  } catch (const Error& error) {
    if (error.kind() == ErrorKind::unsupported) {
      throw;
    }
    throw content.fault("an invalid pose: " + error.place());
  }
}

std::uint32_t read_file_head(RecordingBytes& bytes) {
  std::array<char, kFileHeadSize> head{};
  const std::size_t there = std::min<std::uint64_t>(head.size(), bytes.size());
  bytes.read(head.data(), there);
  const std::string_view text(head.data(), there);
  const std::string_view magic = text.substr(0, kRecordingMagic.size());
  if (magic != kRecordingMagic.substr(0, magic.size()) || magic.empty()) {
    throw Error(ErrorKind::bad_file, bytes.fault(0, "not a recording of soms").place(),
                "give a file that a RecordingWriter wrote");
  }
  if (there < head.size()) {
    throw bytes.cut();
  }
  if (get<std::uint32_t>(head.data() + 12) !=
      static_cast<std::uint32_t>(hash_of(text.substr(0, 12)))) {
    throw bytes.fault(8, "the version is corrupt");
  }
  const auto version = get<std::uint32_t>(head.data() + 8);
  if (version < kContactsVersion || version > kPassagesVersion) {
    throw Error(ErrorKind::unsupported,
                bytes.fault(8, "a recording of version " + std::to_string(version)).place(),
                "this soms reads versions " + std::to_string(kContactsVersion) + " to " +
                    std::to_string(kPassagesVersion) + "; use a newer version of soms");
  }
  return version;
}

ChunkHead read_chunk_head(RecordingBytes& bytes) {
  const std::uint64_t begin = bytes.position();
  if (bytes.size() - begin < kChunkHeadSize) {
    throw bytes.cut();
  }
  std::array<char, kChunkHeadSize> raw{};
  bytes.read(raw.data(), raw.size());
  if (get<std::uint64_t>(raw.data() + 24) != hash_of({raw.data(), 24})) {
    throw bytes.fault(begin, "the header of a chunk is corrupt");
  }
  ChunkHead head;
  std::copy_n(raw.begin(), head.tag.size(), head.tag.begin());
  head.frames = get<std::uint32_t>(raw.data() + 4);
  head.first = get<std::uint64_t>(raw.data() + 8);
  head.length = get<std::uint64_t>(raw.data() + 16);
  const std::uint64_t left = bytes.size() - bytes.position();
  if (left < kCheckSize || head.length > left - kCheckSize) {
    throw bytes.cut();
  }
  return head;
}

RecordingHead read_head(ChunkContent& content, std::uint32_t version) {
  RecordingHead head;
  head.title = content.text();
  head.frames_a_second = read_positive(content, "a frame rate");
  head.frames_requested = content.number<std::uint64_t>();
  const auto bodies = content.count<std::uint32_t>(kLeastMesh + sizeof(Pose));
  for (std::uint32_t k = 0; k < bodies; ++k) {
    RecordedMesh mesh = read_mesh(content);
    const Pose pose = read_pose(content);
    check_pose(content, pose);
    head.environment.push_back({std::move(mesh), pose});
  }
  const auto models = content.count<std::uint32_t>(kLeastMesh);
  for (std::uint32_t k = 0; k < models; ++k) {
    head.models.push_back(read_mesh(content));
  }
  const auto movers = content.count<std::uint32_t>(4);
  for (std::uint32_t k = 0; k < movers; ++k) {
    head.movers.push_back(content.number<std::uint32_t>());
    if (head.movers.back() >= models) {
      throw content.fault("mover " + std::to_string(k) + " refers to no model");
    }
  }
  if (version == kGapsVersion) {
    head.clearance = read_positive(content, "a clearance");
  } else if (version == kPassagesVersion) {
    head.swept = true;
    head.clearance = content.real();
    if (!std::isfinite(head.clearance) || head.clearance < 0) {
      throw content.fault("a clearance that is no length");
    }
  }
  return head;
}

RecordingEnd read_end(ChunkContent& content, std::uint64_t frames) {
  RecordingEnd end;
  end.ending = read_choice(content, RecordingEnding::interrupted, "ending");
  end.frames = frames;
  end.environment_contacts = content.number<std::uint64_t>();
  end.mover_contacts = content.number<std::uint64_t>();
  end.hash = content.number<std::uint64_t>();
  return end;
}

}  // namespace soms::detail
