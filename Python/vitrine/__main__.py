"""The program vitrine, as a wheel holds it: python -m vitrine, or vitrine on PATH."""

import os
import pathlib
import sys


def main() -> None:
    """Become the program, with this process's arguments."""
    program = pathlib.Path(__file__).parent / "bin" / "vitrine"
    if not program.is_file():
        sys.exit(f"vitrine: this installation has the package without the program ({program})")
    os.execv(program, ["vitrine", *sys.argv[1:]])


if __name__ == "__main__":
    main()
