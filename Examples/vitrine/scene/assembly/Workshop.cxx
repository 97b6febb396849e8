#include "scene/assembly/Workshop.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <cmath>
#include <sstream>

namespace program
{

vtkSmartPointer<vtkPolyData> Warehouse::Take(
  const std::string& key, const std::function<Mesh()>& make)
{
  vtkSmartPointer<vtkPolyData>& shelf = this->Shelves[key];
  if (!shelf)
  {
    shelf = ToPolyData(make());
  }
  return shelf;
}

void Unit::Add(Rank rank, const std::string& name, Material material, const glm::dmat4& place,
  const std::string& key, const std::function<Mesh()>& make)
{
  this->Built.push_back(
    { this->NextName(name), rank, this->Stock->Take(key, make), material, place });
}

void Unit::AddSingle(Rank rank, const std::string& name, Material material, const Mesh& mesh)
{
  this->Built.push_back(
    { this->NextName(name), rank, ToPolyData(mesh), material, glm::dmat4(1.0) });
}

std::string Unit::NextName(const std::string& name)
{
  return this->Name + "/" + name + "-" + std::to_string(++this->Numbers[name]);
}

std::string KeyOf(const std::string& kind, const std::vector<double>& sizes)
{
  std::ostringstream key;
  key.precision(12);
  key << kind;
  for (double size : sizes)
  {
    key << " " << size;
  }
  return key.str();
}

vtkSmartPointer<vtkMatrix4x4> MatrixOf(const glm::dmat4& place)
{
  auto matrix = vtkSmartPointer<vtkMatrix4x4>::New();
  for (int row = 0; row < 4; ++row)
  {
    for (int column = 0; column < 4; ++column)
    {
      matrix->SetElement(row, column, place[column][row]);
    }
  }
  return matrix;
}

glm::dmat4 Shift(double x, double y, double z)
{
  return glm::translate(glm::dmat4(1.0), Point(x, y, z));
}

glm::dmat4 Shift(const Point& point)
{
  return glm::translate(glm::dmat4(1.0), point);
}

glm::dmat4 TurnX(double angle)
{
  return glm::rotate(glm::dmat4(1.0), angle, Point(1.0, 0.0, 0.0));
}

glm::dmat4 TurnY(double angle)
{
  return glm::rotate(glm::dmat4(1.0), angle, Point(0.0, 1.0, 0.0));
}

glm::dmat4 TurnZ(double angle)
{
  return glm::rotate(glm::dmat4(1.0), angle, Point(0.0, 0.0, 1.0));
}

glm::dmat4 PointZ(const Point& toward)
{
  const Point z = glm::normalize(toward);
  const Point other = std::abs(z.y) < 0.9 ? Point(0.0, 1.0, 0.0) : Point(1.0, 0.0, 0.0);
  const Point x = glm::normalize(glm::cross(other, z));
  const Point y = glm::cross(z, x);
  return glm::dmat4(
    glm::dvec4(x, 0.0), glm::dvec4(y, 0.0), glm::dvec4(z, 0.0), glm::dvec4(0.0, 0.0, 0.0, 1.0));
}

}
