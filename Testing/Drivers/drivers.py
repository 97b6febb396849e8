"""The drivers that frames are drawn by, and the devices that programs are compiled for."""

from dataclasses import dataclass, field

WITHOUT_FETCH = {"MESA_EXTENSION_OVERRIDE": "-GL_EXT_shader_framebuffer_fetch"}
WITHOUT_POST_DEPTH = {"MESA_EXTENSION_OVERRIDE": "-GL_ARB_post_depth_coverage -GL_EXT_post_depth_coverage"}
# The name is none that Vitrine takes for a driver in software, so that it chooses what it chooses on a device.
AS_A_DEVICE = {"force_gl_renderer": "Another device"}
ZINK = {
    "LIBGL_ALWAYS_SOFTWARE": "1",
    "MESA_LOADER_DRIVER_OVERRIDE": "zink",
    # Debian 12's name of the file, and Debian 13's.
    "VK_ICD_FILENAMES": "/usr/share/vulkan/icd.d/lvp_icd.x86_64.json:/usr/share/vulkan/icd.d/lvp_icd.json",
}
VALIDATION = {
    "VK_INSTANCE_LAYERS": "VK_LAYER_KHRONOS_validation",
    "VK_LAYER_ENABLES": "VK_VALIDATION_FEATURE_ENABLE_SYNCHRONIZATION_VALIDATION_EXT",
}


@dataclass(frozen=True)
class Driver:
    """Draws frames. `fast` ones run in each change's tests, with lights and the culler where they have `effects`.

    A `null` one is the device of that shim. It executes nothing, so its pictures say nothing.
    """

    name: str
    environment: dict = field(default_factory=dict)
    in_root: bool = False
    fast: bool = False
    effects: bool = False
    validated: bool = False
    null: str = ""


@dataclass(frozen=True)
class Device:
    """A null device, for which the driver compiles. The shim's name is one of places.SHIMS."""

    name: str
    shim: str
    environment: dict = field(default_factory=dict)
    in_root: bool = False
    fast: bool = False
    fetch: bool = False  # whether it has framebuffer fetch, so that programs with it are for it


def intel(platform):
    return {"INTEL_STUB_GPU_PLATFORM": platform}


NOUVEAU = {"NOUVEAU_CHIPSET": "160"}  # Turing: the newest that Mesa 22.3 knows

DRIVERS = [
    Driver("llvmpipe", fast=True),
    Driver("llvmpipe, no fetch", WITHOUT_FETCH, fast=True),
    Driver("llvmpipe, no post-depth coverage", WITHOUT_POST_DEPTH, fast=True),
    Driver("llvmpipe as a device", AS_A_DEVICE, fast=True),
    Driver("llvmpipe as a device, no fetch", AS_A_DEVICE | WITHOUT_FETCH, fast=True, effects=True),
    Driver("OpenGL 4.1", {"MESA_GL_VERSION_OVERRIDE": "4.1", "MESA_GLSL_VERSION_OVERRIDE": "410"}, fast=True),
    Driver("OpenGL 3.3", {"MESA_GL_VERSION_OVERRIDE": "3.3", "MESA_GLSL_VERSION_OVERRIDE": "330"}),
    Driver("zink on lavapipe", ZINK, validated=True),
    Driver("Mesa 25.0: llvmpipe", in_root=True),
    Driver("Mesa 25.0: llvmpipe as a device, no fetch", AS_A_DEVICE | WITHOUT_FETCH, in_root=True),
    Driver("Mesa 25.0: zink on lavapipe", ZINK, in_root=True),
    Driver("Intel Xe, null", intel("tgl"), null="intel"),
    Driver("Intel Arc, null", intel("dg2"), null="intel"),
    Driver("nouveau, null", NOUVEAU, null="nouveau"),
    Driver("Mesa 25.0: Intel Xe, null", intel("tgl"), in_root=True, null="intel"),
]

DEVICES = [
    Device("Intel HD 530 (skl)", "intel", intel("skl"), fetch=True),
    Device("Intel Xe (tgl)", "intel", intel("tgl"), fetch=True, fast=True),
    Device("Intel Arc A770M (dg2)", "intel", intel("dg2"), fetch=True),
    Device("Mesa 25.0: Intel HD 530 (skl)", "intel", intel("skl"), in_root=True, fetch=True),
    Device("Mesa 25.0: Intel Xe (tgl)", "intel", intel("tgl"), in_root=True, fetch=True),
    Device("Mesa 25.0: Intel Arc A770M (dg2)", "intel", intel("dg2"), in_root=True, fetch=True),
    Device("nouveau, Turing (NV160)", "nouveau", NOUVEAU),
    Device("AMD Navi 21 (RADV)", "", {"RADV_FORCE_FAMILY": "navi21"}),
]
