"""STEP, IGES and BREP by way of a converter, which is a script here: what is run, what is kept, what goes wrong."""

import os
import unittest

import scenes
from program import FileTest, run

# Answers as vitrine-cad does. FAKE_DOES tells what it does with a file.
CONVERTER = """#!/bin/sh
if [ "$1" = --version ]; then
  echo "${FAKE_VERSION:-fake 1}"
  exit "${FAKE_STATUS_OF_VERSION:-0}"
fi
echo "$@" >> "$FAKE_FOLDER/calls"
echo "progress 0.5 making triangles" >&2
case "$FAKE_DOES" in
  refuse) echo "fake: $1: is a bad file" >&2; exit 2 ;;
  fail) exit 3 ;;
  crash) echo half > "$2"; kill -SEGV $$ ;;
  nothing) exit 0 ;;
  garbage) echo garbage > "$2" ;;
  noisy) head -c 300000 /dev/zero >&2; head -c 300000 /dev/zero; cp "$FAKE_FOLDER/made.glb" "$2" ;;
  leave) echo half > "$2.part"; exit 2 ;;
  *) cp "$FAKE_FOLDER/made.glb" "$2" ;;
esac
"""


class FakeConverter(FileTest):
    def setUp(self):
        super().setUp()
        self.cache = self.folder / "cache"
        self.calls = self.folder / "calls"
        self.converter = self.folder / "a converter.sh"
        self.converter.write_text(CONVERTER)
        self.converter.chmod(0o755)
        self.write("made.glb", scenes.glb())
        self.model = self.write("box.step", b"some STEP")

    def info(self, path=None, *options, **environment):
        variables = {
            "VITRINE_CAD_CONVERTER": str(self.converter),
            "XDG_CACHE_HOME": str(self.cache),
            "TMPDIR": str(self.folder),
            "FAKE_FOLDER": str(self.folder),
            **environment,
        }
        return run("info", path or self.model, "--size", "8x8", *options, **variables)

    def entries(self):
        folder = self.cache / "vitrine/cad"
        return sorted(folder.iterdir()) if folder.is_dir() else []

    def conversions(self):
        return self.calls.read_text().splitlines() if self.calls.exists() else []

    def assert_converted(self, times, result, notes=()):
        said = result.stderr.decode()
        self.assertEqual(result.returncode, 0, said)
        self.assertEqual(said, "")
        self.assertIn(b"triangles", result.stdout)
        self.assertEqual(len(self.conversions()), times)
        for note in notes:
            self.assertIn(note.encode(), result.stdout)


