// Prints results of benchmark programs as Markdown tables: markdown_table RESULT.json...
// Each file is what --benchmark_out wrote of repetitions. One row per benchmark: the median of its
// counters, or of its CPU time where it has none, and how far the repetitions lay apart.

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

namespace {

using nlohmann::json;

// What Google Benchmark writes of every run beside the counters of the benchmark's own.
const std::set<std::string> kOwn = {
    "cpu_time",    "family_index",     "iterations", "real_time",
    "repetitions", "repetition_index", "threads",    "per_family_instance_index"};

using Values = std::map<std::string, std::vector<double>>;  // of one benchmark, by counter

double Median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t middle = values.size() / 2;
  return values.size() % 2 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
}

/// Half of the distance from least to most, as a share of the median.
double Spread(const std::vector<double>& values) {
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  return 0.5 * (*most - *least) / Median(values);
}

void AddRun(const json& run, Values& values) {
  bool counted = false;
  for (const auto& [key, value] : run.items()) {
    if (!value.is_number() || kOwn.contains(key)) continue;
    values[key].push_back(value.get<double>());
    counted = true;
  }
  if (counted) return;
  values["CPU time [" + run.at("time_unit").get<std::string>() + "]"].push_back(
      run.at("cpu_time").get<double>());
}

void PrintTable(const std::string& file) {
  const json result = json::parse(std::ifstream(file));
  std::multimap<int, std::string> order;  // as registered, also when they were run at random
  std::map<std::string, Values> benchmarks;
  for (const json& run : result.at("benchmarks")) {
    if (run.at("run_type") != "iteration" || run.contains("error_occurred")) continue;
    const std::string name = run.at("run_name");
    if (!benchmarks.contains(name)) order.emplace(run.at("family_index").get<int>(), name);
    AddRun(run, benchmarks[name]);
  }
  const std::string program = result.at("context").at("executable");
  std::printf("\n### %s\n\n| benchmark | counter | median | spread |\n|---|---|---|---|\n",
              program.substr(program.rfind('/') + 1).c_str());
  for (const auto& [family, name] : order) {
    for (const auto& [counter, values] : benchmarks[name]) {
      std::printf("| %s | %s | %.4g | %.0f %% |\n", name.c_str(), counter.c_str(), Median(values),
                  100 * Spread(values));
    }
  }
}

}  // namespace

/// A file that cannot be read does not keep the others from being printed.
int main(int argc, char** argv) {
  int unread = 0;
  for (int i = 1; i < argc; ++i) {
    try {
      PrintTable(argv[i]);
    } catch (const json::exception& error) {
      std::fprintf(stderr, "markdown_table: %s: %s\n", argv[i], error.what());
      ++unread;
    }
  }
  return unread > 0 ? 1 : 0;
}
