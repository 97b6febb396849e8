/**
 * Many short lists sorted on the device, one in each pixel, by any of the sorts that are measured against each other.
 */
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
 * Sorts in fragment shaders, since that is where a transparency method's resolve sorts: one draw, 256 pixels to a row.
 */
class SortHarness
{
public:
  /** The window has a context, and outlives the harness. */
  explicit SortHarness(vtkOpenGLRenderWindow* window);
  ~SortHarness();
  SortHarness(const SortHarness&) = delete;
  void operator=(const SortHarness&) = delete;

  /** What the window's context lacks for this, in words; empty if nothing. Nothing else may be called then. */
  std::string FindMissingFeature() const;

  /**
   * Bring the lists to the device, each into storage for `capacity` elements. Returns an empty string, or why they
   * cannot be sorted: there are none then.
   *
   * @param lists     at least one; none longer than `capacity`, no key 0xffffffff, which marks an unused element
   * @param capacity  a power of two from 2 to LargestProvableNetwork
   */
  std::string SetLists(const std::vector<SortList>& lists, int capacity);

  /**
   * Sort all lists, always from what SetLists() brought, and keep a checksum of each. Returns the wall time of the
   * draw in milliseconds, finished on the device, or nothing where the driver cannot compile the shader, which VTK
   * has reported then. The first call of a sort compiles it.
   *
   * @param repeats  times that each list is loaded once and sorted, with its keys in another order each time, where
   *                 time matters; checksums and lists are of the plain lists only with 1
   */
  std::optional<double> Sort(ListSort sort, int repeats = 1);

  /** The same without a sort: the floor under the time of Sort(). */
  std::optional<double> Copy(int repeats = 1);

  /** ListChecksum() of each list as the last Sort() or Copy() left it. */
  std::vector<std::array<std::uint32_t, 2>> ReadChecksums();

  /** Sort all lists and bring them back; nothing where the driver cannot compile the shader. */
  std::optional<std::vector<SortList>> SortAndRead(ListSort sort);

private:
  struct Private;
  std::unique_ptr<Private> Impl;
};

}
#endif
