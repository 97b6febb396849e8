#include "Core/octree/OctreeStore.h"

namespace vitrine
{

namespace
{

std::filesystem::path FileIn(const std::filesystem::path& folder)
{
  return folder / "octree.pages";
}

}

void OctreeStore::Write(
  const Octree& tree, const std::filesystem::path& folder, std::size_t pageBytes)
{
  WriteOctreeFile(tree, FileIn(folder), pageBytes);
}

Octree OctreeStore::Open(
  const std::filesystem::path& folder, std::size_t budget, std::uint32_t itemCount)
{
  return TreeOf(std::make_shared<OctreeStore>(folder, budget, itemCount));
}

OctreeStore::OctreeStore(
  const std::filesystem::path& folder, std::size_t budget, std::uint32_t itemCount)
  : File(FileIn(folder), itemCount)
  , Budget(budget)
{
}

Octree OctreeStore::TreeOf(const std::shared_ptr<OctreeStore>& store)
{
  const OctreeFile& file = store->File;
  return Octree(file.Read(0), file.Root(), file.Unplaced(), file.LeafSize(), store);
}

std::shared_ptr<const OctreePage> OctreeStore::Load(std::uint32_t page)
{
  const std::lock_guard<std::mutex> lock(this->Access);
  const auto found = this->ByPage.find(page);
  if (found != this->ByPage.end())
  {
    this->Residents.splice(this->Residents.begin(), this->Residents, found->second);
    return found->second->Content;
  }
  this->MakeRoomFor(this->File.BytesOf(page));
  this->Residents.push_front({ page, std::make_shared<const OctreePage>(this->File.Read(page)) });
  this->ByPage[page] = this->Residents.begin();
  this->Bytes += this->File.BytesOf(page);
  ++this->Reads;
  return this->Residents.front().Content;
}

void OctreeStore::MakeRoomFor(std::size_t bytes)
{
  while (!this->Residents.empty() && this->Bytes + bytes > this->Budget)
  {
    const std::uint32_t page = this->Residents.back().Page;
    this->Bytes -= this->File.BytesOf(page);
    this->ByPage.erase(page);
    this->Residents.pop_back();
  }
}

std::size_t OctreeStore::ResidentBytes() const
{
  const std::lock_guard<std::mutex> lock(this->Access);
  return this->Bytes;
}

std::uint64_t OctreeStore::ReadCount() const
{
  const std::lock_guard<std::mutex> lock(this->Access);
  return this->Reads;
}

std::size_t OctreeStore::TotalBytes() const
{
  std::size_t bytes = 0;
  for (std::uint32_t page = 1; page < this->File.PageCount(); ++page)
  {
    bytes += this->File.BytesOf(page);
  }
  return bytes;
}

}
