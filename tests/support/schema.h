#pragma once

#include <gtest/gtest.h>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validator.hpp>

#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

namespace dbd {

/// One of the JSON Schema files that dbd ships.
class Schema {
 public:
  /// `name`: "plan" of plan.schema.json.
  explicit Schema(const std::string& name) {
    std::ifstream file(DBD_SCHEMAS "/" + name + ".schema.json");
    json_ = nlohmann::json::parse(file);
    valijson::SchemaParser(valijson::SchemaParser::kDraft7)
        .populateSchema(valijson::adapters::NlohmannJsonAdapter(json_), schema_);
  }

  const nlohmann::json& json() const { return json_; }

  bool Accepts(const nlohmann::json& document) const { return Error(document).empty(); }

  /// Where and why it is refused; empty when it is not.
  std::string Error(const nlohmann::json& document) const {
    valijson::Validator validator;
    valijson::ValidationResults results;
    if (validator.validate(schema_, valijson::adapters::NlohmannJsonAdapter(document), &results)) {
      return "";
    }
    std::string text;
    for (valijson::ValidationResults::Error error; results.popError(error);) {
      for (const std::string& step : error.context) text += step;
      text += ": " + error.description + "\n";
    }
    return text.empty() ? "refused" : text;
  }

 private:
  nlohmann::json json_;
  valijson::Schema schema_;
};

}  // namespace dbd
