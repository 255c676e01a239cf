#pragma once

#include "batch_command.h"

namespace CLI {
class App;
}

namespace dbd {

/// `batch` must outlive the parsing.
void AddBatchFlags(CLI::App* command, BatchArguments* batch);

}  // namespace dbd
