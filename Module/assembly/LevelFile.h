/** Levels of detail of an assembly's geometries, as a file of the cache. */
#ifndef VITRINE_ASSEMBLY_LEVEL_FILE_H
#define VITRINE_ASSEMBLY_LEVEL_FILE_H

#include "assembly/CadCache.h"
#include "assembly/PartDetail.h"

#include <atomic>
#include <memory>
#include <string>
#include <vector>

namespace vitrine
{

using Details = std::vector<std::shared_ptr<const PartDetail>>;

/** Returns the key of all that levels are made from, and of how they are made. It may be any where it is stopped. */
std::string KeyOfLevels(
  const DetailWork::Geometries& geometries, const std::atomic<bool>& isStopped);

/**
 * Reads what KeepLevels() has kept. A damaged entry is removed.
 * @param details  one for each geometry, which stay as they are if there is no entry
 * @return  false if there is none, or if it was stopped
 */
bool ReadLevels(const CadCache& cache, const std::string& key,
  const DetailWork::Geometries& geometries, const std::atomic<bool>& isStopped, Details& details);

/** Keeps levels, if there is room for them. */
void KeepLevels(const CadCache& cache, const std::string& key, const Details& details);

}

#endif
