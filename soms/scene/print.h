/// \file
/// Contacts, gaps, reports and recordings, printed by `<<`:
/// "MoverContact{a: 0, b: 3, i: 17, j: 4}".
#pragma once

#include <cstdint>
#include <iosfwd>

namespace soms {

enum class ContactChange : std::uint8_t;
enum class RecordingEnding : std::uint8_t;
enum class StepScope;
struct ContactEvents;
struct EnvironmentContact;
struct EnvironmentEvent;
struct EnvironmentGap;
struct MoverContact;
struct MoverEvent;
struct MoverGap;
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
std::ostream& operator<<(std::ostream& out, const EnvironmentGap& value);
std::ostream& operator<<(std::ostream& out, const MoverGap& value);
std::ostream& operator<<(std::ostream& out, ContactChange value);
std::ostream& operator<<(std::ostream& out, const EnvironmentEvent& value);
std::ostream& operator<<(std::ostream& out, const MoverEvent& value);
std::ostream& operator<<(std::ostream& out, const ContactEvents& value);
std::ostream& operator<<(std::ostream& out, StepScope value);
std::ostream& operator<<(std::ostream& out, const StepReport& value);
std::ostream& operator<<(std::ostream& out, const StepOptions& value);
std::ostream& operator<<(std::ostream& out, const RecordedMesh& value);
std::ostream& operator<<(std::ostream& out, const RecordedBody& value);
std::ostream& operator<<(std::ostream& out, const RecordingHead& value);
std::ostream& operator<<(std::ostream& out, const RecordedFrame& value);
std::ostream& operator<<(std::ostream& out, RecordingEnding value);
std::ostream& operator<<(std::ostream& out, const RecordingEnd& value);

}  // namespace soms
