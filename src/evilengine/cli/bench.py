"""Measure the engine on this machine.

`evil bench physics` times steps of the scenes that tests and the testbed share, with sleep off, beside other engines
that are installed (pip install 'evilengine[bench]'), in the same process and in turn. It takes about three minutes.
  evil bench physics                               everything
  evil bench physics --scene pyramid --steps 100   one scene
  evil bench physics --only growth                 one part: steps, growth, access or memory
  evil bench physics --json numbers.json           the numbers as a file, too
  evil bench draw                                  frames of moving sprites, beside 'evilengine[bench-draw]'
  evil bench fluid                                 steps of smoke, water and both, beside 'evilengine[bench-fluid]'
  evil bench fluid --only smoke --size 256         one part: smoke, water or frame
"""

from __future__ import annotations

import argparse
import json
import os
import platform
import sys
from pathlib import Path
from typing import TYPE_CHECKING, Any

from evilengine.cli import options
from evilengine.values.checks import one_of
from evilengine.values.errors import ArgumentError

if TYPE_CHECKING:
    from evilengine.bench.peers import Peer

PARTS = ("steps", "growth", "access", "memory")
FLUID_PARTS = ("smoke", "water", "frame")


def add_arguments(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("what", choices=("physics", "draw", "fluid"), help="what to measure")
    parser.add_argument("--only", action="append", metavar="PART", help="only this part (may be given again)")
    parser.add_argument(
        "--scene", action="append", metavar="NAME", help="only steps of this scene (may be given again)"
    )
    parser.add_argument("--size", type=options.count, metavar="N", help="size of the scene (default: Box2D's)")
    parser.add_argument("--steps", type=options.count, metavar="N", help="steps to time (default: the scene's)")
    parser.add_argument("--warm", type=options.count, metavar="N", help="steps to make before (default: the scene's)")
    parser.add_argument(
        "--substeps", type=options.substeps, metavar="N", default=4, help="parts of a step (default: 4)"
    )
    parser.add_argument(
        "--threads", type=options.threads, metavar="N", help="threads of a step (default: one, and two beside it)"
    )
    parser.add_argument(
        "--peer", action="append", metavar="NAME", help="beside this engine only; none for none (default: all)"
    )
    parser.add_argument(
        "--patience",
        type=options.seconds,
        metavar="S",
        default=10.0,
        help="time a scene so long at most, and leave out a peer that takes longer to get there (default: 10)",
    )
    parser.add_argument("--json", metavar="FILE", help="write the numbers to FILE, too")


def run(args: argparse.Namespace) -> int:
    known = {"physics": PARTS, "fluid": FLUID_PARTS, "draw": ()}[args.what]
    for part in args.only or ():
        one_of(part, f"bench {args.what}", "--only", known)
    if args.what == "draw":
        return _draw(args)
    if args.what == "fluid":
        return _fluid(args)
    from evilengine.bench.scene import SCENES, find

    scenes = [find(name) for name in args.scene] if args.scene else list(SCENES.values())
    if args.size is not None and len(scenes) != 1:
        raise ArgumentError("--size is of one scene; name it with --scene")
    target = _target(args.json)
    peers = _peers(args.peer)
    parts = args.only or (("steps",) if args.scene else PARTS)
    numbers: dict[str, Any] = {"machine": _machine()}
    if "steps" in parts:
        _steps(args, scenes, peers, numbers)
    if "growth" in parts:
        _growth(numbers)
    if "access" in parts:
        _access(peers, numbers)
    if "memory" in parts:
        _memory(numbers)
    _write(target, numbers)
    return 0


def _draw(args: argparse.Namespace) -> int:
    from evilengine.bench import drawing, lit
    from evilengine.bench.crowd import SIZE
    from evilengine.bench.drawing_peers import PEERS

    names = [] if args.peer == ["none"] else [one_of(name, "bench", "--peer", PEERS) for name in args.peer or PEERS]
    target = _target(args.json)
    counts = drawing.COUNTS if args.size is None else (args.size,)
    rows, missing = drawing.measure(counts, args.steps or 20, names, args.patience, tell)
    said = f"{SIZE[0]} x {SIZE[1]}, with lights {lit.SIZE[0]} x {lit.SIZE[1]}"
    print(f"ms a frame of {said}, least\n{drawing.table_of(rows)}")
    for row in rows:
        for pair, ratio in row["ratios"].items():
            print(f"{row['sprites']} {row['scene']}: {pair} {ratio:.2f}")
    tell("the first frame")
    first = {renderer: drawing.first_frame(renderer) for renderer in ("soft", "gl")}
    said = ", ".join(f"{name} {seconds:.2f}" for name, seconds in first.items())
    print(f"seconds from a process's start to a level's first frame: {said}")
    _tell_left_out(missing, "bench-draw")
    _write(target, {"machine": _machine(), "draw": rows, "first_frame": first, "left_out": missing})
    return 0


def _fluid(args: argparse.Namespace) -> int:
    from evilengine.bench import gas, liquid
    from evilengine.bench.gas_peers import PEERS
    from evilengine.bench.physics import threads_to_try

    names = [] if args.peer == ["none"] else [one_of(name, "bench", "--peer", PEERS) for name in args.peer or PEERS]
    target = _target(args.json)
    parts = args.only or FLUID_PARTS
    if args.size is not None and len(parts) != 1:
        raise ArgumentError("--size is of one part: cells with --only smoke, particles with --only water")
    threads = threads_to_try(args.threads)
    plan = gas.Plan(steps=args.steps, warm=args.warm, threads=threads, patience=args.patience)
    numbers: dict[str, Any] = {"machine": _machine()}
    if "smoke" in parts:
        sizes = gas.SIZES if args.size is None else (args.size,)
        rows, missing = gas.measure(sizes, plan, names, tell)
        print(gas.tables_of(rows))
        _tell_left_out(missing, "bench-fluid")
        numbers |= {"smoke": rows, "left_out": missing}
    if "water" in parts:
        counts = liquid.COUNTS if args.size is None else (args.size,)
        numbers["water"] = liquid.measure(counts, plan, tell)
        print(f"\n{liquid.table_of(numbers['water'])}")
    if "frame" in parts:
        numbers["frame"] = one = liquid.measure_frame(plan, tell)
        print(f"\n{liquid.said_of(one)}")
    _write(target, numbers)
    return 0


def _tell_left_out(missing: list[str], extra: str) -> None:
    if missing:
        print(f"left out: {'; '.join(missing)}; pip install 'evilengine[{extra}]' brings who is not installed")


def _target(name: str | None) -> Path | None:
    """The file for the numbers, whose folder there must be before anything is measured."""
    target = Path(name) if name else None
    if target is not None and not target.parent.is_dir():
        raise ArgumentError(f"--json {name}: there is no folder {target.parent}")
    return target


def _write(target: Path | None, numbers: dict[str, Any]) -> None:
    if target is not None:
        target.write_text(json.dumps(numbers, indent=1) + "\n")
        print(f"\nwritten to {target}")


def tell(text: str) -> None:
    """What is being done, for who waits; not part of the result."""
    print(f"  {text}", file=sys.stderr, flush=True)


def _peers(names: list[str] | None) -> list[type[Peer]]:
    from evilengine.bench.peers import PEERS, found

    if names == ["none"]:
        return []
    here, missing = found([one_of(name, "bench", "--peer", PEERS) for name in names or PEERS])
    if missing:
        print(f"not installed, so not beside: {', '.join(missing)} (pip install 'evilengine[bench]' brings them)")
    return here


def _machine() -> dict[str, Any]:
    from evilengine import _core
    from evilengine.values.version import VERSION

    return {
        "evilengine": VERSION,
        "instructions": _core.instruction_sets()[-1],
        "python": platform.python_version(),
        "system": platform.platform(terse=True),
        "processors": os.cpu_count(),
    }


def _steps(args: argparse.Namespace, scenes: list[Any], peers: list[type[Peer]], numbers: dict[str, Any]) -> None:
    from evilengine.bench import report
    from evilengine.bench.physics import Plan, measure, threads_to_try
    from evilengine.bench.quality import qualities

    plan = Plan(
        steps=args.steps,
        warm=args.warm,
        substeps=args.substeps,
        threads=threads_to_try(args.threads),
        size=args.size,
        patience=args.patience,
    )
    engines = [*(f"{n} threads" for n in plan.threads[1:]), *(peer.name for peer in peers)]
    print(report.steps_head(engines))
    rows = []
    quality: dict[str, Any] = {}
    for scene in scenes:
        measured = measure(scene, plan, peers, tell)
        rows.append(measured.numbers())
        print(report.steps_row(rows[-1], engines), flush=True)
        if scene.name == "pyramid":
            quality = {"steps": rows[-1]["steps"], "engines": qualities(measured)}
            if "8 substeps" in measured.times:
                eight = measured.times["8 substeps"]
                print(f"  the same with 8 substeps: {eight.least:.3f} / {eight.median:.3f}")
    numbers["scenes"] = rows
    if quality:
        numbers["quality"] = quality
        print(f"\n{report.quality_table(quality['engines'], quality['steps'])}")


def _growth(numbers: dict[str, Any]) -> None:
    from evilengine.bench import report
    from evilengine.bench.growth import growth

    numbers["growth"] = {name: list(growth(name, tell)) for name in ("pile", "sparse")}
    print("\nhow the time of a step grows")
    for rows in numbers["growth"].values():
        print(report.growth_table(rows), flush=True)


def _access(peers: list[type[Peer]], numbers: dict[str, Any]) -> None:
    from evilengine.bench import report
    from evilengine.bench.access import casting, reading

    tell("making and reading bodies")
    numbers["access"] = reading(peers)
    for name, rays in casting(peers, tell).items():
        numbers["access"][name].update(rays)
    print(f"\nfrom Python\n{report.access_table(numbers['access'])}", flush=True)


def _memory(numbers: dict[str, Any]) -> None:
    from evilengine.bench.access import memory

    numbers["memory"] = used = memory()
    if used is None:
        print("\nmemory: only glibc says what is allocated")
    else:
        print(f"\nmemory: {used['body_bytes']:.0f} bytes a body, {used['contact_bytes']:.0f} bytes a contact")
