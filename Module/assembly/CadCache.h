/** Files that took long to make, kept for the next time. */
#ifndef VITRINE_ASSEMBLY_CAD_CACHE_H
#define VITRINE_ASSEMBLY_CAD_CACHE_H

#include <cstdint>
#include <filesystem>
#include <string>

namespace vitrine
{

/**
 * A folder of files of one kind, each named by what it was made from. An entry appears by a renaming, so that no
 * process sees half of one. The entries that were not used for longest are removed where all are larger than the limit.
 */
class CadCache
{
public:
  /**
   * Opens a folder, and makes it if there is none.
   * @param folder     empty for vitrine/cad in $XDG_CACHE_HOME, which is ~/.cache by default
   * @param limit      bytes of all entries
   * @param kind       the name of the default folder in vitrine
   * @param extension  that of the entries' names
   */
  CadCache(std::filesystem::path folder, std::uint64_t limit, const std::string& kind = "cad",
    std::string extension = ".glb");

  /** Returns why the folder cannot be used, or an empty text. */
  const std::string& Problem() const { return this->WhyNot; }

  std::filesystem::path EntryOf(const std::string& key) const;

  /** Returns a name beside the entry, of this process's own, for a file that is not yet whole. */
  std::filesystem::path UnfinishedOf(const std::string& key) const;

  /** Has an entry be the one that was used last. */
  void Touch(const std::string& key) const;

  /** Makes an unfinished file an entry, and removes what is too much. Returns false if that cannot be done. */
  bool Keep(const std::filesystem::path& unfinished, const std::string& key) const;

  void Remove(const std::string& key) const;

private:
  void Trim() const;

  std::filesystem::path Folder;
  std::uint64_t Limit;
  std::string Extension;
  std::string WhyNot;
};

/**
 * Returns a key of 32 hexadecimal digits of a file's content and of a text with all else that decides.
 * @throws  AssemblyError if the file cannot be read
 */
std::string CadKey(const std::filesystem::path& file, const std::string& rest);

}

#endif
