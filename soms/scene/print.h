/// \file
/// Contacts, reports and recordings, printed by `<<`:
/// "MoverContact{a: 0, b: 3, i: 17, j: 4}".
#pragma once

#include <cstdint>
#include <iosfwd>

namespace soms {

enum class RecordingEnding : std::uint8_t;
struct EnvironmentContact;
struct MoverContact;
struct RecordedBody;
struct RecordedFrame;
struct RecordedMesh;
struct RecordingEnd;
struct RecordingHead;
struct StepOptions;
struct StepReport;

/// One line, as in soms/base/print.h. Lists are counted, not listed.
std::ostream& operator<<(std::ostream& out, const EnvironmentContact& value);
std::ostream& operator<<(std::ostream& out, const MoverContact& value);
std::ostream& operator<<(std::ostream& out, const StepReport& value);
std::ostream& operator<<(std::ostream& out, const StepOptions& value);
std::ostream& operator<<(std::ostream& out, const RecordedMesh& value);
std::ostream& operator<<(std::ostream& out, const RecordedBody& value);
std::ostream& operator<<(std::ostream& out, const RecordingHead& value);
std::ostream& operator<<(std::ostream& out, const RecordedFrame& value);
std::ostream& operator<<(std::ostream& out, RecordingEnding value);
std::ostream& operator<<(std::ostream& out, const RecordingEnd& value);

}  // namespace soms
