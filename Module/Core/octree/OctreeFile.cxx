#include "Core/octree/OctreeFile.h"

#include "Core/octree/OctreePageCutter.h"

#include <cassert>
#include <cstring>
#include <stdexcept>
#include <string>
#include <type_traits>

namespace vitrine
{

namespace
{

// The beginning of the file. It is followed by the places of the pages, the unplaced items, and the pages.
struct Header
{
  char Magic[8] = { 'V', 'i', 't', 'r', 'O', 'c', 't', '1' };
  std::uint32_t ByteOrder = 0x01020304;
  std::uint32_t PageCount = 0;
  std::uint32_t UnplacedCount = 0;
  std::uint32_t LeafSize = 0;
  float Centre[3] = {};
  float Half = 0;
  // Checksum of everything before the first page, with this number as 0.
  std::uint64_t Checksum = 0;
};
static_assert(sizeof(Header) == 48 && sizeof(OctreeFile::PagePlace) == 24, "without padding");
static_assert(std::is_trivially_copyable_v<OctreeNode>, "nodes are read and written as they are");

// FNV-1a over words of 32 bits. (G. Fowler, L. C. Noll, K.-P. Vo, 1991)
class Checksum
{
public:
  template <class Value>
  void Add(const Value* values, std::size_t count)
  {
    static_assert(sizeof(Value) % sizeof(std::uint32_t) == 0);
    const char* bytes = reinterpret_cast<const char*>(values);
    for (std::size_t i = 0; i < count * sizeof(Value); i += sizeof(std::uint32_t))
    {
      std::uint32_t word;
      std::memcpy(&word, bytes + i, sizeof(word));
      this->Hash = (this->Hash ^ word) * 0x100000001b3;
    }
  }

