"""Files that the program reads, and its demo scenes, as parts: `vitrine unpack` reads them in a process of its own.

So there is one reader for each kind, and files that crash a reader end no interpreter.
"""

from __future__ import annotations

import json
import pathlib
import subprocess
import tempfile
from typing import Any, Sequence

from vtkmodules.vtkCommonCore import vtkInformation
from vtkmodules.vtkCommonMath import vtkMatrix4x4
from vtkmodules.vtkIOLegacy import vtkGenericDataObjectReader
from vtkmodules.vtkRenderingCore import vtkProp, vtkProperty, vtkTexture

from . import _cad
from .vtkVitrineRendering import vtkAssemblyActors

KINDS: tuple[str, ...] = (
    *(".3mf", ".obj", ".stl", ".ply"),
    *(".vtp", ".vtu", ".vtm", ".vtpd", ".vtpc", ".vtk", ".vtkhdf"),
)
_TEXTURE = "unlitTex"  # what vtkAssemblyActors takes off parts that are given a colour


def is_demo(source: str) -> bool:
    """Whether a name is that of a scene that the program makes, and of no file."""
    return source.startswith("demo:")


def add_parts(actors: vtkAssemblyActors, source: str) -> list[str]:
    """Add the parts of a file or a demo scene, and return notes of what is shown otherwise than the file says.

    Raises:
        ValueError: the file is damaged, or the scene cannot be had.
        FileNotFoundError: this installation has no program.
    """
    with tempfile.TemporaryDirectory(prefix="vitrine-") as folder:
        _unpack(source, folder)
        pack = json.loads(pathlib.Path(folder, "parts.json").read_text(encoding="utf-8"))
        reader = vtkGenericDataObjectReader()
        reader.SetFileName(str(pathlib.Path(folder, "blocks.vtk")))
        reader.Update()
        blocks: Any = reader.GetOutputDataObject(0)
    textures = [_texture_of(texture, blocks) for texture in pack["textures"]]
    looks: Any = [
        (_property_of(material, textures), _keys_of(material, pack["textures"])) for material in pack["materials"]
    ]
    for part in pack["parts"]:
        geometry, place = blocks.GetBlock(part["geometry"]), _matrix_of(part["place"])
        number = actors.AddPart(geometry, place, *looks[part["material"]], part["translucent"])
        actors.SetPartNames(number, part["name"], part["path"], part["material_name"])
    return _cad.unit_notes(pack["length_unit"]) + list(pack["notes"])


def _unpack(source: str, folder: str) -> None:
    """Have the program write the parts into a folder."""
    from .__main__ import environment, program  # not before: `python -m vitrine` runs that file

    name = source if is_demo(source) else str(pathlib.Path(source).absolute())
    command = [str(program()), "unpack", name, "--to", folder]
    done = subprocess.run(command, env=environment(), capture_output=True, check=False)
    if done.returncode != 0:
        lines = done.stderr.decode("utf-8", "replace").replace("\r", "\n").strip().splitlines()
        problem = lines[-1] if lines else f"{source}: the program that reads it ended with {done.returncode}"
        raise ValueError(problem.removeprefix("vitrine: ").replace(name, source))


def _matrix_of(numbers: Sequence[float] | None) -> vtkMatrix4x4 | None:
    if numbers is None:
        return None
    matrix = vtkMatrix4x4()
    matrix.DeepCopy(numbers)
    return matrix


def _texture_of(told: dict[str, Any], blocks: Any) -> vtkTexture:
    texture = vtkTexture()
    texture.SetInputDataObject(blocks.GetBlock(told["image"]))
    texture.SetInterpolate(told["interpolate"])
    texture.SetRepeat(told["repeat"])
    texture.SetEdgeClamp(told["edge_clamp"])
    texture.SetMipmap(told["mipmap"])
    texture.SetUseSRGBColorSpace(told["srgb"])
    texture.SetColorMode(told["color_mode"])
    return texture


def _keys_of(material: dict[str, Any], textures: list[dict[str, Any]]) -> vtkInformation | None:
    """The keys of actors that have the place of a texture, which a property cannot have."""
    place = textures[material["texture"]]["place"] if material["texture"] is not None else None
    if place is None:
        return None
    renamed = hasattr(vtkProp, "GENERAL_TEXTURE_TRANSFORM")  # in VTK 9.6
    keys = vtkInformation()
    keys.Set(vtkProp.GENERAL_TEXTURE_TRANSFORM() if renamed else vtkProp.GeneralTextureTransform(), place, 16)
    return keys


def _property_of(told: dict[str, Any], textures: list[vtkTexture]) -> vtkProperty:
    made = vtkProperty()
    made.SetMaterialName(told["name"])
    made.SetAmbientColor(told["ambient_color"])
    made.SetDiffuseColor(told["diffuse_color"])
    made.SetSpecularColor(told["specular_color"])
    made.SetAmbient(told["ambient"])
    made.SetDiffuse(told["diffuse"])
    made.SetSpecular(told["specular"])
    made.SetSpecularPower(told["specular_power"])
    made.SetOpacity(told["opacity"])
    made.SetInterpolation(told["interpolation"])
    made.SetRepresentation(told["representation"])
    made.SetPointSize(told["point_size"])
    made.SetLineWidth(told["line_width"])
    made.SetLighting(told["lighting"])
    made.SetBackfaceCulling(told["backface_culling"])
    if told["texture"] is not None:
        made.SetTexture(_TEXTURE, textures[told["texture"]])
    return made
