#pragma once

#include <map>
#include <string>

#include "decision_table.h"

namespace dbd {

/// What queries came to, by number, in a file with one JSON object per line: a long run may end at
/// any time, and go on later with what is left.
class DecisionResults {
 public:
  /// Reads what the file holds; an empty name keeps nothing. `settings`: what the answers depend on
  /// besides the number. Throws InputError when a line is not one that `Add` has written with the
  /// same settings.
  DecisionResults(std::string file, std::string settings);

  bool Has(int number) const { return results_.contains(number); }
  /// Also appends it to the file. Throws InputError when that cannot be written.
  void Add(int number, const QueryResult& result);
  std::vector<QueryResult> All() const;

 private:
  std::string file_;
  std::string settings_;
  std::map<int, QueryResult> results_;
};

}  // namespace dbd
