#include "scene/files/PlyCheck.h"

#include "Errors.h"
#include "scene/files/PlyHeader.h"

#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>

namespace program
{

namespace
{
const std::size_t MostCorners = 255; // VTK counts them in a byte
const std::size_t LongestTextLine = 4000;

/** Reads the numbers of a body one after the other. */
class BodyReader
{
public:
  BodyReader(const std::string& path, const std::string& bytes, const PlyHeader& header)
    : Path(path)
    , Bytes(bytes)
    , Header(header)
    , Position(header.Bytes)
  {
  }

  /** In a text file, go to the next line: VTK wants one for each element. */
  void BeginElement()
  {
    if (!this->Header.IsText)
    {
      return;
    }
    if (this->Position >= this->Bytes.size())
    {
      this->FailTruncated();
    }
    const std::size_t newline = this->Bytes.find('\n', this->Position);
    this->LineEnd = newline == std::string::npos ? this->Bytes.size() : newline;
    if (this->LineEnd - this->Position > LongestTextLine)
    {
      throw InputError(this->Path, "has a line that is longer than VTK's reader can take");
    }
  }

  void EndElement()
  {
    if (this->Header.IsText)
    {
      this->Position = this->LineEnd + 1;
    }
  }

  double Next(const PlyType& type)
  {
    return this->Header.IsText ? this->NextWord() : this->NextBinary(type);
  }

private:
  [[noreturn]] void FailTruncated() const
  {
    throw InputError(this->Path, "is truncated: it ends before all that its header announces");
  }

  double NextWord()
  {
    this->Position = this->Bytes.find_first_not_of(" \t\r", this->Position);
    double value = 0.0;
    const char* begin = this->Bytes.data() + std::min(this->Position, this->LineEnd);
    const auto [last, error] = std::from_chars(begin, this->Bytes.data() + this->LineEnd, value);
    if (error == std::errc::invalid_argument)
    {
      throw InputError(this->Path, "is damaged: it has a line with too few numbers");
    }
    this->Position = last - this->Bytes.data();
    return value;
  }

  double NextBinary(const PlyType& type)
  {
    if (type.Bytes > this->Bytes.size() - this->Position)
    {
      this->FailTruncated();
    }
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < type.Bytes; ++i)
    {
      const std::size_t byte = this->Header.IsBigEndian ? i : type.Bytes - 1 - i;
      bits = bits << 8 | static_cast<unsigned char>(this->Bytes[this->Position + byte]);
    }
    this->Position += type.Bytes;
    return ToNumber(bits, type);
  }

  static double ToNumber(std::uint64_t bits, const PlyType& type)
  {
    if (type.IsFloat && type.Bytes == 8)
    {
      double value = 0.0;
      std::memcpy(&value, &bits, sizeof(value));
      return value;
    }
    if (type.IsFloat)
    {
      const auto narrow = static_cast<std::uint32_t>(bits);
      float value = 0.0f;
      std::memcpy(&value, &narrow, sizeof(value));
      return value;
    }
    const std::uint64_t half = 1ull << (8 * type.Bytes - 1);
    const bool isNegative = type.IsSigned && bits >= half;
    return isNegative ? static_cast<double>(bits) - 2.0 * half : static_cast<double>(bits);
  }

  const std::string& Path;
  const std::string& Bytes;
  const PlyHeader& Header;
  std::size_t Position;
  std::size_t LineEnd = 0;
};

bool IsCornerList(const PlyProperty& property)
{
  return property.IsList && (property.Name == "vertex_indices" || property.Name == "vertex_index");
}

/** What VTK's reader takes for granted of the header. */
void CheckElements(const std::string& path, const PlyHeader& header)
{
  const PlyElement* vertex = FindPlyElement(header, "vertex");
  if (!vertex || header.Elements.front().Name != "vertex")
  {
    throw InputError(path, "does not begin with vertices, as VTK's reader wants");
  }
  for (const char* axis : { "x", "y", "z" })
  {
    const PlyProperty* property = FindPlyProperty(*vertex, axis);
    if (!property || property->IsList)
    {
      throw InputError(path, std::string("is damaged: its vertices have no ") + axis);
    }
  }
  for (const PlyElement& element : header.Elements)
  {
    if (element.Count > static_cast<std::size_t>(std::numeric_limits<int>::max()))
    {
      throw InputError(path,
        "is damaged: it announces " + std::to_string(element.Count) + " of element '" +
          element.Name + "'");
    }
  }
  const PlyElement* face = FindPlyElement(header, "face");
  if (!face || face->Count == 0)
  {
    throw InputError(path, "has no faces");
  }
  if (header.Elements[1].Name != "face")
  {
    throw InputError(path,
      "has elements '" + header.Elements[1].Name +
        "' between vertices and faces, which VTK's reader cannot skip");
  }
  for (const PlyProperty& property : face->Properties)
  {
    if (IsCornerList(property))
    {
      return;
    }
  }
  throw InputError(path, "is damaged: its faces list no vertices");
}

void CheckList(
  const std::string& path, const PlyProperty& property, BodyReader& body, std::size_t vertexCount)
{
  const double count = body.Next(property.CountType);
  if (!(count >= 0.0 && count <= MostCorners))
  {
    throw InputError(path,
      "has a list of more than " + std::to_string(MostCorners) +
        " entries, which is damage or more than VTK's reader can take");
  }
  for (int i = 0; i < static_cast<int>(count); ++i)
  {
    const double value = body.Next(property.Type);
    if (IsCornerList(property) && !(value >= 0.0 && value < static_cast<double>(vertexCount)))
    {
      throw InputError(path,
        "is damaged: a face has a corner that is not among its " + std::to_string(vertexCount) +
          " vertices");
    }
  }
}

void CheckBody(
  const std::string& path, const PlyElement& element, BodyReader& body, std::size_t vertexCount)
{
  for (std::size_t i = 0; i < element.Count; ++i)
  {
    body.BeginElement();
    for (const PlyProperty& property : element.Properties)
    {
      if (property.IsList)
      {
        CheckList(path, property, body, vertexCount);
      }
      else
      {
        body.Next(property.Type);
      }
    }
    body.EndElement();
  }
}
}

void CheckPly(const std::string& path, const std::string& bytes)
{
  const PlyHeader header = ParsePlyHeader(path, bytes);
  CheckElements(path, header);
  BodyReader body(path, bytes, header);
  const std::size_t vertexCount = header.Elements[0].Count;
  CheckBody(path, header.Elements[0], body, vertexCount);
  CheckBody(path, header.Elements[1], body, vertexCount);
}

}
