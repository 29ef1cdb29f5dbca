// Several threads search one graph at the same time: each source gets the distance of the vertex
// that is farthest from it, and the path from there.

#include <CGAL/Approximate_geodesics/Graphs/Discrete_geodesic_graph.h>
#include <CGAL/Approximate_geodesics/Mesh/Triangulation_builder.h>
#include <CGAL/Approximate_geodesics/Paths/Surface_search.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <iostream>
#include <string>
#include <thread>
#include <vector>

namespace AG = CGAL::Approximate_geodesics;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using Graph = AG::Discrete_geodesic_graph;
using Search = AG::Surface_search<Graph>;

struct Result
{
  double distance;
  AG::Path path; // its points are those of the graph's triangulation
};

Result farthest_vertex(Search& search, const AG::Intrinsic_point& source)
{
  search.run({{source}});
  AG::Intrinsic_point farthest = source;
  for(const Search::Node v : search.search().reached_nodes())
    if(search.search().distance(v) > search.distance(farthest))
      farthest = AG::Intrinsic_point::at_vertex(v);
  return {search.distance(farthest), search.find_path(farthest)};
}

// The graph never changes, so the threads share it. Each of them has a search of its own.
std::vector<Result> farthest_vertices(const Graph& graph,
                                      const std::vector<AG::Intrinsic_point>& sources,
                                      const unsigned number_of_threads)
{
  std::vector<Result> results(sources.size());
  std::atomic<std::size_t> next(0);
  const auto work = [&] {
    Search search(graph);
    for(std::size_t i = next++; i < sources.size(); i = next++)
      results[i] = farthest_vertex(search, sources[i]);
  };
  std::vector<std::thread> threads;
  for(unsigned i = 0; i < number_of_threads; ++i)
    threads.emplace_back(work);
  for(std::thread& thread : threads)
    thread.join();
  return results;
}

int main(int argc, char* argv[])
{
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/bunny00.off");
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(filename, mesh) || mesh.is_empty() ||
     !CGAL::is_triangle_mesh(mesh))
  {
    std::cerr << "No triangle mesh could be read from " << filename << "\n";
    return EXIT_FAILURE;
  }

  const Graph graph(AG::Intrinsic_triangulation(mesh), CGAL::parameters::epsilon(0.1));
  std::vector<AG::Intrinsic_point> sources; // some vertices; the graph has numbers of its own
  for(std::size_t i = 0; i < mesh.number_of_vertices(); i += mesh.number_of_vertices() / 100 + 1)
    sources.push_back(AG::Intrinsic_point::at_vertex(graph.triangulation().vertex(i)));
  const auto results =
      farthest_vertices(graph, sources, (std::max)(2u, std::thread::hardware_concurrency()));

  const Result& longest =
      *std::max_element(results.begin(), results.end(),
                        [](const Result& a, const Result& b) { return a.distance < b.distance; });
  std::cout << "The largest distance from " << sources.size() << " vertices is " << longest.distance
            << ", by a path through " << longest.path.points.size() << " points.\n";
  return EXIT_SUCCESS;
}
