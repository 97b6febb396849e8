"""glTF documents that are valid JSON and make no sense."""

import base64
import json
import unittest

import scenes
from program import FileTest, info, run


class BadDocuments(FileTest):
    def refuse_document(self, change, *words):
        document = scenes.gltf_document(168)
        change(document)
        self.refuse("bad.glb", scenes.pack_glb(document, scenes.gltf_binary()), *words)

    def test_required_extensions(self):
        for extension in ("KHR_texture_basisu", "KHR_animation_pointer", "ACME_anything"):

            def require(document, extension=extension):
                document["extensionsRequired"] = [extension]

            self.refuse_document(require, extension)

    def test_references_beyond_their_arrays(self):
        changes = {
            "scene": lambda d: d.update(scene=1),
            "scene node": lambda d: d["scenes"][0].update(nodes=[3]),
            "child": lambda d: d["nodes"][0].update(children=[99]),
            "mesh": lambda d: d["nodes"][1].update(mesh=2),
            "skin": lambda d: d["nodes"][1].update(skin=0),
            "attribute": lambda d: d["meshes"][0]["primitives"][0]["attributes"].update(NORMAL=2),
            "indices": lambda d: d["meshes"][0]["primitives"][0].update(indices=-1),
            "material": lambda d: d["meshes"][0]["primitives"][0].update(material=2),
            "view": lambda d: d["accessors"][0].update(bufferView=2),
            "buffer": lambda d: d["bufferViews"][0].update(buffer=1),
            "texture": lambda d: d["materials"][0].update(normalTexture={"index": 0}),
            "text": lambda d: d["nodes"][1].update(mesh="0"),
            "fraction": lambda d: d["nodes"][1].update(mesh=0.5),
        }
        for name, change in changes.items():
            with self.subTest(reference=name):
                self.refuse_document(change, "damaged", "there are")

    def test_accessors_beyond_their_buffers(self):
        changes = {
            "count": lambda d: d["accessors"][0].update(count=9),
            "no elements": lambda d: d["accessors"][0].update(count=0),
            "huge count": lambda d: d["accessors"][0].update(count=2**40),
            "negative offset": lambda d: d["accessors"][0].update(byteOffset=-4),
            "offset": lambda d: d["accessors"][0].update(byteOffset=4),
            "view length": lambda d: d["bufferViews"][0].update(byteLength=1000),
            "view offset": lambda d: d["bufferViews"][1].update(byteOffset=100),
            "stride": lambda d: d["bufferViews"][0].update(byteStride=16),
            "type": lambda d: d["accessors"][0].update(type="VEC5"),
            "component": lambda d: d["accessors"][0].update(componentType=5124),
            "buffer length": lambda d: d["buffers"][0].update(byteLength=1000),
            "sparse": lambda d: d["accessors"][0].update(
                sparse={
                    "count": 5,
                    "indices": {"bufferView": 1, "componentType": 5123, "byteOffset": 70},
                    "values": {"bufferView": 0, "byteOffset": 0},
                }
            ),
        }
        for name, change in changes.items():
            with self.subTest(accessor=name):
                self.refuse_document(change)

    def test_primitives_that_make_no_sense(self):
        def primitive(document):
            return document["meshes"][0]["primitives"][0]

        changes = {
            "mode": lambda d: primitive(d).update(mode=7),
            "position type": lambda d: primitive(d).update(attributes={"POSITION": 1}),
            "color count": lambda d: primitive(d)["attributes"].update(COLOR_0=1),
            "signed indices": lambda d: d["accessors"][1].update(componentType=5122),
            "primitives": lambda d: d["meshes"][0].update(primitives=3),
        }
        for name, change in changes.items():
            with self.subTest(primitive=name):
                self.refuse_document(change)

    def test_nodes_that_form_no_tree(self):
        changes = {
            "own child": lambda d: d["nodes"][1].update(children=[1]),
            "cycle": lambda d: d["nodes"][1].update(children=[0]),
            "two parents": lambda d: d["nodes"][1].update(children=[2]),
            "no scenes": lambda d: d.update(scenes=[]),
        }
        for name, change in changes.items():
            with self.subTest(nodes=name):
                self.refuse_document(change)

    def test_deep_nodes(self):
        document = scenes.gltf_document(168)
        document["nodes"] += [{"children": [4 + i]} for i in range(100000)] + [{"mesh": 0}]
        document["scenes"][0]["nodes"] = [3]
        self.refuse("deep.glb", scenes.pack_glb(document, scenes.gltf_binary()), "tree")

    def test_matrix_that_is_not_finite(self):
        document = scenes.gltf_document(168)
        text = json.dumps(document).replace("1.5", "1e39", 1)
        uri = "data:;base64," + base64.b64encode(scenes.gltf_binary()).decode()
        text = text.replace('"byteLength": 168}', f'"byteLength": 168, "uri": "{uri}"}}')
        self.refuse("far.gltf", text.encode())

    def test_buffer_that_is_not_there(self):
        document = scenes.gltf_document(168, "nowhere.bin")
        path = self.write("lonely.gltf", json.dumps(document).encode())
        self.assert_refused(run("info", path), "nowhere.bin", "is not there")

    def test_image_that_is_damaged_is_noted(self):
        for image in (b"\x89PNG\r\n\x1a\n" + bytes(40), b"\xff\xd8\xff\xe0" + bytes(40), b"what"):
            uri = "data:image/png;base64," + base64.b64encode(image).decode()

            document = scenes.gltf_document(168)
            document["images"] = [{"uri": uri, "name": "grain"}]
            document["textures"] = [{"source": 0}]
            document["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"] = {"index": 0}
            path = self.write("grain.glb", scenes.pack_glb(document, scenes.gltf_binary()))
            self.assertIn("picture 'grain' is no PNG or JPEG", "; ".join(info(path)["notes"]))


if __name__ == "__main__":
    unittest.main()
