#include "CadMesh.h"

#include "Errors.h"

#include <BRepBndLib.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <BRep_Builder.hxx>
#include <Bnd_Box.hxx>
#include <Precision.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS_Compound.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <XCAFPrs_DocumentExplorer.hxx>

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>

namespace cad
{

namespace
{
const double EndOfMeshing = 0.95; // of the whole conversion
const double ToleranceOfSize = 1e-3;

/** The shapes without their places, and the box around all places. */
struct Shapes
{
  TopoDS_Compound Distinct;
  Bnd_Box Box; ///< in the document's unit
};

Shapes CollectShapes(const CadFile& file)
{
  const BRep_Builder builder;
  Shapes shapes;
  builder.MakeCompound(shapes.Distinct);
  std::map<const TopoDS_TShape*, Bnd_Box> boxes;
  for (XCAFPrs_DocumentExplorer explorer(
         file.Document, XCAFPrs_DocumentExplorerFlags_OnlyLeafNodes);
       explorer.More(); explorer.Next())
  {
    const XCAFPrs_DocumentNode& leaf = explorer.Current();
    const TopoDS_Shape shape = XCAFDoc_ShapeTool::GetShape(leaf.RefLabel);
    if (shape.IsNull())
    {
      continue;
    }
    const auto [known, isNew] = boxes.try_emplace(shape.TShape().get());
    if (isNew)
    {
      const TopoDS_Shape unplaced = shape.Located(TopLoc_Location());
      BRepBndLib::Add(unplaced, known->second, false);
      builder.Add(shapes.Distinct, unplaced);
    }
    if (!known->second.IsVoid())
    {
      shapes.Box.Add(
        known->second.Transformed((leaf.Location * shape.Location()).Transformation()));
    }
  }
  return shapes;
}
}

double MeshShapes(const CadFile& file, const MeshLimits& limits, ProgressLines& progress)
{
  const double least = METERS_OF_DOCUMENT * Precision::Confusion(); // Nearer points are one.
  if (limits.Tolerance > 0.0 && limits.Tolerance < least)
  {
    std::ostringstream problem;
    problem << "cannot be made into triangles: its tolerance must be " << least
            << " metres at least";
    throw CadError(problem.str());
  }
  const Shapes shapes = CollectShapes(file);
  if (shapes.Box.IsVoid() || !TopExp_Explorer(shapes.Distinct, TopAbs_FACE).More())
  {
    throw CadError("has no faces to draw");
  }
  const double size = std::sqrt(shapes.Box.SquareExtent());
  const double tolerance = limits.Tolerance > 0.0
    ? limits.Tolerance / METERS_OF_DOCUMENT
    : std::max(ToleranceOfSize * size, Precision::Confusion());
  IMeshTools_Parameters parameters;
  parameters.Deflection = tolerance;
  parameters.Angle = limits.Angle;
  parameters.InParallel = true;
  BRepMesh_IncrementalMesh(
    shapes.Distinct, parameters, progress.Begin("making triangles", EndOfMeshing));
  return tolerance * METERS_OF_DOCUMENT;
}

}