class Cache(FakeConverter):
    def test_second_opening_runs_no_converter(self):
        self.assert_converted(1, self.info())
        self.assert_converted(1, self.info())
        self.assertEqual(len(self.entries()), 1)

    def test_other_tolerance_is_converted(self):
        self.assert_converted(1, self.info())
        self.assert_converted(2, self.info(None, "--tolerance", "0.25"))
        self.assertTrue(self.conversions()[1].endswith(" --progress --tolerance 0.25"))
        self.assertNotIn("--tolerance", self.conversions()[0])
        self.assert_converted(2, self.info())
        self.assert_converted(2, self.info(None, "--tolerance", "0.25"))

    def test_changed_content_is_converted(self):
        self.assert_converted(1, self.info())
        stamp = self.model.stat().st_mtime_ns
        self.model.write_bytes(b"Some STEP")
        os.utime(self.model, ns=(stamp, stamp))
        self.assert_converted(2, self.info())

    def test_touched_file_and_copy_are_not_converted(self):
        self.assert_converted(1, self.info())
        os.utime(self.model, (1, 1))
        self.assert_converted(1, self.info())
        elsewhere = self.folder / "elsewhere"
        elsewhere.mkdir()
        copy = elsewhere / self.model.name
        copy.write_bytes(self.model.read_bytes())
        self.assert_converted(1, self.info(copy))

    def test_other_version_is_converted(self):
        self.assert_converted(1, self.info())
        self.assert_converted(2, self.info(FAKE_VERSION="fake 2"))

    def test_damaged_entry_is_converted_again(self):
        self.assert_converted(1, self.info())
        (entry,) = self.entries()
        whole = entry.read_bytes()
        for damaged in (b"", whole[:-1], whole[: len(whole) // 2]):
            before = len(self.conversions())
            entry.write_bytes(damaged)
            self.assert_converted(before + 1, self.info())
            self.assertEqual(entry.read_bytes(), whole)

    def test_no_cache_neither_uses_nor_keeps(self):
        self.assert_converted(1, self.info(None, "--no-cache"))
        self.assertEqual(self.entries(), [])
        self.assert_converted(2, self.info())
        self.assert_converted(3, self.info(None, "--no-cache"))
        self.assertEqual(len(self.entries()), 1)

    def test_only_its_user_can_look_into_the_cache(self):
        self.assert_converted(1, self.info())
        self.assertEqual((self.cache / "vitrine/cad").stat().st_mode & 0o777, 0o700)

    def test_no_folder_for_a_cache(self):
        self.cache.mkdir()
        (self.cache / "vitrine").write_bytes(b"a file")
        note = "conversions are not kept: the folder"
        self.assert_converted(1, self.info(), [note])
        self.assert_converted(2, self.info(), [note])
        note = "conversions are not kept: neither XDG_CACHE_HOME nor HOME is set"
        nowhere = {"XDG_CACHE_HOME": "", "HOME": "", "MESA_SHADER_CACHE_DISABLE": "true"}
        self.assert_converted(3, self.info(**nowhere), [note])

    @unittest.skipIf(os.geteuid() == 0, "root may write anywhere")
    def test_unwritable_cache(self):
        self.cache.mkdir(mode=0o500)
        self.assert_converted(1, self.info(), ["conversions are not kept: the folder"])

    def test_cache_of_home(self):
        self.assert_converted(1, self.info(
                XDG_CACHE_HOME="relative", HOME=str(self.folder), MESA_SHADER_CACHE_DIR=str(self.folder)
            ))
        self.assertEqual(len(list((self.folder / ".cache/vitrine/cad").iterdir())), 1)

    def test_old_leftovers_are_removed(self):
        self.assert_converted(1, self.info())
        names = ("0" * 32 + ".7-1.glb", "1" * 32 + ".7-1.glb", "notes.txt", "machine.glb")
        old, new, *others = (self.cache / "vitrine/cad" / name for name in names)
        for file in (old, new, *others):
            file.write_bytes(b"half")
        for file in (old, *others):
            os.utime(file, (1, 1))
        self.assert_converted(2, self.info(None, "--tolerance", "1"))
        self.assertFalse(old.exists())
        self.assertTrue(new.exists())
        self.assertTrue(all(file.exists() for file in others), "files of others")


class Refusals(FakeConverter):
    def assert_nothing_is_left(self):
        self.assertEqual(self.entries(), [])
        left = {entry.name for entry in self.folder.iterdir()}
        known = {"cache", "calls", "a converter.sh", "made.glb", "box.step", "model.STEP", "none.step"}
        self.assertLessEqual(left, known)

    def refuse_what(self, does, *words):
        for options in ((), ("--no-cache",)):
            with self.subTest(does=does, options=options):
                result = self.info(None, *options, FAKE_DOES=does)
                self.assert_refused(result, f"{self.model}: ", *words)
                self.assert_nothing_is_left()

    def test_converters_message_is_told(self):
        result = self.info(FAKE_DOES="refuse")
        self.assertEqual(result.stderr.decode(), f"vitrine: {self.model}: is a bad file\n")
        self.refuse_what("refuse", "is a bad file")

    def test_converter_fails_without_a_word(self):
        self.refuse_what("fail", "ended with status 3")

    def test_converter_crashes(self):
        self.refuse_what("crash", "a converter.sh crashed (Segmentation fault)")

    def test_converter_writes_nothing(self):
        self.refuse_what("nothing", "wrote nothing")

    def test_converter_writes_garbage(self):
        self.refuse_what("garbage", "the GLB that a converter.sh wrote")

    def test_converter_leaves_something(self):
        self.refuse_what("leave", "ended with status 2")

    def test_noise_is_no_harm(self):
        self.assert_converted(1, self.info(FAKE_DOES="noisy"))

    def test_missing_converter(self):
        nowhere = str(self.folder / "nowhere")
        result = self.info(VITRINE_CAD_CONVERTER=nowhere)
        self.assert_refused(result, self.model, "nowhere cannot be run")
        result = self.info(VITRINE_CAD_CONVERTER=" ")
        self.assert_refused(result, self.model, "has no words")
        self.assert_nothing_is_left()

    def test_converter_without_a_version(self):
        result = self.info(FAKE_STATUS_OF_VERSION="2")
        self.assert_refused(result, self.model, "cannot be converted")
        self.assertEqual(self.conversions(), [])

    def test_no_folder_for_temporary_files(self):
        result = self.info(None, "--no-cache", TMPDIR=str(self.folder / "nowhere"))
        self.assert_refused(result, self.model, "temporary files")

    def test_missing_and_empty_files(self):
        self.assert_refused(self.info(self.folder / "none.step"), "no such file")
        self.assert_refused(self.info(self.write("model.STEP", b"")), "empty")
        self.assertEqual(self.conversions(), [])

    def test_bad_tolerance(self):
        for text in ("-1", "nan", "inf", "wide"):
            result = self.info(None, "--tolerance", text)
            self.assertEqual(result.returncode, 2)
            self.assertIn(b"--tolerance", result.stderr)


class Commands(FakeConverter):
    def test_kinds(self):
        for i, name in enumerate(("a.step", "a.STP", "a.iges", "a.IGS", "a.Brep"), 1):
            self.assert_converted(i, self.info(self.write(name, b"some shapes")))

    def test_words_of_a_command(self):
        command = f"/bin/sh '{self.converter}'"
        self.assert_converted(1, self.info(VITRINE_CAD_CONVERTER=command))

    def test_file_that_begins_with_a_dash(self):
        self.write("-box.step", b"some STEP")
        here = os.getcwd()
        os.chdir(self.folder)
        try:
            self.assert_converted(1, self.info("./-box.step"))
        finally:
            os.chdir(here)
        self.assertTrue(self.conversions()[0].startswith(f"{self.folder}/"))

    def test_no_program_beside_the_model_is_run(self):
        trap = self.folder / "vitrine-cad"
        trap.write_text('#!/bin/sh\ntouch "$FAKE_FOLDER/trapped"\n')
        trap.chmod(0o755)
        here = os.getcwd()
        os.chdir(self.folder)
        try:
            for path in ("", ".", ":/nowhere"):
                self.info(VITRINE_CAD_CONVERTER="", PATH=path)
        finally:
            os.chdir(here)
        self.assertFalse((self.folder / "trapped").exists())
