#pragma once

/// Before a function: everything it calls is inlined. Not in sanitized builds, where the checks of
/// a whole step in one function take the compiler minutes.
///
/// DBD_STAGE, before a function template of the step: the same, and it stays a function of its own.
/// One function for the whole step is so large that GCC gives up on keeping small structs of packs
/// in registers, and stores each twice; profiles name the stages.
/// A translation unit that only counts operations defines DBD_NO_FLATTEN.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__) || defined(DBD_NO_FLATTEN)
#define DBD_FLATTEN
#define DBD_STAGE
#else
#define DBD_FLATTEN [[gnu::flatten]]
#define DBD_STAGE [[gnu::noinline, gnu::flatten]]
#endif
