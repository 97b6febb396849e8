#include "ProgressLines.h"

#include <iostream>

namespace cad
{

Message_ProgressRange ProgressLines::Begin(const std::string& task, double end)
{
  this->Task = task;
  this->TaskBegin = this->TaskEnd;
  this->TaskEnd = end;
  this->Shown = -1;
  this->Print(this->TaskBegin);
  return this->Start();
}

void ProgressLines::Show(const Message_ProgressScope&, const Standard_Boolean)
{
  this->Print(this->TaskBegin + (this->TaskEnd - this->TaskBegin) * this->GetPosition());
}

void ProgressLines::Print(double fraction)
{
  const int hundredths = static_cast<int>(100.0 * fraction);
  if (this->IsShown && hundredths > this->Shown)
  {
    this->Shown = hundredths;
    std::cerr << "progress " << fraction << " " << this->Task << "\n" << std::flush;
  }
}

}
