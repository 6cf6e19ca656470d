/// \file
/// Contacts, gaps, reports and recordings, printed by `<<`:
/// "MoverContact{a: 0, b: 3, i: 17, j: 4}".
#pragma once

#include "soms/query/print.h"
#include "soms/scene/body_index.h"
#include "soms/scene/clearance_along.h"
#include "soms/scene/contact_tracker.h"
#include "soms/scene/recording.h"
#include "soms/scene/scene_query.h"
#include "soms/scene/step_report.h"

#include <cstdint>
#include <iosfwd>

namespace soms {

struct BodyClosestBatch;
struct BodyFilter;
struct BodyAllHits;
struct BodyHitBatch;
struct Clearance;
struct ClearanceOptions;
struct ClearanceStation;
struct ClearanceStretch;
struct ContactEvents;
struct ContactSide;
struct ContactSpan;
struct PathContact;
struct MotionPath;
struct RecordedBody;
struct RecordedFrame;
struct RecordedMesh;
struct RecordingEnd;
struct RecordingHead;
struct SceneClosestBatch;
struct SceneFilter;
struct SceneAllHits;
struct SceneHitBatch;
struct StepOptions;
struct StepReport;

/// One line, as in soms/base/print.h. Lists are counted, not listed.
std::ostream& operator<<(std::ostream& out, const BodyClosestBatch& value);
std::ostream& operator<<(std::ostream& out, const BodyFilter& value);
std::ostream& operator<<(std::ostream& out, const BodyHitBatch& value);
std::ostream& operator<<(std::ostream& out, const BodyAllHits& value);
std::ostream& operator<<(std::ostream& out, const SceneClosestBatch& value);
std::ostream& operator<<(std::ostream& out, const SceneFilter& value);
std::ostream& operator<<(std::ostream& out, const SceneHitBatch& value);
std::ostream& operator<<(std::ostream& out, const SceneAllHits& value);
std::ostream& operator<<(std::ostream& out, const Clearance& value);
std::ostream& operator<<(std::ostream& out, const ClearanceOptions& value);
std::ostream& operator<<(std::ostream& out, const ClearanceStation& value);
std::ostream& operator<<(std::ostream& out, const ClearanceStretch& value);
std::ostream& operator<<(std::ostream& out, const PathContact& value);
std::ostream& operator<<(std::ostream& out, const MotionPath& value);
std::ostream& operator<<(std::ostream& out, const ContactEvents& value);
std::ostream& operator<<(std::ostream& out, const ContactSide& value);
std::ostream& operator<<(std::ostream& out, const ContactSpan& value);
std::ostream& operator<<(std::ostream& out, const StepReport& value);
std::ostream& operator<<(std::ostream& out, const StepOptions& value);
std::ostream& operator<<(std::ostream& out, const RecordedMesh& value);
std::ostream& operator<<(std::ostream& out, const RecordedBody& value);
std::ostream& operator<<(std::ostream& out, const RecordingHead& value);
std::ostream& operator<<(std::ostream& out, const RecordedFrame& value);
std::ostream& operator<<(std::ostream& out, const RecordingEnd& value);

}  // namespace soms
