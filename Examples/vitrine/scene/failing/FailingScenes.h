/**
 * Generated scenes in which methods of transparency fail. What is expected of each stands in scene/DemoTable.
 */
#ifndef VITRINE_FAILING_SCENES_H
#define VITRINE_FAILING_SCENES_H

#include "scene/DemoScene.h"

namespace program
{

Scene MakeCoincidentScene(const DemoValues& values);
Scene MakeMatingScene(const DemoValues& values);
Scene MakeCrossingScene(const DemoValues& values);
Scene MakeCyclicScene(const DemoValues& values);
Scene MakeGapsScene(const DemoValues& values);
Scene MakeNearFarScene(const DemoValues& values);
Scene MakeLargeCoordinatesScene(const DemoValues& values);
Scene MakeInsideScene(const DemoValues& values);
Scene MakeAtFaceScene(const DemoValues& values);
Scene MakeParallelScene(const DemoValues& values);
Scene MakeNeedlesScene(const DemoValues& values);
Scene MakeSliversScene(const DemoValues& values);
Scene MakeOpaqueScene(const DemoValues& values);
Scene MakeClippedScene(const DemoValues& values);
Scene MakeAlphaTextureScene(const DemoValues& values);
Scene MakeImpostorsScene(const DemoValues& values);
Scene MakeNonFiniteScene(const DemoValues& values);
Scene MakeEmptyScene(const DemoValues& values);

}
#endif
