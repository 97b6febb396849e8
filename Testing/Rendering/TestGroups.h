/**
 * Methods with a tolerance for coincidence, and plates that coincide.
 */
#ifndef VITRINE_TEST_GROUPS_H
#define VITRINE_TEST_GROUPS_H

#include "TestMethods.h"
#include "TestScene.h"

#include <cstdint>
#include <vector>

/** A tolerance, and noise that it takes in: of heights over two units of depth. */
constexpr double Steps = 64.0;
constexpr double Noise = Steps / (1 << 24);

/** Set the tolerance of a pass that has one. */
void SetTolerance(vtkTransparencyPass* pass, double steps, double slope = 0.0);

/** A new pass of the method, with a tolerance. */
vtkSmartPointer<vtkTransparencyPass> MakeTolerant(
  const Method& method, double steps = Steps, double slope = 0.0);

/** Those of AllMethods() that have a tolerance. */
std::vector<Method> TolerantMethods();

/** Plates in groups, front to back, each group of one height. */
struct Groups
{
  std::vector<Rgba> Plates;
  std::vector<double> Heights;
  std::vector<int> Sizes;
};

/** So many layers of random colours, in groups of these sizes in turn. */
Groups RandomGroups(int layers, const std::vector<int>& sizes, double alpha, std::uint64_t seed);

/** The heights, each a little nearer. */
std::vector<double> Noisy(const std::vector<double>& heights, std::uint64_t seed);

/** What groups look like of which each is the mean over all its orders. */
Rgba ClosedForm(const Groups& groups);

#endif
