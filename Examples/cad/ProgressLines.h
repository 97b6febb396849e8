/**
 * How far a conversion has got, as lines for the program that runs it.
 */
#ifndef VITRINE_CAD_PROGRESS_LINES_H
#define VITRINE_CAD_PROGRESS_LINES_H

#include <Message_ProgressIndicator.hxx>
#include <Message_ProgressScope.hxx>

#include <string>

namespace cad
{

/** Prints "progress FRACTION TASK" on stderr where a hundredth of the whole is done, or a task begins. */
class ProgressLines : public Message_ProgressIndicator
{
public:
  explicit ProgressLines(bool isShown)
    : IsShown(isShown)
  {
  }

  /** Begin a task that ends at a fraction of the whole. */
  Message_ProgressRange Begin(const std::string& task, double end);

protected:
  void Show(const Message_ProgressScope& scope, const Standard_Boolean isForced) override;

private:
  void Print(double fraction);

  bool IsShown;
  std::string Task;
  double TaskBegin = 0.0;
  double TaskEnd = 0.0;
  int Shown = -1; ///< hundredths
};

}
#endif
