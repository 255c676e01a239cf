#include <dbd/core/embedded_file.h>
#include <dbd/core/error.h>
#include <dbd/core/units.h>
#include <dbd/terrain/material_map.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <nlohmann/json.hpp>
#include <span>
#include <sstream>
#include <utility>

#include "nearest_name.h"

namespace dbd {

std::span<const EmbeddedFile> EmbeddedMaterialFiles();

namespace {

using Json = nlohmann::json;

constexpr const char* kSchema = "dbd.materials/1";

// A place in a JSON file, for messages.
struct Place {
  std::string file;
  std::string path;

  Place operator/(const std::string& key) const {
    return {file, path.empty() ? key : path + "." + key};
  }
  [[noreturn]] void Fail(const std::string& what) const {
    throw InputError(file + ": " + (path.empty() ? "" : path + " ") + what);
  }
};

void CheckKeys(const Json& object, const std::vector<std::string>& allowed, const Place& place) {
  if (!object.is_object()) place.Fail("must be an object");
  for (const auto& [key, value] : object.items()) {
    if (std::find(allowed.begin(), allowed.end(), key) != allowed.end()) continue;
    (place / key).Fail("is not a known key; nearest is '" + NearestName(key, allowed) + "'");
  }
}

const Json& Get(const Json& object, const std::string& key, const Place& place) {
  if (!object.contains(key)) (place / key).Fail("is missing");
  return object.at(key);
}

std::string GetText(const Json& object, const std::string& key, const Place& place) {
  const Json& value = Get(object, key, place);
  if (!value.is_string() || value.get<std::string>().empty()) {
    (place / key).Fail("is " + value.dump() + ", must be text");
  }
  return value.get<std::string>();
}

double GetNumber(const Json& object, const std::string& key, const Place& place) {
  const Json& value = Get(object, key, place);
  if (!value.is_number()) (place / key).Fail("is " + value.dump() + ", must be a number");
  return value.get<double>();
}

int GetCode(const Json& object, const Place& place) {
  const Json& value = Get(object, "code", place);
  if (!value.is_number_integer() || value.get<double>() < 0 ||
      value.get<double>() > std::numeric_limits<int>::max()) {
    (place / "code").Fail("is " + value.dump() + ", must be an integer of at least 0");
  }
  return value.get<int>();
}

Material ParseMaterial(const Json& row, const Place& place) {
  CheckKeys(row,
            {"code", "name", "cone_index_kpa", "friction_limit", "cone_index_spread", "passable",
             "source"},
            place);
  Material material;
  material.code = GetCode(row, place);
  material.name = GetText(row, "name", place);
  material.soil.cone_index = Kilopascals(GetNumber(row, "cone_index_kpa", place));
  if (row.contains("friction_limit")) {
    material.soil.friction_limit = GetNumber(row, "friction_limit", place);
  }
  if (row.contains("cone_index_spread")) {
    material.cone_index_spread = GetNumber(row, "cone_index_spread", place);
  }
  if (row.contains("passable")) {
    if (!row["passable"].is_boolean()) {
      (place / "passable").Fail("is " + row["passable"].dump() + ", must be true or false");
    }
    material.passable = row["passable"].get<bool>();
  }
  material.source = row.contains("source") ? GetText(row, "source", place) : "assumed";
  return material;
}

MaterialTable ParseTable(const std::string& file, const std::string& text,
                         const std::string& default_name) {
  const Place top{file, ""};
  Json root;
  try {
    root = Json::parse(text);
  } catch (const Json::parse_error& error) {
    top.Fail("is not valid JSON: " + std::string(error.what()));
  }
  CheckKeys(root, {"schema", "name", "description", "materials"}, top);
  if (const std::string schema = GetText(root, "schema", top); schema != kSchema) {
    (top / "schema").Fail("is '" + schema + "', must be '" + kSchema + "'");
  }
  const Json& rows = Get(root, "materials", top);
  if (!rows.is_array()) (top / "materials").Fail("must be a list");
  std::vector<Material> materials;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    materials.push_back(ParseMaterial(rows[i], top / ("materials[" + std::to_string(i) + "]")));
  }
  const std::string name = root.contains("name") ? GetText(root, "name", top) : default_name;
  try {
    return MaterialTable(name, std::move(materials));
  } catch (const InputError& error) {
    top.Fail(error.what());
  }
}

std::string ReadFile(const std::string& file) {
  std::error_code ignored;
  if (!std::filesystem::exists(file, ignored)) {
    const std::vector<std::string> names = MaterialTable::BuiltInNames();
    throw InputError("material table '" + file + "' is neither a file nor built in; nearest is '" +
                     NearestName(file, names) + "' (built in: " + Join(names) + ")");
  }
  std::ifstream stream(file, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  if (!stream || std::filesystem::is_directory(file, ignored)) {
    throw InputError(file + ": cannot be read");
  }
  return text;
}

void CheckRange(const std::string& field, double value, bool in_range, const std::string& rule) {
  if (in_range) return;
  std::ostringstream text;
  text << field << " is " << value << ", must be " << rule;
  throw InputError(text.str());
}

void CheckMaterial(const Material& material, const std::string& where) {
  const double kpa = material.soil.cone_index / 1e3;
  const double friction = material.soil.friction_limit;
  const double spread = material.cone_index_spread;
  CheckRange(where + ".code", material.code, material.code >= 0, "at least 0");
  CheckRange(where + ".cone_index_kpa", kpa, kpa > 0 && kpa <= 20000, "above 0 and at most 20000");
  CheckRange(where + ".friction_limit", friction, friction > 0 && friction <= 1.5,
             "above 0 and at most 1.5");
  CheckRange(where + ".cone_index_spread", spread, spread >= 0 && spread <= 1, "0 to 1");
}

}  // namespace

MaterialTable MaterialTable::Load(const std::string& name_or_file) {
  for (const EmbeddedFile& file : EmbeddedMaterialFiles()) {
    if (file.name == name_or_file) {
      return ParseTable(name_or_file, std::string(file.text), name_or_file);
    }
  }
  return ParseTable(name_or_file, ReadFile(name_or_file),
                    std::filesystem::path(name_or_file).stem().string());
}

std::vector<std::string> MaterialTable::BuiltInNames() {
  std::vector<std::string> names;
  for (const EmbeddedFile& file : EmbeddedMaterialFiles()) names.emplace_back(file.name);
  std::sort(names.begin(), names.end());
  return names;
}

MaterialTable::MaterialTable(std::string name, std::vector<Material> materials)
    : name_(std::move(name)), materials_(std::move(materials)) {
  CheckRange("the number of materials", static_cast<double>(materials_.size()),
             !materials_.empty() && materials_.size() < 256, "1 to 255");
  for (std::size_t i = 0; i < materials_.size(); ++i) {
    const std::string where = "materials[" + std::to_string(i) + "]";
    CheckMaterial(materials_[i], where);
    if (FindCode(materials_[i].code) != &materials_[i]) {
      throw InputError(where + ".code " + std::to_string(materials_[i].code) + " is there twice");
    }
    if (FindName(materials_[i].name) != &materials_[i]) {
      throw InputError(where + ".name '" + materials_[i].name + "' is there twice");
    }
  }
}

const Material* MaterialTable::FindCode(int code) const {
  for (const Material& material : materials_) {
    if (material.code == code) return &material;
  }
  return nullptr;
}

const Material* MaterialTable::FindName(const std::string& name) const {
  for (const Material& material : materials_) {
    if (material.name == name) return &material;
  }
  return nullptr;
}

const Material& MaterialTable::GetName(const std::string& name) const {
  if (const Material* material = FindName(name)) return *material;
  std::vector<std::string> names;
  for (const Material& material : materials_) names.push_back(material.name);
  throw InputError("material '" + name + "' is not in the material table '" + name_ +
                   "'; nearest is '" + NearestName(name, names) + "'");
}

}  // namespace dbd
