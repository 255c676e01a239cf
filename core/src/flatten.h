#pragma once

/// Before a function: everything it calls is inlined. Not in sanitized builds, where the checks of
/// a whole step in one function take the compiler minutes.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define DBD_FLATTEN
#else
#define DBD_FLATTEN [[gnu::flatten]]
#endif
