/**
 * Priorities of observers of a frame's start and of a capture's: who moves planes and fades parts with the camera comes
 * first, then who sets looks of parts, then who reads both. So it does not matter which of them was attached first.
 */
#ifndef VITRINE_SCENE_FRAME_ORDER_H
#define VITRINE_SCENE_FRAME_ORDER_H

namespace vitrine
{

constexpr float FollowsCamera = 1.0f;
constexpr float SetsLooks = 0.0f; ///< VTK's default, which applications use
constexpr float ReadsLooks = -1.0f;

}

#endif
