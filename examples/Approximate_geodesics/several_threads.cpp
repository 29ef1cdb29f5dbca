// One graph that several threads search at the same time, for the largest of many distances.

#include <CGAL/Approximate_geodesics/Graphs/Edge_graph.h>
#include <CGAL/Approximate_geodesics/Mesh/Triangulation_builder.h>
#include <CGAL/Approximate_geodesics/Search/Propagation.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>
#include <CGAL/Real_timer.h>
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

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using CGAL::Approximate_geodesics::Edge_graph;
using Search = CGAL::Approximate_geodesics::Propagation<Edge_graph>;
using Node = Search::Node;

double largest_distance(Search& search, const Node source)
{
  search.run_from(source);
  double result = 0;
  for(const Node node : search.reached_nodes())
    result = (std::max)(result, search.distance(node));
  return result;
}

// The graph never changes, so the threads share it; each of them has a `Search` of its own.
std::vector<double>
largest_distances(const Edge_graph& graph, const std::vector<Node>& sources, const unsigned threads)
{
  std::vector<double> result(sources.size());
  std::atomic<std::size_t> next(0);
  const auto work = [&] {
    Search search(graph);
    for(std::size_t i = next++; i < sources.size(); i = next++)
      result[i] = largest_distance(search, sources[i]);
  };

  std::vector<std::thread> workers;
  CGAL::Real_timer timer;
  timer.start();
  for(unsigned i = 0; i < threads; ++i)
    workers.emplace_back(work);
  for(std::thread& worker : workers)
    worker.join();
  std::cout << "With " << threads << " thread(s): " << timer.time() << " s\n";
  return result;
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

  const Edge_graph graph{CGAL::Approximate_geodesics::Intrinsic_triangulation(mesh)};
  std::vector<Node> sources;
  for(const auto v : mesh.vertices())
    if(v.idx() % (mesh.number_of_vertices() / 100 + 1) == 0)
      sources.push_back(graph.triangulation().vertex(v.idx()));
  const unsigned number_of_threads = (std::max)(2u, std::thread::hardware_concurrency());
  const auto alone = largest_distances(graph, sources, 1);
  const auto together = largest_distances(graph, sources, number_of_threads);
  std::cout << "The largest distance from " << sources.size() << " vertices is "
            << *std::max_element(together.begin(), together.end()) << "; the threads "
            << (together == alone ? "agree" : "DISAGREE") << ".\n";
  return together == alone ? EXIT_SUCCESS : EXIT_FAILURE;
}
