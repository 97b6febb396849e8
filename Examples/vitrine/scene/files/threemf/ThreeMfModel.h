/**
 * One model of a 3MF file: an XML document of objects, their colours, and what is built of them.
 */
#ifndef VITRINE_THREE_MF_MODEL_H
#define VITRINE_THREE_MF_MODEL_H

#include "scene/files/threemf/ZipArchive.h"

#include <array>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <tuple>
#include <vector>

namespace program
{

/** A base material, or a colour of a group, which has no name. */
struct ThreeMfColor
{
  std::string Name;
  std::array<std::uint8_t, 4> Rgba = { 255, 255, 255, 255 };

  bool operator<(const ThreeMfColor& other) const
  {
    return std::tie(this->Name, this->Rgba) < std::tie(other.Name, other.Rgba);
  }
};

/** A transform of points, which are rows, from the left: 3 rows of axes and the origin. */
using ThreeMfTransform = std::array<double, 12>;

const int NoGroup = -1;

struct ThreeMfTriangle
{
  std::array<std::uint32_t, 3> Corners{};
  int Group = NoGroup;         ///< of colours; the object's own where there is none
  std::array<int, 3> Colors{}; ///< numbers in the group, at the corners
};

/** An object at a place: a component of another one, or an item that is built. */
struct ThreeMfUse
{
  std::string Model; ///< the file in the archive; empty for the same one
  int Object = 0;
  ThreeMfTransform Transform = { 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0 };
  std::string Name; ///< may be empty
};

struct ThreeMfObject
{
  std::string Name; ///< may be empty
  int Group = NoGroup;
  int Color = 0;
  std::vector<std::array<float, 3>> Vertices;
  std::vector<ThreeMfTriangle> Triangles;
  std::vector<ThreeMfUse> Components;
};

struct ThreeMfModel
{
  double MetersPerUnit = 0.001;
  std::string LengthUnit = "millimeter"; ///< as 3MF calls it
  std::map<int, std::vector<ThreeMfColor>> Groups;
  std::map<int, ThreeMfObject> Objects;
  std::vector<ThreeMfUse> Items;
  std::set<std::string> Notes; ///< what of it is not shown
};

/**
 * Read a model from an archive. Corners of triangles are among the vertices, and all numbers are finite. Throws
 * InputError if the model is not there or is damaged.
 * @param path  of the archive, for messages
 * @param name  of the model in the archive
 */
ThreeMfModel ReadThreeMfModel(
  const std::string& path, ZipArchive& archive, const std::string& name);

/** The name of the archive's first model, which its relationships tell. Throws InputError if they tell none. */
std::string FindThreeMfModel(const std::string& path, ZipArchive& archive);

}
#endif
