"""`vitrine models`: the manifest, and what is fetched from a server on this machine."""

import contextlib
import hashlib
import http.server
import json
import os
import pathlib
import re
import socket
import struct
import subprocess
import sys
import threading
import unittest

from program import FileTest, ProgramTest, run, scratch_folder

PROJECT = pathlib.Path(__file__).resolve().parents[2]
OWN = PROJECT / "Examples" / "vitrine" / "models"
DATA = pathlib.Path(os.environ.get("VITRINE_SHARED_DATA", PROJECT.parent / "shared" / "data"))
NO_PROXY = {"no_proxy": "*", "NO_PROXY": "*"}
BYTES = bytes(range(256)) * 1024
OTHER = BYTES[::-1]


class Server(http.server.ThreadingHTTPServer):
    """Has BYTES at /right, and faults at other paths. `asked` are the paths that were asked for."""

    def __init__(self):
        super().__init__(("127.0.0.1", 0), Handler)
        self.asked = []
        threading.Thread(target=self.serve_forever, args=(0.01,), daemon=True).start()

    def address(self, path):
        return f"http://127.0.0.1:{self.server_port}/{path}"


class Handler(http.server.BaseHTTPRequestHandler):
    def do_GET(self):
        self.server.asked.append(self.path)
        answer = {
            "/right": lambda: self.send(BYTES, len(BYTES)),
            "/right%20too": lambda: self.send(BYTES, len(BYTES)),
            "/other": lambda: self.send(OTHER, len(OTHER)),
            "/cut": lambda: self.send(BYTES[:1000], len(BYTES)),
            "/short": lambda: self.send(BYTES[:1000], None),
            "/long": lambda: self.send(BYTES + b"x", None),
            "/moved": lambda: self.redirect("/right"),
            "/to-a-file": lambda: self.redirect("file:///etc/hostname"),
            "/to-ftp": lambda: self.redirect("ftp://127.0.0.1:1/a.stl"),
            "/round": lambda: self.redirect("/round"),
        }.get(self.path)
        if answer:
            answer()
        else:
            self.send_error(404)

    def send(self, content, length):
        self.send_response(200)
        if length is not None:
            self.send_header("Content-Length", str(length))
        self.end_headers()
        with contextlib.suppress(ConnectionError):  # the program hangs up where a file is too long
            self.wfile.write(content)

    def redirect(self, address):
        self.send_response(302)
        self.send_header("Location", address)
        self.end_headers()

    def log_message(self, *_):
        pass


def model(name, **changes):
    """A model of a manifest. A key of None is left out."""
    entry = {
        "name": name,
        "sha256": hashlib.sha256(BYTES).hexdigest(),
        "bytes": len(BYTES),
        "licence": "CC0-1.0",
        "author": "nobody",
        "source": "http://127.0.0.1/",
        "conversion": "none",
        **changes,
    }
    return {key: value for key, value in entry.items() if value is not None}


