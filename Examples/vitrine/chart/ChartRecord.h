/**
 * The measurements of a chart as they stand in a folder, so that a run can be stopped and go on: chart.json and the pictures
 * that it names.
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
   * Begin anew; `head` holds what all of it is measured with ({"vitrine", "build", "device", "settings"}). The folder is made if it is not
   * there, and no other run can have it meanwhile. Throws InputError if it cannot be, if one of its files may not be written to, or if it holds a chart.json of something
   * else, or one that was measured with another head, or a page, a plot or pictures without any; the message names `folderOption`, by which users name a folder.
   */
  ChartRecord(const std::string& folder, const Json& head, const std::string& folderOption);

  /**
   * Take up what stands in the folder. Returns what was found, in a sentence; empty if nothing was. Throws InputError for rows that
   * are not of a chart.
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
