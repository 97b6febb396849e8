#!/usr/bin/env python3
"""Count the words of the pages, and check style and links.

    docs/check_pages.py            check; exit status 1 names each place that breaks a rule
    docs/check_pages.py --table    also print the counts by page, as Markdown

User pages are all but lab/ and develop/. A sentence of theirs has at most 35 words, and a page's sentences have 18 at most
on average. A cell of a table has at most 25 words. All user pages together have at most 22,250 words, tables not counted.
Links to files and headings lead somewhere, on all pages.
"""

import argparse
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
DOCS = ROOT / "docs"
LONGEST_SENTENCE = 35
LONGEST_MEAN = 18
LONGEST_CELL = 25
MOST_WORDS = 22250
GENERATED = {  # tables made by commands
    "bench/devices.md",
    "bench/drivers.md",
    "reference/culler-limits.md",
    "reference/effects.md",
}
CAPS = {"howto": 400, "tutorial": 900, "explain": 1500}
FENCE = re.compile(r"^(`{3,}|~{3,}|:{3,})[^\n]*\n.*?^\1\s*$", re.S | re.M)
COMMENT = re.compile(r"<!--.*?-->", re.S)
WRITTEN = re.compile(r"<!-- Written by .*?<!-- End of what .*?-->", re.S)  # a part that a script writes
LINK = re.compile(r"!?\[([^\]]*)\]\(([^)\s]+)[^)]*\)")
WORD = re.compile(r"[A-Za-z0-9][\w'.,/%-]*")


def prose_of(text):
    """The text without code, comments, addresses of links, and parts written by scripts. Code counts as one word."""
    text = COMMENT.sub("", WRITTEN.sub("", FENCE.sub("", text)))
    text = re.sub(r"`[^`\n]*`", "code", text)
    return LINK.sub(lambda link: link.group(1), text)


def words(text):
    return len(WORD.findall(text))


def rows_of(prose):
    """The cells of each row of the tables."""
    for line in prose.splitlines():
        if line.startswith("|") and not re.fullmatch(r"[|\s:-]+", line):
            yield [cell.strip() for cell in line.strip().strip("|").split("|")]


def sentences_of(prose):
    """Sentences of paragraphs and items of lists. A line of a table is none."""
    lines = [line for line in prose.splitlines() if not line.startswith("|")]
    blocks = re.split(r"\n\s*\n|\n(?=\s*(?:[-*]|\d+\.)\s)|\n(?=#)", "\n".join(lines))
    for block in blocks:
        for sentence in re.split(r"(?<=[.!?:;])\s", " ".join(block.split())):
            if words(sentence):
                yield sentence


def slug(heading):
    """The anchor of a heading, as forges make it."""
    text = re.sub(r"[`*_]|\[|\]\([^)]*\)", "", heading.strip().lower())
    return re.sub(r"\s", "-", re.sub(r"[^\w\s-]", "", text))


def anchors_of(path):
    text = FENCE.sub("", path.read_text(encoding="utf-8"))
    return {slug(heading) for heading in re.findall(r"^#+ (.*)$", text, re.M)}


def bad_links(path, text):
    for link in LINK.finditer(FENCE.sub("", text)):
        address = link.group(2)
        if re.match(r"[a-z]+:", address):
            continue
        file, _, anchor = address.partition("#")
        target = (path.parent / file).resolve() if file else path
        if not target.exists():
            yield f"the link to {address} leads nowhere"
        elif anchor and target.suffix == ".md" and anchor not in anchors_of(target):
            yield f"{address} has no such heading"


class Page:
    def __init__(self, path):
        self.path = path
        self.name = str(path.relative_to(DOCS)) if path.is_relative_to(DOCS) else str(path.relative_to(ROOT))
        self.text = path.read_text(encoding="utf-8")
        prose = prose_of(self.text)
        self.lengths = [words(sentence) for sentence in sentences_of(prose)]
        self.sentences = list(sentences_of(prose))
        self.cells = [cell for row in rows_of(prose) for cell in row]
        self.words = sum(self.lengths)
        self.words_in_tables = sum(words(cell) for cell in self.cells)
        self.kind = self.name.split("/")[0]
        self.is_users = self.kind not in ("lab", "develop") and self.path.name != "CHANGELOG.md"

    @property
    def mean(self):
        return sum(self.lengths) / max(1, len(self.lengths))

    def faults(self):
        yield from bad_links(self.path, self.text)
        if not self.is_users:
            return
        for sentence, length in zip(self.sentences, self.lengths):
            if length > LONGEST_SENTENCE:
                yield f"a sentence of {length} words: {sentence[:90]}..."
        if self.mean > LONGEST_MEAN:
            yield f"its sentences have {self.mean:.1f} words on average"
        if self.name not in GENERATED:
            for cell in self.cells:
                if words(cell) > LONGEST_CELL:
                    yield f"a cell of {words(cell)} words: {cell[:90]}..."
        cap = CAPS.get(self.kind)
        if cap and self.words > cap:
            yield f"{self.words} words; pages of {self.kind}/ have at most {cap}"
        for file in re.findall(r"\b(?:Module|Testing)/[\w/.]+", prose_of(self.text.replace("`", " "))):
            yield f"a user page names {file}"


def pages():
    own = sorted(DOCS.rglob("*.md"))
    return [Page(path) for path in [ROOT / "README.md", *own] if "build" not in path.parts]


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("--table", action="store_true")
    asked = options.parse_args()
    all_pages = pages()
    if asked.table:
        print("| page | words | in tables | longest sentence | mean | longest cell |\n| --- | --- | --- | --- | --- | --- |")
        for page in all_pages:
            cell = max((words(cell) for cell in page.cells), default=0)
            counts = f"{page.words} | {page.words_in_tables} | {max(page.lengths, default=0)} | {page.mean:.1f}"
            print(f"| {page.name} | {counts} | {cell} |")
    faults = [f"{page.name}: {fault}" for page in all_pages for fault in page.faults()]
    total = sum(page.words for page in all_pages if page.is_users and page.name not in GENERATED)
    if asked.table:
        print(f"\nUser pages: {total} words, tables not counted.")
    if total > MOST_WORDS:
        faults.append(f"user pages have {total} words together; {MOST_WORDS} at most")
    for fault in faults:
        print(fault, file=sys.stderr)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
