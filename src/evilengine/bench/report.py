"""The numbers of `evil bench physics` as tables for people."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from evilengine.bench.physics import OURS, Numbers

WIDTHS = (15, 7, 9)
COLUMN = 19


def steps_head(engines: Sequence[str]) -> str:
    """Over the rows of `steps_row`."""
    names = [OURS, *(f"{name} (ratio)" for name in engines)]
    return (
        "ms a step, least / median; ratio: our time as a part of theirs, median of rounds side by side;"
        " for threads: how many times as fast as one\n"
        + f"{'scene':<{WIDTHS[0]}}{'bodies':>{WIDTHS[1]}}{'contacts':>{WIDTHS[2]}}"
        + "".join(f"{name:>{COLUMN + 6}}" for name in names)
    )


def steps_row(row: Numbers, engines: Sequence[str]) -> str:
    """One scene."""
    text = f"{row['scene']:<{WIDTHS[0]}}{row['bodies']:>{WIDTHS[1]}}{row['contacts']:>{WIDTHS[2]}}"
    for name in (OURS, *engines):
        one = row["engines"].get(name)
        if one is None:
            text += f"{'-':>{COLUMN + 6}}"
            continue
        ratio = "" if name == OURS else f" ({one['ours_to_it']:.2f})"
        text += f"{one['min']:.3f} / {one['median']:.3f}{ratio}".rjust(COLUMN + 6)
    return text


def quality_table(qualities: Numbers, steps: int) -> str:
    rows = [
        (name, f"{q['top_drop']:.3f}", f"{q['overlap']:.4f}", f"{q['sideways']:.3f}", f"{q['tilt']:.4f}")
        for name, q in qualities.items()
    ]
    head = ("", "top drops, m", "deepest overlap, m", "furthest sideways, m", "most tilt, rad")
    return f"pyramid after {steps} steps\n{table([head, *rows])}"


def growth_table(rows: Sequence[Numbers]) -> str:
    head = (rows[0]["scene"], "contacts", "ms, least", "ns a body")
    body = [(str(r["bodies"]), str(r["contacts"]), f"{r['min']:.3f}", f"{r['ns_a_body']:.0f}") for r in rows]
    return table([head, *body])


def access_table(reading: Numbers) -> str:
    words = {
        "create_ms": "create 5050, ms",
        "create_batch_ms": "by batch, ms",
        "position_ns": "body.position, ns",
        "all_positions_us": "view of all, us",
        "ray_us": "a ray, us",
        "ray_batch_us": "a ray in a batch, us",
    }
    used = [key for key in words if any(key in one for one in reading.values())]
    rows = [[name, *(f"{one[key]:.3g}" if key in one else "-" for key in used)] for name, one in reading.items()]
    return table([["", *(words[key] for key in used)], *rows])


def table(rows: Iterable[Sequence[str]]) -> str:
    """Columns as wide as they need to be: the first to the left, the others to the right.

    >>> print(table([("", "ms"), ("evil", "2"), ("other", "11")]))
           ms
    evil    2
    other  11
    """
    lines = [list(row) for row in rows]
    widths = [max(len(line[column]) for line in lines) for column in range(len(lines[0]))]
    return "\n".join(
        "  ".join([line[0].ljust(widths[0]), *(text.rjust(w) for text, w in zip(line[1:], widths[1:], strict=True))])
        for line in lines
    )
