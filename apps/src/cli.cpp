#include "cli.h"

#include <dbd/core/error.h>

#include <CLI/CLI.hpp>
#include <new>

#include "command_line.h"
#include "console.h"

namespace dbd {
namespace {

/// "dbd plan" for the sub-command that was being read, to point at the right help.
std::string CommandName(const CLI::App& app) {
  std::string name = app.get_name();
  const CLI::App* at = &app;
  while (!at->get_subcommands().empty()) {
    at = at->get_subcommands().front();
    name += " " + at->get_name();
  }
  return name;
}

int ParseAndRun(int argc, const char* const* argv) {
  CLI::App app;
  Commands commands;
  DeclareCommands(&app, &commands);
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& help_or_version) {
    return app.exit(help_or_version);
  } catch (const CLI::ParseError& error) {
    PrintError(std::string(error.what()) + " (see " + CommandName(app) + " --help)");
    return kExitBadInput;
  }
  ConfigureConsole(commands.quiet     ? Verbosity::kQuiet
                   : commands.verbose ? Verbosity::kVerbose
                                      : Verbosity::kNormal);
  return commands.run();
}

}  // namespace

int RunProgram(int argc, const char* const* argv) {
  ConfigureConsole(Verbosity::kNormal);
  try {
    return ParseAndRun(argc, argv);
  } catch (const InputError& error) {
    PrintError(error.what());
    return kExitBadInput;
  } catch (const std::bad_alloc&) {
    PrintError("out of memory");
    return kExitBug;
  } catch (const std::exception& error) {
    PrintError(std::string("internal error: ") + error.what());
    return kExitBug;
  }
}

}  // namespace dbd
