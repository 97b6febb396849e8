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
 * Orders in which to draw so many parts, each a permutation of their indices: all of them where there are `count` at most,
 * else `count` random ones, which are the same in each run.
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
 * So many steps of 1/100 pixel: in one run if they go through a whole pixel. Fewer would all lie near one place, where edges
 * of a scene may cross no middle of a pixel. They are runs of one step then: the first from the scene's own view, each of the
 * others in its share of the pixel, over a step that changes the picture, which is found by halving; if the picture is the same
 * at both ends of the share, the run begins there.
 */
MotionPlan PlanShifts(int steps, const DoesChange& doesChange);

/**
 * So many steps of a degree: in one run if they go all the way round. Fewer are runs of one step, spread evenly over the turn,
 * since a scene may fail where no step from its own view leads.
 */
MotionPlan PlanTurns(int steps);

}
#endif