  std::uint64_t Value() const { return this->Hash; }

private:
  std::uint64_t Hash = 0xcbf29ce484222325;
};

std::uint64_t ChecksumOf(const OctreePage& page)
{
  Checksum sum;
  sum.Add(page.Nodes.data(), page.Nodes.size());
  sum.Add(page.Items.data(), page.Items.size());
  return sum.Value();
}

std::uint64_t ChecksumOf(Header header, const std::vector<OctreeFile::PagePlace>& places,
  const std::vector<std::uint32_t>& unplaced)
{
  header.Checksum = 0;
  Checksum sum;
  sum.Add(&header, 1);
  sum.Add(places.data(), places.size());
  sum.Add(unplaced.data(), unplaced.size());
  return sum.Value();
}

template <class Value>
void WriteValues(std::ostream& stream, const Value* values, std::size_t count)
{
  stream.write(reinterpret_cast<const char*>(values), count * sizeof(Value));
}

template <class Value>
bool ReadValues(std::istream& stream, Value* values, std::size_t count)
{
  const std::streamsize bytes = count * sizeof(Value);
  return bool(stream.read(reinterpret_cast<char*>(values), bytes)) && stream.gcount() == bytes;
}

std::uint64_t BytesFor(std::uint64_t nodes, std::uint64_t items)
{
  return nodes * sizeof(OctreeNode) + items * sizeof(std::uint32_t);
}

[[noreturn]] void Fail(const std::filesystem::path& file, const std::string& what)
{
  throw std::runtime_error(file.string() + ": " + what);
}

}

void WriteOctreeFile(const Octree& tree, const std::filesystem::path& file, std::size_t pageBytes)
{
  std::filesystem::path beside = file;
  beside += ".part";
  {
    std::ofstream stream(beside, std::ios::binary);
    const OctreePageCutter cutter(tree.TopPage(), pageBytes);
    Header header;
    header.PageCount = cutter.PageCount();
    header.UnplacedCount = static_cast<std::uint32_t>(tree.UnplacedItems().size());
    header.LeafSize = tree.LeafSize();
    std::memcpy(header.Centre, &tree.RootCell().Centre, sizeof(header.Centre));
    header.Half = tree.RootCell().Half;

    std::vector<OctreeFile::PagePlace> places(header.PageCount);
    std::uint64_t offset = sizeof(Header) + places.size() * sizeof(OctreeFile::PagePlace) +
      header.UnplacedCount * sizeof(std::uint32_t);
    stream.seekp(static_cast<std::streamoff>(offset));
    for (std::uint32_t number = 0; number < header.PageCount; ++number)
    {
      const OctreePage page = cutter.Page(number);
      places[number] = { offset, ChecksumOf(page), static_cast<std::uint32_t>(page.Nodes.size()),
        static_cast<std::uint32_t>(page.Items.size()) };
      WriteValues(stream, page.Nodes.data(), page.Nodes.size());
      WriteValues(stream, page.Items.data(), page.Items.size());
      offset += BytesFor(page.Nodes.size(), page.Items.size());
    }
    header.Checksum = ChecksumOf(header, places, tree.UnplacedItems());
    stream.seekp(0);
    WriteValues(stream, &header, 1);
    WriteValues(stream, places.data(), places.size());
    WriteValues(stream, tree.UnplacedItems().data(), tree.UnplacedItems().size());
    stream.close();
    if (!stream)
    {
      std::error_code ignored;
      std::filesystem::remove(beside, ignored);
      Fail(file, "the octree cannot be written");
    }
  }
  std::error_code failure;
  std::filesystem::rename(beside, file, failure);
  if (failure)
  {
    Fail(file, "the octree cannot be written: " + failure.message());
  }
}

OctreeFile::OctreeFile(const std::filesystem::path& file, std::uint32_t itemCount)
  : Path(file)
  , ItemCount(itemCount)
  , Stream(file, std::ios::binary | std::ios::ate)
{
  if (!this->Stream)
  {
    Fail(file, "the octree cannot be opened");
  }
  const std::uint64_t fileBytes = static_cast<std::uint64_t>(std::streamoff(this->Stream.tellg()));
  this->Stream.seekg(0);
  Header header;
  const bool isHeader = ReadValues(this->Stream, &header, 1) &&
    std::memcmp(header.Magic, Header().Magic, sizeof(header.Magic)) == 0;
  if (!isHeader)
  {
    Fail(file, "this is not an octree, or of another version");
  }
  if (header.ByteOrder != Header().ByteOrder)
  {
    Fail(file, "the octree was written by a machine of another byte order");
  }
  const std::uint64_t begin = sizeof(Header) + header.PageCount * sizeof(PagePlace) +
    header.UnplacedCount * sizeof(std::uint32_t);
  if (begin > fileBytes)
  {
    Fail(file, "the octree is truncated");
  }
  this->Pages.resize(header.PageCount);
  this->UnplacedItems.resize(header.UnplacedCount);
  ReadValues(this->Stream, this->Pages.data(), this->Pages.size());
  ReadValues(this->Stream, this->UnplacedItems.data(), this->UnplacedItems.size());
  if (!this->Stream || header.Checksum != ChecksumOf(header, this->Pages, this->UnplacedItems))
  {
    Fail(file, "the octree is damaged");
  }
  for (const PagePlace& place : this->Pages)
  {
    if (place.Offset > fileBytes || BytesFor(place.Nodes, place.Items) > fileBytes - place.Offset)
    {
      Fail(file, "the octree is truncated");
    }
  }
  bool isForeign = this->Pages.empty();
  for (std::size_t i = 0; i < this->UnplacedItems.size(); ++i)
  {
    const bool isAscending = i == 0 || this->UnplacedItems[i - 1] < this->UnplacedItems[i];
    isForeign = isForeign || !isAscending || this->UnplacedItems[i] >= itemCount;
  }
  if (isForeign)
  {
    Fail(file, "the octree was made of other items");
  }
  std::memcpy(&this->RootCell.Centre, header.Centre, sizeof(header.Centre));
  this->RootCell.Half = header.Half;
  this->LargestLeaf = header.LeafSize;
}

std::size_t OctreeFile::BytesOf(std::uint32_t page) const
{
  return BytesFor(this->Pages[page].Nodes, this->Pages[page].Items);
}

OctreePage OctreeFile::Read(std::uint32_t number) const
{
  const PagePlace& place = this->Pages[number];
  OctreePage page;
  page.Nodes.resize(place.Nodes);
  page.Items.resize(place.Items);
  {
    const std::lock_guard<std::mutex> lock(this->Access);
    this->Stream.clear();
    this->Stream.seekg(static_cast<std::streamoff>(place.Offset));
    const bool isRead = ReadValues(this->Stream, page.Nodes.data(), page.Nodes.size()) &&
      ReadValues(this->Stream, page.Items.data(), page.Items.size());
    if (!isRead)
    {
      Fail(this->Path, "page " + std::to_string(number) + " of the octree cannot be read");
    }
  }
  if (ChecksumOf(page) != place.Checksum)
  {
    Fail(this->Path, "page " + std::to_string(number) + " of the octree is damaged");
  }
  if (!IsSound(page, number == 0, this->ItemCount, this->PageCount()))
  {
    Fail(this->Path, "page " + std::to_string(number) + " of the octree was made of other items");
  }
  return page;
}

bool OctreeFile::IsSound(
  const OctreePage& page, bool isTop, std::uint32_t itemCount, std::uint32_t pageCount)
{
  struct Visited
  {
    std::uint32_t Node;
    int Depth;
    bool MayBeInner;
  };
  std::vector<bool> isSeen(page.Nodes.size(), false);
  std::vector<Visited> open;
  if (!page.Nodes.empty())
  {
    open.push_back({ 0, 0, true });
  }
  else if (!isTop)
  {
    return false;
  }
  while (!open.empty())
  {
    const Visited visited = open.back();
    open.pop_back();
    if (isSeen[visited.Node] || visited.Depth > Octree::LargestDepth)
    {
      return false;
    }
    isSeen[visited.Node] = true;
    const OctreeNode& node = page.Nodes[visited.Node];
    if (node.IsLeaf())
    {
      const std::uint64_t end = std::uint64_t{ node.First } + node.Count();
      if (node.First == 0 || end > page.Items.size())
      {
        return false;
      }
      for (std::uint32_t i = 0; i < node.Count(); ++i)
      {
        if (page.ItemsOf(node)[i] >= itemCount)
        {
          return false;
        }
      }
    }
    else if (node.Kind() == OctreeNode::Kinds::Stored)
    {
      if (!isTop || node.First == 0 || node.First >= pageCount)
      {
        return false;
      }
    }
    else
    {
      const bool hasSlots = node.Kind() == OctreeNode::Kinds::Inner && node.Slots() != 0 &&
        node.Slots() < 2u << OctreeNode::OwnSlot;
      if (!visited.MayBeInner || !hasSlots ||
        std::uint64_t{ node.First } + node.ChildCount() > page.Nodes.size())
      {
        return false;
      }
      for (std::uint32_t i = 0; i < node.ChildCount(); ++i)
      {
        const bool isOwn = node.HasChild(OctreeNode::OwnSlot) && i + 1 == node.ChildCount();
        open.push_back({ node.First + i, visited.Depth + 1, !isOwn });
      }
    }
  }
  return true;
}

}
