#include "report/StabilityReport.h"

#include "report/TextTable.h"
#include "stability/Verdict.h"

namespace program
{

namespace
{
const TextRow StabilityHead = { "method", "error/255", "wrong pixels", "repeated", "shuffled",
  "shift/255 (truth)", "shift % (truth)", "turn/255 (truth)", "turn % (truth)", "verdict" };

std::string Steps(double value)
{
  return FormatCell("%.2f", 255.0 * value);
}

/** A method's figure beside truth's. */
std::string Beside(const std::string& method, const std::string& truth)
{
  return method + " (" + truth + ")";
}

std::string LargestCell(const Flicker& flicker)
{
  return Beside(Steps(flicker.Method.Largest), Steps(flicker.Truth.Largest));
}

std::string ChangedCell(const Flicker& flicker)
{
  return Beside(FormatCell("%.2f", 100.0 * flicker.Method.ChangedPixels),
    FormatCell("%.2f", 100.0 * flicker.Truth.ChangedPixels));
}

TextRow ToCells(const StabilityCell& cell)
{
  if (!cell.Skipped.empty())
  {
    return { cell.Method, cell.Verdict };
  }
  return { cell.Method, Steps(cell.Error->Max),
    FormatCell("%.2f %%", 100.0 * cell.Error->WrongPixels),
    std::to_string(cell.RepetitionDifference), std::to_string(cell.OrderDifference),
    LargestCell(cell.Shift), ChangedCell(cell.Shift), LargestCell(cell.Turn),
    ChangedCell(cell.Turn), cell.Verdict };
}

/**
 * Returns what verdicts do not tell: refusals and larger errors in other windows, why these have no truth, and VTK's
 * messages.
 */
std::string Remarks(const StabilityCell& cell)
{
  std::string lines;
  for (const OtherWindow& other : cell.Others)
  {
    const std::string place = "  " + cell.Method + ", " + other.Name + ": ";
    if (!other.Skipped.empty())
    {
      lines += place + "refused: " + other.Skipped + "\n";
    }
    else if (!other.NotJudged.empty())
    {
      lines += place + "not judged, there is no truth: " + other.NotJudged + "\n";
    }
    else if (IsWrong(other) && other.Error->Max > cell.OwnWindowError())
    {
      lines += place + "wrong by " + Steps(other.Error->Max) + "/255\n";
    }
  }
  for (const std::string& message : cell.Messages)
  {
    lines += "  " + cell.Method + ": " + message + "\n";
  }
  return lines;
}

std::string Title(const StabilityScene& scene)
{
  return scene.Name == scene.Input ? scene.Name : scene.Name + ", " + scene.Input;
}

/** The cell with the largest error, the first of equals; null if none could run. */
const StabilityCell* WorstOf(const std::vector<StabilityCell>& cells, const std::string& method)
{
  const StabilityCell* worst = nullptr;
  for (const StabilityCell& cell : cells)
  {
    if (cell.Method == method && cell.Skipped.empty() &&
      (!worst || cell.WorstError() > worst->WorstError()))
    {
      worst = &cell;
    }
  }
  return worst;
}

Json FlickerJson(const Flicker& flicker)
{
  return { { "largest", flicker.Method.Largest }, { "typical", flicker.Method.Typical },
    { "changed_pixels", flicker.Method.ChangedPixels }, { "truth_largest", flicker.Truth.Largest },
    { "truth_typical", flicker.Truth.Typical },
    { "truth_changed_pixels", flicker.Truth.ChangedPixels }, { "excess", flicker.Excess },
    { "error", flicker.Error } };
}

Json OtherJson(const OtherWindow& other)
{
  Json row = { { "name", other.Name }, { "width", other.Size.Width },
    { "height", other.Size.Height }, { "multisamples", other.Multisamples } };
  if (!other.Skipped.empty())
  {
    row["skipped"] = other.Skipped;
  }
  else if (!other.NotJudged.empty())
  {
    row["not_judged"] = other.NotJudged;
  }
  else
  {
    row["error"] = ErrorJson(*other.Error);
  }
  return row;
}

Json SettingsJson(const StabilitySettings& settings)
{
  Json json = { { "repetitions", settings.Repetitions }, { "orders", settings.Orders },
    { "shifts", settings.Shifts }, { "turns", settings.Turns } };
  AddCoincidence(json, settings.Tolerance);
  return json;
}
}

std::string TableHead(const StabilityResult& result)
{
  return result.GL.Renderer + "\n\n";
}

std::string SceneTable(const StabilityScene& scene, const std::vector<StabilityCell>& cells)
{
  std::vector<TextRow> rows = { StabilityHead };
  std::string remarks;
  for (const StabilityCell& cell : cells)
  {
    if (cell.Scene == scene.Name)
    {
      rows.push_back(ToCells(cell));
      remarks += Remarks(cell);
    }
  }
  const std::string expected =
    scene.Expectation.empty() ? "" : "Expected: " + scene.Expectation + "\n";
  return Title(scene) + "\n" + expected + AlignColumns(rows) + remarks + "\n";
}

std::string WorstTable(const StabilityResult& result)
{
  std::vector<TextRow> rows = { { "method", "worst error/255", "scene", "frames" } };
  for (const std::string& method : result.Settings.Methods)
  {
    const StabilityCell* worst = WorstOf(result.Cells, method);
    rows.push_back(worst
        ? TextRow{ method, Steps(worst->WorstError()), worst->Scene, worst->Worst().Frames }
        : TextRow{ method, "refused in all scenes" });
  }
  return "Worst scene of each method:\n" + AlignColumns(rows);
}

Json ToJsonRow(const StabilityCell& cell)
{
  Json row = { { "scene", cell.Scene }, { "method", cell.Method }, { "width", cell.Size.Width },
    { "height", cell.Size.Height }, { "outcome", Name(cell.Outcome) },
    { "verdict", cell.Verdict } };
  if (!cell.Skipped.empty())
  {
    row["skipped"] = cell.Skipped;
    return row;
  }
  row["error"] = ErrorJson(*cell.Error);
  row["worst_error"] = cell.WorstError();
  row["worst_frames"] = cell.Worst().Frames;
  row["repetition_difference"] = cell.RepetitionDifference;
  row["order_difference"] = cell.OrderDifference;
  row["redrawn_error"] = cell.RedrawnError;
  row["shift"] = FlickerJson(cell.Shift);
  row["turn"] = FlickerJson(cell.Turn);
  row["others"] = Json::array();
  for (const OtherWindow& other : cell.Others)
  {
    row["others"].push_back(OtherJson(other));
  }
  row["messages"] = cell.Messages;
  return row;
}

Json ScenesJson(const std::vector<StabilityScene>& scenes)
{
  Json list = Json::array();
  for (const StabilityScene& scene : scenes)
  {
    list.push_back({ { "name", scene.Name }, { "input", scene.Input },
      { "opacity", scene.Opacity.value_or(1.0) }, { "expected", scene.Expectation },
      { "zoom_before", scene.ZoomBefore },
      { "width", scene.Size ? Json(scene.Size->Width) : Json(nullptr) },
      { "height", scene.Size ? Json(scene.Size->Height) : Json(nullptr) },
      { "heavy", scene.IsHeavy } });
  }
  return list;
}

std::string ToJson(const StabilityResult& result)
{
  Json document = MeasurementHead(result.GL);
  document["settings"] = SettingsJson(result.Settings);
  document["scenes"] = ScenesJson(result.Settings.Scenes);
  document["results"] = Json::array();
  for (const StabilityCell& cell : result.Cells)
  {
    document["results"].push_back(ToJsonRow(cell));
  }
  return JsonText(document);
}

}
