"""The page of chapter 08: one HTML file that needs no other, of accuracy.json and its pictures."""

import base64
import math
from html import escape

from accuracy_page.scatter import Mark, to_svg

STYLE = """
:root { color-scheme: light dark; --text: #1b1b1b; --quiet: #5a5a5a; --back: #fff; --raised: #f3f3f3;
  --rule: #dcdcdc; --good: #00601b; --bad: #a30000; --best: #0b5fa5; --worse: #8a8a8a; --hover: #c2500a; }
@media (prefers-color-scheme: dark) { :root { --text: #e4e4e4; --quiet: #a8a8a8; --back: #16181a;
  --raised: #24272a; --rule: #3a3e42; --good: #7fd494; --bad: #ff8f85; --best: #6db7f2; --worse: #8f959b;
  --hover: #ffa45c; } }
* { box-sizing: border-box; }
body { font: 16px/1.5 "DejaVu Sans", Verdana, sans-serif; margin: 2em auto; max-width: 68em; padding: 0 1em;
  color: var(--text); background: var(--back); }
h1, h2 { line-height: 1.2; overflow-wrap: break-word; }
h2 { margin-top: 2.2em; border-top: 2px solid var(--rule); padding-top: .8em; }
a { color: var(--best); } nav { margin: 1em 0; } nav a { display: inline-block; margin-right: 1em; }
.wide { overflow-x: auto; }
table { border-collapse: collapse; font-size: 14px; margin: 1em 0; }
th, td { padding: .22em .7em; text-align: right; border-bottom: 1px solid var(--rule); vertical-align: top; }
th:first-child, td:first-child, .words th, .words td { text-align: left; }
.words td { overflow-wrap: anywhere; } .figures td { white-space: nowrap; }
tr.dominated td { color: var(--quiet); } small { color: var(--quiet); }
tr.family th { background: var(--raised); } td.bad { color: var(--bad); } td.good { color: var(--good); }
.note { color: var(--quiet); font-size: 14px; } summary { cursor: pointer; }
svg { display: block; width: 100%; min-width: 620px; max-width: 860px; margin: .6em 0; }
svg text { font: 13px "DejaVu Sans", Verdana, sans-serif; fill: var(--text); }
svg .title { font-weight: bold; font-size: 15px; } svg .middle { text-anchor: middle; }
svg .end { text-anchor: end; } svg .tick { font-size: 11.5px; fill: var(--quiet); }
svg .grid { stroke: var(--rule); } svg .frame { fill: none; stroke: var(--worse); }
svg .range { stroke-width: 1.6; } svg .leader { fill: none; stroke: var(--worse); stroke-width: .7; }
svg .best .mark, svg .best .range { fill: var(--best); stroke: var(--best); }
svg .dominated .mark { fill: var(--back); stroke: var(--worse); stroke-width: 1.6; }
svg .dominated .range { stroke: var(--worse); } svg .dominated .label { fill: var(--quiet); }
svg g:hover .mark { fill: var(--hover); } svg g:hover .leader { stroke: var(--hover); stroke-width: 1.6; }
.pictures { display: grid; grid-template-columns: repeat(auto-fill, minmax(150px, 1fr)); gap: 14px; }
figure { margin: 0; max-width: 220px; } figcaption { font-size: 13px; line-height: 1.3; }
figure img { width: 100%; display: block; image-rendering: pixelated; border: 1px solid var(--rule); }
@media (max-width: 600px) { body { margin: 1em auto; } h1 { font-size: 1.6em; }
  .words tr { display: block; padding: .4em 0; border-bottom: 1px solid var(--rule); }
  .words th { display: none; } .words td { display: block; border: 0; padding: .05em 0; }
  .words td:first-child { font-weight: bold; } .advice td:last-child::before { content: "Take: "; } }
"""

LEGEND = ("In the plots, left is cheaper and low is more accurate. Lines are ranges of rounds, and "
          "bounds of 95 %. A triangle that points down is an upper bound: no fault was seen in so many "
          "cases. Hollow marks are dominated: another method is surely better in one way, and surely "
          "worse in none. The tables below them have the same figures: the mean cost of the families, and the "
          "faults and the error of the family where the method did worst.")


