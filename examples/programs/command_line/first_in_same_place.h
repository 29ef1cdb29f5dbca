#ifndef COMMAND_LINE_FIRST_IN_SAME_PLACE_H
#define COMMAND_LINE_FIRST_IN_SAME_PLACE_H

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

// Mixes the bits of the coordinates. Zeros have two representations, which are equal.
template <typename Point>
std::uint64_t hash_of_point(const Point& p)
{
  std::uint64_t result = 0;
  for(const double x : {p.x() + 0., p.y() + 0., p.z() + 0.})
  {
    std::uint64_t bits = 0;
    std::memcpy(&bits, &x, sizeof(bits));
    result = (result ^ bits) * 0x9e3779b97f4a7c15u;
    result ^= result >> 29;
  }
  return result;
}

// Returns for each point which is the first one with the same coordinates; nothing if they all
// differ.
template <typename Point>
std::vector<std::size_t> first_in_same_place(const std::vector<Point>& points)
{
  constexpr std::size_t none = std::size_t(-1);
  std::size_t size = 16;
  while(size < 2 * points.size())
    size *= 2;
  std::vector<std::size_t> table(size, none); // open addressing
  std::vector<std::size_t> result(points.size());
  bool is_any_equal = false;
  for(std::size_t i = 0; i < points.size(); ++i)
  {
    std::size_t slot = hash_of_point(points[i]) % size;
    while(table[slot] != none && points[table[slot]] != points[i])
      slot = (slot + 1) % size;
    if(table[slot] == none)
      table[slot] = i;
    result[i] = table[slot];
    is_any_equal = is_any_equal || result[i] != i;
  }
  if(!is_any_equal)
    result.clear();
  return result;
}

#endif // COMMAND_LINE_FIRST_IN_SAME_PLACE_H
