// Costs and cheapest paths on a raster, from the command line: see --help.

#include "../command_line/Ignored_signal.h"
#include "../command_line/Stopwatch.h"
#include "../command_line/run_program.h"
#include "Answer.h"
#include "Costs.h"
#include "Options.h"
#include "Output_files.h"
#include "parse_options.h"
#include "places.h"

#include <csignal>
#include <cstdlib>
#include <iostream>
#include <vector>

static void print(const Answer& answer, const double seconds)
{
  const Raster_frame& frame = answer.frame();
  std::cout << frame.columns << " columns, " << frame.rows << " rows; " << answer.number_reached()
            << " cells reached in " << seconds << " s";
  if(answer.search().number_of_tiles() > 1)
    std::cout << ", " << answer.search().number_of_tiles() << " tiles, settled "
              << answer.search().number_of_visits() << " times";
  std::cout << "\nLargest cost: " << answer.largest_cost() << '\n';
  for(const Route& route : answer.routes())
  {
    std::cout << (answer.goes_to_sources() ? "From cell " : "To cell ") << route.target.column
              << ',' << route.target.row << ": ";
    if(route.points.empty())
      std::cout << "there is no path\n";
    else
      std::cout << "cost " << route.cost << ", length " << route.length() << '\n';
  }
}

static void run(const Options& options)
{
  const Output_files files(options);
  const Ignored_signal file_too_large{SIGXFSZ}; // an error tells that
  Costs costs(options);
  const std::vector<Grid_cell> sources = cells_of("--sources", options.sources, costs.frame());
  const std::vector<Grid_cell> targets = cells_of("--targets", options.targets, costs.frame());
  costs.read();
  const Stopwatch stopwatch;
  Answer answer(costs, options, sources, targets);
  print(answer, stopwatch.seconds());
  files.write(answer);
  files.print(std::cout);
  answer.remove_work_files();
  costs.remove_files();
}

int main(int argc, char* argv[])
{
  return run_program("terrain_routes", [&] {
    const Options options = parse_options(argc, argv);
    if(!options.asks_for_help)
      run(options);
    return EXIT_SUCCESS;
  });
}
