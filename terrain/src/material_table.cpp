#include <dbd/core/embedded_file.h>
#include <dbd/core/error.h>
#include <dbd/core/internal/json_object.h>
#include <dbd/core/units.h>
#include <dbd/terrain/material_map.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <set>
#include <span>
#include <sstream>
#include <utility>

namespace dbd {

std::span<const EmbeddedFile> EmbeddedMaterialFiles();

namespace {

using internal::JsonObject;

constexpr const char* kSchema = "dbd.materials/1";

constexpr double kHardestKpa = 20000;
constexpr double kHighestFriction = 1.5;

BekkerSoil ParsePlate(const JsonObject& row) {
  BekkerSoil soil;
  soil.n = row.Number("n", 0.01, 3);
  soil.kc = 1e3 * row.Number("kc_kn", 0, 1e6);
  soil.kphi = 1e3 * row.Number("kphi_kn", 1e-3, 1e8);
  soil.cohesion = Kilopascals(row.Number("cohesion_kpa", 0, 1e3));
  soil.friction_angle = Degrees(row.Number("friction_angle_deg", 0, 60));
  soil.shear_deformation = row.Number("shear_deformation", 1e-4, 1, soil.shear_deformation);
  row.RefuseUnknownKeys();
  return soil;
}

TractionModel ParseTractionModel(const JsonObject& row) {
  const std::string name = row.Text("traction_model", "brixius");
  if (name == "brixius") return TractionModel::kBrixius;
  if (name == "wismer_luth") return TractionModel::kWismerLuth;
  if (name == "bekker") return TractionModel::kBekker;
  row.Fail("traction_model", "is \"" + name + "\", must be brixius, wismer_luth or bekker");
}

SoilSample ParseSoil(const JsonObject& row) {
  SoilSample soil;
  soil.traction_model = ParseTractionModel(row);
  const bool has_plate = row.Has("plate");
  if (has_plate) soil.plate = ParsePlate(row.Child("plate"));
  if (soil.traction_model == TractionModel::kBekker && !has_plate) {
    row.Fail("plate", "is missing, must be there for the traction model bekker");
  }
  if (has_plate && !row.Has("cone_index_kpa")) {
    soil.cone_index = std::min(MeanConeIndexFromBekker(soil.plate), Kilopascals(kHardestKpa));
  } else {
    soil.cone_index = Kilopascals(row.Number("cone_index_kpa", 0, kHardestKpa));
  }
  soil.friction_limit = row.Number("friction_limit", 0, kHighestFriction, soil.friction_limit);
  return soil;
}

std::optional<UscsClass> ParseUscsClass(const JsonObject& row) {
  if (!row.Has("uscs")) return std::nullopt;
  const std::string name = row.Text("uscs");
  const std::optional<UscsClass> soil = UscsClassOf(name);
  if (!soil) {
    row.Fail("uscs", "is \"" + name +
                         "\", must be SW, SP, SM, SC, SM-SC, ML, CL-ML, CL, OL, CH, MH "
                         "or OH");
  }
  if (row.Has("plate")) {
    row.Fail("uscs", "cannot be with \"plate\": how moisture changes its constants is not known");
  }
  return soil;
}

Material ParseMaterial(const JsonObject& row) {
  Material material;
  material.code = row.Integer("code", 0, std::numeric_limits<int>::max());
  material.name = row.Text("name");
  material.soil = ParseSoil(row);
  material.cone_index_spread = row.Number("cone_index_spread", 0, 1, material.cone_index_spread);
  material.passable = row.Flag("passable", material.passable);
  material.uscs = ParseUscsClass(row);
  material.source = row.Text("source", "assumed");
  row.RefuseUnknownKeys();
  return material;
}

MaterialTable ParseTable(const std::string& file, const std::string& text,
                         const std::string& default_name) {
  const JsonObject root = JsonObject::Parse(text, file, kSchema);
  const std::string name = root.Text("name", default_name);
  root.Text("description", "");
  std::vector<Material> materials;
  for (const JsonObject& row : root.Children("materials")) materials.push_back(ParseMaterial(row));
  root.RefuseUnknownKeys();
  try {
    return MaterialTable(name, std::move(materials));
  } catch (const InputError& error) {
    throw InputError(file + ": " + error.what());
  }
}

std::string Join(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

std::string ReadFile(const std::string& file) {
  std::error_code ignored;
  if (!std::filesystem::exists(file, ignored)) {
    const std::vector<std::string> names = MaterialTable::BuiltInNames();
    throw InputError("material table '" + file + "' is neither a file nor built in; built in are " +
                     Join(names));
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
  CheckRange(where + ".cone_index_kpa", kpa, kpa > 0 && kpa <= kHardestKpa,
             "above 0 and at most 20000");
  CheckRange(where + ".friction_limit", friction, friction > 0 && friction <= kHighestFriction,
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
  std::set<std::string> names;
  for (const Material& material : materials_) names.insert(material.name);
  throw InputError("material '" + name + "' is not in the material table '" + name_ +
                   "'; nearest is '" + internal::NearestWord(name, names) + "'");
}

MaterialTable MaterialTable::InState(MoistureState state) const {
  const double strongest = Psi(300);
  std::vector<Material> materials = materials_;
  bool any = false;
  for (Material& material : materials) {
    if (!material.uscs) continue;
    any = true;
    const double moist = material.soil.cone_index;
    material.soil.cone_index =
        std::min(moist * MoistureFactor(*material.uscs, state), std::max(moist, strongest));
  }
  if (!any) {
    throw InputError("moisture changes nothing: no material of the table '" + name_ +
                     "' has a soil class, \"uscs\"");
  }
  return MaterialTable(name_, std::move(materials));
}

}  // namespace dbd
