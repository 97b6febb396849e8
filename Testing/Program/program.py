"""Runs the program vitrine and reads what it writes. Standard library only."""

import contextlib
import json
import os
import pathlib
import struct
import subprocess
import tempfile
import unittest
import zlib

PROGRAM = os.environ.get("VITRINE_PROGRAM", "vitrine")
TIMEOUT = 600  # seconds; for hangs only

# Keys of the device in JSON, and of its features.
DEVICE = ["vendor", "renderer", "gl", "storage_block_bytes", "buffer_texture_texels", "samples", "features"]
FEATURES = ["framebuffer_fetch", "interlock", "ballot", "post_depth_coverage"]


def environment_without_display(**changes):
    """Environment variables; some may be added."""
    variables = {key: value for key, value in os.environ.items() if key != "DISPLAY"}
    variables.update({key: value for key, value in changes.items() if value is not None})
    return variables


def run(*arguments, stdout=subprocess.PIPE, **environment):
    """Run the program with no display; environment variables may be added."""
    return subprocess.run(
        [PROGRAM, *map(str, arguments)],
        stdin=subprocess.DEVNULL,
        stdout=stdout,
        stderr=subprocess.PIPE,
        env=environment_without_display(**environment),
        timeout=TIMEOUT,
        check=False,
    )


def info(*arguments):
    """The JSON of `vitrine info` for a small window."""
    return info_at("16x16", *arguments)


def info_at(size, *arguments):
    """The JSON of `vitrine info`."""
    result = run("info", *arguments, "--size", size, "--json", "-")
    if result.returncode != 0:
        raise AssertionError(result.stderr.decode(errors="replace"))
    return json.loads(result.stdout)


def compare(*arguments):
    """The JSON of `vitrine compare`."""
    result = run("compare", *arguments, "--json", "-")
    if result.returncode != 0:
        raise AssertionError(result.stderr.decode(errors="replace"))
    return json.loads(result.stdout)


@contextlib.contextmanager
def scratch_folder():
    with tempfile.TemporaryDirectory() as folder:
        yield pathlib.Path(folder)


def png(rows, alpha=False):
    """The bytes of a PNG of rows from the top, of tuples of 8-bit RGB or RGBA."""
    raw = b"".join(b"\0" + bytes(value for pixel in row for value in pixel) for row in rows)
    header = struct.pack(">IIBBBBB", len(rows[0]), len(rows), 8, 6 if alpha else 2, 0, 0, 0)
    chunks = ((b"IHDR", header), (b"IDAT", zlib.compress(raw)), (b"IEND", b""))
    return b"\x89PNG\r\n\x1a\n" + b"".join(
        struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))
        for kind, body in chunks
    )


def paeth(left, up, corner):
    estimate = left + up - corner
    distances = [abs(estimate - left), abs(estimate - up), abs(estimate - corner)]
    return (left, up, corner)[distances.index(min(distances))]


def unfilter(kind, line, before, step):
    """Undo a PNG filter (PNG specification, section 9)."""
    line = bytearray(line)
    for i, value in enumerate(line):
        left = line[i - step] if i >= step else 0
        corner = before[i - step] if i >= step else 0
        guess = (0, left, before[i], (left + before[i]) // 2, paeth(left, before[i], corner))
        line[i] = (value + guess[kind]) & 255
    return line


def read_png(path):
    """An 8-bit RGB picture: its width, its height and its rows of bytes, from the top."""
    data = pathlib.Path(path).read_bytes()
    if data[:8] != b"\x89PNG\r\n\x1a\n":
        raise AssertionError(f"{path} is no PNG")
    position, compressed = 8, b""
    while position < len(data):
        length, kind = struct.unpack(">I4s", data[position : position + 8])
        body = data[position + 8 : position + 8 + length]
        if kind == b"IHDR":
            width, height, depth, color = struct.unpack(">IIBB", body[:10])
        elif kind == b"IDAT":
            compressed += body
        position += 12 + length
    if (depth, color) != (8, 2):
        raise AssertionError(f"{path} is not 8-bit RGB")
    raw, step = zlib.decompress(compressed), 3
    rows, before = [], bytearray(width * step)
    for y in range(height):
        begin = y * (width * step + 1)
        before = unfilter(raw[begin], raw[begin + 1 : begin + 1 + width * step], before, step)
        rows.append(before)
    return width, height, rows


class ProgramTest(unittest.TestCase):
    def assert_refused(self, result, *words):
        """One line on stderr that begins with the program's name and has the words; status 2."""
        said = result.stderr.decode(errors="replace")
        self.assertEqual(result.returncode, 2, said)
        self.assertTrue(said.startswith("vitrine: "), said)
        self.assertEqual(said.count("\n"), 1, said)
        self.assertTrue(said.endswith("\n"), said)
        for word in words:
            self.assertIn(str(word), said)
        self.assertEqual(result.stdout, b"")

    def assert_done(self, result):
        self.assertEqual(result.returncode, 0, result.stderr.decode(errors="replace"))
        self.assertEqual(result.stderr, b"")


class FileTest(ProgramTest):
    """Tests with a folder for their files."""

    def setUp(self):
        manager = scratch_folder()
        self.folder = manager.__enter__()
        self.addCleanup(manager.__exit__, None, None, None)

    def write(self, name, content):
        path = self.folder / name
        path.write_bytes(content)
        return path

    def refuse(self, name, content, *words):
        path = self.write(name, content)
        result = run("info", path, "--size", "8x8")
        self.assert_refused(result, path, *words)
        self.assertNotIn(b"crashed", result.stderr)
