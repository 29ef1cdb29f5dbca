#ifndef GEODESIC_DISTANCES_VTP_FILE_H
#define GEODESIC_DISTANCES_VTP_FILE_H

#include <boost/endian/conversion.hpp>

#include <cstddef>
#include <cstdint>
#include <ostream>
#include <string>
#include <type_traits>
#include <vector>

// Points, cells of them, and arrays of numbers, to be written in VTK's XML format, which
// ParaView, f3d and others read: numbers as they are in memory, behind the text.
class Vtp_file
{
public:
  struct Cells // of one kind: the points of all of them, and where each one ends in that list
  {
    std::vector<std::int64_t> points;
    std::vector<std::int64_t> ends;

    template <typename Points>
    void add(const Points& points_of_cell)
    {
      points.insert(points.end(), points_of_cell.begin(), points_of_cell.end());
      ends.push_back(static_cast<std::int64_t>(points.size()));
    }
  };

  std::vector<double> coordinates;
  Cells vertices;
  Cells lines;
  Cells polygons;

  // Returns the number of the new point.
  template <typename Point>
  std::int64_t add_point(const Point& p)
  {
    coordinates.insert(coordinates.end(), {p.x(), p.y(), p.z()});
    return static_cast<std::int64_t>(coordinates.size() / 3) - 1;
  }

  // Adds new points, and the line through them.
  template <typename Points>
  void add_line(const Points& points)
  {
    std::vector<std::int64_t> numbers;
    for(const auto& p : points)
      numbers.push_back(add_point(p));
    lines.add(numbers);
  }

  // An array with a number per point. The first one colors them.
  template <typename T>
  void add_array_of_points(const std::string& name, const std::vector<T>& numbers)
  {
    add_array(m_of_points, name, numbers);
  }

  // An array with a number per cell: those of vertices, then lines, then polygons.
  template <typename T>
  void add_array_of_cells(const std::string& name, const std::vector<T>& numbers)
  {
    add_array(m_of_cells, name, numbers);
  }

  // The same, of texts: zeros behind them are their ends.
  void add_texts_of_cells(const std::string& name, const std::vector<std::string>& texts)
  {
    std::string codes;
    for(const std::string& text : texts)
    {
      for(const char c : text)
        codes += std::to_string(static_cast<unsigned char>(c)) + ' ';
      codes += "0 ";
    }
    m_of_cells.text += "<DataArray type=\"String\" Name=\"" + name + "\" NumberOfTuples=\"" +
                       std::to_string(texts.size()) + "\" format=\"ascii\">\n" + codes +
                       "\n</DataArray>\n";
  }

  void write(std::ostream& out)
  {
    const std::string points = array("points", coordinates, 3);
    const std::string all_cells =
        cells("Verts", vertices) + cells("Lines", lines) + cells("Polys", polygons);
    out << "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\""
        << (boost::endian::order::native == boost::endian::order::little ? "Little" : "Big")
        << "Endian\" header_type=\"UInt64\">\n<PolyData>\n<Piece NumberOfPoints=\""
        << coordinates.size() / 3 << "\" NumberOfVerts=\"" << vertices.ends.size()
        << "\" NumberOfLines=\"" << lines.ends.size() << "\" NumberOfPolys=\""
        << polygons.ends.size() << "\" NumberOfStrips=\"0\">\n<Points>\n"
        << points << "</Points>\n"
        << all_cells << data("PointData", m_of_points) << data("CellData", m_of_cells)
        << "</Piece>\n</PolyData>\n<AppendedData encoding=\"raw\">\n_";
    out.write(m_bytes.data(), static_cast<std::streamsize>(m_bytes.size()));
    out << "\n</AppendedData>\n</VTKFile>\n";
  }

private:
  struct Arrays
  {
    std::string first_name;
    std::string text;
  };

  template <typename T>
  void add_array(Arrays& arrays, const std::string& name, const std::vector<T>& numbers)
  {
    if(arrays.first_name.empty())
      arrays.first_name = name;
    arrays.text += array(name, numbers);
  }

  // Appends the numbers, and returns the text that says what they are.
  template <typename T>
  std::string
  array(const std::string& name, const std::vector<T>& numbers, const int components = 1)
  {
    const std::string type = std::is_same_v<T, double> ? "Float64" : "Int64";
    static_assert(std::is_same_v<T, double> || std::is_same_v<T, std::int64_t>);
    const std::string result = "<DataArray type=\"" + type + "\" Name=\"" + name +
                               "\" NumberOfComponents=\"" + std::to_string(components) +
                               "\" format=\"appended\" offset=\"" + std::to_string(m_bytes.size()) +
                               "\"/>\n";
    const std::uint64_t size = numbers.size() * sizeof(T);
    m_bytes.append(reinterpret_cast<const char*>(&size), sizeof(size));
    m_bytes.append(reinterpret_cast<const char*>(numbers.data()), size);
    return result;
  }

  std::string cells(const std::string& kind, const Cells& cells)
  {
    return '<' + kind + ">\n" + array("connectivity", cells.points) + array("offsets", cells.ends) +
           "</" + kind + ">\n";
  }

  static std::string data(const std::string& kind, const Arrays& arrays)
  {
    const std::string scalars =
        arrays.first_name.empty() ? "" : " Scalars=\"" + arrays.first_name + '"';
    return '<' + kind + scalars + ">\n" + arrays.text + "</" + kind + ">\n";
  }

  Arrays m_of_points;
  Arrays m_of_cells;
  std::string m_bytes;
};

#endif // GEODESIC_DISTANCES_VTP_FILE_H
