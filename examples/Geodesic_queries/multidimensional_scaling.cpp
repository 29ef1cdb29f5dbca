// The canonical form of a surface: a surface in space on which straight distances are as near as
// possible to the geodesic ones, so that it does not matter how the given one is bent. It is found
// by classical multidimensional scaling of some points, which carry all others along.
// draw_scaling.py draws both.

#include <CGAL/Geodesic_constructions/farthest_point_sampling.h>
#include <CGAL/Geodesic_queries/Distance_matrix_types.h>
#include <CGAL/Geodesic_queries/Rows_in_memory.h>
#include <CGAL/IO/Color.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh/IO/PLY.h>
#include <CGAL/approximate_geodesic_distance_matrix.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/helpers.h>

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <vector>

namespace AG = CGAL::Approximate_geodesics;
using Point = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Vertex = Mesh::Vertex_index;
using Positions = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;
using Color_map = Mesh::Property_map<Vertex, CGAL::IO::Color>;

namespace parameters = CGAL::parameters;

// Of points that are spread evenly.
Eigen::MatrixXd distances_between(const Mesh& mesh, const std::vector<Vertex>& points)
{
  AG::Dense_rows<double> rows;
  CGAL::approximate_geodesic_distance_matrix(
      mesh, rows, points,
      parameters::targets(points).epsilon(0.1).symmetric(true).concurrency_tag(
          CGAL::Parallel_if_available_tag()));
  const auto size = static_cast<Eigen::Index>(points.size());
  Eigen::MatrixXd result = Eigen::Map<const Eigen::MatrixXd>(rows.data(), size, size);
  if(!result.allFinite())
    throw std::runtime_error("the mesh has several components, which no path connects");
  return result;
}

// Three coordinates for points with given distances.
class Scaling
{
public:
  // If the points were in space, the squares of distances, centered in rows and columns, would be
  // inner products: a matrix with three eigenvalues that are not zero.
  explicit Scaling(const Eigen::MatrixXd& distances)
    : m_means(distances.cwiseAbs2().rowwise().mean())
  {
    Eigen::MatrixXd products = distances.cwiseAbs2();
    products.colwise() -= m_means;
    products.rowwise() -= products.colwise().mean().eval();
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(-0.5 * products);
    const Eigen::Array3d values = solver.eigenvalues().tail<3>(); // the largest ones
    m_factors = solver.eigenvectors().rightCols<3>() * values.rsqrt().matrix().asDiagonal();
  }

  // What the distance of any point from point `i` adds to its coordinates.
  Eigen::RowVector3d part(const std::size_t i, const double distance) const
  {
    const auto row = static_cast<Eigen::Index>(i);
    return 0.5 * (m_means(row) - distance * distance) * m_factors.row(row);
  }

private:
  Eigen::VectorXd m_means; // of the squares of distances, by point
  Positions m_factors;
};

// The rows are summed up as they come: the matrix of all distances is never in memory.
Positions coordinates(const Mesh& mesh, const std::vector<Vertex>& points, const Scaling& scaling)
{
  Positions result = Positions::Zero(Eigen::Index(mesh.number_of_vertices()), 3);
  CGAL::approximate_geodesic_distance_matrix(
      mesh,
      [&](const std::size_t row, const AG::Distance_row& distances) {
        for(std::size_t v = 0; v < distances.size(); ++v)
          result.row(static_cast<Eigen::Index>(v)) += scaling.part(row, distances[v]);
      },
      points, parameters::epsilon(0.1).concurrency_tag(CGAL::Parallel_if_available_tag()));
  return result;
}

Positions positions(const Mesh& mesh)
{
  Positions result(Eigen::Index(mesh.number_of_vertices()), 3);
  for(const Vertex v : mesh.vertices())
    result.row(Eigen::Index(v)) << mesh.point(v).x(), mesh.point(v).y(), mesh.point(v).z();
  return result.rowwise() - result.colwise().mean();
}

// Turns and mirrors points, of which only distances are known, so that they are near the others.
Positions aligned(const Positions& points, const Positions& others)
{
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(points.transpose() * others,
                                              Eigen::ComputeFullU | Eigen::ComputeFullV);
  return points * svd.matrixU() * svd.matrixV().transpose();
}

// How much straight distances differ from the given ones, as a part of their mean.
double mean_difference(const Eigen::MatrixXd& distances,
                       const std::vector<Vertex>& points,
                       const Positions& positions)
{
  double sum = 0;
  for(std::size_t i = 0; i < points.size(); ++i)
    for(std::size_t j = 0; j < points.size(); ++j)
    {
      const auto difference =
          positions.row(Eigen::Index(points[i])) - positions.row(Eigen::Index(points[j]));
      sum += std::abs(difference.norm() - distances(Eigen::Index(i), Eigen::Index(j)));
    }
  return sum / distances.sum();
}

// From blue at the bottom to red at the top.
Color_map color_by_height(Mesh& mesh, const Eigen::VectorXd& height)
{
  const Color_map result = mesh.add_property_map<Vertex, CGAL::IO::Color>("v:color").first;
  const double lowest = height.minCoeff(), range = height.maxCoeff() - lowest;
  for(const Vertex v : mesh.vertices())
    result[v].set_hsv(240 - 240 * (height(Eigen::Index(v)) - lowest) / range, 60, 95);
  return result;
}

void write(const std::string& file, Mesh mesh, const Positions& points)
{
  for(const Vertex v : mesh.vertices())
  {
    const auto p = points.row(Eigen::Index(v));
    mesh.point(v) = Point(p(0), p(1), p(2));
  }
  std::ofstream out(file, std::ios::binary);
  CGAL::IO::set_binary_mode(out);
  if(!CGAL::IO::write_PLY(out, mesh))
    throw std::runtime_error("cannot write " + file);
}

void process(Mesh& mesh, const std::size_t number_of_points)
{
  std::vector<Vertex> points;
  AG::farthest_point_sampling(mesh, std::back_inserter(points), number_of_points);
  if(points.size() < 4)
    throw std::runtime_error("space needs four points at least");
  const Eigen::MatrixXd distances = distances_between(mesh, points);
  const Positions original = positions(mesh);
  const Positions canonical = aligned(coordinates(mesh, points, Scaling(distances)), original);

  std::cout << "Straight distances differ from geodesic ones by "
            << 100 * mean_difference(distances, points, original) << " % on average, and by "
            << 100 * mean_difference(distances, points, canonical) << " % on the canonical form.\n";
  color_by_height(mesh, original.col(1));
  write("multidimensional_scaling_original.ply", mesh, original);
  write("multidimensional_scaling.ply", mesh, canonical);
}

int main(int argc, char* argv[])
{
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/elephant.off");
  const int number_of_points = argc > 2 ? std::atoi(argv[2]) : 1000;
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(filename, mesh) || mesh.is_empty() ||
     !CGAL::is_triangle_mesh(mesh))
  {
    std::cerr << "No triangle mesh could be read from " << filename << "\n";
    return EXIT_FAILURE;
  }
  try
  {
    process(mesh, static_cast<std::size_t>((std::max)(0, number_of_points)));
    return EXIT_SUCCESS;
  }
  catch(const std::runtime_error& e)
  {
    std::cerr << "Error: " << e.what() << "\n";
    return EXIT_FAILURE;
  }
}
