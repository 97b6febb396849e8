"""Figures of ranks: are pictures those of one rank, how many bytes are sent, and what does it cost?

    python3 Testing/Ranks/rank_figures.py FILE|demo... [--ranks 1,2,3,4,8] [--partitions kd-tree,random] [--ghosts 0,1]
        [--size 640x480] [--samples 0] [--opacity 0.3] [--frames 4] [--storage HalfFloat|Compact] [--json OUT]

The cells of a model are divided among the ranks. Each row is a run of mpirun; each rank has one thread of the
rasteriser and keeps to one core. "alone" is the frame of the slowest rank if each draws only its own geometry, at the
same time as the others; "together" is the frame of all. Both are the least of the frames of a turn. Alone, VTK draws
ghost cells too, so that is left open. The result is a table in Markdown; --json writes a line for each run.
"""

import argparse
import json
import pathlib
import sys

from test_ranks import run

HEAD = (
    "| scene | ranks | partition | differing bytes | fragments | sent | bytes a fragment byte | other bytes | "
    "alone, ms | together, ms | ratio |"
)


def read_arguments():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("source")
    parser.add_argument("--ranks", default="1,2,3,4,8")
    parser.add_argument("--partitions", default="kd-tree,round-robin,random")
    parser.add_argument("--ghosts", default="0,1")
    parser.add_argument("--size", default="640x480")
    parser.add_argument("--samples", default="0")
    parser.add_argument("--opacity", default="0.3")
    parser.add_argument("--frames", default="4")
    parser.add_argument("--storage", default="HalfFloat")
    parser.add_argument("--json")
    return parser.parse_args()


def row_of(name, ranks, partition, ghosts, told):
    sent = sum(row["sent"] for row in told)
    node = told[0]["node"]
    alone, together = (min(map(max, zip(*(row[way] for row in told)))) for way in ("alone", "together"))
    share = sum(row["bytes"] for row in told) / (sent * node) if sent else 0.0
    return (
        f"| {name} | {ranks} | {partition}{', ghosts' if ghosts else ''} | {told[0]['differing']} | "
        f"{told[0]['fragments']:,} | {sent:,} | {share:.3f} | {sum(row['other'] for row in told):,} | "
        f"{'' if ghosts else f'{1e3 * alone:.0f}'} | {1e3 * together:.0f} | "
        f"{'' if ghosts else f'{together / alone:.2f}'} |"
    )


def main():
    options = read_arguments()
    name = pathlib.Path(options.source).stem
    print(HEAD)
    print("|" + (HEAD.count("|") - 1) * " --- |")
    for ranks in map(int, options.ranks.split(",")):
        for partition in options.partitions.split(","):
            for ghosts in map(int, options.ghosts.split(",")):
                if ranks == 1 and (ghosts or partition != options.partitions.split(",")[0]):
                    continue
                words = (options.source, options.opacity, partition, ghosts, options.size, options.storage)
                more = (options.samples, options.frames)
                result = run(ranks, *map(str, words), *more, script="rank_turn.py", timeout=600)
                lines = [line for line in result.stdout.splitlines() if line.startswith("[{")]
                if result.returncode or not lines:
                    sys.exit(result.stderr)
                told = json.loads(lines[0])
                print(row_of(name, ranks, partition, ghosts, told), flush=True)
                if options.json:
                    with open(options.json, "a", encoding="utf-8") as out:
                        row = {"scene": name, "ranks": ranks, "partition": partition, "ghosts": ghosts}
                        row.update(size=options.size, samples=options.samples, told=told)
                        out.write(json.dumps(row) + "\n")


if __name__ == "__main__":
    main()