def rate_words(rate):
    """Per million, with the bounds: `0 (<184)`, `101637 (101045 to 102232)`."""
    if rate["per_million"] == 0:
        return f"0 (<{math.ceil(rate['upper_bound'])})"
    return f"{rate['per_million']:.0f} ({rate['lower_bound']:.0f} to {rate['upper_bound']:.0f})"


def _anchor(name):
    return "".join(letter if letter.isalnum() else "-" for letter in name)


def _rows(rows):
    return "".join("<tr>" + "".join(f"<td>{cell}</td>" for cell in row) + "</tr>\n" for row in rows)


def _circumstances(report):
    head = report["head"]
    commit = head["commit"] + (", and the tree was modified" if head["modified"] else "")
    rows = [(escape(name), escape(value)) for name, value in (
        ("commit", commit), ("date", head["date"]), ("processor", f"{head['cpu']}, {head['cores']} cores"),
        ("renderer", f"{head['renderer']}, OpenGL {head['opengl']}"), *report["circumstances"].items())]
    return f"<table class='words'>\n{_rows(rows)}</table>\n"


def _advice(report):
    rows = [(escape(one["trade_off"]), escape(one["need"]), escape(one["condition"]),
             escape("; ".join(one["methods"])) or "<em>none of these</em>")
            for one in report["advice"]]
    return ("<div class='wide'><table class='words advice'><tr><th>choice</th><th>need</th>"
            "<th>it must have</th><th>take (no rank among those named together)</th></tr>\n"
            f"{_rows(rows)}</table></div>\n")


def _plot(trade_off, y_label, height_of):
    """height_of(method) is its (counted, lowest, highest) along y, or None."""
    marks = []
    for method in trade_off["methods"]:
        height = height_of(method)
        if height is None or height[2] <= 0:
            continue
        cost = (method["nanoseconds"], method["lowest"], method["highest"])
        hint = (f"{method['method']}: {cost[0]:.4g} ns ({cost[1]:.4g} to {cost[2]:.4g}); "
                f"{height[0]:.4g} ({height[1]:.4g} to {height[2]:.4g}) {y_label}")
        marks.append(Mark(method["method"], hint, cost, height, method["dominated"]))
    if len({mark.y[0] for mark in marks}) < 2:  # nothing to see
        return ""
    svg = to_svg(trade_off["trade_off"], f"ns per {trade_off['unit_of_cases']}, mean of the families",
                 y_label, marks)
    return f"<div class='wide'>{svg}</div>\n"


def _faults(method):
    rate = method.get("faults")
    return rate and (rate["per_million"], rate["lower_bound"], rate["upper_bound"])


def _error(method):
    return (method["error"],) * 3 if "error" in method else None


def _methods(trade_off):
    """What the plots show, in figures."""
    rows = ""
    for one in trade_off["methods"]:
        kind = "dominated" if one["dominated"] else "best"
        faults = escape(rate_words(one["faults"])) if "faults" in one else ""
        error = f"{one['error']:.3g}" if "error" in one else ""
        rows += (f"<tr class='{kind}'><td>{escape(one['method'])}</td><td>{one['nanoseconds']:.4g} "
                 f"<small>({one['lowest']:.4g} to {one['highest']:.4g})</small></td>"
                 f"<td>{faults}</td><td>{error}</td></tr>\n")
    return ("<div class='wide'><table class='methods'>\n<tr><th>method</th>"
            f"<th>ns per {escape(trade_off['unit_of_cases'])}</th><th>faults per million</th>"
            f"<th>error, 99 %</th></tr>\n{rows}</table></div>\n")


def _plots(trade_off):
    if trade_off["kind"] == "speed_only":
        return ""
    return (_plot(trade_off, "faults per million, worst family", _faults) +
            _plot(trade_off, f"error (99 %), worst family; {trade_off['unit_of_error']}", _error))


