/// \file
/// Contacts, gaps, reports and recordings, printed by `<<`:
/// "MoverContact{a: 0, b: 3, i: 17, j: 4}".
#pragma once

#include <cstdint>
#include <iosfwd>

namespace soms {

enum class ClearanceVerdict : std::uint8_t;
enum class ContactChange : std::uint8_t;
enum class RecordingEnding : std::uint8_t;
enum class SceneBodyKind : std::uint8_t;
enum class StepScope;
struct BodyClosest;
struct BodyClosestBatch;
struct BodyFilter;
struct BodyAllHits;
struct BodyHit;
struct BodyHitBatch;
struct Clearance;
struct ClearanceOptions;
struct ClearanceStation;
struct ClearanceStretch;
struct ContactEvents;
struct ContactSide;
struct ContactSpan;
struct EnvironmentContact;
struct EnvironmentEvent;
struct EnvironmentGap;
struct FirstContact;
struct MotionPath;
struct MoverContact;
struct MoverEvent;
struct MoverGap;
struct RecordedBody;
struct RecordedFrame;
struct RecordedMesh;
struct RecordingEnd;
struct RecordingHead;
struct SceneBody;
struct SceneClosest;
struct SceneClosestBatch;
struct SceneFilter;
struct SceneAllHits;
struct SceneHit;
struct SceneHitBatch;
struct StepOptions;
struct StepReport;

/// One line, as in soms/base/print.h. Lists are counted, not listed.
std::ostream& operator<<(std::ostream& out, const BodyClosest& value);
std::ostream& operator<<(std::ostream& out, const BodyClosestBatch& value);
std::ostream& operator<<(std::ostream& out, const BodyFilter& value);
std::ostream& operator<<(std::ostream& out, const BodyHit& value);
std::ostream& operator<<(std::ostream& out, const BodyHitBatch& value);
std::ostream& operator<<(std::ostream& out, const BodyAllHits& value);
std::ostream& operator<<(std::ostream& out, SceneBodyKind value);
std::ostream& operator<<(std::ostream& out, const SceneBody& value);
std::ostream& operator<<(std::ostream& out, const SceneClosest& value);
std::ostream& operator<<(std::ostream& out, const SceneClosestBatch& value);
std::ostream& operator<<(std::ostream& out, const SceneFilter& value);
std::ostream& operator<<(std::ostream& out, const SceneHit& value);
std::ostream& operator<<(std::ostream& out, const SceneHitBatch& value);
std::ostream& operator<<(std::ostream& out, const SceneAllHits& value);
std::ostream& operator<<(std::ostream& out, const EnvironmentContact& value);
std::ostream& operator<<(std::ostream& out, const MoverContact& value);
std::ostream& operator<<(std::ostream& out, const EnvironmentGap& value);
std::ostream& operator<<(std::ostream& out, const MoverGap& value);
std::ostream& operator<<(std::ostream& out, const Clearance& value);
std::ostream& operator<<(std::ostream& out, const ClearanceOptions& value);
std::ostream& operator<<(std::ostream& out, const ClearanceStation& value);
std::ostream& operator<<(std::ostream& out, const ClearanceStretch& value);
std::ostream& operator<<(std::ostream& out, ClearanceVerdict value);
std::ostream& operator<<(std::ostream& out, const FirstContact& value);
std::ostream& operator<<(std::ostream& out, const MotionPath& value);
std::ostream& operator<<(std::ostream& out, ContactChange value);
std::ostream& operator<<(std::ostream& out, const EnvironmentEvent& value);
std::ostream& operator<<(std::ostream& out, const MoverEvent& value);
std::ostream& operator<<(std::ostream& out, const ContactEvents& value);
std::ostream& operator<<(std::ostream& out, const ContactSide& value);
std::ostream& operator<<(std::ostream& out, const ContactSpan& value);
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
