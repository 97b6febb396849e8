"""The program `vitrine inspect`: python -m vitrine.inspector FILE..."""

from __future__ import annotations

import argparse
import asyncio
import os
import sys

from . import _server


def main(arguments: list[str]) -> int:
    """Serve the inspector until it is ended. Returns the status of the process: 2 for bad input, after one line."""
    from ._render import size

    parser = argparse.ArgumentParser(
        prog="vitrine inspect", description="Open an assembly in a page of the browser. The page is on this machine."
    )
    parser.add_argument(
        "files", metavar="FILE", nargs="+", help="an assembly, several, or a state that the page has saved"
    )
    parser.add_argument("--host", metavar="ADDRESS", default="127.0.0.1", help="listen for other machines too")
    parser.add_argument("--port", metavar="N", type=_port, default=0, help="where to listen; a free one by default")
    parser.add_argument("--no-browser", action="store_true", help="print the address, and open no browser")
    parser.add_argument(
        "--size", metavar="WxH", type=size, default=(1024, 640), help="pixels, until the page tells its own"
    )
    parser.add_argument("--tolerance", metavar="METRES", type=float, default=0.0, help="of triangles of STEP")
    parser.add_argument("--dark", action="store_true", help="begin with the dark page")
    options = parser.parse_args(arguments)
    try:
        _server.check_installed()
        target = options.files[0] if len(options.files) == 1 else options.files
        server = _server.Server(
            target,
            host=options.host,
            port=options.port,
            size=options.size,
            tolerance=options.tolerance,
            dark=options.dark,
        )
        asyncio.run(server.run(open_browser=not options.no_browser))
    except (ValueError, KeyError, TypeError, OSError, ImportError, RuntimeError) as error:
        print(f"vitrine inspect: {error.args[0] if isinstance(error, KeyError) else error}", file=sys.stderr)
        return 2
    if server.is_busy:
        sys.stdout.flush()
        os._exit(0)  # does not wait for the frame that is drawn
    return 0


def _port(text: str) -> int:
    if not text.isdecimal() or not 0 <= int(text) < 65536:
        raise argparse.ArgumentTypeError(f"a port is a number from 0 to 65535, not {text!r}")
    return int(text)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
