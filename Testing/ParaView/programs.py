"""Runs ParaView's other programs under an X server: programs.py PLUGIN FOLDER server RANKS, programs.py PLUGIN FOLDER
window. Prints lines of JSON, as draw.py does.
"""

import json
import os
import pathlib
import socket
import subprocess
import sys

HERE = pathlib.Path(__file__).parent
MPI = ["mpirun", "--allow-run-as-root", "--oversubscribe", "-np"]
OFFSCREEN = "--force-offscreen-rendering"
REFUSAL = "Vitrine draws on one rank, and these are"


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
    if int(ranks) > 1:
        row = {"scene": f"a server of {ranks} ranks is refused in words", "by": "the message", "allowed": 0.0}
        row |= {"wrong": 0.0} if REFUSAL in client.stdout else {"error": "the client shows no message"}
        print(json.dumps(row))
    return client.returncode


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
    run = {"server": run_server, "window": run_window}[what]
    return run(plugin, pathlib.Path(folder), *arguments)


sys.exit(main(*sys.argv[1:]))
