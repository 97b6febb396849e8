#include "scene/files/threemf/ZipArchive.h"

#include "Errors.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <vector>

namespace program
{

namespace
{
// Records of an archive by their first bytes (PKWARE's APPNOTE 6.3, section 4.3).
const std::uint64_t EndRecord = 0x06054b50;
const std::uint64_t LargeEndRecord = 0x06064b50;
const std::uint64_t LargeEndLocator = 0x07064b50;
const std::uint64_t DirectoryRecord = 0x02014b50;
const std::uint64_t FileRecord = 0x04034b50;
const std::uint64_t EndRecordBytes = 22;
const std::uint64_t LongestComment = 65535;
const std::uint64_t DirectoryRecordBytes = 46;
const std::uint64_t FileRecordBytes = 30;
const std::uint64_t LargeField = 0xffffffff; ///< the number is in an extra field
const int Stored = 0;
const int Deflated = 8;

const std::uint64_t LeastLimit = std::uint64_t(256) << 20; // bytes
const std::uint64_t MostBytesOfAByte = 64;
const std::size_t PieceBytes = 1 << 16;

std::string KeyOf(const std::string& name)
{
  std::string key = name.substr(std::min(name.find_first_not_of('/'), name.size()));
  std::transform(key.begin(), key.end(), key.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return key;
}

/** zlib's state of inflating, which is freed at the end. */
class Inflater
{
public:
  Inflater() { this->IsReady = inflateInit2(&this->Stream, -MAX_WBITS) == Z_OK; }
  ~Inflater() { inflateEnd(&this->Stream); }
  Inflater(const Inflater&) = delete;
  Inflater& operator=(const Inflater&) = delete;

  z_stream Stream{};
  bool IsReady = false;
};
}

ZipArchive::ZipArchive(const std::string& path, std::string bytes)
  : Path(path)
  , Bytes(std::move(bytes))
  , Left(LeastLimit + MostBytesOfAByte * this->Bytes.size())
{
  this->ReadDirectory();
}

void ZipArchive::Fail(const std::string& problem) const
{
  throw InputError(this->Path, problem);
}

std::uint64_t ZipArchive::Number(std::uint64_t offset, int bytes) const
{
  if (offset > this->Bytes.size() ||
    this->Bytes.size() - offset < static_cast<std::uint64_t>(bytes))
  {
    this->Fail("is damaged: its ZIP archive goes on beyond the end of the file");
  }
  std::uint64_t value = 0;
  for (int i = bytes - 1; i >= 0; --i)
  {
    value =
      value << 8 | static_cast<unsigned char>(this->Bytes[offset + static_cast<std::uint64_t>(i)]);
  }
  return value;
}

/** The offset of the record at the archive's end. A comment may stand after it. */
std::uint64_t ZipArchive::FindDirectory() const
{
  const std::uint64_t size = this->Bytes.size();
  const std::uint64_t first = size - std::min(size, EndRecordBytes + LongestComment);
  for (std::uint64_t at = size - std::min(size, EndRecordBytes) + 1; at > first; --at)
  {
    if (size - (at - 1) >= EndRecordBytes && this->Number(at - 1, 4) == EndRecord)
    {
      return at - 1;
    }
  }
  this->Fail("is no ZIP archive, or is truncated");
}

void ZipArchive::ReadDirectory()
{
  const std::uint64_t end = this->FindDirectory();
  std::uint64_t count = this->Number(end + 10, 2);
  std::uint64_t at = this->Number(end + 16, 4);
  if (end >= 20 && this->Number(end - 20, 4) == LargeEndLocator)
  {
    const std::uint64_t large = this->Number(end - 12, 8);
    if (this->Number(large, 4) != LargeEndRecord)
    {
      this->Fail("is damaged: the directory of its ZIP archive is not where it should be");
    }
    count = this->Number(large + 32, 8);
    at = this->Number(large + 48, 8);
  }
  for (std::uint64_t i = 0; i < count; ++i)
  {
    if (this->Number(at, 4) != DirectoryRecord)
    {
      this->Fail("is damaged: the directory of its ZIP archive is not whole");
    }
    Entry entry;
    entry.Flags = static_cast<std::uint16_t>(this->Number(at + 8, 2));
    entry.Method = static_cast<std::uint16_t>(this->Number(at + 10, 2));
    entry.Checksum = static_cast<std::uint32_t>(this->Number(at + 16, 4));
    entry.PackedSize = this->Number(at + 20, 4);
    entry.Size = this->Number(at + 24, 4);
    entry.Header = this->Number(at + 42, 4);
    const std::uint64_t name = at + DirectoryRecordBytes;
    const std::uint64_t extra = name + this->Number(at + 28, 2);
    const std::uint64_t comment = extra + this->Number(at + 30, 2);
    this->ReadLargeSizes(extra, comment, entry);
    at = comment + this->Number(at + 32, 2);
    this->Number(at, 0); // the record is whole
    this->Entries[KeyOf(this->Bytes.substr(name, extra - name))] = entry;
  }
}

/** Sizes beyond 32 bits stand in an extra field, in this order, as far as their own fields are full. */
void ZipArchive::ReadLargeSizes(std::uint64_t begin, std::uint64_t end, Entry& entry) const
{
  while (end > begin && end - begin >= 4)
  {
    const std::uint64_t kind = this->Number(begin, 2);
    std::uint64_t at = begin + 4;
    begin = at + this->Number(begin + 2, 2);
    for (std::uint64_t* const field : { &entry.Size, &entry.PackedSize, &entry.Header })
    {
      if (kind == 1 && *field == LargeField && at + 8 <= begin)
      {
        *field = this->Number(at, 8);
        at += 8;
      }
    }
  }
}

bool ZipArchive::Has(const std::string& name) const
{
  return this->Entries.count(KeyOf(name)) > 0;
}

std::string_view ZipArchive::PackedBytes(const std::string& name, const Entry& entry) const
{
  if (this->Number(entry.Header, 4) != FileRecord)
  {
    this->Fail("is damaged: '" + name + "' is not where its ZIP archive says");
  }
  const std::uint64_t begin = entry.Header + FileRecordBytes + this->Number(entry.Header + 26, 2) +
    this->Number(entry.Header + 28, 2);
  if (begin > this->Bytes.size() || entry.PackedSize > this->Bytes.size() - begin)
  {
    this->Fail("is damaged: '" + name + "' goes on beyond the end of the file");
  }
  return std::string_view(this->Bytes).substr(begin, entry.PackedSize);
}

void ZipArchive::Inflate(const std::string& name, std::string_view packed,
  const std::function<void(std::string_view)>& take) const
{
  Inflater inflater;
  z_stream& stream = inflater.Stream;
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data()));
  stream.avail_in = static_cast<uInt>(packed.size());
  std::vector<char> piece(PieceBytes);
  int status = inflater.IsReady && packed.size() <= LargeField ? Z_OK : Z_DATA_ERROR;
  while (status == Z_OK)
  {
    stream.next_out = reinterpret_cast<Bytef*>(piece.data());
    stream.avail_out = static_cast<uInt>(piece.size());
    status = inflate(&stream, Z_NO_FLUSH);
    take({ piece.data(), piece.size() - stream.avail_out });
  }
  if (status != Z_STREAM_END)
  {
    this->Fail("is damaged: '" + name + "' cannot be decompressed");
  }
}

