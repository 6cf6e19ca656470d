#include "apps/soms/simulate/simulate_record.h"

#include "soms/base/error.h"

#include "apps/world/recorded_world.h"

namespace soms::command {

/// The file knows better than the writer why it cannot be written.
template <class Write>
void Recorder::write(const Write& write) {
  try {
    write();
  } catch (const Error& error) {
    if (error.kind() == ErrorKind::cannot_write) {
      file_.check();
    }
    throw;
  }
}

Recorder::Recorder(OutputFile& file, const World& world, std::uint64_t frames, double clearance,
                   bool swept)
    : file_(file), writer_(file.stream(), recording_head(world, frames, clearance, swept)) {
}

void Recorder::add(std::span<const Pose> poses, const StepReport& report) {
  write([&] { writer_.add(poses, report); });
}

void Recorder::finish(RecordingEnding ending) {
  write([&] { writer_.finish(ending); });
  file_.commit();
}

}  // namespace soms::command
