#pragma once

namespace dbd {

/// Threads to work with: those asked for, 0 = all, but no more than the process may have (TBB
/// prints a warning when an arena asks for more).
int ThreadCount(int asked);

}  // namespace dbd
