/**
 * The measurements of a chart in a folder: chart.json and the pictures that it names. A run can be stopped and
 * continued.
 */
#ifndef VITRINE_CHART_RECORD_H
#define VITRINE_CHART_RECORD_H

#include "chart/FolderLock.h"
#include "methods/Stage.h"
#include "report/Json.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace program
{

/** The files beside chart.json that are written once everything is measured. */
inline constexpr const char* PageFile = "index.html";
inline constexpr const char* ErrorPlotFile = "error.png";
inline constexpr const char* GrowthPlotFile = "growth.png";

class ChartRecord
{
public:
  /**
   * Begin a new record. `head` states what all of it is measured with ({"vitrine", "build", "device", "settings"}).
   *
   * The folder is created if needed, and locked against other runs. Throws InputError if that fails, or if one of its
   * files is not writable. Throws it as well if the folder holds a chart.json of other content or with another head, or
   * a page, a plot or pictures without chart.json. The message names `folderOption`, the option by which users name a
   * folder.
   */
  ChartRecord(const std::string& folder, const Json& head, const std::string& folderOption);

  /**
   * Continue from the contents of the folder. Returns a sentence about what was found, empty if nothing was. Throws
   * InputError for rows that are not of a chart.
   */
  std::string GoOn();

  /** Whether the list `list` has rows with these values. */
  bool Has(const std::string& list, const Json& values) const;

  /** Rows of a list; none if there is no such list. */
  const Json& Rows(const std::string& list) const;

  /** Add rows to a list and write chart.json: all of them or none are there. */
  void Add(const std::string& list, const Json& rows);

  /** Remove the rows with these values from a list, and write chart.json if there were any. */
  void Remove(const std::string& list, const Json& values);

  /** Set what follows from the rows, and write chart.json. */
  void Set(const std::string& key, const Json& value);

  /** Write 8-bit RGB, rows from the bottom, as a PNG. Returns its path in the folder. */
  std::string AddPicture(
    const std::string& name, const std::vector<std::uint8_t>& pixels, PictureSize size);

  /** The path of a file in the folder. */
  std::string PathOf(const std::string& file) const;

  const Json& Document() const { return this->Contents; }

private:
  void CheckThatNoneIsThere(
    const std::vector<std::string>& files, const std::string& folderOption) const;
  void Save() const;

  std::string Folder;
  std::unique_ptr<FolderLock> Lock;
  Json Contents;
};

}
#endif
