#pragma once

#include <Eigen/Core>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

namespace dbd::internal {

/// A JSON object that is read key by key and remembers which keys were asked for, so that every
/// message can name file, path, value and rule, and a misspelt key is found. For .cpp files only.
class JsonObject {
 public:
  /// `origin`: file name or another word for where the text comes from. Throws InputError when the
  /// text is not JSON or not an object, or its "schema" is not `schema`.
  static JsonObject Parse(const std::string& text, const std::string& origin,
                          const std::string& schema);
  /// The same, but a missing "schema" means the right one: for single lines of many.
  static JsonObject ParseOptionalSchema(const std::string& text, const std::string& origin,
                                        const std::string& schema);

  bool Has(const std::string& key) const;
  double Number(const std::string& key, double least, double most) const;
  double Number(const std::string& key, double least, double most, double otherwise) const;
  int Integer(const std::string& key, int least, int most) const;
  bool Flag(const std::string& key, bool otherwise) const;
  std::string Text(const std::string& key) const;
  std::string Text(const std::string& key, const std::string& otherwise) const;
  /// One text or a list of texts.
  std::vector<std::string> TextOrTexts(const std::string& key) const;
  /// A list of numbers with this length, or any length when `size` is 0.
  std::vector<double> Numbers(const std::string& key, std::size_t size = 0) const;
  Eigen::Vector3d Point(const std::string& key) const;
  /// A list of `size` points.
  std::vector<Eigen::Vector3d> Points(const std::string& key, std::size_t size) const;
  JsonObject Child(const std::string& key) const;
  std::vector<JsonObject> Children(const std::string& key) const;

  /// Throws when the object has a key that nobody asked for; names the nearest one.
  void RefuseUnknownKeys() const;

  /// Throws InputError "origin: path.key: message".
  [[noreturn]] void Fail(const std::string& key, const std::string& message) const;

 private:
  JsonObject(nlohmann::json value, std::string origin, std::string path);
  static JsonObject ParseObject(const std::string& text, const std::string& origin);
  void RequireSchema(const std::string& schema) const;
  const nlohmann::json& At(const std::string& key) const;

  nlohmann::json value_;
  std::string origin_;
  std::string path_;
  mutable std::set<std::string> asked_;
};

/// The word of `words` that takes the fewest edits to reach from `word`.
std::string NearestWord(const std::string& word, const std::set<std::string>& words);

}  // namespace dbd::internal
