#include "commands/Commands.h"

#include "Errors.h"
#include "Progress.h"
#include "commands/Options.h"
#include "commands/PartIndex.h"
#include "report/QueryReport.h"

#include "vtkIdList.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkTable.h"
#include "vtkVariant.h"

#include <cmath>
#include <limits>
#include <memory>
#include <utility>

namespace program
{

namespace
{
struct QueryOptions
{
  SceneOptions Scene;
  std::optional<std::string> Ray, Nearest, Box, Sphere, Distance, Sees;
  bool IsWholly = false;
  std::optional<std::string> Json;
};

std::vector<double> Numbers(
  const std::string& option, const std::string& text, std::size_t count, const std::string& form)
{
  std::vector<double> numbers = ParseNumbers(text);
  if (numbers.size() != count)
  {
    throw InputError(option, "'" + text + "' is not " + form);
  }
  return numbers;
}

/** Where the first comma is that no backslash stands before. A backslash takes the meaning from what follows it. */
std::size_t FindComma(const std::string& text)
{
  std::size_t at = 0;
  while (at < text.size() && text[at] != ',')
  {
    at += text[at] == '\\' ? 2 : 1;
  }
  return at < text.size() ? at : std::string::npos;
}

/** Two parts, with a comma between them. A comma of a name has a backslash before it, as in a GLOB. */
std::array<int, 2> TwoParts(const Scene& scene, const std::string& option, const std::string& text)
{
  const std::size_t comma = FindComma(text);
  if (comma == std::string::npos)
  {
    throw InputError(option, "'" + text + "' is not A,B, two parts");
  }
  return { FindPart(scene, option, text.substr(0, comma)),
    FindPart(scene, option, text.substr(comma + 1)) };
}

std::vector<std::string> Names(vtkAssemblyIndex* index, vtkIdList* parts)
{
  std::vector<std::string> names;
  for (vtkIdType i = 0; i < parts->GetNumberOfIds(); ++i)
  {
    names.push_back(index->GetPartName(static_cast<int>(parts->GetId(i))));
  }
  return names;
}

std::array<std::string, 2> Names(vtkAssemblyIndex* index, const std::array<int, 2>& parts)
{
  return { index->GetPartName(parts[0]), index->GetPartName(parts[1]) };
}

RayAnswer AskRay(vtkAssemblyIndex* index, const std::string& text)
{
  const std::vector<double> ray =
    Numbers("--ray", text, 6, "X,Y,Z,DX,DY,DZ, where a ray begins and its direction");
  if (vtkMath::Norm(&ray[3]) == 0.0)
  {
    throw InputError("--ray", "'" + text + "' has a direction of 0");
  }
  const double endless = std::numeric_limits<double>::infinity();
  RayAnswer answer;
  vtkNew<vtkTable> table;
  index->CastRay(&ray[0], &ray[3], endless, table);
  const auto number = [&](vtkIdType row, const char* column)
  { return table->GetValueByName(row, column).ToDouble(); };
  const auto part = [&](vtkIdType row)
  { return index->GetPartName(table->GetValueByName(row, "part").ToInt()); };
  for (vtkIdType row = 0; row < table->GetNumberOfRows(); ++row)
  {
    CrossedSurface crossing{ part(row), number(row, "distance"), {}, number(row, "entering") > 0 };
    vtkDataArray::SafeDownCast(table->GetColumnByName("position"))
      ->GetTuple(row, crossing.Position.data());
    answer.Crossings.push_back(crossing);
  }
  index->FindWalls(&ray[0], &ray[3], endless, table);
  for (vtkIdType row = 0; row < table->GetNumberOfRows(); ++row)
  {
    answer.Walls.push_back({ part(row), number(row, "start"), number(row, "end") });
  }
  return answer;
}

NearestAnswer AskNearest(vtkAssemblyIndex* index, const std::string& text)
{
  const std::vector<double> point = Numbers("--nearest", text, 3, "X,Y,Z, a point");
  NearestAnswer answer;
  const int part = index->FindNearest(point.data(), answer.Position.data());
  if (part < 0)
  {
    throw InputError("--nearest", "no part has triangles");
  }
  answer.Part = index->GetPartName(part);
  answer.Distance =
    std::sqrt(vtkMath::Distance2BetweenPoints(point.data(), answer.Position.data()));
  return answer;
}

std::vector<std::string> AskBox(vtkAssemblyIndex* index, const std::string& text, bool isWholly)
{
  const std::string form = "XMIN,XMAX,YMIN,YMAX,ZMIN,ZMAX, a box";
  const std::vector<double> box = Numbers("--box", text, 6, form);
  if (box[0] > box[1] || box[2] > box[3] || box[4] > box[5])
  {
    throw InputError("--box", "'" + text + "' is not " + form + ": a MIN is above its MAX");
  }
  vtkNew<vtkIdList> parts;
  index->FindPartsInBox(box.data(), isWholly, parts);
  return Names(index, parts);
}

std::vector<std::string> AskSphere(vtkAssemblyIndex* index, const std::string& text, bool isWholly)
{
  const std::string form = "X,Y,Z,R, a centre and a radius of at least 0";
  const std::vector<double> sphere = Numbers("--sphere", text, 4, form);
  if (sphere[3] < 0.0)
  {
    throw InputError("--sphere", "'" + text + "' is not " + form);
  }
  vtkNew<vtkIdList> parts;
  index->FindPartsInSphere(sphere.data(), sphere[3], isWholly, parts);
  return Names(index, parts);
}

DistanceAnswer AskDistance(vtkAssemblyIndex* index, const std::array<int, 2>& parts)
{
  for (const int part : parts)
  {
    if (index->GetPartNumberOfTriangles(part) == 0)
    {
      throw InputError("--distance", "'" + index->GetPartName(part) + "' has no triangles");
    }
  }
  DistanceAnswer answer;
  answer.Parts = Names(index, parts);
  answer.Distance =
    index->GetDistance(parts[0], parts[1], answer.Positions[0].data(), answer.Positions[1].data());
  return answer;
}

QueryAnswers Ask(const QueryOptions& options, const Scene& scene)
{
  const vtkSmartPointer<vtkAssemblyIndex> index = MakePartIndex(scene);
  QueryAnswers answers;
  answers.Scene = scene.Name;
  if (options.Ray)
  {
    answers.Ray = AskRay(index, *options.Ray);
  }
  if (options.Nearest)
  {
    answers.Nearest = AskNearest(index, *options.Nearest);
  }
  if (options.Box)
  {
    answers.InBox = AskBox(index, *options.Box, options.IsWholly);
  }
  if (options.Sphere)
  {
    answers.InSphere = AskSphere(index, *options.Sphere, options.IsWholly);
  }
  if (options.Distance)
  {
    answers.Distance = AskDistance(index, TwoParts(scene, "--distance", *options.Distance));
  }
  if (options.Sees)
  {
    const std::array<int, 2> parts = TwoParts(scene, "--sees", *options.Sees);
    answers.Sight = SightAnswer{ Names(index, parts), index->MaySee(parts[0], parts[1], nullptr) };
  }
  return answers;
}

void Query(const QueryOptions& options)
{
  if (!options.Ray && !options.Nearest && !options.Box && !options.Sphere && !options.Distance &&
    !options.Sees)
  {
    throw InputError(
      "query", "asks nothing; give --ray, --nearest, --box, --sphere, --distance or --sees");
  }
  CheckJsonPath(options.Json);
  CheckIsNoInput(options.Json, options.Scene.Inputs);
  Progress progress;
  progress.Show("reading the scene");
  const Scene scene = LoadScene(options.Scene);
  progress.Show("measuring");
  const QueryAnswers answers = Ask(options, scene);
  progress.Hide();
  PrintOmissions(scene);
  WriteReport(options.Json, ToText(answers), ToJson(answers));
}
}

void AddQueryCommand(CLI::App& app)
{
  auto options = std::make_shared<QueryOptions>();
  CLI::App* command =
    app.add_subcommand("query", "Measure along a ray, around a point, or between two parts");
  AddMeasuredOptions(*command, options->Scene);
  const auto add = [command](const char* name, std::optional<std::string>& text, const char* type,
                     const char* description)
  { command->add_option(name, text, description)->type_name(type); };
  add("--ray", options->Ray, "X,Y,Z,DX,DY,DZ",
    "surfaces and walls along a ray from a point in a direction");
  add("--nearest", options->Nearest, "X,Y,Z", "the part nearest to a point");
  add("--box", options->Box, "XMIN,XMAX,YMIN,YMAX,ZMIN,ZMAX",
    "parts with a point of their surface in a box");
  add("--sphere", options->Sphere, "X,Y,Z,R", "parts with a point of their surface in a sphere");
  command->add_flag(
    "--wholly", options->IsWholly, "only parts that lie in the box or sphere wholly");
  add("--distance", options->Distance, "A,B", "the least distance of two parts, each a GLOB");
  add("--sees", options->Sees, "A,B",
    "whether two parts may see each other, or others stand between them for sure");
  AddJsonOption(*command, options->Json);
  command->callback([options] { Query(*options); });
}

}