void ZipArchive::Read(const std::string& name, const std::function<void(std::string_view)>& take)
{
  const auto found = this->Entries.find(KeyOf(name));
  if (found == this->Entries.end())
  {
    this->Fail("is damaged: it has no '" + name + "'");
  }
  const Entry& entry = found->second;
  if ((entry.Flags & 1) != 0 || (entry.Method != Stored && entry.Method != Deflated))
  {
    this->Fail(
      "cannot be read: '" + name + "' is encrypted, or compressed in a way that is not known");
  }
  std::uint64_t size = 0;
  uLong checksum = crc32(0, nullptr, 0);
  const auto takeChecked = [&](std::string_view piece)
  {
    if (piece.size() > this->Left)
    {
      this->Fail("is far larger than its compressed size allows: it may be made to fill memory");
    }
    this->Left -= piece.size();
    size += piece.size();
    checksum = crc32(
      checksum, reinterpret_cast<const Bytef*>(piece.data()), static_cast<uInt>(piece.size()));
    take(piece);
  };
  const std::string_view packed = this->PackedBytes(name, entry);
  if (entry.Method == Deflated)
  {
    this->Inflate(name, packed, takeChecked);
  }
  else
  {
    for (std::size_t at = 0; at < packed.size(); at += PieceBytes)
    {
      takeChecked(packed.substr(at, PieceBytes));
    }
  }
  if (size != entry.Size || checksum != entry.Checksum)
  {
    this->Fail("is damaged: '" + name + "' is not what its ZIP archive says");
  }
}

}
