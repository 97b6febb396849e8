/**
 * Which frames of a scene are tried: orders of its parts, and places of its camera.
 */
#ifndef VITRINE_STUDY_PLAN_H
#define VITRINE_STUDY_PLAN_H

#include <cstddef>
#include <functional>
#include <vector>

namespace program
{

/**
 * Returns orders in which to draw `parts` parts, each a permutation of their indices. These are all orders if there are
 * at most `count`, else `count` random ones, which are the same in each run.
 */
std::vector<std::vector<std::size_t>> PlanOrders(std::size_t parts, int count);

/** Where the camera is, frame by frame. */
struct MotionPlan
{
  std::vector<double> Places; ///< pixels or degrees from the scene's own view, which is the first
  std::size_t RunLength; ///< frames that follow each other by a step; the next run begins elsewhere
};

/** So many steps of 1/100 pixel. */
double InPixels(int steps);

/** Whether a picture is another at b than at a, both in steps of 1/100 pixel. */
using DoesChange = std::function<bool(int a, int b)>;

/**
 * Plan `steps` steps of 1/100 pixel. If they go through a whole pixel, they form one run.
 *
 * Fewer steps would all lie near one place, where edges of a scene may cross no pixel centre. So they are runs of one
 * step. The first begins at the scene's own view. Each other run begins in its share of the pixel, at a step that
 * changes the picture, found by bisection. If the picture is the same at both ends of the share, the run begins there.
 */
MotionPlan PlanShifts(int steps, const DoesChange& doesChange);

/**
 * Plan `steps` steps of one degree. If they go all the way round, they form one run. Fewer are runs of one step, spread
 * evenly over the turn, since a scene may fail far from its own view.
 */
MotionPlan PlanTurns(int steps);

}
#endif
