#include "apps/soms/clash/bcf_xml.h"

#include "soms/base/text.h"

#include "apps/soms/clash/bcf_guid.h"

#include <algorithm>
#include <pugixml.hpp>
#include <sstream>
#include <string_view>

namespace soms::command {

namespace {

/// Words that XML may hold and schema 3.0 takes: no control characters, no bytes that are not
/// UTF-8, not empty.
std::string bcf_words(std::string_view words) {
  std::string text = printable(words);
  for (const std::string_view forbidden : {"\xef\xbf\xbe", "\xef\xbf\xbf"}) {  // U+FFFE, U+FFFF
    for (std::size_t at = text.find(forbidden); at != std::string::npos;
         at = text.find(forbidden)) {
      text.replace(at, forbidden.size(), 1, '?');
    }
  }
  const bool is_blank = text.find_first_not_of(' ') == std::string::npos;
  return is_blank ? std::string(1, '-') : text;
}

/// Likewise, but for line breaks.
std::string bcf_lines(const std::string& words) {
  std::istringstream in(words);
  std::string text;
  for (std::string line; std::getline(in, line);) {
    text += text.empty() ? "" : "\n";
    text += bcf_words(line);
  }
  return text;
}

class XmlFile {
 public:
  explicit XmlFile(const char* root) {
    pugi::xml_node head = document_.append_child(pugi::node_declaration);
    head.append_attribute("version") = "1.0";
    head.append_attribute("encoding") = "UTF-8";
    root_ = document_.append_child(root);
  }

  [[nodiscard]] pugi::xml_node& root() { return root_; }

  [[nodiscard]] std::string text() const {
    std::ostringstream out;
    document_.save(out, " ", pugi::format_indent, pugi::encoding_utf8);
    return out.str();
  }

