#ifndef COMMAND_LINE_TABLE_H
#define COMMAND_LINE_TABLE_H

#include <cmath>
#include <iomanip>
#include <ostream>
#include <sstream>
#include <string>
#include <vector>

// What a program prints: a name and a value per line.
class Table
{
public:
  template <typename Value>
  void add(const std::string& name, const Value& value, const std::string& unit = "")
  {
    std::ostringstream text;
    text << std::setprecision(6) << value << unit;
    m_rows.push_back({name, text.str()});
  }

  void add_milliseconds(const std::string& name, const double seconds)
  {
    add(name, std::round(seconds * 1e6) / 1e3, " ms");
  }

  void print(std::ostream& out) const
  {
    for(const Row& row : m_rows)
      out << std::left << std::setw(34) << row.name << std::right << std::setw(14) << row.value
          << '\n';
  }

private:
  struct Row
  {
    std::string name;
    std::string value;
  };

  std::vector<Row> m_rows;
};

#endif // COMMAND_LINE_TABLE_H
