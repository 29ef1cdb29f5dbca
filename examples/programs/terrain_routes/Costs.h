#ifndef TERRAIN_ROUTES_COSTS_H
#define TERRAIN_ROUTES_COSTS_H

#include "../command_line/files.h"
#include "Cell_values.h"
#include "Options.h"
#include "map_of_rasters.h"
#include "rasters/Raster.h"
#include "rasters/descriptions.h"
#include "rasters/raster_files.h"
#include "slope_functions.h"

#include <CGAL/Approximate_geodesics/Grid_files/Grid_window.h>
#include <CGAL/Geodesic_grids/Grid_graph.h>
#include <CGAL/Geodesic_grids/Grid_shape.h>
#include <CGAL/Geodesic_grids/internal/Grid_metric.h>

#include <boost/interprocess/exceptions.hpp>
#include <boost/interprocess/sync/file_lock.hpp>

#include <cmath>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <functional>
#include <ios>
#include <limits>
#include <memory>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

using CGAL::Approximate_geodesics::Grid_cell;
using CGAL::Approximate_geodesics::Grid_graph;
using CGAL::Approximate_geodesics::Grid_point;

// The friction and the heights of all cells, in memory or in files of the work folder, and the
// graphs of windows.
class Costs
{
public:
  using Metric = CGAL::Approximate_geodesics::internal::Grid_metric;

  // Opens the rasters.
  explicit Costs(const Options& options)
    : m_options(options), m_slope_function(slope_function(options.cost))
  {
    if(!options.friction.empty())
      m_friction_raster = open_raster(options.friction, options.band);
    if(!options.heights.empty())
      m_heights_raster = open_raster(
          options.heights, options.friction.empty() ? options.band : std::optional<int>());
    m_frame = common_frame(options, m_friction_raster ? &m_friction_raster->frame() : nullptr,
                           m_heights_raster ? &m_heights_raster->frame() : nullptr);
    apply_options(options, m_frame);
    m_shape = shape_of(m_frame, options);
    m_metric = Metric(m_shape);
    if(m_heights_raster)
      m_unit_of_heights = unit_of_heights(options, m_frame, *m_heights_raster);
  }

  // Reads their values. No other member function may be called before, but for `frame()`.
  void read()
  {
    if(!m_options.work_folder.empty())
      lock();
    for(Raster_reader* const raster : {m_friction_raster.get(), m_heights_raster.get()})
      if(raster != nullptr && m_options.no_data)
        raster->set_no_data(*m_options.no_data);
    if(m_friction_raster)
      m_friction.emplace(*m_friction_raster, file("terrain_routes_friction"), 1., infinity,
                         [&](auto... args) { check_friction(args...); });
    if(m_heights_raster)
      m_heights.emplace(*m_heights_raster, file("terrain_routes_heights"), m_unit_of_heights.meters,
                        std::numeric_limits<double>::quiet_NaN(),
                        [&](auto... args) { check_height(args...); });
    describe();
    m_friction_raster.reset();
    m_heights_raster.reset();
  }

  // What was read, in lines for the user.
  const std::string& description() const { return m_description; }

  // The unit of lengths and heights; none if it is not known what the coordinates are in.
  std::string unit_of_lengths() const
  {
    return is_in_meters(m_options, m_frame) || m_slope_function ? "m" : "";
  }

  // The unit of costs; none if it is not known, as that of friction.
  std::string unit_of_costs() const
  {
    if(m_options.cost == "walking_energy")
      return "J/kg";
    return m_slope_function ? "s" : m_friction ? "" : unit_of_lengths();
  }

  // Returns which cells of a row can be entered.
  std::vector<bool> open_row(const std::size_t row) const
  {
    std::vector<bool> result(m_shape.columns, true);
    const std::vector<double> friction = m_friction ? m_friction->row(row) : std::vector<double>();
    const std::vector<double> heights = m_heights ? m_heights->row(row) : std::vector<double>();
    for(std::size_t i = 0; i < result.size(); ++i)
      result[i] =
          !(m_friction && friction[i] == infinity) && !(m_heights && std::isnan(heights[i]));
    return result;
  }

  bool is_open(const Grid_cell& cell) const { return open_row(cell.row)[cell.column]; }

  // Returns a point of the same place as `q` that is beside `p`, in columns and rows: on rasters
  // that go round, it may be beyond the first or the last column.
  Grid_point beside(const Grid_point& p, Grid_point q) const
  {
    const auto columns = static_cast<double>(m_shape.columns);
    if(m_shape.is_periodic)
      q.x += columns * std::round((p.x - q.x) / columns);
    return q;
  }

  const Raster_frame& frame() const { return m_frame; }
  const Grid_shape& shape() const { return m_shape; }
  const Metric& metric() const { return m_metric; }
  bool has_friction() const { return m_friction.has_value(); }
  bool has_heights() const { return m_heights.has_value(); }

  // A text that tells them, and what paths follow from them, apart from others.
  std::string identity() const
  {
    std::ostringstream out;
    out.precision(17);
    out << std::hex;
    if(m_friction)
      out << "friction " << m_friction->checksum() << ", ";
    if(m_heights)
      out << "heights " << m_heights->checksum() << ", ";
    out << std::dec << m_options.cost << ", cells of " << m_shape.cell_width << " by "
        << m_shape.cell_height;
    if(m_shape.first_latitude)
      out << " degrees from latitude " << *m_shape.first_latitude << " on "
          << m_shape.ellipsoid.equatorial_radius << ", " << m_shape.ellipsoid.flattening
          << (m_shape.is_periodic ? ", periodic" : "");
    if(m_options.epsilon)
      out << ", epsilon " << *m_options.epsilon;
    if(std::isfinite(m_options.max_slope))
      out << ", slopes up to " << m_options.max_slope;
    return out.str();
  }

