/**
 * The rounding model of devices and of the culler: the constants behind margins and uncertainties, each with its
 * derivation and its test.
 *
 * A device computes with floats of 24 bits. Each sum, product and quotient rounds by up to half an ulp, which is 2^-24
 * of the result. The device multiplies a point by one matrix, clips to the view, divides by w, and maps the quotient to
 * the window. There it snaps corners to a subpixel grid to find the samples that a face covers. Depths come from a
 * plane through the corners, before or after snapping. A more precise device changes nothing. Most figures are for
 * llvmpipe, which does all of this.
 *
 * Shares are relative to the rounded quantity. Places are in columns and lines. Depths are reversed, from 1 at the near
 * plane to 0 at the far plane. (N. J. Higham: Accuracy and Stability of Numerical Algorithms, 2nd ed., 2002, for sums
 * of rounded terms)
 */
#ifndef VITRINE_CORE_CULLING_SCREEN_DEVICE_MODEL_H
#define VITRINE_CORE_CULLING_SCREEN_DEVICE_MODEL_H

namespace vitrine
{

// ---- One operation ----

/**
 * Rounding of one result of a 24-bit float operation, as a share of the result. Tested by
 * DeviceModel.OneOperationRoundsByHalfAUnitInTheLastPlace.
 */
inline constexpr float RoundingOfFloat = 0x1p-24f;

// ---- From a model to the screen: products of a matrix and a point ----

/**
 * Rounding of one coordinate by the device and the culler, as a share of the sum of the absolute values of all terms of
 * the product. The device rounds the point, the matrix, a product and three sums. So does the culler, whose points are
 * relative to the middle of a mesh. Together this is 12 * 2^-24. The rounding of the later quotient is less than this
 * bound's share of w. Tested by DeviceModel.ProductsOfAMatrixAndAPointRoundByTheirSums and
 * MeshProjection.HasPointsWhereADeviceHasThemWithinTheMargin.
 */
inline constexpr double RoundingOfSums = 12.0 * 0x1p-24;

/**
 * Share of RoundingOfSums that remains if the culler computes points in doubles: the device's six roundings, and the
 * culler's rounding of the point. Tested by the tests of RoundingOfSums and by
 * HiddenFaces.AreFoundInDoublesWhereFloatsTellNothing.
 */
inline constexpr double ShareOfDevice = 7.0 * 0x1p-24 / RoundingOfSums;

/**
 * Rounding in doubles of the sums that lead to a matrix, as a share of them over RoundingOfSums. It is 32 * 2^-52.
 * Tested by DeviceModel.ProductsOfMatricesInDoublesRoundByLess.
 */
inline constexpr double RoundingOfDoubles = 0x1p-47 / RoundingOfSums;

/**
 * Rounding by a device of a quotient by w on its way to the window, as a share of it: a quotient, a product, a sum, and
 * one in reserve. Tested by DeviceModel.QuotientsRoundOnTheirWayToTheWindow.
 */
inline constexpr double RoundingOfQuotients = 0x1p-22;

/**
 * Least w of an occluder, as a multiple of the device's rounding of w. Nearer to the eye, the place of a face is so
 * uncertain that the face hides next to nothing. The limit saves time; no test depends on its value.
 */
inline constexpr double LeastRatio = 2048.0;

/**
 * The limit in place of LeastRatio for a mesh that is cut farther behind the near plane. It lets distant parts be
 * hidden although the near plane is so close to the eye that depths hardly differ. Tested by
 * CoverageWithin.IsKnownWhereTheNearPlaneIsCloseToTheEye.
 */
inline constexpr double FartherRatio = 32768.0;

// ---- In the window: snapping ----

/** OpenGL requires rasterisers to snap corners to a grid of 1/16 pixel or finer (GL_SUBPIXEL_BITS of at least 4). */
inline constexpr int LeastSubpixelBits = 4;

/** Largest number of subpixel bits that is believed. Current rasterisers resolve 1/256 pixel. */
inline constexpr int MostSubpixelBits = 8;

/**
 * Movement of corners by snapping, in grid steps: half a step to the nearest grid point, and a reserve. Tested by
 * DeviceModel.SnappingToTheNearestMovesByHalfAStep.
 */
inline constexpr float SnappedSteps = 0.6f;

/** Additional error of depths: eight steps of a 24-bit depth buffer. */
inline constexpr float SnappedDepth = 0x1p-21f;

/**
 * Rounding of a place in the window, as a share of it, if a device takes depths from a plane relative to the window's
 * corner. The effect is that of depths taken 8 * 2^-24 of the place elsewhere.
 */
inline constexpr float RoundingOfPlaces = 0x1p-21f;

/**
 * Farthest reach of an occluder off the screen, in columns or lines, if samples are half a line away from the screen's
 * borders. The limit shrinks in proportion if samples are closer. A device clips what reaches farther. Its floats then
 * round by as much as the samples are away from the borders, so it may not draw on them. Tested by
 * PartCuller.WhatReachesVeryFarOffTheScreenHidesNothing.
 */
inline constexpr float FarthestOff = 0x1p17f;

// ---- Where a device cuts faces: at the sides of the view, its near and its far plane ----

/**
 * Rounding of a place in the view where a device cuts edges, as a share of the view's size. There are up to four planes
 * in turn, with a product, a sum and a quotient each. Three operations map the place to the window. Together this is 15
 * * 2^-24. Tested by DeviceModel.PlacesWhereEdgesAreCutRoundByFourCuts.
 */
inline constexpr float RoundingOfCuts = 0x1p-20f;

/**
 * Least distance between two places of cuts that a device can tell apart, as a share of the view's width or height. It
 * is an ulp of a sum of half the size. Tested by CutFaces.AreNotKnownWhereAllCornersMayLieOnASide.
 */
inline constexpr float StepOfCuts = 0x1p-25f;

/**
 * A strip of this many snapping movements beside the view's sides must be free of samples. Then faces that are moved
 * there cover none. No test depends on a smaller value.
 */
inline constexpr double StepsOnASide = 2.0;

/**
 * Least distance of corners from the side of the view that cuts a face, as a multiple of the device's error of corners.
 * If a corner is closer, the remainder of the face is unknown. So shares of edges err by a sixth at most. Tested by
 * DeviceModel.SharesOfEdgesThatEndAwayFromTheCutAreKnown.
 */
inline constexpr float LeastAway = 8.0f;

/**
 * Products of two such shares err by less than half. Tested by the same test and by
 * CutFacesOfKind.AreKnownEightAtATimeWhereOneSideCutsThem.
 */
inline constexpr float LeastOfShares = 0.5f;

// ---- Planes of faces ----

/**
 * Tilt of a device's plane of a face, as a share of its depth, per width of the face over its height on the screen. The
 * device subtracts products to find two slopes and the area. Each of the three has two products, and a product has up
 * to four roundings of 2^-24. Tested by CutFacesOfKind.AreNowhereElseThanIsKnown.
 */
inline constexpr float RoundingOfTilt = 24.0f * 0x1p-24f;

/** Further error of a device's plane depth, in units of SnappedDepth. No test depends on a smaller value. */
inline constexpr float StepsOnDevice = 8.0f;

/**
 * The depth of a thin face is unknown. A face is thin if its width is less than ThinOfSnapping times the snapping
 * movement plus ThinOfRounding times the rounding of a column or a line. Rounding moves each corner by at most the root
 * of 2 of that rounding, each by its own amount. Across the face this takes less than three quarters of ThinOfRounding
 * times the rounding at its farthest corner, so that ThinOfSnapping is left. (An affine function that is no larger than
 * a bound at the corners changes by less than twice the bound over the face's width.) Tested by
 * FacePlanes.OfFacesThatAreNotThinRoundingLeavesWhatSnappingTakes.
 */
inline constexpr double ThinOfSnapping = 1.0;
inline constexpr double ThinOfRounding = 4.0;

/**
 * Largest factor by which a device's plane is steeper, for faces that are not thin. It is 4 / (4 - 2 * the root of 2) =
 * 3.41, and a reserve. Tested by the same test and by DeviceModel.FacesAndLinesAreSteeperByWhatTheirCornersMove.
 */
inline constexpr double SteeperOnDevice = 4.2;

// ---- Lines ----

/**
 * Least length of a line on the screen whose depths are known, as a multiple of the error of its ends. The ends of a
 * shorter line may lie side by side. Tested by HiddenLines.ShowWhereTheyAreDrawnBeyondTheirEnds.
 */
inline constexpr double ShortestByMargin = 16.0;

/**
 * Largest factor by which the depths of longer lines are steeper along the line. Both ends err by the root of 2 of the
 * margin, so it is 16 / (16 - 2 * the root of 2) = 1.22, and a reserve. Tested by
 * DeviceModel.FacesAndLinesAreSteeperByWhatTheirCornersMove.
 */
inline constexpr double SteeperByMargin = 1.25;

// ---- The culler's own floats ----

/**
 * Rounding of a few float sums and products, as a share of the absolute terms. It is 8 * 2^-24. Tested by
 * DeviceModel.ProductsOfSidesRoundByTheirSums.
 */
inline constexpr float RoundingOfFloats = 0x1p-21f;

/**
 * Rounding of float sums for a place on an edge, as a share of the farthest column and line from 0 on the edge. It is
 * 16 * 2^-24. Tested by CoverageIsTrue.OfRandomMeshesInRandomViews and OfLongSlimFaces.
 */
inline constexpr float RoundingOnEdges = 0x1p-20f;

/**
 * Rounding of distances from planes in floats, as a share of the distance from the eye to the farthest point of a mesh.
 * It is 4 * 2^-24. Tested by DeviceModel.DistancesFromPlanesRoundByHowFarTheEyeIs.
 */
inline constexpr double RoundingOfDistances = 0x1p-22;

}

#endif
