/** Sorts many short lists on the device, one per pixel, by any of the measured sorts. */
#ifndef VITRINE_STUDY_SORTS_SORT_HARNESS_H
#define VITRINE_STUDY_SORTS_SORT_HARNESS_H

#include "study/sorts/ListChecksum.h"
#include "study/sorts/ListSorts.h"

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

class vtkOpenGLRenderWindow;

namespace vitrine
{

/**
 * Sorts lists in fragment shaders, because the resolve pass of a transparency method sorts there. It takes one draw
 * with 256 pixels per row.
 */
class SortHarness
{
public:
  /** Creates a harness. The window must have a context and outlive the harness. */
  explicit SortHarness(vtkOpenGLRenderWindow* window);
  ~SortHarness();
  SortHarness(const SortHarness&) = delete;
  void operator=(const SortHarness&) = delete;

  /**
   * Returns a description of what the window's context lacks, or an empty string. If it lacks anything, no other method
   * may be called.
   */
  std::string FindMissingFeature() const;

  /**
   * Uploads the lists, each into storage for `capacity` elements. Returns an empty string, or the reason why they
   * cannot be sorted; then there are no lists.
   *
   * @param lists     at least one list; none longer than `capacity`; no key 0xffffffff, which marks unused elements
   * @param capacity  a power of two from 2 to LargestProvableNetwork
   */
  std::string SetLists(const std::vector<SortList>& lists, int capacity);

  /**
   * Sorts all lists as uploaded by SetLists(), and keeps a checksum of each. Returns the wall time of the draw in
   * milliseconds, until the device is done. Returns nothing if the driver cannot compile the shader; VTK has reported
   * that then. The first call of a sort compiles it.
   *
   * @param repeats  number of times that each list is sorted after one load, with its keys in another order each time,
   *                 for timing; checksums and lists are those of the plain lists only with 1
   */
  std::optional<double> Sort(ListSort sort, int repeats = 1);

  /** Draws without a sort. Its time is the lower bound of the time of Sort(). */
  std::optional<double> Copy(int repeats = 1);

  /** Returns ListChecksum() of each list after the last Sort() or Copy(). */
  std::vector<std::array<std::uint32_t, 2>> ReadChecksums();

  /** Sorts all lists and downloads them. Returns nothing if the driver cannot compile the shader. */
  std::optional<std::vector<SortList>> SortAndRead(ListSort sort);

private:
  struct Private;
  std::unique_ptr<Private> Impl;
};

}
#endif
