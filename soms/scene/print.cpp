#include "soms/scene/print.h"

#include "soms/base/print.h"
#include "soms/base/print_fields.h"
#include "soms/geometry/print.h"
#include "soms/query/print.h"
#include "soms/scene/body_index.h"
#include "soms/scene/clearance_along.h"
#include "soms/scene/contact_spans.h"
#include "soms/scene/contact_tracker.h"
#include "soms/scene/recording.h"
#include "soms/scene/scene.h"
#include "soms/scene/scene_query.h"

#include <string>

namespace soms {

namespace {

/// An answer about one of many bodies, and its body: of `Answer`, what `<<` prints of one body.
template <class Answer, class Value>
std::ostream& print_with_body(std::ostream& out, const char* name, const Value& value) {
  PrintedFields fields(name);
  if (value.body) {
    fields.add("body", *value.body);
  }
  return out << fields.item(printed(static_cast<const Answer&>(value)));
}

std::ostream& print_filter(std::ostream& out, PrintedFields& fields, const auto& except) {
  if (except) {
    fields.add("except", *except);
  }
  return out << fields;
}

}  // namespace

std::ostream& operator<<(std::ostream& out, const BodyClosest& value) {
  return print_with_body<Closest>(out, "BodyClosest", value);
}

std::ostream& operator<<(std::ostream& out, const BodyClosestBatch& value) {
  return out << PrintedFields("BodyClosestBatch")
                    .item(printed(static_cast<const ClosestBatch&>(value)));
}

std::ostream& operator<<(std::ostream& out, const BodyFilter& value) {
  PrintedFields fields("BodyFilter");
  return print_filter(out, fields, value.except);
}

std::ostream& operator<<(std::ostream& out, const BodyHit& value) {
  return print_with_body<ClosestHit>(out, "BodyHit", value);
}

std::ostream& operator<<(std::ostream& out, const BodyHitBatch& value) {
  return out
         << PrintedFields("BodyHitBatch").item(printed(static_cast<const ClosestHitBatch&>(value)));
}

std::ostream& operator<<(std::ostream& out, const BodyAllHits& value) {
  return out << PrintedFields("BodyAllHits").item(printed(static_cast<const AllHits&>(value)));
}

std::ostream& operator<<(std::ostream& out, SceneBodyKind value) {
  return out << printed_name("SceneBodyKind", static_cast<int>(value), {"environment", "mover"});
}

std::ostream& operator<<(std::ostream& out, const SceneBody& value) {
  return out << PrintedFields("SceneBody").add("kind", value.kind).add("id", value.id);
}

std::ostream& operator<<(std::ostream& out, const SceneClosest& value) {
  return print_with_body<Closest>(out, "SceneClosest", value);
}

std::ostream& operator<<(std::ostream& out, const SceneClosestBatch& value) {
  return out << PrintedFields("SceneClosestBatch")
                    .item(printed(static_cast<const ClosestBatch&>(value)));
}

std::ostream& operator<<(std::ostream& out, const SceneFilter& value) {
  PrintedFields fields("SceneFilter");
  fields.add("environment", value.environment).add("movers", value.movers);
  return print_filter(out, fields, value.except);
}

std::ostream& operator<<(std::ostream& out, const SceneHit& value) {
  return print_with_body<ClosestHit>(out, "SceneHit", value);
}

std::ostream& operator<<(std::ostream& out, const SceneHitBatch& value) {
  return out << PrintedFields("SceneHitBatch")
                    .item(printed(static_cast<const ClosestHitBatch&>(value)));
}

std::ostream& operator<<(std::ostream& out, const SceneAllHits& value) {
  return out << PrintedFields("SceneAllHits").item(printed(static_cast<const AllHits&>(value)));
}

std::ostream& operator<<(std::ostream& out, const EnvironmentContact& value) {
  return out << PrintedFields("EnvironmentContact")
                    .add("mover", value.mover)
                    .add("part", value.part)
                    .add("i", value.i)
                    .add("j", value.j);
}

std::ostream& operator<<(std::ostream& out, const MoverContact& value) {
  return out << PrintedFields("MoverContact")
                    .add("a", value.a)
                    .add("b", value.b)
                    .add("i", value.i)
                    .add("j", value.j);
}

std::ostream& operator<<(std::ostream& out, const EnvironmentGap& value) {
  return out << PrintedFields("EnvironmentGap")
                    .add("mover", value.mover)
                    .add("part", value.part)
                    .add("i", value.i)
                    .add("j", value.j)
                    .add("lower", value.distance.lower)
                    .add("upper", value.distance.upper)
                    .add("point_a", value.point_a)
                    .add("point_b", value.point_b);
}

std::ostream& operator<<(std::ostream& out, const MoverGap& value) {
  return out << PrintedFields("MoverGap")
                    .add("a", value.a)
                    .add("b", value.b)
                    .add("i", value.i)
                    .add("j", value.j)
                    .add("lower", value.distance.lower)
                    .add("upper", value.distance.upper)
                    .add("point_a", value.point_a)
                    .add("point_b", value.point_b);
}

std::ostream& operator<<(std::ostream& out, const Clearance& value) {
  PrintedFields fields("Clearance");
  fields.item(printed_count(value.stations.size(), "station", "stations"))
      .add("at_least", value.at_least)
      .add("least", value.least);
  if (value.first_contact) {
    fields.add("first_contact", *value.first_contact);
  }
  return out << fields.add("below", value.below)
                    .add("queries", value.queries)
                    .add("coverage", value.coverage)
                    .add("cost", value.cost);
}

std::ostream& operator<<(std::ostream& out, const ClearanceOptions& value) {
  return out << PrintedFields("ClearanceOptions")
                    .add("every", value.every)
                    .add("accuracy", value.accuracy)
                    .add("clearance", value.clearance)
                    .add("keep_on_stop", value.keep_on_stop);
}

std::ostream& operator<<(std::ostream& out, const ClearanceStation& value) {
  PrintedFields fields("ClearanceStation");
  fields.add("segment", value.segment)
      .add("t", value.t)
      .add("chainage", value.chainage)
      .add("gap", value.gap);
  if (value.body && value.triangles) {
    fields.add("body", *value.body)
        .add("i", value.triangles->first)
        .add("j", value.triangles->second);
  }
  return out << fields;
}

std::ostream& operator<<(std::ostream& out, const ClearanceStretch& value) {
  return out << PrintedFields("ClearanceStretch")
                    .add("at_least", value.at_least)
                    .add("least", value.least)
                    .add("below", value.below)
                    .add("queries", value.queries);
}

std::ostream& operator<<(std::ostream& out, ClearanceVerdict value) {
  return out << printed_name("ClearanceVerdict", static_cast<int>(value),
                             {"ok", "below", "contact", "undecided"});
}

std::ostream& operator<<(std::ostream& out, const FirstContact& value) {
  return out << PrintedFields("FirstContact")
                    .add("free_until", value.free_until)
                    .add("station", value.station);
}

std::ostream& operator<<(std::ostream& out, const MotionPath& value) {
  return out << PrintedFields("MotionPath")
                    .item(printed_count(value.poses.size(), "pose", "poses"))
                    .add("length", value.chainage.empty()
                                       ? 0.0
                                       : value.chainage.back() - value.chainage.front())
                    .add("pivot", value.pivot);
}

std::ostream& operator<<(std::ostream& out, ContactChange value) {
  return out << printed_name("ContactChange", static_cast<int>(value), {"begin", "stay", "end"});
}

std::ostream& operator<<(std::ostream& out, const EnvironmentEvent& value) {
  return out << PrintedFields("EnvironmentEvent")
                    .add("mover", value.mover)
                    .add("part", value.part)
                    .add("change", value.change);
}

std::ostream& operator<<(std::ostream& out, const MoverEvent& value) {
  return out << PrintedFields("MoverEvent")
                    .add("a", value.a)
                    .add("b", value.b)
                    .add("change", value.change);
}

std::ostream& operator<<(std::ostream& out, const ContactEvents& value) {
  return out << PrintedFields("ContactEvents")
                    .add("environment", value.environment.size())
                    .add("movers", value.movers.size());
}

std::ostream& operator<<(std::ostream& out, const ContactSide& value) {
  PrintedFields fields("ContactSide");
  fields.add("body", value.body);
  if (value.part != Part::kNoParent) {
    fields.add("part", value.part);
  }
  return out << fields;
}

std::ostream& operator<<(std::ostream& out, const ContactSpan& value) {
  return out << PrintedFields("ContactSpan")
                    .add("a", value.a)
                    .add("b", value.b)
                    .add("begin", value.begin)
                    .add("end", value.end)
                    .add("steps", value.steps)
                    .add("most_pairs", value.most_pairs)
                    .add("most_step", value.most_step)
                    .add("i", value.pair.first)
                    .add("j", value.pair.second)
                    .add("place", value.place)
                    .add("box", value.box)
                    .add("lasts", value.lasts);
}

std::ostream& operator<<(std::ostream& out, StepScope value) {
  return out << printed_name("StepScope", static_cast<int>(value), {"every_pair", "first_contact"});
}

std::ostream& operator<<(std::ostream& out, const StepReport& value) {
  return out << PrintedFields("StepReport")
                    .add("environment", value.environment.size())
                    .add("movers", value.movers.size())
                    .add("coverage", value.coverage)
                    .add("cost", value.cost)
                    .add("queries", value.queries)
                    .add("box_pairs", value.box_pairs)
                    .add("scope", value.scope)
                    .add("mover_mover", value.mover_mover)
                    .add("shapes_set", value.shapes_set)
                    .add("clearance", value.clearance)
                    .add("environment_gaps", value.environment_gaps.size())
                    .add("mover_gaps", value.mover_gaps.size())
                    .add("gap_queries", value.gap_queries);
}

std::ostream& operator<<(std::ostream& out, const StepOptions& value) {
  PrintedFields fields("StepOptions");
  fields.add("mode", value.mode)
      .add("scope", value.scope)
      .add("mover_mover", value.mover_mover)
      .add("coherent", value.coherent)
      .add("clearance", value.clearance);
  if (value.method != nullptr) {
    fields.item("method set");
  }
  return out << fields;
}

std::ostream& operator<<(std::ostream& out, const RecordedMesh& value) {
  return out << PrintedFields("RecordedMesh")
                    .item(quoted_text(value.name))
                    .item("origin: " + printed_name("Origin", static_cast<int>(value.origin),
                                                    {"file", "city", "mover"}))
                    .add("source", value.source)
                    .item(printed_count(value.triangles, "triangle", "triangles"));
}

std::ostream& operator<<(std::ostream& out, const RecordedBody& value) {
  return out << PrintedFields("RecordedBody").item(printed(value.mesh)).item(printed(value.pose));
}

std::ostream& operator<<(std::ostream& out, const RecordingHead& value) {
  return out << PrintedFields("RecordingHead")
                    .item(quoted_text(value.title))
                    .add("frames_a_second", value.frames_a_second)
                    .add("frames_requested", value.frames_requested)
                    .add("environment", value.environment.size())
                    .add("models", value.models.size())
                    .add("movers", value.movers.size())
                    .add("clearance", value.clearance);
}

std::ostream& operator<<(std::ostream& out, const RecordedFrame& value) {
  return out << PrintedFields("RecordedFrame")
                    .add("poses", value.poses.size())
                    .add("environment", value.environment.size())
                    .add("movers", value.movers.size())
                    .add("environment_gaps", value.environment_gaps.size())
                    .add("mover_gaps", value.mover_gaps.size());
}

std::ostream& operator<<(std::ostream& out, RecordingEnding value) {
  return out << printed_name("RecordingEnding", static_cast<int>(value),
                             {"complete", "timed_out", "interrupted"});
}

std::ostream& operator<<(std::ostream& out, const RecordingEnd& value) {
  return out << PrintedFields("RecordingEnd")
                    .add("ending", value.ending)
                    .add("frames", value.frames)
                    .add("environment_contacts", value.environment_contacts)
                    .add("mover_contacts", value.mover_contacts)
                    .add("hash", value.hash);
}

}  // namespace soms
