/// \file
/// Answers about robots printed by `<<`: "RobotAnswer{contact, 2 contacts, ...}".
#pragma once

#include "soms/robot/robot_path.h"
#include "soms/robot/robot_query.h"

#include <iosfwd>

namespace soms {

enum class RobotVerdict : unsigned char;
struct RobotAnswer;
struct RobotAttachment;
struct RobotBody;
struct RobotMeshPart;
struct RobotContact;
struct RobotGap;
struct RobotModelOptions;
struct RobotOptions;
struct RobotPair;
struct RobotPath;
struct RobotPathOptions;
struct RobotSegment;

/// One line, as in soms/base/print.h. Lists are counted, not listed.
std::ostream& operator<<(std::ostream& out, const RobotAnswer& value);
std::ostream& operator<<(std::ostream& out, const RobotAttachment& value);
std::ostream& operator<<(std::ostream& out, const RobotMeshPart& value);
std::ostream& operator<<(std::ostream& out, const RobotBody& value);
std::ostream& operator<<(std::ostream& out, const RobotContact& value);
std::ostream& operator<<(std::ostream& out, const RobotGap& value);
std::ostream& operator<<(std::ostream& out, const RobotModelOptions& value);
std::ostream& operator<<(std::ostream& out, const RobotOptions& value);
std::ostream& operator<<(std::ostream& out, const RobotPair& value);
std::ostream& operator<<(std::ostream& out, const RobotPath& value);
std::ostream& operator<<(std::ostream& out, const RobotPathOptions& value);
std::ostream& operator<<(std::ostream& out, const RobotSegment& value);

}  // namespace soms
