/**
 * Files in a ZIP archive.
 */
#ifndef VITRINE_ZIP_ARCHIVE_H
#define VITRINE_ZIP_ARCHIVE_H

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <string_view>

namespace program
{

/**
 * An archive whose bytes are in memory. Its files are stored or deflated. All that is taken out of it is at most 256 MB
 * and 64 times the bytes of the archive, which no honest file of text reaches.
 */
class ZipArchive
{
public:
  /** `path` is for messages. Throws InputError if this is no archive, or a damaged one. */
  ZipArchive(const std::string& path, std::string bytes);

  /** Whether there is a file of that name. Case does not count, and a slash may stand before it. */
  bool Has(const std::string& name) const;

  /**
   * Take a file out of the archive, a piece at a time. Throws InputError if it is not there, is encrypted or damaged,
   * or if too much was taken out.
   */
  void Read(const std::string& name, const std::function<void(std::string_view)>& take);

private:
  struct Entry
  {
    std::uint16_t Flags = 0;
    std::uint16_t Method = 0;
    std::uint32_t Checksum = 0;
    std::uint64_t PackedSize = 0;
    std::uint64_t Size = 0;
    std::uint64_t Header = 0; ///< offset of its own header
  };

  [[noreturn]] void Fail(const std::string& problem) const;
  std::uint64_t Number(std::uint64_t offset, int bytes) const;
  std::uint64_t FindDirectory() const;
  void ReadDirectory();
  void ReadLargeSizes(std::uint64_t begin, std::uint64_t end, Entry& entry) const;
  std::string_view PackedBytes(const std::string& name, const Entry& entry) const;
  void Inflate(const std::string& name, std::string_view packed,
    const std::function<void(std::string_view)>& take) const;

  const std::string Path;
  const std::string Bytes;
  std::map<std::string, Entry> Entries; ///< by names in small letters
  std::uint64_t Left;                   ///< bytes that may still be taken out
};

}
#endif
