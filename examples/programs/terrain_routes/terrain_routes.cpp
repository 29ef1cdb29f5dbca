// Costs and cheapest paths on a raster, from the command line: see --help.

#include "../command_line/Ignored_signal.h"
#include "../command_line/Stopwatch.h"
#include "../command_line/run_program.h"
#include "Answer.h"
#include "Costs.h"
#include "Options.h"
#include "open_cells.h"
#include "outputs/Output_files.h"
#include "parse_options.h"
#include "places.h"

#include <csignal>
#include <cstdlib>
#include <iostream>
#include <vector>

static void print_route(const Answer& answer, const Route& route)
{
  std::cout << (answer.goes_to_sources() ? "From cell " : "To cell ") << route.target.column << ','
            << route.target.row << ": ";
  if(!route.points.empty())
    std::cout << "cost " << route.cost << with_blank(answer.costs().unit_of_costs()) << ", length "
              << route.length() << with_blank(answer.costs().unit_of_lengths()) << '\n';
  else if(answer.costs().is_open(route.target))
    std::cout << "there is no path\n";
  else
    std::cout << "there is no path: " << closed_cell(answer.costs(), route.target) << '\n';
}

static void print(const Answer& answer, const double seconds)
{
  const Raster_frame& frame = answer.frame();
  std::cout << answer.costs().description() << frame.columns << " columns, " << frame.rows
            << " rows; " << answer.number_reached() << " cells reached in " << seconds << " s";
  if(answer.search().number_of_tiles() > 1)
    std::cout << ", " << answer.search().number_of_tiles() << " tiles, settled "
              << answer.search().number_of_visits() << " times";
  std::cout << "\nLargest cost: " << answer.largest_cost()
            << with_blank(answer.costs().unit_of_costs()) << '\n';
  for(const Route& route : answer.routes())
    print_route(answer, route);
}

static void run(const Options& options)
{
  const Output_files files(options);
  const Ignored_signal file_too_large{SIGXFSZ}; // an error tells that
  Costs costs(options);
  const bool is_periodic = costs.shape().is_periodic;
  std::vector<Grid_cell> sources =
      cells_of("--sources", options.sources, costs.frame(), is_periodic);
  std::vector<Grid_cell> targets =
      cells_of("--targets", options.targets, costs.frame(), is_periodic);
  costs.read();
  if(options.snaps)
    std::cout << snap(costs, "source", sources) << snap(costs, "target", targets);
  check_sources(costs, sources);
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