class Fetch(FileTest):
    @classmethod
    def setUpClass(cls):
        """The program may be built without libcurl. It says so in one line, which is all that it can do then."""
        with scratch_folder() as folder:
            manifest = folder / "manifest.json"
            manifest.write_text('{"format": 1, "models": []}')
            result = run("models", "fetch", "all", "--to", folder / "out", "--manifest", manifest)
            if b"built without" in result.stderr:
                cls().assert_refused(result, "libcurl4-openssl-dev")
                raise unittest.SkipTest("the program was built without libcurl or libcrypto")

    def setUp(self):
        super().setUp()
        self.server = Server()
        self.addCleanup(self.server.server_close)
        self.addCleanup(self.server.shutdown)
        self.out = self.folder / "out"

    def manifest(self, *models):
        return self.write("manifest.json", json.dumps({"format": 1, "models": models}).encode())

    def of(self, path, name="a.stl", **changes):
        return model(name, address=self.server.address(path), **changes)

    def fetch(self, manifest, *names, to=None):
        to = to or self.out
        return run("models", "fetch", *names, "--to", to, "--manifest", manifest, **NO_PROXY)

    def files(self):
        return sorted(path.name for path in self.out.iterdir()) if self.out.exists() else []

    def assert_not_fetched(self, model_of_it, *words):
        """It is refused, and neither a file nor half of one is left."""
        self.assert_refused(self.fetch(self.manifest(model_of_it), model_of_it["name"]), *words)
        self.assertEqual(self.files(), [])

    def test_a_model_is_there_whole(self):
        for path in ("right", "right%20too", "moved"):
            with self.subTest(path=path):
                name = path.replace("%", "-") + ".stl"
                result = self.fetch(self.manifest(self.of(path, name)), name)
                self.assert_done(result)
                self.assertEqual(result.stdout.decode(), f"{name}: fetched\n")
                self.assertEqual((self.out / name).read_bytes(), BYTES)
        self.assertEqual(len(self.files()), 3, "no temporary file is left")

    def test_all_are_those_with_an_address(self):
        others = [model("b.stl", reason="nobody has it"), self.of("right", "c.stl")]
        result = self.fetch(self.manifest(self.of("right"), *others), "all")
        self.assert_done(result)
        self.assertEqual(result.stdout.decode(), "a.stl: fetched\nc.stl: fetched\n")
        self.assertEqual(self.files(), ["a.stl", "c.stl"])

    def test_a_name_that_is_given_twice_is_fetched_once(self):
        self.assert_done(self.fetch(self.manifest(self.of("right")), "a.stl", "all", "a.stl"))
        self.assertEqual(self.server.asked, ["/right"])

    def test_what_is_there_is_not_asked_for_again(self):
        manifest = self.manifest(self.of("right"), self.of("right%20too", "b.stl"))
        self.assert_done(self.fetch(manifest, "a.stl"))
        written = (self.out / "a.stl").stat().st_mtime_ns
        result = self.fetch(manifest, "all")
        self.assert_done(result)
        self.assertEqual(result.stdout.decode(), "a.stl: is there already\nb.stl: fetched\n")
        self.assertEqual(self.server.asked, ["/right", "/right%20too"])
        self.assertEqual((self.out / "a.stl").stat().st_mtime_ns, written)

    def test_a_model_that_was_made_by_hand_is_checked(self):
        manifest = self.manifest(model("b.stl", reason="it is made by a script"))
        self.out.mkdir()
        (self.out / "b.stl").write_bytes(BYTES)
        result = self.fetch(manifest, "b.stl")
        self.assert_done(result)
        self.assertEqual(result.stdout.decode(), "b.stl: is there already\n")

    def test_another_file_of_that_name_is_kept(self):
        self.out.mkdir()
        for content in (OTHER, b"", BYTES[:-1]):
            (self.out / "a.stl").write_bytes(content)
            result = self.fetch(self.manifest(self.of("right")), "a.stl")
            self.assert_refused(result, self.out / "a.stl", "is another file than the manifest's")
            self.assertEqual((self.out / "a.stl").read_bytes(), content)
        self.assertEqual(self.server.asked, [])

    def test_a_folder_of_that_name(self):
        (self.out / "a.stl").mkdir(parents=True)
        result = self.fetch(self.manifest(self.of("right")), "a.stl")
        self.assert_refused(result, self.out / "a.stl", "is a directory")

    def test_wrong_hash(self):
        hashes = [hashlib.sha256(content).hexdigest() for content in (BYTES, OTHER)]
        self.assert_not_fetched(self.of("other"), self.server.address("other"), *hashes)

    def test_wrong_size(self):
        first = f"ended after 1000 of {len(BYTES)} bytes"
        self.assert_not_fetched(self.of("cut"), self.server.address("cut"), first)
        self.assert_not_fetched(self.of("short"), self.server.address("short"), first)
        self.assert_not_fetched(self.of("long"), f"more than the {len(BYTES)} bytes")

    def test_after_a_failure_the_same_command_goes_on(self):
        good, bad = self.of("right"), self.of("cut", "b.stl")
        self.assertEqual(self.fetch(self.manifest(good, bad), "all").returncode, 2)
        self.assertEqual(self.files(), ["a.stl"])
        self.assert_done(self.fetch(self.manifest(good, self.of("right", "b.stl")), "all"))
        self.assertEqual(self.server.asked, ["/right", "/cut", "/right"])

    def test_the_server_says_no(self):
        self.assert_not_fetched(self.of("nowhere"), self.server.address("nowhere"), "status 404")

    def test_redirects_lead_to_servers_and_to_an_end(self):
        self.assert_not_fetched(self.of("to-a-file"), "from the network", '"file"', "disabled")
        self.assert_not_fetched(self.of("to-ftp"), "from the network", '"ftp"', "disabled")
        self.assert_not_fetched(self.of("round"), "cannot be fetched from the network")
        self.assertLess(len(self.server.asked), 10)

    def test_no_network(self):
        with socket.socket() as closed:
            closed.bind(("127.0.0.1", 0))
            address = f"http://127.0.0.1:{closed.getsockname()[1]}/a.stl"
            self.assert_not_fetched(model("a.stl", address=address), address, "from the network")
        address = "http://nowhere.invalid/a.stl"
        self.assert_not_fetched(model("a.stl", address=address), address, "from the network")

    def test_folders_that_cannot_be_written_to(self):
        manifest = self.manifest(self.of("right"))
        file = self.write("file", b"x")
        self.assert_refused(self.fetch(manifest, "a.stl", to=file), file, "is not a folder")
        within = self.folder / "none" / "out"
        self.assert_refused(self.fetch(manifest, "a.stl", to=within), within, "cannot be made")
        # Of Linux: a folder in which root cannot make files either.
        self.assert_refused(self.fetch(manifest, "a.stl", to="/proc"), "/proc/a.stl")
        if os.geteuid() != 0:
            self.out.mkdir(mode=0o555)
            result = self.fetch(manifest, "a.stl")
            self.assert_refused(result, self.out / "a.stl", "its folder may not be written to")

    def test_names_are_checked_before_anything_is_fetched(self):
        manifest = self.manifest(self.of("right"), model("b.stl", reason="nobody has it"))
        self.assert_refused(self.fetch(manifest, "a.stl", "c.stl"), "c.stl: there is no such model")
        words = "b.stl: this model cannot be fetched: nobody has it"
        self.assert_refused(self.fetch(manifest, "a.stl", "b.stl"), words)
        self.assert_refused(self.fetch(manifest), "NAME")
        self.assert_refused(run("models", "fetch", "a.stl", "--manifest", manifest), "--to")
        self.assertEqual((self.server.asked, self.files()), ([], []))

    def test_json_is_of_the_list(self):
        result = run("models", "--json", "-", "fetch", "all", "--to", self.out)
        self.assert_refused(result, "--json")


