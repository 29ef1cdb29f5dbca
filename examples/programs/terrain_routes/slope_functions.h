#ifndef TERRAIN_ROUTES_SLOPE_FUNCTIONS_H
#define TERRAIN_ROUTES_SLOPE_FUNCTIONS_H

#include "../command_line/read_options.h"

#include <CGAL/Geodesic_costs/cost_functions.h>

#include <functional>
#include <string>

// The costs per unit of length by slope.
using Slope_function = std::function<double(double)>;

// Returns the function of this name; none for lengths.
inline Slope_function slope_function(const std::string& name)
{
  if(name == "hiking_time")
    return CGAL::Approximate_geodesics::Hiking_time();
  if(name == "walking_energy")
    return CGAL::Approximate_geodesics::Walking_energy();
  if(name == "naismith_time")
    return CGAL::Approximate_geodesics::Naismith_time();
  if(name != "length")
    reject_option("cost", name + " is not length, hiking_time, walking_energy or naismith_time");
  return {};
}

#endif // TERRAIN_ROUTES_SLOPE_FUNCTIONS_H
