#include <dbd/core/error.h>
#include <dbd/core/internal/json_object.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <sstream>

namespace dbd::internal {
namespace {

std::string Short(const nlohmann::json& value) {
  std::string text = value.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  if (text.size() > 60) text = text.substr(0, 57) + "...";
  return text;
}

std::string Format(double number) {
  std::ostringstream text;
  text << number;
  return text.str();
}

std::size_t EditDistance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({replaced, row[j] + 1, row[j - 1] + 1});
    }
  }
  return row.back();
}

}  // namespace

std::string NearestWord(const std::string& word, const std::set<std::string>& words) {
  const auto nearest = std::min_element(
      words.begin(), words.end(),
      [&](const auto& a, const auto& b) { return EditDistance(word, a) < EditDistance(word, b); });
  return nearest == words.end() ? std::string() : *nearest;
}

JsonObject::JsonObject(nlohmann::json value, std::string origin, std::string path)
    : value_(std::move(value)), origin_(std::move(origin)), path_(std::move(path)) {}

JsonObject JsonObject::ParseObject(const std::string& text, const std::string& origin) {
  constexpr int kDeepest = 32;  // what prints or compares values calls itself once per level
  bool too_deep = false;
  const auto keep = [&](int depth, nlohmann::json::parse_event_t, nlohmann::json&) {
    too_deep = too_deep || depth > kDeepest;
    return !too_deep;
  };
  nlohmann::json value = nlohmann::json::parse(text, keep, false, true);
  if (too_deep) {
    throw InputError(origin + ": is nested deeper than " + std::to_string(kDeepest) + " levels");
  }
  if (value.is_discarded()) throw InputError(origin + ": is not valid JSON");
  if (!value.is_object()) throw InputError(origin + ": must be a JSON object");
  return JsonObject(std::move(value), origin, "");
}

void JsonObject::RequireSchema(const std::string& schema) const {
  const std::string found = Text("schema");
  if (found != schema) Fail("schema", "is \"" + found + "\", must be \"" + schema + "\"");
}

JsonObject JsonObject::Parse(const std::string& text, const std::string& origin,
                             const std::string& schema) {
  JsonObject object = ParseObject(text, origin);
  object.RequireSchema(schema);
  return object;
}

JsonObject JsonObject::ParseOptionalSchema(const std::string& text, const std::string& origin,
                                           const std::string& schema) {
  JsonObject object = ParseObject(text, origin);
  if (object.Has("schema")) object.RequireSchema(schema);
  return object;
}

void JsonObject::Fail(const std::string& key, const std::string& message) const {
  throw InputError(origin_ + ": " + path_ + key + ": " + message);
}

bool JsonObject::Has(const std::string& key) const {
  asked_.insert(key);
  return value_.contains(key);
}

const nlohmann::json& JsonObject::At(const std::string& key) const {
  if (!Has(key)) Fail(key, "is missing");
  return value_[key];
}

double JsonObject::Number(const std::string& key, double least, double most) const {
  const nlohmann::json& value = At(key);
  if (!value.is_number()) Fail(key, "is " + Short(value) + ", must be a number");
  const double number = value.get<double>();
  if (!(number >= least && number <= most)) {
    Fail(key,
         "is " + Format(number) + ", must be between " + Format(least) + " and " + Format(most));
  }
  return number;
}

double JsonObject::Number(const std::string& key, double least, double most,
                          double otherwise) const {
  return Has(key) ? Number(key, least, most) : otherwise;
}

int JsonObject::Integer(const std::string& key, int least, int most) const {
  const double number = Number(key, least, most);
  if (number != std::floor(number)) Fail(key, "is " + Format(number) + ", must be whole");
  return static_cast<int>(number);
}

bool JsonObject::Flag(const std::string& key, bool otherwise) const {
  if (!Has(key)) return otherwise;
  if (!At(key).is_boolean()) Fail(key, "is " + Short(At(key)) + ", must be true or false");
  return At(key).get<bool>();
}

std::string JsonObject::Text(const std::string& key) const {
  if (!At(key).is_string()) Fail(key, "is " + Short(At(key)) + ", must be text");
  return At(key).get<std::string>();
}

std::string JsonObject::Text(const std::string& key, const std::string& otherwise) const {
  return Has(key) ? Text(key) : otherwise;
}

std::vector<std::string> JsonObject::TextOrTexts(const std::string& key) const {
  const nlohmann::json& value = At(key);
  if (value.is_string()) return {value.get<std::string>()};
  const bool texts = value.is_array() &&
                     std::all_of(value.begin(), value.end(), [](auto& v) { return v.is_string(); });
  if (!texts) Fail(key, "is " + Short(value) + ", must be text or a list of texts");
  return value.get<std::vector<std::string>>();
}

std::vector<double> JsonObject::Numbers(const std::string& key, std::size_t size) const {
  const nlohmann::json& value = At(key);
  const bool numbers = value.is_array() && std::all_of(value.begin(), value.end(), [](auto& v) {
                         return v.is_number() && std::isfinite(v.template get<double>());
                       });
  if (!numbers || (size != 0 && value.size() != size)) {
    Fail(key, "is " + Short(value) + ", must be a list of " +
                  (size == 0 ? std::string() : std::to_string(size) + " ") + "numbers");
  }
  return value.get<std::vector<double>>();
}

Eigen::Vector3d JsonObject::Point(const std::string& key) const {
  const std::vector<double> v = Numbers(key, 3);
  return {v[0], v[1], v[2]};
}

std::vector<Eigen::Vector3d> JsonObject::Points(const std::string& key, std::size_t size) const {
  const nlohmann::json& value = At(key);
  if (!value.is_array() || value.size() != size) {
    Fail(key, "must be a list of " + std::to_string(size) + " points");
  }
  std::vector<Eigen::Vector3d> points;
  for (const nlohmann::json& point : value) {
    const JsonObject wrapper({{"point", point}}, origin_, path_ + key + ".");
    points.push_back(wrapper.Point("point"));
  }
  return points;
}

JsonObject JsonObject::Child(const std::string& key) const {
  if (!At(key).is_object()) Fail(key, "must be an object");
  return JsonObject(At(key), origin_, path_ + key + ".");
}

std::vector<JsonObject> JsonObject::Children(const std::string& key) const {
  const nlohmann::json& value = At(key);
  if (!value.is_array() || value.empty()) Fail(key, "must be a list of objects");
  std::vector<JsonObject> children;
  for (std::size_t i = 0; i < value.size(); ++i) {
    const std::string name = key + "[" + std::to_string(i) + "]";
    if (!value[i].is_object()) Fail(name, "must be an object");
    children.push_back(JsonObject(value[i], origin_, path_ + name + "."));
  }
  return children;
}

void JsonObject::RefuseUnknownKeys() const {
  // "notes" is free for the author of a file at every level: sources and reasons.
  asked_.insert("notes");
  for (const auto& [key, value] : value_.items()) {
    if (asked_.contains(key)) continue;
    constexpr std::size_t kLongestKey = 60;
    if (key.size() > kLongestKey) Fail(key.substr(0, kLongestKey) + "...", "is not a known key");
    Fail(key, "is not a known key; did you mean \"" + NearestWord(key, asked_) + "\"?");
  }
}

}  // namespace dbd::internal
