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

std::ostream& print_filter(std::ostream& out, PrintedFields& fields, const auto& except) {
  if (except) {
    fields.add("except", *except);
  }
  return out << fields;
}

}  // namespace

std::ostream& operator<<(std::ostream& out, const BodyFilter& value) {
  PrintedFields fields("BodyFilter");
  return print_filter(out, fields, value.except);
}

std::ostream& operator<<(std::ostream& out, const SceneFilter& value) {
  PrintedFields fields("SceneFilter");
  fields.add("environment", value.environment).add("movers", value.movers);
  return print_filter(out, fields, value.except);
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
    fields.add("body", *value.body).add("i", value.triangles->a).add("j", value.triangles->b);
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

std::ostream& operator<<(std::ostream& out, const PathContact& value) {
  return out << PrintedFields("PathContact")
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
                    .add("i", value.pair.a)
                    .add("j", value.pair.b)
                    .add("place", value.place)
                    .add("box", value.box)
                    .add("lasts", value.lasts);
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
                    .add("gap_queries", value.gap_queries)
                    .add("swept", value.swept)
                    .add("environment_passages", value.environment_passages.size())
                    .add("mover_passages", value.mover_passages.size())
                    .add("passage_queries", value.passage_queries);
}

std::ostream& operator<<(std::ostream& out, const StepOptions& value) {
  PrintedFields fields("StepOptions");
  fields.add("mode", value.mode)
      .add("scope", value.scope)
      .add("mover_mover", value.mover_mover)
      .add("coherent", value.coherent)
      .add("clearance", value.clearance)
      .add("swept", value.swept);
  if (value.method != nullptr) {
    fields.item("method set");
  }
  return out << fields;
}

std::ostream& operator<<(std::ostream& out, const RecordedMesh& value) {
  return out << PrintedFields("RecordedMesh")
                    .item(quoted_text(value.name))
                    .add("origin", value.origin)
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
                    .add("mover_gaps", value.mover_gaps.size())
                    .add("environment_passages", value.environment_passages.size())
                    .add("mover_passages", value.mover_passages.size());
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
