// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include <CLI/App.hpp>
#include <csignal>
#include <exception>

#ifdef __GLIBC__
#include <malloc.h>
#endif

#include "apps/setsquare/command_line/parse.hpp"
#include "apps/setsquare/subcommands.hpp"

namespace {

void add_subcommands(CLI::App& application) {
  setsquare::app::add_info(application);
  setsquare::app::add_map(application);
  setsquare::app::add_merge(application);
  setsquare::app::add_render(application);
  setsquare::app::add_localize(application);
  setsquare::app::add_audit(application);
  setsquare::app::add_convert(application);
  setsquare::app::add_evaluate(application);
  setsquare::app::add_match(application);
  setsquare::app::add_explain(application);
  setsquare::app::add_simulate(application);
  setsquare::app::add_live(application);
  setsquare::app::add_experiment(application);
  setsquare::app::add_reference(application);
}

}  // namespace

int main(int argc, char** argv) {
#ifdef __GLIBC__
  // Large pieces of memory go back to the system once they are freed. By default glibc raises this
  // bound to the largest piece seen, and what lies between the small ones then stays.
  mallopt(M_MMAP_THRESHOLD, 128 * 1024);
#endif
  // A file that grows beyond the limit (ulimit -f) is an error of writing, reported like others.
  std::signal(SIGXFSZ, SIG_IGN);
  try {
    CLI::App application{
        "Setsquare: 2-D laser scans of a building to a map whose walls are straight and square.",
        "setsquare"};
    setsquare::app::set_help_form(application);
    application.set_version_flag("--version", "setsquare " SETSQUARE_VERSION);
    application.require_subcommand(1);
    add_subcommands(application);
    application.footer(  // after the subcommands, which would inherit it
        "Examples:\n"
        "  setsquare map intel.clf -o out\n"
        "  setsquare map my_bag -o out\n"
        "  setsquare map tuesday.bag --continue out -o out2\n"
        "  setsquare merge east west -o both\n"
        "  setsquare render out/map.setsquare -o out2\n"
        "  setsquare localize out today.clf -o where\n"
        "  setsquare audit intel.clf out\n"
        "  setsquare convert my_bag scans.jsonl\n"
        "  setsquare simulate --building office -o sim\n"
        "  setsquare match intel.clf 100 140\n"
        "  setsquare explain intel.clf 100 140 -o match.html\n"
        "  zcat intel.clf.gz | setsquare info -\n"
        "Each subcommand has its own --help.");
    return setsquare::app::parse_and_run(application, argc, argv);
  } catch (const std::exception& error) {
    return setsquare::app::complain(error.what());
  }
}
