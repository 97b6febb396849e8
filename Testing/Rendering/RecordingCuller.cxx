#include "RecordingCuller.h"

#include "culling/mappers/DividedMapper.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkMatrix4x4.h"
#include "vtkObjectFactory.h"
#include "vtkPropCollection.h"
#include "vtkRenderWindow.h"

#include <algorithm>
#include <array>
#include <map>
#include <sstream>

vtkStandardNewMacro(RecordingCuller);

namespace
{

constexpr int MostNamed = 10; // props, of those that may cover a pixel
constexpr int NoIndex = -1;   // of a prop that its renderer does not have any more

/** Which parts of a prop that is drawn are left out. */
std::vector<int> HiddenParts(vtkRenderer* renderer, vtkProp* prop)
{
  std::vector<int> hidden;
  vtkActor* const actor = vtkActor::SafeDownCast(prop);
  vitrine::DividedMapper* const mapper =
    actor && actor->GetMapper() ? vitrine::DividedMapperOf(actor->GetMapper()) : nullptr;
  const auto shown = mapper ? mapper->ShownIn(renderer, actor) : nullptr;
  for (std::size_t i = 0; shown && i < shown->Shown().size(); ++i)
  {
    if (!shown->Shown()[i])
    {
      hidden.push_back(static_cast<int>(i));
    }
  }
  return hidden;
}

/** The place of each prop among those of its renderer. */
std::map<vtkProp*, int> IndicesOf(vtkRenderer* renderer)
{
  std::map<vtkProp*, int> indices;
  vtkPropCollection* const props = renderer->GetViewProps();
  vtkCollectionSimpleIterator place;
  props->InitTraversal(place);
  for (int i = 0; vtkProp* const prop = props->GetNextProp(place); ++i)
  {
    indices.emplace(prop, i);
  }
  return indices;
}

/** Runs of numbers that follow each other, as in "1 to 4, 7". */
std::string Ranges(const std::vector<int>& numbers)
{
  std::ostringstream text;
  for (std::size_t i = 0; i < numbers.size();)
  {
    std::size_t end = i + 1;
    while (end < numbers.size() && numbers[end] == numbers[end - 1] + 1)
    {
      ++end;
    }
    text << (i == 0 ? "" : ", ") << numbers[i];
    if (end - i > 1)
    {
      text << " to " << numbers[end - 1];
    }
    i = end;
  }
  return text.str();
}

/** The corner of a box in the coordinates of the window, in pixels; nothing if it is behind the eye. */
bool ToPixels(vtkRenderer* renderer, const std::array<double, 3>& corner, double pixels[2])
{
  const double* const viewport = renderer->GetViewport();
  const int* const size = renderer->GetRenderWindow()->GetSize();
  const std::array<double, 4> homogeneous = { corner[0], corner[1], corner[2], 1.0 };
  double clip[4];
  renderer->GetActiveCamera()
    ->GetCompositeProjectionTransformMatrix(renderer->GetTiledAspectRatio(), -1.0, 1.0)
    ->MultiplyPoint(homogeneous.data(), clip);
  for (int axis = 0; axis < 2; ++axis)
  {
    const double share = 0.5 * (clip[axis] / clip[3] + 1.0);
    pixels[axis] = size[axis] * (viewport[axis] + share * (viewport[axis + 2] - viewport[axis]));
  }
  return clip[3] > 0.0;
}

}

double RecordingCuller::Cull(vtkRenderer* renderer, vtkProp** props, int& count, int& initialized)
{
  const std::vector<vtkProp*> before(props, props + count);
  const double total = this->Superclass::Cull(renderer, props, count, initialized);
  if (!this->GetCulling())
  {
    return total;
  }
  int kept = 0; // props keep their order
  for (vtkProp* const prop : before)
  {
    const bool isKept = kept < count && props[kept] == prop;
    kept += isKept;
    const std::vector<int> parts = isKept ? HiddenParts(renderer, prop) : std::vector<int>();
    if (!isKept || !parts.empty())
    {
      this->LeftOut.push_back({ renderer, prop, parts });
    }
  }
  return total;
}

bool RecordingCuller::LeftOutProp::MayCover(const PixelPlace& pixel) const
{
  const double* const bounds = this->Prop->GetBounds();
  if (!bounds)
  {
    return true;
  }
  double low[2] = { 1e300, 1e300 }, high[2] = { -1e300, -1e300 };
  for (int corner = 0; corner < 8; ++corner)
  {
    double pixels[2];
    if (!ToPixels(this->Renderer,
          { bounds[corner & 1], bounds[2 + (corner >> 1 & 1)], bounds[4 + (corner >> 2)] }, pixels))
    {
      return true;
    }
    for (int axis = 0; axis < 2; ++axis)
    {
      low[axis] = std::min(low[axis], pixels[axis]);
      high[axis] = std::max(high[axis], pixels[axis]);
    }
  }
  return low[0] <= pixel[0] + 1 && pixel[0] <= high[0] && low[1] <= pixel[1] + 1 &&
    pixel[1] <= high[1];
}

std::string RecordingCuller::LeftOutProp::Describe(int index) const
{
  std::ostringstream text;
  text << "prop " << index << " (" << this->Prop->GetClassName() << ")";
  if (const double* bounds = this->Prop->GetBounds())
  {
    text << ", x " << bounds[0] << " to " << bounds[1] << ", y " << bounds[2] << " to " << bounds[3]
         << ", z " << bounds[4] << " to " << bounds[5];
  }
  if (!this->Parts.empty())
  {
    text << ", its parts " << Ranges(this->Parts);
  }
  return text.str();
}

std::string RecordingCuller::DescribeLeftOut(const std::optional<PixelPlace>& pixel) const
{
  std::map<vtkRenderer*, std::map<vtkProp*, int>> indices;
  std::vector<int> others;
  std::ostringstream text;
  int named = 0;
  for (const LeftOutProp& prop : this->LeftOut)
  {
    if (!prop.Renderer || !prop.Prop)
    {
      continue;
    }
    std::map<vtkProp*, int>& ofRenderer = indices[prop.Renderer];
    if (ofRenderer.empty())
    {
      ofRenderer = IndicesOf(prop.Renderer);
    }
    const auto found = ofRenderer.find(prop.Prop);
    const int index = found != ofRenderer.end() ? found->second : NoIndex;
    if (named < MostNamed && (!pixel || prop.MayCover(*pixel)))
    {
      text << "  left out, and may cover the first pixel: " << prop.Describe(index) << "\n";
      ++named;
    }
    else
    {
      others.push_back(index);
    }
  }
  text << (named == 0 ? "  nothing that was left out may cover the first pixel\n" : "");
  std::sort(others.begin(), others.end());
  text << (others.empty() ? "" : "  left out besides: props " + Ranges(others));
  return text.str();
}
