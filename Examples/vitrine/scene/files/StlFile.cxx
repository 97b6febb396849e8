#include "scene/files/FileReaders.h"

#include "Errors.h"
#include "scene/files/FileBytes.h"

#include "vtkNew.h"
#include "vtkSTLReader.h"

namespace program
{

namespace
{
const std::size_t HeaderBytes = 84; // with the number of triangles at its end
const std::size_t CountOffset = 80;
const std::size_t TriangleBytes = 50;

/**
 * VTK reads a binary file to whatever end it has. A text file says where it ends, and VTK looks.
 */
void CheckBinaryLength(const std::string& path, const std::string& bytes)
{
  if (bytes.size() < HeaderBytes)
  {
    throw InputError(path,
      "is truncated: " + std::to_string(bytes.size()) +
        " bytes are less than the header of an STL file");
  }
  const std::size_t stated = ReadUInt32(bytes, CountOffset);
  if (bytes.size() != HeaderBytes + stated * TriangleBytes)
  {
    throw InputError(path,
      "is truncated or no STL file: it states " + std::to_string(stated) + " triangles, " +
        std::to_string(HeaderBytes + stated * TriangleBytes) + " bytes, and has " +
        std::to_string(bytes.size()));
  }
}

/** A binary file may begin with "solid" too, so its length decides first. */
bool IsText(const std::string& bytes)
{
  const std::size_t begin = bytes.find_first_not_of(" \t\r\n");
  if (begin == std::string::npos || bytes.compare(begin, 5, "solid") != 0)
  {
    return false;
  }
  const bool hasBinaryLength = bytes.size() >= HeaderBytes &&
    bytes.size() == HeaderBytes + ReadUInt32(bytes, CountOffset) * TriangleBytes;
  return !hasBinaryLength && bytes.find('\0') == std::string::npos;
}
}

Scene ReadStlFile(const std::string& path)
{
  const std::string bytes = ReadBytes(path);
  if (!IsText(bytes))
  {
    CheckBinaryLength(path, bytes);
  }
  vtkNew<vtkSTLReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  return MakeSinglePartScene(path, reader->GetOutput());
}

}
