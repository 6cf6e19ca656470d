/// \file
/// Contacts, gaps, reports and recordings, printed by `<<`:
/// "MoverContact{a: 0, b: 3, i: 17, j: 4}".
#pragma once

#include "soms/base/print_fields.h"
#include "soms/query/print.h"
#include "soms/scene/body_index.h"
#include "soms/scene/clearance_along.h"
#include "soms/scene/contact_tracker.h"
#include "soms/scene/of_bodies.h"
#include "soms/scene/recording.h"
#include "soms/scene/scene_query.h"
#include "soms/scene/step_report.h"

#include <cstdint>
#include <iosfwd>

namespace soms {

struct BodyFilter;
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
struct SceneFilter;
struct StepOptions;
struct StepReport;

/// One line, as in soms/base/print.h. Lists are counted, not listed.
std::ostream& operator<<(std::ostream& out, const BodyFilter& value);
std::ostream& operator<<(std::ostream& out, const SceneFilter& value);
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

/// Columns of answers about many bodies, and lists of crossings:
/// "BodyHitBatch{ClosestHitBatch{...}}".
template <detail::ListOfAnswers Answers, class Name>
std::ostream& operator<<(std::ostream& out, const OfBodies<Answers, Name>& value) {
  const char* name = nullptr;
  if constexpr (Described<Answers>) {
    name = Fields<OfBodies<Answers, Name>>::kName;
  } else {
    name = Fields<decltype(value.at(0))>::kBatchName;
  }
  return out << PrintedFields(name).item(printed(static_cast<const Answers&>(value)));
}

}  // namespace soms
