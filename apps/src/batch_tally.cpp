#include "batch_tally.h"

#include "batch_answer.h"
#include "text.h"

namespace dbd {

void BatchTally::Add(const JobResult& result) {
  Add(StatusOf(result));
  rollouts_ += result.plan.rollouts.size();
  simulated_ += result.plan.simulated_time;
}

std::size_t BatchTally::answered() const {
  std::size_t sum = 0;
  for (const auto& [status, count] : counts_) sum += count;
  return sum;
}

std::size_t BatchTally::errors() const {
  const auto found = counts_.find("error");
  return found == counts_.end() ? 0 : found->second;
}

double BatchTally::Seconds() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
}

void BatchTally::Show(std::size_t total, ProgressLine& line) const {
  const double rate = static_cast<double>(answered()) / Seconds();
  const double left = static_cast<double>(total - answered()) / rate;
  line.Show(Format("%s (%.2g/s, %s left)", what_.c_str(), rate, FormatDuration(left).c_str()),
            static_cast<int>(answered()), static_cast<int>(total));
}

std::string BatchTally::Summary(std::size_t skipped) const {
  std::string text = Format("%zu %s answered", answered(), what_.c_str());
  for (const auto& [status, count] : counts_) text += Format(", %zu %s", count, status.c_str());
  if (skipped > 0) text += Format("; %zu had been answered before", skipped);
  const double hours = simulated_ / 3600;
  return text + Format("\n%zu rollouts, %.2f h of driving in %s: %.3g h per second\n", rollouts_,
                       hours, FormatDuration(Seconds()).c_str(), hours / Seconds());
}

}  // namespace dbd