  // Returns the graph of a window, with the arcs of the whole grid to the last bit.
  Grid_graph graph(const Grid_window& window, const bool goes_to_sources) const
  {
    Grid_shape shape = m_shape;
    shape.columns = window.columns;
    shape.rows = window.rows;
    shape.is_periodic = m_shape.is_periodic && window.columns == m_shape.columns;
    if(shape.first_latitude)
    {
      shape.rows_before = window.first_row;
      shape.rows_after = m_shape.rows - window.first_row - window.rows;
    }
    if(!m_heights)
      return m_options.epsilon ? Grid_graph(shape, m_friction->window(window),
                                            CGAL::parameters::epsilon(*m_options.epsilon))
                               : Grid_graph(shape, m_friction->window(window));
    shape.no_data = std::numeric_limits<double>::quiet_NaN();
    const std::vector<double> heights = m_heights->window(window);
    return m_friction ? graph(shape, m_friction->window(window), heights, goes_to_sources)
                      : graph(shape, 1., heights, goes_to_sources);
  }

  // Returns the friction of a row, infinity for cells that cannot be entered; there must be
  // friction.
  std::vector<double> friction_row(const std::size_t row) const { return m_friction->row(row); }

  // Returns the heights in a window, NaN for cells without one; there must be heights.
  std::vector<double> heights(const Grid_window& window) const { return m_heights->window(window); }

  // Removes the files.
  void remove_files()
  {
    for(const std::optional<Cell_values>* values : {&m_friction, &m_heights})
      if(*values)
        (*values)->remove_file();
    std::error_code ignored; // what is left does no harm
    if(!m_options.work_folder.empty())
      for(const std::string& name : {file("in_use"), m_options.work_folder})
        std::filesystem::remove(name, ignored);
  }

private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  // Returns the name of a file in the work folder, if there is one.
  std::string file(const char* const name) const
  {
    return m_options.work_folder.empty() ? "" : m_options.work_folder + '/' + name;
  }

  void describe()
  {
    if(m_friction_raster)
      m_description += described_raster(m_options.friction, *m_friction_raster,
                                        m_friction->number_without(), "friction");
    if(m_heights_raster)
      m_description += described_raster(m_options.heights, *m_heights_raster,
                                        m_heights->number_without(), "heights");
    m_description += described_map(m_frame, m_shape, m_metric.middle(), unit_of_lengths());
    if(m_heights_raster && !m_unit_of_heights.name.empty())
      m_description += described_heights(m_unit_of_heights,
                                         m_options.unit_of_heights ||
                                             m_heights_raster->frame().system.unit_of_heights ||
                                             !m_heights_raster->values().unit.empty());
  }

  template <typename Friction>
  Grid_graph graph(const Grid_shape& shape,
                   const Friction& friction,
                   const std::vector<double>& heights,
                   const bool goes_to_sources) const
  {
    const auto np = CGAL::parameters::heights(std::cref(heights))
                        .max_slope(m_options.max_slope)
                        .direction_to_source(goes_to_sources);
    if(!m_slope_function)
      return Grid_graph(shape, friction, np);
    return Grid_graph(
        shape, friction,
        np.face_weight_map(CGAL::Approximate_geodesics::directional_cost(m_slope_function)));
  }

  // Keeps other processes from writing there.
  void lock()
  {
    const std::string& folder = m_options.work_folder;
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if(error)
      fail_to("create", folder, error.value());
    std::ofstream(file("in_use"), std::ios::app);
    try
    {
      boost::interprocess::file_lock(file("in_use").c_str()).swap(m_lock);
      if(m_lock.try_lock())
        return;
    }
    catch(const boost::interprocess::interprocess_exception& e)
    {
      fail_to("write into", folder, e.get_native_error());
    }
    throw std::invalid_argument("--work-folder " + folder + ": another process works there");
  }

  void check_friction(const double value, const std::size_t column, const std::size_t row) const
  {
    if(!(value >= 0))
      reject_value(m_options.friction, "cost", value, column, row, "that is not negative");
  }

  void check_height(const double value, const std::size_t column, const std::size_t row) const
  {
    constexpr double too_large = 1e100;
    if(!(std::abs(value) < too_large))
      reject_value(m_options.heights, "height", value, column, row, "of at most 1e100");
  }

  [[noreturn]] static void reject_value(const std::string& file,
                                        const char* const role,
                                        const double value,
                                        const std::size_t column,
                                        const std::size_t row,
                                        const char* const kind)
  {
    std::ostringstream out;
    out << "the " << role << " of cell " << column << ',' << row << " (column, row) is " << value
        << "; it must be a number " << kind << ", or no data (see --no-data)";
    reject_raster(file, out.str());
  }

  const Options& m_options;
  Slope_function m_slope_function;
  Length_unit m_unit_of_heights{"", 1};
  std::string m_description;
  std::unique_ptr<Raster_reader> m_friction_raster, m_heights_raster; // until they have been read
  Raster_frame m_frame;
  Grid_shape m_shape;
  Metric m_metric;
  std::optional<Cell_values> m_friction; // infinity for cells that cannot be entered
  std::optional<Cell_values> m_heights;  // NaN for cells that cannot be entered
  boost::interprocess::file_lock m_lock; // the system releases it when the process ends
};

// The graphs of windows for searches in one direction.
struct Graph_of_window
{
  Grid_graph operator()(const Grid_window& window) const
  {
    return costs.graph(window, goes_to_sources);
  }

  const Costs& costs;
  bool goes_to_sources;
};

#endif // TERRAIN_ROUTES_COSTS_H
