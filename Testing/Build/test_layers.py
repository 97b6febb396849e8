"""scripts/check-layers: each of its rules notices what breaks it, in a tree of a few lines."""

import pathlib
import shutil
import subprocess
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]

# What no rule has anything against.
TREE = {
    "CMakeLists.txt": "add_subdirectory(Examples/study)\n",
    "Examples/benchmarks/CMakeLists.txt": "target_link_libraries(CoreBenchmarks PRIVATE VitrineStudy)\n",
    "Examples/minimal/minimal.cxx": "#include <vtkSeeThroughPass.h>\n",
    "Examples/study/image/Flip.h": '#include "Core/geometry/Box.h"\n',
    "Examples/vitrine/commands/Chart.h": '#include "study/image/Flip.h"\n',
    "Module/CMakeLists.txt": "",
    "Module/Core/culling/hidden/HiddenFaces.h": '#include "Core/culling/steady/FaceBlock.h"\n',
    "Module/Core/culling/steady/FaceBlock.h": '#include "Core/geometry/Box.h"\n',
    "Module/Core/culling/walk/PartCuller.h": '#include "Core/threads/WorkerThreads.h"\n',
    "Module/Core/geometry/Box.h": "#include <glm/vec3.hpp>\n",
    "Module/Core/lighting/LightTree.h": '#include "Core/geometry/Box.h"\n',
    "Module/Core/threads/WorkerThreads.h": "#include <thread>\n",
    "Module/Shaders/SharedLayout.h": "",
    "Module/culling/PartRules.h": '#include "scene/ActorRules.h"\n',
    "Module/frame/vtkSeeThroughPass.h": '#include "vtkTruthTransparencyPass.h"\n',
    "Module/gl/GLObjects.h": '#include "Shaders/SharedLayout.h"\n',
    "Module/lighting/deferred/GBuffer.cxx": '#include "lighting/forward/LightLoop.h"\n',
    "Module/lighting/forward/LightLoop.h": '#include "shader/ShaderTags.h"\n',
    "Module/scene/ActorRules.h": '#include "gl/GLObjects.h"\n#include "vtkActor.h"\n',
    "Module/shader/ShaderTags.h": '#include "gl/GLObjects.h"\n',
    "Module/transparency/common/FillShader.h": '#include "shader/ShaderTags.h"\n',
    "Module/transparency/truth/vtkTruthTransparencyPass.h": '#include "vtkRenderPass.h"\n',
    "Testing/Core/TestFlip.cxx": '#include "study/image/Flip.h"\n#include <gtest/gtest.h>\n',
}

# A line more in a file, and what is said of it.
BREAKS = (
    ("Module/transparency/common/FillShader.h", '#include "culling/PartRules.h"', "transparency/ includes"),
    ("Module/culling/PartRules.h", '#include "vtkTruthTransparencyPass.h"', "culling/ includes"),
    ("Module/scene/ActorRules.h", '#include "lighting/forward/LightLoop.h"', "scene/ includes"),
    ("Module/gl/GLObjects.h", '#include "shader/ShaderTags.h"', "gl/ includes"),
    ("Module/lighting/forward/LightLoop.h", '#include "vtkSeeThroughPass.h"', "lighting/ includes"),
    ("Module/lighting/forward/LightLoop.h", '#include "lighting/deferred/GBuffer.h"', "forward/ includes"),
    ("Module/transparency/common/FillShader.h", '#include "vtkTruthTransparencyPass.h"', "common/ includes"),
    ("Module/Core/geometry/Box.h", '#include "Core/threads/WorkerThreads.h"', "geometry/ includes"),
    ("Module/Core/lighting/LightTree.h", '#include "Core/culling/steady/FaceBlock.h"', "lighting/ includes"),
    ("Module/Core/culling/steady/FaceBlock.h", '#include "Core/culling/hidden/HiddenFaces.h"', "steady/ includes"),
    ("Module/Core/culling/hidden/HiddenFaces.h", '#include "Core/culling/cover/FaceCoverage.h"', "hidden/ includes"),
    ("Module/Core/geometry/Box.h", '#include "gl/GLObjects.h"', "Core/ includes"),
    ("Module/Core/geometry/Box.h", '#include "vtkActor.h"', "Core reaches up"),
    ("Module/Core/geometry/Box.h", "#include <GL/gl.h>", "Core reaches up"),
    ("Module/Core/geometry/Box.h", '#include "study/image/Flip.h"', "Module reaches up"),
    ("Module/culling/PartRules.h", "#include <gtest/gtest.h>", "Module reaches up"),
    ("Module/culling/PartRules.h", '#include "commands/Chart.h"', "Module reaches up"),
    ("Module/frame/vtkSeeThroughPass.h", '#include "gl/GLObjects.h"', "not installed"),
    ("Module/scene/ActorRules.h", '#include "../culling/PartRules.h"', 'has ".."'),
    ("Module/gl/GLObjects.h", '#include "gl/../scene/ActorRules.h"', 'has ".."'),
    ("Examples/study/image/Flip.h", '#include "../../vitrine/commands/Chart.h"', 'has ".."'),
    ("Module/helpers/Helper.h", "", "stands in no room"),
    ("Module/Core/Helper.h", "", "stands in no room"),
    ("Examples/minimal/minimal.cxx", '#include "study/image/Flip.h"', "for the program, tests and benchmarks"),
    ("Examples/study/image/Flip.h", '#include "commands/Chart.h"', "the study library reaches up"),
    ("Module/CMakeLists.txt", "target_link_libraries(Rendering PRIVATE VitrineStudy)", "links the study library"),
    ("CMakeLists.txt", "target_link_libraries(Some PRIVATE VitrineMeshTopology)", "links the study library"),
    ("Module/culling/PartRules.h", 'const char* text = "void main() { }";', "a GLSL body"),
    ("Examples/study/image/Flip.h", '"a;\\n"\n"b;\\n"\n"c;\\n"', "a GLSL body"),
)


class Layers(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.root = pathlib.Path(self.folder.name)
        for name, text in TREE.items():
            self.write(name, text)
        (self.root / "scripts").mkdir()
        shutil.copy(ROOT / "scripts/check-layers", self.root / "scripts")

    def write(self, name, text):
        path = self.root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")

    def check(self):
        return subprocess.run([self.root / "scripts/check-layers"], capture_output=True, text=True)

    def test_nothing_is_said_where_no_rule_is_broken(self):
        result = self.check()
        self.assertEqual((result.returncode, result.stdout, result.stderr), (0, "", ""))

    def test_each_rule_notices_what_breaks_it(self):
        for name, line, message in BREAKS:
            with self.subTest(file=name, line=line):
                self.write(name, TREE.get(name, "") + line + "\n")
                result = self.check()
                self.assertEqual(result.returncode, 1)
                told = [text for text in result.stdout.splitlines() if text.startswith(f"{name}:")]
                self.assertTrue(any(message in text for text in told), result.stdout)
                self.assertEqual(len(result.stdout.splitlines()), len(told))
                if name in TREE:
                    self.write(name, TREE[name])
                else:
                    (self.root / name).unlink()


if __name__ == "__main__":
    unittest.main()
