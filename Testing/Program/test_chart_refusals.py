import json
import os
import signal
import unittest

from charts import SMALL, chart, read_document, results_there, start_chart, stop_when
from program import FileTest, run


class Refusals(FileTest):
    def refuse_chart(self, folder, *words):
        for command in (("chart", *SMALL, "--out"), ("compare", "demo:stack", "--chart")):
            with self.subTest(command=command[0]):
                self.assert_refused(run(*command, folder), *words)

    def test_a_folder_must_be_a_folder(self):
        path = self.write("file", b"")
        self.refuse_chart(path, path, "is not a folder")
        self.refuse_chart("", "is empty")

    def test_a_folder_must_lie_in_a_folder(self):
        path = self.folder / "none" / "chart"
        self.refuse_chart(path, path, "cannot be made")
        self.assertFalse(path.parent.exists())

    @unittest.skipIf(os.geteuid() == 0, "root may write everywhere")
    def test_a_folder_must_be_writable(self):
        path = self.folder / "locked"
        path.mkdir()
        path.chmod(0o500)
        self.refuse_chart(path, path, "may not be written to")

    def test_a_file_in_the_way_of_a_picture_is_told(self):
        path = self.write("pictures", b"")
        self.refuse_chart(self.folder, path, "is of no chart")

    def test_the_json_of_others_is_left_alone(self):
        for content in (b"", b"{", b"[]", b'{"vitrine": "0"}', b"null"):
            path = self.write("chart.json", content)
            words = "is damaged" if len(content) < 2 else "is not the chart.json of a chart"
            self.refuse_chart(self.folder, path, words)
            self.assertEqual(path.read_bytes(), content)

    def test_the_page_and_the_plots_of_others_are_left_alone(self):
        for name in ("index.html", "error.png", "growth.png"):
            path = self.write(name, b"mine")
            self.refuse_chart(
                self.folder, path, "no chart.json is beside it", "another folder by --"
            )
            self.assertEqual([file.read_bytes() for file in self.folder.iterdir()], [b"mine"])
            path.unlink()

    def test_a_chart_of_others_is_not_written_over(self):
        head = {"vitrine": "0.0.0", "device": {}, "settings": {}, "results": []}
        path = self.write("chart.json", json.dumps(head).encode())
        before = path.read_bytes()
        self.refuse_chart(self.folder, path, "by another version", "another folder by --")
        self.assertEqual(path.read_bytes(), before)

    def test_a_chart_with_other_settings_is_not_written_over(self):
        folder = self.folder / "chart"
        compare = ("compare", "demo:stack,layers=2", "--size", "8x8", "--frames", "1")
        first = run(*compare, "--methods", "blend", "--chart", folder)
        self.assertEqual(first.returncode, 0, first.stderr.decode())
        before = (folder / "chart.json").read_bytes()
        for command in ((*compare, "--methods", "vtk-oit", "--chart"), ("chart", *SMALL, "--out")):
            words = ("with other settings (settings.", " was ", " and is ", command[-1])
            self.assert_refused(run(*command, folder), *words)
            self.assertEqual((folder / "chart.json").read_bytes(), before)

    def test_a_file_in_the_way_of_a_plot_is_told(self):
        for name in ("index.html", "error.png", "growth.png"):
            path = self.folder / name
            path.mkdir()
            self.refuse_chart(self.folder, path, "is a directory")
            path.rmdir()

    def test_damaged_rows_are_told(self):
        folder = self.folder / "chart"
        process = start_chart(folder)
        stop_when(process, lambda: results_there(folder), signal.SIGKILL)
        document = read_document(folder)
        for change in ({"part": 3}, {"frame_ms": {}}, {"picture": "/etc/passwd"}):
            with self.subTest(change=change):
                rows = [{**document["results"][0], **change}]
                text = json.dumps({**document, "results": rows})
                (folder / "chart.json").write_text(text)
                self.assert_refused(chart(folder), folder / "chart.json", "damaged")
        (folder / "chart.json").write_text(json.dumps({**document, "results": [7]}))
        self.assert_refused(chart(folder), folder / "chart.json", "damaged")

    def test_what_cannot_be_read_is_told_before_anything_is_measured(self):
        path = self.write("empty.stl", b"")
        folder = self.folder / "chart"
        self.assert_refused(chart(folder, path), path)
        self.assertFalse(folder.exists())

    def test_methods_must_be_known(self):
        result = run("chart", "--methods", "magic", "--out", self.folder / "chart")
        self.assert_refused(result, "magic")


if __name__ == "__main__":
    unittest.main()