class Manifest(FileTest):
    def refuse_manifest(self, content, *words):
        path = self.write("manifest.json", content)
        for arguments in ((), ("fetch", "all", "--to", self.folder / "out")):
            result = run("models", *arguments, "--manifest", path)
            self.assert_refused(result, path, *words)
        self.assertFalse((self.folder / "out").exists())

    def refuse_models(self, *models_and_words):
        """The last of some models is bad."""
        words = [item for item in models_and_words if isinstance(item, str)]
        models = [item for item in models_and_words if not isinstance(item, str)]
        document = json.dumps({"format": 1, "models": models}).encode()
        self.refuse_manifest(document, f"of model number {len(models)}", *words)

    def test_what_is_no_manifest(self):
        none = self.folder / "none.json"
        self.assert_refused(run("models", "--manifest", none), none, "there is no such file")
        self.refuse_manifest(b"{", "it is no JSON")
        self.refuse_manifest(b"\xff\xfe", "it is no JSON")
        for text in (b"[]", b"3", b"{}", b'{"format": 1}', b'{"format": 2, "models": []}',
                     b'{"format": 1, "models": {}}'):  # fmt: skip
            self.refuse_manifest(text, "is no manifest of models", "format")

    def test_names_stay_in_the_folder(self):
        for name in ("", "../a", "/a", "a/b", ".a", "..", "-a", "a b", "a\n", "all", None, 3):
            self.refuse_models(model(name, reason="none"), "name")

    def test_models_have_all_keys(self):
        good = model("a", reason="none")
        self.refuse_models(["a"], "name")
        self.refuse_models(model("a"), 'either an "address" or a "reason"')
        both = model("a", reason="none", address="http://127.0.0.1/a")
        self.refuse_models(good, both | {"name": "b"}, 'either an "address" or a "reason"')
        self.refuse_models(good, good, "of a model before it")
        for address in ("file:///etc/hostname", "ftp://127.0.0.1/a", "127.0.0.1/a", "http://a b", "http://a\nb"):
            self.refuse_models(model("a", address=address), "address")
        for sha256 in (None, "", "0" * 63, "A" * 64, "g" * 64, 3):
            self.refuse_models(model("a", reason="none", sha256=sha256), "sha256")
        for size in (None, 0, -1, 1.5, "1", 2**30 + 1, 2**70):
            self.refuse_models(model("a", reason="none", bytes=size), "bytes")
        for key in ("licence", "author", "source", "conversion"):
            for text in (None, "", 3, "a\nb", "\x1b[31m"):
                self.refuse_models(model("a", reason="none", **{key: text}), key, "of one line")
        self.refuse_models(model("a", reason="no\nne"), "reason", "of one line")

    def test_it_is_listed(self):
        models = [model("a.stl", address="http://127.0.0.1/a"), model("b.stl", reason="nobody has it")]
        content = json.dumps({"format": 1, "models": models}).encode()
        path = self.write("manifest.json", content)
        result = run("models", "--manifest", path)
        self.assert_done(result)
        lines = result.stdout.decode().splitlines()
        self.assertEqual(lines[1].split(), ["a.stl", str(len(BYTES)), "yes", "CC0-1.0"])
        self.assertEqual(lines[2].split(), ["b.stl", str(len(BYTES)), "no", "CC0-1.0"])
        self.assertIn("Cannot be fetched: b.stl\n  nobody has it\n", result.stdout.decode())
        result = run("models", "--manifest", path, "--json", "-")
        self.assert_done(result)
        self.assertEqual(result.stdout, content)
        self.assert_refused(run("models", "--manifest", path, "--json", path), path)
        self.assertEqual(path.read_bytes(), content)


