#pragma once

#include "matrix_command.h"

namespace CLI {
class App;
}

namespace dbd {

/// `matrix` must outlive the parsing.
void AddMatrixFlags(CLI::App* command, MatrixArguments* matrix);

}  // namespace dbd
