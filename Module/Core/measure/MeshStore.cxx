#include "Core/measure/MeshStore.h"

#include <cerrno>
#include <ios>
#include <random>
#include <sstream>
#include <stdexcept>
#include <string>
#include <system_error>
#include <utility>

namespace vitrine
{

namespace fs = std::filesystem;

namespace
{

constexpr auto OpenMode = std::ios::in | std::ios::out | std::ios::binary | std::ios::trunc;

[[noreturn]] void Fail(const std::string& what)
{
  throw std::runtime_error("parts beyond the memory limit cannot be " + what + ": " +
    std::generic_category().message(errno));
}

template <class Item>
std::size_t SizeOf(const std::vector<Item>& items)
{
  return items.size() * sizeof(Item);
}

}

ScratchFile::ScratchFile()
{
  std::error_code problem;
  std::random_device random;
  std::ostringstream name;
  name << "vitrine-" << std::hex << random() << random();
  this->Path = fs::temp_directory_path(problem) / name.str();
  errno = problem ? problem.value() : 0;
  if (!problem)
  {
    this->Stream.open(this->Path, OpenMode);
  }
  if (!this->Stream.is_open())
  {
    Fail("written to a temporary file, TMPDIR or /tmp");
  }
  fs::permissions(this->Path, fs::perms::owner_read | fs::perms::owner_write, problem);
  fs::remove(this->Path, problem); // where a system keeps files that are open
}

ScratchFile::~ScratchFile()
{
  this->Stream.close();
  std::error_code problem;
  fs::remove(this->Path, problem);
}

std::uint64_t ScratchFile::Append(const void* data, std::size_t bytes)
{
  const std::uint64_t place = this->Size;
  this->Stream.clear();
  this->Stream.seekp(static_cast<std::streamoff>(place));
  this->Stream.write(static_cast<const char*>(data), static_cast<std::streamsize>(bytes));
  this->Stream.flush();
  if (!this->Stream)
  {
    Fail("written to a temporary file, TMPDIR or /tmp");
  }
  this->Size += bytes;
  return place;
}

void ScratchFile::Read(std::uint64_t place, void* data, std::size_t bytes)
{
  this->Stream.clear();
  this->Stream.seekg(static_cast<std::streamoff>(place));
  this->Stream.read(static_cast<char*>(data), static_cast<std::streamsize>(bytes));
  if (!this->Stream)
  {
    Fail("read again");
  }
}

void MeshStore::SetBudget(std::size_t bytes)
{
  if (!this->File && this->TotalBytes > bytes)
  {
    this->BeginFile();
  }
  this->Budget = bytes;
  this->DropUnused();
}

std::uint32_t MeshStore::Keep(std::shared_ptr<const PartMesh> mesh)
{
  const auto number = static_cast<std::uint32_t>(this->Slots.size());
  Slot slot;
  slot.Bytes = BytesOf(*mesh);
  slot.PointCount = mesh->Points().size();
  slot.TriangleCount = mesh->TriangleCount();
  if (!this->File && this->TotalBytes + slot.Bytes > this->Budget)
  {
    this->BeginFile();
  }
  if (this->File)
  {
    slot.Place = Write(*mesh, *this->File);
  }
  slot.Mesh = std::move(mesh);
  slot.InUse = this->Residents.insert(this->Residents.begin(), number);
  this->Slots.push_back(slot);
  this->Bytes += slot.Bytes;
  this->TotalBytes += slot.Bytes;
  this->DropUnused();
  return number;
}

std::shared_ptr<const PartMesh> MeshStore::Load(std::uint32_t mesh) const
{
  if (!this->File)
  {
    return this->Slots[mesh].Mesh;
  }
  const std::lock_guard<std::mutex> lock(this->Access);
  Slot& slot = this->Slots[mesh];
  if (slot.Mesh)
  {
    this->Residents.splice(this->Residents.begin(), this->Residents, slot.InUse);
    return slot.Mesh;
  }
  const std::shared_ptr<const PartMesh> found = this->ReadMesh(slot);
  slot.Mesh = found;
  slot.InUse = this->Residents.insert(this->Residents.begin(), mesh);
  this->Bytes += slot.Bytes;
  ++this->Reads;
  this->DropUnused();
  return found;
}

std::size_t MeshStore::BytesOf(const PartMesh& mesh)
{
  constexpr std::size_t ofTree = 40; // for a triangle: a mean over files of assemblies
  const PartMesh::Arrays& arrays = mesh.Content();
  return SizeOf(arrays.Points) + SizeOf(arrays.Corners) + SizeOf(arrays.Sources) +
    ofTree * mesh.TriangleCount() + sizeof(std::uint32_t) * arrays.Points.size() + sizeof(PartMesh);
}

std::size_t MeshStore::ResidentBytes() const
{
  const std::lock_guard<std::mutex> lock(this->Access);
  return this->Bytes;
}

std::uint64_t MeshStore::ReadCount() const
{
  const std::lock_guard<std::mutex> lock(this->Access);
  return this->Reads;
}

void MeshStore::BeginFile()
{
  auto file = std::make_unique<ScratchFile>();
  for (Slot& slot : this->Slots)
  {
    slot.Place = Write(*slot.Mesh, *file);
  }
  this->File = std::move(file);
}

std::uint64_t MeshStore::Write(const PartMesh& mesh, ScratchFile& file)
{
  const PartMesh::Arrays& arrays = mesh.Content();
  const std::uint64_t place = file.Append(arrays.Points.data(), SizeOf(arrays.Points));
  file.Append(arrays.Corners.data(), SizeOf(arrays.Corners));
  file.Append(arrays.Sources.data(), SizeOf(arrays.Sources));
  return place;
}

std::shared_ptr<const PartMesh> MeshStore::ReadMesh(const Slot& slot) const
{
  PartMesh::Arrays arrays;
  arrays.Points.resize(slot.PointCount);
  arrays.Corners.resize(3 * slot.TriangleCount);
  arrays.Sources.resize(slot.TriangleCount);
  std::uint64_t place = slot.Place;
  this->File->Read(place, arrays.Points.data(), SizeOf(arrays.Points));
  place += SizeOf(arrays.Points);
  this->File->Read(place, arrays.Corners.data(), SizeOf(arrays.Corners));
  place += SizeOf(arrays.Corners);
  this->File->Read(place, arrays.Sources.data(), SizeOf(arrays.Sources));
  return std::make_shared<const PartMesh>(std::move(arrays));
}

void MeshStore::DropUnused() const
{
  while (this->File && this->Bytes > this->Budget && !this->Residents.empty())
  {
    Slot& slot = this->Slots[this->Residents.back()];
    this->Residents.pop_back();
    this->Bytes -= slot.Bytes;
    slot.Mesh.reset();
  }
}

}