class OwnManifest(ProgramTest):
    def setUp(self):
        result = run("models", "--json", "-")
        self.assert_done(result)
        self.models = {entry["name"]: entry for entry in json.loads(result.stdout)["models"]}

    def test_it_is_that_of_the_sources(self):
        text = (OWN / "manifest.json").read_text(encoding="utf-8")
        self.assertEqual({entry["name"]: entry for entry in json.loads(text)["models"]}, self.models)
        self.assertEqual(list(self.models), sorted(self.models, key=str.lower))

    def test_it_has_each_model_of_a_figure(self):
        named = set()
        for page in (*PROJECT.glob("docs/bench/*.md"), *PROJECT.glob("docs/lab/*.md")):
            text = page.read_text(encoding="utf-8")
            named.update(re.findall(r"(?<![\w.-])[\w-]+\.(?:glb|obj|stl|ply|vtp|vtm)\b", text))
        named -= {"model.glb", "_step.glb"}  # a model of one's own; the end of a name
        self.assertGreater(len(named), 25)
        self.assertEqual(named - set(self.models), set())

    def test_its_page_has_each_model(self):
        page = (PROJECT / "docs" / "bench" / "models.md").read_text(encoding="utf-8")
        rows = dict(re.findall(r"^\| `([\w.-]+)` \| ([^|]+?) \|", page, re.M))
        self.assertEqual(rows, {name: entry["licence"] for name, entry in self.models.items()})

    def test_addresses_are_of_a_commit(self):
        """The file at an address of a branch would change."""
        for name, entry in self.models.items():
            with self.subTest(model=name):
                for address in (entry.get("address"), *entry["source"].split(" and ")):
                    self.assertRegex(address or entry["source"], r"^https://[^ ]*/[0-9a-f]{40}/")

    @unittest.skipUnless(DATA.is_dir(), f"there are no models in {DATA}")
    def test_sizes_and_hashes_are_those_of_the_files(self):
        found = {path.name: path for path in DATA.glob("*/*") if path.name in self.models}
        self.assertGreater(len(found), 25)
        for name, path in found.items():
            content = path.read_bytes()
            told = (self.models[name]["bytes"], self.models[name]["sha256"])
            self.assertEqual(told, (len(content), hashlib.sha256(content).hexdigest()), name)


