"""Runs ParaView's other programs under an X server: programs.py PLUGIN FOLDER server RANKS, the same with batch RANKS,
and with window. Prints lines of JSON, as draw.py does.
"""

import json
import os
import pathlib
import re
import socket
import subprocess
import sys

HERE = pathlib.Path(__file__).parent
sys.path.insert(0, str(HERE))
sys.dont_write_bytecode = True

from pictures import difference, read  # noqa: E402

MPI = ["mpirun", "--allow-run-as-root", "--oversubscribe", "-np"]
OFFSCREEN = "--force-offscreen-rendering"
REFUSED = {  # on several ranks, with these words
    "caps of divided parts": "parts that the section cuts are divided among ranks",
    "volume": "Vitrine does not draw volumes on several ranks",
    "ambient occlusion": "Vitrine does not draw ambient occlusion on several ranks"}


def free_port():
    with socket.socket() as found:
        found.bind(("127.0.0.1", 0))
        return str(found.getsockname()[1])


def run_server(plugin, folder, ranks):
    """Run remote.py with a server. The client tries to connect until the server listens."""
    port = free_port()
    with open(folder / "server.log", "w", encoding="utf-8") as log:
        server = subprocess.Popen(
            [*MPI, ranks, "pvserver", OFFSCREEN, f"--server-port={port}"], stdout=log, stderr=subprocess.STDOUT)
        client = subprocess.run(
            ["pvpython", OFFSCREEN, HERE / "remote.py", plugin, folder, port, ranks], timeout=300, text=True,
            stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)
        server.terminate()
        server.wait()
    print(client.stdout)
    return client.returncode


def draw_on_ranks(plugin, folder, ranks):
    """What ranks.py told on so many ranks of pvbatch, by scenes, with the picture of each."""
    done = subprocess.run(
        [*MPI, ranks, "pvbatch", OFFSCREEN, HERE / "ranks.py", plugin, folder], timeout=600, text=True,
        stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=True)
    told = {row.pop("scene"): row for row in map(json.loads, re.findall(r"^{.*}$", done.stdout, re.M))}
    for name, row in told.items():
        row["picture"] = read(folder / f"ranks-{ranks}" / f"{name.replace(' ', '-')}.png")
    return told


def judge(row, right):
    """The part of a row of the table that tells how far a scene is from that of one rank."""
    wrong = difference(row.pop("picture"), right["picture"])
    others = {key: (value, right[key]) for key, value in row.items() if value != right[key]}
    return {"wrong": wrong} | ({"error": f"what ranks and one rank tell: {others}"} if others else {})


def run_batch(plugin, folder, ranks):
    """Run ranks.py on several ranks of pvbatch, and on one."""
    told, one = (draw_on_ranks(plugin, folder, count) for count in (ranks, "1"))
    for name, row in told.items():
        allowed = 1.0 if name == "contours" else 0.0
        line = {"scene": f"{name}; ranks of pvbatch: {ranks}", "by": "one rank", "allowed": allowed}
        if name in REFUSED:
            is_told = REFUSED[name] in row["FallbackReason"][0]
            line |= {"by": "the message", **({"wrong": 0.0} if is_told else {"error": f"told: {row}"})}
        else:
            line |= judge(row, one[name])
        print(json.dumps(line))
    return 0


def run_window(plugin, folder):
    """Run window.py in ParaView's window, without the dialog that welcomes users."""
    settings = folder / "home/.config/ParaView"
    settings.mkdir(parents=True, exist_ok=True)
    for name in ("ParaView5.11.0.ini", "ParaView.ini"):  # the latter from 6 on
        (settings / name).write_text("[General]\nGeneralSettings.ShowWelcomeDialog=0\n", encoding="utf-8")
    result = folder / "window.json"
    result.unlink(missing_ok=True)
    environment = os.environ | {
        "HOME": str(folder / "home"), "VITRINE_PLUGIN": plugin, "VITRINE_RESULTS": str(folder),
        "VITRINE_SCRIPTS": str(HERE)}
    status = subprocess.run(
        ["paraview", f"--script={HERE / 'window.py'}"], env=environment, timeout=300, check=False).returncode
    print(result.read_text(encoding="utf-8"))
    return status


def main(plugin, folder, what, *arguments):
    run = {"server": run_server, "batch": run_batch, "window": run_window}[what]
    return run(plugin, pathlib.Path(folder), *arguments)


sys.exit(main(*sys.argv[1:]))
