/**
 * How a device rounds, and how the culler does: the constants that margins and doubts are made of, each with its
 * derivation and the test that holds it.
 *
 * The model. A device has floats of 24 bits: it rounds each sum, product and quotient by up to half a unit in the
 * last place, 2^-24 of the result. It multiplies a point by one matrix, cuts what reaches beyond the view, divides
 * by w, takes what comes of it to the window, and moves corners to a grid there to find which samples a face covers.
 * Depths are those of a plane through the corners, before or after they are moved. A device may do better, which
 * changes nothing; llvmpipe, which most figures are of, does all of it.
 *
 * Shares are of what is rounded. Places are in columns and lines, depths reversed, from 1 at the near plane to 0 at
 * the far one. (N. J. Higham: Accuracy and Stability of Numerical Algorithms, 2nd ed., 2002, for sums of rounded
 * terms)
 */
#ifndef VITRINE_CORE_CULLING_SCREEN_DEVICE_MODEL_H
#define VITRINE_CORE_CULLING_SCREEN_DEVICE_MODEL_H

namespace vitrine
{

// ---- One operation ----

/**
 * What a float of 24 bits rounds of one result, as a share of it. Held by
 * DeviceModel.OneOperationRoundsByHalfAUnitInTheLastPlace.
 */
inline constexpr float RoundingOfFloat = 0x1p-24f;

// ---- From a model to the screen: products of a matrix and a point ----

/**
 * What a device and the culler round of a coordinate, as a share of the sum of the absolute values of all terms of
 * the product: a device rounds the point, the matrix, a product and three sums, and so does the culler, whose points
 * count from the middle of a mesh. That is twelve times 2^-24. What each rounds of the quotient that comes of it is
 * less than what this has of its w. Held by DeviceModel.ProductsOfAMatrixAndAPointRoundByTheirSums and
 * MeshProjection.HasPointsWhereADeviceHasThemWithinTheMargin.
 */
inline constexpr double RoundingOfSums = 12.0 * 0x1p-24;

/**
 * What is left of that, as a share of it, for points that the culler finds in doubles: the device's six roundings,
 * and one of the culler's, of the point. Held by the former, and by
 * HiddenFaces.AreFoundInDoublesWhereFloatsTellNothing.
 */
inline constexpr double ShareOfDevice = 7.0 * 0x1p-24 / RoundingOfSums;

/**
 * What doubles round of sums that lead to a matrix, as a share of them over RoundingOfSums: 32 times 2^-52. Held by
 * DeviceModel.ProductsOfMatricesInDoublesRoundByLess.
 */
inline constexpr double RoundingOfDoubles = 0x1p-47 / RoundingOfSums;

/**
 * What a device rounds of quotients by w that it takes to the window: a quotient, a product and a sum, and one to
 * spare. Held by DeviceModel.QuotientsRoundOnTheirWayToTheWindow.
 */
inline constexpr double RoundingOfQuotients = 0x1p-22;

/**
 * Least w of what hides, over what a device rounds of it. Nearer to the eye so little is known of where a face is
 * drawn that it hides next to nothing: this saves time, and no test notices another number.
 */
inline constexpr double LeastRatio = 2048.0;

/**
 * The same where a mesh is cut farther behind the near plane: there what is far off is hidden, too, though the near
 * plane is so close to the eye that depths hardly differ. Held by
 * CoverageWithin.IsKnownWhereTheNearPlaneIsCloseToTheEye.
 */
inline constexpr double FartherRatio = 32768.0;

// ---- In the window: snapping ----

/** OpenGL has rasterisers move corners to a grid of at least 1/16 of a pixel (GL_SUBPIXEL_BITS of 4). */
inline constexpr int LeastSubpixelBits = 4;

/** Those of today tell 1/256 of a pixel. Finer ones are not believed to be. */
inline constexpr int MostSubpixelBits = 8;

/**
 * By how much corners are moved, in steps of that grid: half of one to the nearest, and some to spare. Held by
 * DeviceModel.SnappingToTheNearestMovesByHalfAStep.
 */
inline constexpr float SnappedSteps = 0.6f;

/** By how much depths may be off besides: eight steps of a depth buffer of 24 bits. */
inline constexpr float SnappedDepth = 0x1p-21f;

/**
 * What floats round of a place in the window, as a share of it, where a device takes depths from a plane that counts
 * from the window's corner: as if it took them eight times 2^-24 elsewhere.
 */
inline constexpr float RoundingOfPlaces = 0x1p-21f;

/**
 * How far off the screen what hides may reach, in columns or lines, where samples are half a line away from its
 * borders; in proportion where they are closer. A device clips what reaches farther, and its floats then round by as
 * much as the samples are away from the borders, so that it may draw nothing on them. Held by
 * PartCuller.WhatReachesVeryFarOffTheScreenHidesNothing.
 */
inline constexpr float FarthestOff = 0x1p17f;

// ---- Where a device cuts faces: at the sides of the view, its near and its far plane ----

/**
 * What a device rounds of a place in the view, where it cuts edges, as a share of the view's size: up to four planes
 * one after the other, at each of which it multiplies, sums and divides, and three operations that take the place to
 * the window: fifteen times 2^-24. Held by DeviceModel.PlacesWhereEdgesAreCutRoundByFourCuts.
 */
inline constexpr float RoundingOfCuts = 0x1p-20f;

/**
 * No two places that a device tells apart there are closer, as a share of the view's width or height: a step of a
 * sum of half of either. Held by CutFaces.AreNotKnownWhereAllCornersMayLieOnASide.
 */
inline constexpr float StepOfCuts = 0x1p-25f;

/**
 * No samples are so few steps of snapping beside the view's sides: what is moved there covers none. No test notices
 * a smaller number.
 */
inline constexpr double StepsOnASide = 2.0;

/**
 * Corners are so many times as far away from the side of the view that cuts a face as a device may have them
 * elsewhere, or it is not known what the cut leaves: so shares of edges are off by a sixth at most. Held by
 * DeviceModel.SharesOfEdgesThatEndAwayFromTheCutAreKnown.
 */
inline constexpr float LeastAway = 8.0f;

/**
 * And products of two shares by less than half. Held by the same test, and
 * CutFacesOfKind.AreKnownEightAtATimeWhereOneSideCutsThem.
 */
inline constexpr float LeastOfShares = 0.5f;

// ---- Planes of faces ----

/**
 * By how much of its depth a device's plane of a face tilts, times how many times as wide the face is on the screen
 * as it is high: it subtracts products one from another to find two slopes and the area. A product has up to four
 * roundings by 2^-24, and there are two products to each of the three. Held by
 * CutFacesOfKind.AreNowhereElseThanIsKnown.
 */
inline constexpr float RoundingOfTilt = 24.0f * 0x1p-24f;

/** What a device may have of a plane's depth besides, in units of SnappedDepth. No test notices a smaller number. */
inline constexpr float StepsOnDevice = 8.0f;

/**
 * Of faces that are thinner than so many times what a device snaps by, and so many times what its floats round of a
 * column or a line, no depth is known. Corners that those round move by the root of 2 of that at most, each by its
 * own distance: across the face that takes less than three quarters of ThinOfRounding times as much as at its
 * farthest corner, so that ThinOfSnapping is left. (Whatever is affine on the screen, and no more than that at the
 * corners, changes by less than twice as much over the face's width.) Held by
 * FacePlanes.OfFacesThatAreNotThinRoundingLeavesWhatSnappingTakes.
 */
inline constexpr double ThinOfSnapping = 1.0;
inline constexpr double ThinOfRounding = 4.0;

/**
 * By how many times a device's planes of faces that are no thinner are steeper at most: 4 / (4 - 2 * the root of 2),
 * which is 3.41, and some to spare. Held by the same test and
 * DeviceModel.FacesAndLinesAreSteeperByWhatTheirCornersMove.
 */
inline constexpr double SteeperOnDevice = 4.2;

// ---- Lines ----

/**
 * Of lines that are shorter on the screen than so many times what their ends may be off nothing is known: the ends
 * may lie side by side. Held by HiddenLines.ShowWhereTheyAreDrawnBeyondTheirEnds.
 */
inline constexpr double ShortestByMargin = 16.0;

/**
 * By how many times depths of longer ones are steeper at most, along the line between ends that are off by the root
 * of 2 of that each: 16 / (16 - 2 * the root of 2), which is 1.22, and some to spare. Held by
 * DeviceModel.FacesAndLinesAreSteeperByWhatTheirCornersMove.
 */
inline constexpr double SteeperByMargin = 1.25;

// ---- The culler's own floats ----

/**
 * What a few sums and products in floats round, as a share of all terms: eight times 2^-24. Held by
 * DeviceModel.ProductsOfSidesRoundByTheirSums.
 */
inline constexpr float RoundingOfFloats = 0x1p-21f;

/**
 * What sums in floats round of a place on an edge, as a share of the column and the line farthest from 0 on it:
 * sixteen times 2^-24. Held by CoverageIsTrue.OfRandomMeshesInRandomViews and OfLongSlimFaces.
 */
inline constexpr float RoundingOnEdges = 0x1p-20f;

/**
 * What floats round of distances from planes, as a share of the distance from the eye to the farthest point of a
 * mesh: four times 2^-24. Held by DeviceModel.DistancesFromPlanesRoundByHowFarTheEyeIs.
 */
inline constexpr double RoundingOfDistances = 0x1p-22;

}

#endif