def _pictures(trade_off, folder):
    html = ""
    for picture in trade_off["pictures"]:
        caption = escape(picture["caption"])
        png = base64.b64encode((folder / picture["file"]).read_bytes()).decode()
        html += (f"<figure><img alt='{caption}' src='data:image/png;base64,{png}'>"
                 f"<figcaption>{caption}</figcaption></figure>\n")
    return html and f"<div class='pictures'>\n{html}</div>\n"


def _measurement(one, fault_columns, has_error):
    cells = [f"<td>{escape(one['method'])}</td><td>{one['nanoseconds']:.4g}</td>"
             f"<td>{one['lowest']:.4g} to {one['highest']:.4g}</td>"]
    for fault in one["faults"]:
        kind = "good" if fault["count"] == 0 else "bad"
        cells.append(f"<td class='{kind}'>{escape(rate_words(fault))}</td>"
                     f"<td>{fault['count']} of {fault['of']}</td>")
    cells.append("<td></td><td></td>" * (fault_columns - len(one["faults"])))
    if has_error:
        error = one.get("error")
        cells.append("".join(f"<td>{error[part]:.3g}</td>" for part in
                             ("median", "percentile_99", "largest")) if error else "<td></td>" * 3)
    words = ", ".join(f"{name} {value:.5g}" for name, value in one["measures"].items())
    return f"<tr>{''.join(cells)}<td>{escape(words)}</td></tr>\n"


def _figures(trade_off):
    """All that was measured, family by family."""
    measurements = trade_off["measurements"]
    columns = max((len(one["faults"]) for one in measurements), default=0)
    has_error = bool(trade_off["unit_of_error"])
    html = ""
    for family in dict.fromkeys(one["family"] for one in measurements):
        own = [one for one in measurements if one["family"] == family]
        html += (f"<tr class='family'><th>{escape(family)}</th>"
                 f"<th>ns per {escape(trade_off['unit_of_cases'])}</th><th>range</th>")
        names = [fault["name"] for fault in own[0]["faults"]]
        html += "".join(f"<th>{escape(name)}, per million</th><th></th>" for name in names)
        html += "<th></th><th></th>" * (columns - len(names))
        html += "<th>error, median</th><th>99 %</th><th>largest</th>" if has_error else ""
        html += "<th></th></tr>\n" + "".join(_measurement(one, columns, has_error) for one in own)
    return ("<details><summary>All figures</summary>\n<div class='wide'><table class='figures'>\n"
            f"{html}</table></div>\n</details>\n")


def _section(trade_off, folder):
    name = trade_off["trade_off"]
    error = f" Error: {trade_off['unit_of_error']}." if trade_off["unit_of_error"] else ""
    html = f"<h2 id='{_anchor(name)}'>{escape(name)}</h2>\n<p>{escape(trade_off['question'] + error)}</p>\n"
    if trade_off["source"]:
        html += f"<p class='note'>{escape(trade_off['source'])}</p>\n"
    return html + _plots(trade_off) + _methods(trade_off) + _pictures(trade_off, folder) + _figures(trade_off)


def to_html(report, folder):
    """The page. The folder is that of the pictures' files. Those that change only the speed come last."""
    trade_offs = sorted(report["trade_offs"], key=lambda one: one["kind"] == "speed_only")
    links = "".join(f"<a href='#{_anchor(one['trade_off'])}'>{escape(one['trade_off'])}</a>\n"
                    for one in trade_offs)
    needs = "".join(f"<li>{escape(sentence)}</li>\n" for sentence in report["scene_needs"])
    return ("<!doctype html>\n<html lang='en'><head><meta charset='utf-8'>\n"
            "<meta name='viewport' content='width=device-width, initial-scale=1'>\n"
            "<title>What accuracy costs in time</title>\n"
            f"<style>{STYLE}</style></head><body>\n<h1>What accuracy costs in time</h1>\n"
            f"<nav>{links}</nav>\n<h2>What to take</h2>\n{_advice(report)}"
            f"<h2>What {escape(report['head']['scenes'][0]['scene'])} needs</h2>\n<ul>\n{needs}</ul>\n"
            f"<h2>How it was measured</h2>\n{_circumstances(report)}<p class='note'>{LEGEND}</p>\n" +
            "".join(_section(one, folder) for one in trade_offs) + "</body></html>\n")
