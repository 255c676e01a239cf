#include "xml_oddities.h"

#include <cpl_minixml.h>

#include <algorithm>
#include <filesystem>
#include <string_view>

#include "gdal_session.h"

namespace dbd {
namespace {

constexpr std::uintmax_t kLargestBytes = 64 << 20;

// What a Placemark may hold (OGC 07-147r2, KML 2.2, 9.1 and 9.11), and what 2.0 and 2.1 had.
constexpr std::string_view kPlacemarkElements[] = {
    "name",          "visibility",       "open",         "address",
    "phoneNumber",   "Snippet",          "snippet",      "description",
    "Camera",        "LookAt",           "TimeStamp",    "TimeSpan",
    "TimePrimitive", "styleUrl",         "Style",        "StyleMap",
    "Region",        "Metadata",         "ExtendedData", "Point",
    "LineString",    "LinearRing",       "Polygon",      "MultiGeometry",
    "Model",         "refreshVisibility"};

bool IsElement(const CPLXMLNode& node) { return node.eType == CXT_Element; }

// Without its prefix.
std::string_view LocalName(const CPLXMLNode& node) {
  const std::string_view name = node.pszValue;
  return name.substr(name.find(':') + 1);
}

bool HasPrefix(const CPLXMLNode& node) {
  return std::string_view(node.pszValue).find(':') != std::string_view::npos;
}

bool HasOwnNamespace(const CPLXMLNode& element) {
  return HasPrefix(element) || CPLGetXMLValue(&element, "xmlns", nullptr) != nullptr;
}

class Oddities {
 public:
  void Find(const CPLXMLNode& root, bool is_kml) {
    std::vector<const CPLXMLNode*> nodes = {&root};
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      const CPLXMLNode& node = *nodes[i];
      if (!is_kml && LocalName(node) == "extensions") CheckExtensions(node);
      if (is_kml && LocalName(node) == "Placemark") CheckPlacemark(node);
      for (const CPLXMLNode* child = node.psChild; child != nullptr; child = child->psNext) {
        if (IsElement(*child)) nodes.push_back(child);
      }
    }
  }

  std::vector<std::string> Take() { return std::move(found_); }

 private:
  // GPX 1.1: extensions are elements of any namespace but GPX's.
  void CheckExtensions(const CPLXMLNode& extensions) {
    for (const CPLXMLNode* child = extensions.psChild; child != nullptr; child = child->psNext) {
      if (!IsElement(*child) || HasOwnNamespace(*child)) continue;
      Add("its extension <" + std::string(child->pszValue) +
          "> has no namespace of its own, which GPX demands");
    }
  }

  void CheckPlacemark(const CPLXMLNode& placemark) {
    for (const CPLXMLNode* child = placemark.psChild; child != nullptr; child = child->psNext) {
      if (!IsElement(*child)) continue;
      const std::string name = child->pszValue;
      if (LocalName(*child) == "Track" || LocalName(*child) == "MultiTrack") {
        Add("its <" + name + "> is not read; convert it to a LineString or to GPX");
      } else if (!HasPrefix(*child) &&
                 std::find(std::begin(kPlacemarkElements), std::end(kPlacemarkElements), name) ==
                     std::end(kPlacemarkElements)) {
        Add("its <" + name + "> is no element of KML");
      }
    }
  }

  void Add(std::string oddity) {
    constexpr std::size_t kEnough = 5;
    if (found_.size() >= kEnough) return;
    if (std::find(found_.begin(), found_.end(), oddity) != found_.end()) return;
    found_.push_back(std::move(oddity));
  }

  std::vector<std::string> found_;
};

}  // namespace

std::vector<std::string> XmlOddities(const std::string& file, const std::string& format) {
  if (format != "KML" && format != "GPX") return {};
  std::error_code error;
  const std::uintmax_t bytes = std::filesystem::file_size(file, error);
  if (error || bytes > kLargestBytes) return {};
  const GdalSession silent;
  const CPLXMLTreeCloser root(CPLParseXMLFile(file.c_str()));
  if (!root) return {};
  Oddities oddities;
  // The declaration and comments stand beside the root element.
  for (const CPLXMLNode* node = root.get(); node != nullptr; node = node->psNext) {
    if (IsElement(*node)) oddities.Find(*node, format == "KML");
  }
  return oddities.Take();
}

}  // namespace dbd
