#ifndef COMMAND_LINE_SCRIPT_FILE_H
#define COMMAND_LINE_SCRIPT_FILE_H

#include <filesystem>
#include <string>
#include <system_error>

// Returns where the script is that belongs to this program: for an installed one, beside it,
// wherever that is, as `cmake --install build --prefix FOLDER` is told only then; else where it was
// when the program was compiled. (Where there is no /proc, only the latter is known.)
inline std::string script_file(const std::string& when_compiled)
{
  namespace fs = std::filesystem;
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  const fs::path installed = program.parent_path().parent_path() / "share" /
                             "approximate_geodesics" / fs::path(when_compiled).filename();
  return !error && fs::exists(installed, error) ? installed.string() : when_compiled;
}

#endif // COMMAND_LINE_SCRIPT_FILE_H
