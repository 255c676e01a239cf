#include "plan_flags.h"

#include <CLI/CLI.hpp>

#include "common_flags.h"

namespace dbd {
namespace {

void AddUncertaintyFlags(CLI::App* command, PlanArguments* plan) {
  CLI::Option* draws =
      command
          ->add_option(
              "--draws", plan->draws,
              "Drive the best candidates on this many random draws of what is uncertain of "
              "the terrain; default 1 = the terrain as it is given")
          ->check(CLI::Range(1, 10000))
          ->option_text("N");
  command
      ->add_option(
          "--min-success", plan->min_success,
          "Least share of the draws on which a route must reach the goal (not P(go), which is less "
          "sure of few draws), default 0")
      ->needs(draws)
      ->check(Within(0.0, 1.0))
      ->option_text("SHARE");
  command
      ->add_option("--soil-spread", plan->soil_spread,
                   "Factor on the materials' spread of strength, default 1")
      ->needs(draws)
      ->check(Within(0.0, 10.0))
      ->option_text("F");
  command
      ->add_option("--elevation-error-m", plan->elevation_error_m,
                   "Standard deviation of the heights, default 0")
      ->needs(draws)
      ->check(Within(0.0, 100.0))
      ->option_text("L");
  command
      ->add_option("--elevation-correlation-m", plan->elevation_correlation_m,
                   "Distance over which height errors are alike, default 20")
      ->needs(draws)
      ->check(Within(0.1, 1e5))
      ->option_text("L");
}

}  // namespace

void AddPlanFlags(CLI::App* command, PlanArguments* plan) {
  command
      ->add_option("--candidates", plan->candidates,
                   "Routes to drive, default " + std::to_string(plan->candidates))
      ->check(CLI::Range(1, 100000))
      ->option_text("N");
  command
      ->add_option("--rounds", plan->rounds,
                   "Most rounds that share these candidates, each learning from the drives before; "
                   "default 3, 1 = all at once")
      ->check(CLI::Range(1, 100))
      ->option_text("N");
  command
      ->add_option("--max-speed-kmh", plan->max_speed_kmh,
                   "Target speed on open ground, default 28.8")
      ->check(Within(0.1, 500.0))
      ->option_text("V");
  command->add_flag("--reversing", plan->reversing,
                    "Routes may change between forward and reverse, as in a three-point turn");
  command->add_option("--seed", plan->seed, "Of the sampling, default 1")->option_text("N");
  AddThreadsFlag(command, &plan->threads);
  command
      ->add_option("--deadline", plan->deadline_s,
                   "Answer with the best so far when this many seconds have passed; default: none")
      ->check(Within(1e-3, 1e9))
      ->option_text("SECONDS");
  command
      ->add_option("--engine", plan->engine,
                   "lanes: many vehicles at once in single precision, the default; reference: one "
                   "at a time in double precision")
      ->check(CLI::IsMember({"lanes", "reference"}))
      ->option_text("NAME");
  AddUncertaintyFlags(command, plan);
}

}  // namespace dbd
