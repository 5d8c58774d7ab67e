"""What a run found: as a table, a page, and figures (docs/figures.md)."""

import json
import os
import subprocess
import time
from html import escape
from pathlib import Path

from judge import bounds
from suite import SuiteError

ROOT = Path(__file__).resolve().parents[2]
STYLE = """:root { color-scheme: light dark } body { font: 16px/1.5 "DejaVu Sans", Verdana, sans-serif; margin: 2em auto;
max-width: 70em; padding: 0 1em } .wide { overflow-x: auto } table { border-collapse: collapse; font-size: 14px }
th, td { padding: .25em .7em; text-align: left; border-bottom: 1px solid #8886; vertical-align: top }
td.number { text-align: right; white-space: nowrap } tr.wrong td:nth-child(3) { background: #d0402a40 }
tr.right td:nth-child(3) { background: #2a9d4a30 } code { font-size: 13px; overflow-wrap: anywhere }"""


def git(*words):
    try:
        run = subprocess.run(["git", "-C", ROOT, *words], capture_output=True, text=True, check=False)
    except OSError:  # an installed suite needs no git
        return ""
    return run.stdout.strip() if run.returncode == 0 else ""


def cpu_name():
    try:
        for line in Path("/proc/cpuinfo").read_text().splitlines():
            if line.startswith("model name"):
                return line.partition(":")[2].strip()
    except OSError:
        pass
    return "unknown"


def head():
    """The head of all figures; nothing is drawn, built or loaded here."""
    return {"schema": "conformance.schema.json", "schema_version": 1, "commit": git("rev-parse", "HEAD") or "unknown",
            "modified": bool(git("status", "--porcelain", "--untracked-files=no")),
            "date": time.strftime("%Y-%m-%dT%H:%M:%SZ", time.gmtime()), "cpu": cpu_name(),
            "cores": len(os.sched_getaffinity(0)), "renderer": None, "opengl": None, "builders": {}, "scenes": []}


def rate_words(row):
    per_million = 1e6 * row["wrong"] / row["tried"] if row["tried"] else 0.0
    if row["wrong"] == 0:
        return f"0 (<{row['highest']:.0f})"
    return f"{per_million:.0f} ({row['lowest']:.0f} to {row['highest']:.0f})"


def row_of(family, ended, seconds, verdict):
    """One family's figures."""
    lowest, highest = bounds(verdict.total(), family.rays)
    return {"family": family.name, "inside": family.inside, "tried": family.rays, "wrong": verdict.total(),
            "lowest": lowest, "highest": highest,
            "wrong_by_kind": {kind: count for kind, count in verdict.wrong.items() if count},
            "ended": ended, "seconds": seconds, "first_wrong": verdict.first}


def replay(family, first):
    """The command that shows the walk of the ray; nothing where the file has rays that are none."""
    if family.name in ("no_rays", "nothing"):
        return ""
    return (f"./run.sh view {family.file('obj')} --rays {family.file('f32')} --ray-number {first['ray']}")


def first_in_words(first):
    if first["triangle"] == -1:
        got = "no hit" if first["kind"] != "no answer" else "no answer"
    else:
        got = f"triangle {first['triangle']} at t = {first['t']}"
    allowed = [f"{one['triangle']} at {one['t_least']:.9g} to {one['t_most']:.9g}" for one in first["allowed"][:3]]
    allowed += ["a miss"] if first["miss"] else []
    return f"ray {first['ray']}: {got}; right is {' or '.join(allowed) or 'nothing that it can find'}"


def to_line(row):
    how = ", ".join(f"{count} {kind}" for kind, count in row["wrong_by_kind"].items())
    told = "" if row["ended"] == "done" else f"[{row['ended']}] "
    return (f"{row['family']:14} {row['tried']:>8} {row['wrong']:>8} {rate_words(row):>26} {row['seconds']:>8.2f}  "
            f"{told}{how}")


HEADING = f"{'family':14} {'tried':>8} {'wrong':>8} {'wrong per million (95 %)':>26} {'seconds':>8}"


def to_html(figures, families):
    by_name = {family.name: family for family in families}
    rows = ""
    for row in figures["families"]:
        family, first = by_name[row["family"]], row["first_wrong"]
        how = ", ".join(f"{count} {kind}" for kind, count in row["wrong_by_kind"].items())
        shown = ""
        if first:
            shown = f"<br>{escape(first_in_words(first))}<br><code>{escape(replay(family, first))}</code>"
        rows += (f"<tr class='{'wrong' if row['wrong'] else 'right'}'><td>{escape(family.name)}</td>"
                 f"<td>{escape(family.tests)}</td><td class='number'>{escape(rate_words(row))}</td>"
                 f"<td class='number'>{row['seconds']:.2f}</td><td>{escape(row['ended'])}</td>"
                 f"<td>{escape(how)}{shown}</td></tr>\n")
    return (f"<!doctype html><html lang='en'><meta charset='utf-8'><title>{escape(figures['engine'])}</title>"
            f"<meta name='viewport' content='width=device-width'><style>{STYLE}</style>"
            f"<h1>{escape(figures['engine'])}</h1><p><code>{escape(figures['command'])}</code></p>"
            f"<p>{figures['wrong']} of {figures['tried']} answers are wrong. Rates are per million, with bounds of 95 %: "
            "Wilson's, and 3/n where none is wrong.</p><div class='wide'><table>"
            "<tr><th>family</th><th>what it tests</th><th>wrong per million</th><th>seconds</th><th>ended</th>"
            f"<th>what is wrong, and the first wrong ray</th></tr>\n{rows}</table></div></html>\n")


def cell_of(row):
    """Wrong answers, those whose u and v alone are wrong apart; or how the run ended."""
    if row["ended"] != "done":
        return row["ended"]
    weights = row["wrong_by_kind"].get("wrong u, v", 0)
    return f"{row['wrong'] - weights} + {weights}" if weights else str(row["wrong"])


def run_in(path):
    """The figures of a run; or those in a card that the playground saved of a reader's GPU."""
    figures = json.loads(path.read_text())
    if "families" in figures:
        return figures
    if "conformance" not in figures:
        raise SuiteError(f"{path}: it has no run of the suite. Name files of --json, or cards that the book's playground saved.")
    rows = [{**row, "ended": "done", "wrong_by_kind": {}} for row in figures["conformance"]["families"]]
    return {**figures["conformance"], "engine": figures["head"]["renderer"], "families": rows}


def compare(paths):
    """A table in Markdown: families down, engines across."""
    runs = [run_in(path) for path in paths]
    lines = ["| family | " + " | ".join(run["engine"] for run in runs) + " |", "| --- |" + " --- |" * len(runs)]
    names = list(dict.fromkeys(row["family"] for run in runs for row in run["families"]))
    for name in names:
        cells = []
        for run in runs:
            row = next((row for row in run["families"] if row["family"] == name), None)
            cells.append("" if row is None else cell_of(row))
        lines.append(f"| {name} | " + " | ".join(cells) + " |")
    lines.append("| together | " + " | ".join(f"{run['wrong']} of {run['tried']}" for run in runs) + " |")
    return "\n".join(lines)
