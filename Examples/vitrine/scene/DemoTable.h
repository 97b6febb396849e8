/**
 * What generated scenes there are.
 */
#ifndef VITRINE_DEMO_TABLE_H
#define VITRINE_DEMO_TABLE_H

#include "scene/DemoScene.h"

#include <string>
#include <vector>

namespace program
{

struct DemoKey
{
  std::string Name;
  double Default;
  double Minimum;
  double Maximum;
  bool IsInteger;
};

struct Demo
{
  std::string Name;
  std::string Description;
  std::string Expectation;   ///< how methods do on it; empty where all should do well
  std::vector<DemoKey> Keys; ///< at least one
  Scene (*Make)(const DemoValues& values);
};

const std::vector<Demo>& Demos();

}
#endif