def glb(document, binary=b"\1\2\3\4"):
    text = json.dumps(document).encode()
    text += b" " * (-len(text) % 4)
    chunks = struct.pack("<II", len(text), 0x4E4F534A) + text
    chunks += struct.pack("<II", len(binary), 0x004E4942) + binary
    return struct.pack("<4sII", b"glTF", 2, 12 + len(chunks)) + chunks


class BlendTransmission(FileTest):
    """The script by which models with _blend in their names were made."""

    def convert(self, content):
        source, result = self.write("a.glb", content), self.folder / "b.glb"
        command = [sys.executable, OWN / "blend_transmission.py", source, result]
        return subprocess.run(command, capture_output=True, check=False), result

    def test_transmission_becomes_opacity(self):
        glass = {"KHR_materials_transmission": {"transmissionFactor": 0.5}, "KHR_materials_volume": {}}
        materials = [
            {"name": "steel", "pbrMetallicRoughness": {"baseColorFactor": [1, 0, 0, 1]}},
            {"name": "glass", "extensions": glass},
            {"name": "masked", "alphaMode": "MASK", "extensions": glass,
             "pbrMetallicRoughness": {"baseColorFactor": [0, 1, 0, 0.5]}},
            {"name": "blended", "alphaMode": "BLEND", "extensions": glass,
             "pbrMetallicRoughness": {"baseColorFactor": [0, 0, 1, 0.25]}},
        ]  # fmt: skip
        done, result = self.convert(glb({"asset": {"version": "2.0"}, "materials": materials}))
        self.assertEqual(done.returncode, 0, done.stderr)
        content = result.read_bytes()
        length = struct.unpack("<I", content[12:16])[0]
        self.assertEqual(struct.unpack("<I", content[8:12])[0], len(content))
        self.assertEqual(content[20 + length :], struct.pack("<II", 4, 0x004E4942) + b"\1\2\3\4")
        steel, clear, masked, blended = json.loads(content[20 : 20 + length])["materials"]
        self.assertEqual(steel, materials[0])
        for material, color in ((clear, [1, 1, 1, 0.65]), (masked, [0, 1, 0, 0.325]), (blended, [0, 0, 1, 0.25])):
            self.assertEqual(material["alphaMode"], "BLEND")
            self.assertEqual(material["extensions"], {})
            self.assertEqual(material["pbrMetallicRoughness"]["baseColorFactor"], color)

    def test_what_is_no_glb(self):
        for content in (b"", b"solid a", glb({})[:30], glb({}).replace(b"glTF", b"glTG")):
            done, result = self.convert(content)
            self.assertEqual(done.returncode, 1)
            self.assertIn(b"blend_transmission.py: the source", done.stderr)
            self.assertFalse(result.exists())


if __name__ == "__main__":
    unittest.main()
