#include "batch_flags.h"

#include <CLI/CLI.hpp>

#include "common_flags.h"

namespace dbd {

void AddBatchFlags(CLI::App* command, BatchArguments* batch) {
  command->add_option("requests", batch->requests, "File of requests, - for standard input")
      ->required()
      ->option_text("REQUESTS.jsonl");
  command->add_option("--out", batch->out, "One line per request, as soon as it is answered")
      ->required()
      ->option_text("RESULTS.jsonl");
  command->add_flag("--resume", batch->resume,
                    "Go on with the results of a run that was stopped or killed");
  CLI::Option* shard =
      command->add_option("--shard", batch->shard, "Only every N-th request, from the I-th on")
          ->option_text("I/N");
  command->add_flag("--merge", batch->merge, "Join the results of shards instead")->excludes(shard);
  AddThreadsFlag(command, &batch->threads);
  command
      ->add_option("--memory-gb", batch->memory_gb,
                   "Terrains are kept for later requests up to this much; default 4")
      ->check(Within(0.0, 1e4))
      ->option_text("GB");
}

}  // namespace dbd