 private:
  pugi::xml_document document_;
  pugi::xml_node root_;
};

void add_text(pugi::xml_node& parent, const char* name, std::string_view words) {
  parent.append_child(name).text().set(bcf_words(words).c_str());
}

void add_vector(pugi::xml_node& parent, const char* name, const Vec3& v) {
  pugi::xml_node node = parent.append_child(name);
  for (const auto& [axis, value] :
       {std::pair("X", v.x), std::pair("Y", v.y), std::pair("Z", v.z)}) {
    node.append_child(axis).text().set(shortest(value).c_str());
  }
}

void add_attribute(pugi::xml_node& node, const char* name, std::string_view words) {
  node.append_attribute(name) = bcf_words(words).c_str();
}

void add_component(pugi::xml_node& parent, const BcfComponent& part) {
  pugi::xml_node node = parent.append_child("Component");
  if (is_ifc_guid(part.id)) {
    node.append_attribute("IfcGuid") = part.id.c_str();
    add_text(node, "OriginatingSystem", part.file);
  } else {
    add_text(node, "OriginatingSystem", part.file);
    add_text(node, "AuthoringToolId", part.id.empty() ? part.label : part.id);
  }
}

pugi::xml_node list_in(pugi::xml_node& parent, const char* name, BcfVersion version) {
  return version == BcfVersion::v3_0 ? parent.append_child(name) : parent;
}

void add_files(pugi::xml_node& root, const BcfTopic& topic, BcfVersion version) {
  if (topic.files.empty()) {
    return;
  }
  pugi::xml_node header = root.append_child("Header");
  pugi::xml_node files = list_in(header, "Files", version);
  for (const std::string& file : topic.files) {
    pugi::xml_node node = files.append_child("File");
    node.append_attribute(version == BcfVersion::v3_0 ? "IsExternal" : "isExternal") = "true";
    add_text(node, "Filename", file);
  }
}

void add_viewpoints(pugi::xml_node& parent, const BcfTopic& topic, BcfVersion version) {
  if (topic.viewpoint_guid.empty()) {
    return;
  }
  const bool newer = version == BcfVersion::v3_0;
  pugi::xml_node list = list_in(parent, "Viewpoints", version);
  pugi::xml_node node = list.append_child(newer ? "ViewPoint" : "Viewpoints");
  node.append_attribute("Guid") = topic.viewpoint_guid.c_str();
  add_text(node, "Viewpoint", kBcfViewpoint);
  if (topic.has_snapshot) {
    add_text(node, "Snapshot", kBcfSnapshot);
  }
}

void add_all(pugi::xml_node& root, const char* list, const char* name,
             const std::set<std::string>& words) {
  pugi::xml_node node = root.append_child(list);
  for (const std::string& word : words) {
    add_text(node, name, word);
  }
}

}  // namespace

std::string bcf_version_xml(const BcfHead& head) {
  const bool newer = head.version == BcfVersion::v3_0;
  XmlFile file("Version");
  file.root().append_attribute("VersionId") = newer ? "3.0" : "2.1";
  if (!newer) {
    add_text(file.root(), "DetailedVersion", "2.1");
  }
  return file.text();
}

std::string bcf_project_xml(const BcfHead& head) {
  const bool newer = head.version == BcfVersion::v3_0;
  XmlFile file(newer ? "ProjectInfo" : "ProjectExtension");
  pugi::xml_node project = file.root().append_child("Project");
  project.append_attribute("ProjectId") = head.project_guid.c_str();
  add_text(project, "Name", head.project_name);
  if (!newer) {
    file.root().append_child("ExtensionSchema");  // none: any status and label is allowed
  }
  return file.text();
}

std::string bcf_extensions_xml(const BcfHead& head, const std::set<std::string>& statuses,
                               const std::set<std::string>& labels) {
  XmlFile file("Extensions");
  add_all(file.root(), "TopicTypes", "TopicType", {kBcfTopicType});
  add_all(file.root(), "TopicStatuses", "TopicStatus", statuses);
  add_all(file.root(), "TopicLabels", "TopicLabel", labels);
  add_all(file.root(), "Users", "User", {head.author});
  return file.text();
}

std::string bcf_markup_xml(const BcfHead& head, const BcfTopic& topic) {
  XmlFile file("Markup");
  add_files(file.root(), topic, head.version);
  pugi::xml_node node = file.root().append_child("Topic");
  node.append_attribute("Guid") = topic.guid.c_str();
  node.append_attribute("TopicType") = kBcfTopicType;
  add_attribute(node, "TopicStatus", topic.status);
  add_text(node, "Title", topic.title);
  node.append_child("Index").text().set(std::to_string(topic.index).c_str());
  const bool newer = head.version == BcfVersion::v3_0;
  pugi::xml_node labels = list_in(node, "Labels", head.version);
  for (const std::string& label : topic.labels) {
    add_text(labels, newer ? "Label" : "Labels", label);
  }
  add_text(node, "CreationDate", head.date);
  add_text(node, "CreationAuthor", head.author);
  node.append_child("Description").text().set(bcf_lines(topic.description).c_str());
  add_viewpoints(newer ? node : file.root(), topic, head.version);
  return file.text();
}

std::string bcf_viewpoint_xml(const BcfHead& head, const BcfTopic& topic) {
  const bool newer = head.version == BcfVersion::v3_0;
  XmlFile file("VisualizationInfo");
  file.root().append_attribute("Guid") = topic.viewpoint_guid.c_str();
  pugi::xml_node components = file.root().append_child("Components");
  if (!topic.components.empty()) {
    pugi::xml_node selection = components.append_child("Selection");
    for (const BcfComponent& part : topic.components) {
      add_component(selection, part);
    }
  }
  components.append_child("Visibility").append_attribute("DefaultVisibility") = "true";
  if (!topic.components.empty()) {
    pugi::xml_node coloring = components.append_child("Coloring");
    for (const BcfComponent& part : topic.components) {
      pugi::xml_node color = coloring.append_child("Color");
      color.append_attribute("Color") = part.color.c_str();
      pugi::xml_node of = list_in(color, "Components", head.version);
      add_component(of, part);
    }
  }
  pugi::xml_node camera = file.root().append_child("PerspectiveCamera");
  add_vector(camera, "CameraViewPoint", topic.camera->eye);
  add_vector(camera, "CameraDirection", topic.camera->direction);
  add_vector(camera, "CameraUpVector", topic.camera->up);
  camera.append_child("FieldOfView").text().set(shortest(topic.camera->field_of_view).c_str());
  if (newer) {
    camera.append_child("AspectRatio").text().set(shortest(topic.camera->aspect).c_str());
  }
  pugi::xml_node planes = file.root().append_child("ClippingPlanes");
  for (const auto& [place, hidden] : topic.camera->clipping) {
    pugi::xml_node plane = planes.append_child("ClippingPlane");
    add_vector(plane, "Location", place);
    add_vector(plane, "Direction", hidden);
  }
  return file.text();
}

}  // namespace soms::command
