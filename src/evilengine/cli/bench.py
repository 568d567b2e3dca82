"""Measure the engine on this machine.

`evil bench physics` times steps of the scenes that tests and the testbed share, one thread, sleep off:
  evil bench physics                               all scenes
  evil bench physics --scene pyramid --steps 100   one of them
  evil bench physics --json numbers.json           the numbers as a file, too
"""

from __future__ import annotations

import argparse
import json
import sys
from pathlib import Path
from typing import Any

from evilengine.cli import options
from evilengine.values.errors import ArgumentError


def add_arguments(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("what", choices=("physics",), help="what to measure")
    parser.add_argument("--scene", action="append", metavar="NAME", help="only this scene (may be given again)")
    parser.add_argument("--size", type=options.count, metavar="N", help="size of the scene (default: Box2D's)")
    parser.add_argument("--steps", type=options.count, metavar="N", default=100, help="steps to time (default: 100)")
    parser.add_argument("--warm", type=options.count, metavar="N", help="steps to make before (default: the scene's)")
    parser.add_argument("--substeps", type=options.count, metavar="N", default=4, help="parts of a step (default: 4)")
    parser.add_argument("--threads", type=options.count, metavar="N", default=1, help="threads of a step (default: 1)")
    parser.add_argument("--json", metavar="FILE", help="write the numbers to FILE, too")


def run(args: argparse.Namespace) -> int:
    from evilengine.bench.physics import Plan, measure
    from evilengine.bench.scene import SCENES, find

    scenes = [find(name) for name in args.scene] if args.scene else list(SCENES.values())
    if args.size is not None and len(scenes) != 1:
        raise ArgumentError("--size is of one scene; name it with --scene")
    target = Path(args.json) if args.json else None
    if target is not None and not target.parent.is_dir():
        raise ArgumentError(f"--json {args.json}: there is no folder {target.parent}")
    plan = Plan(steps=args.steps, warm=args.warm, substeps=args.substeps, threads=args.threads, size=args.size)
    results: list[dict[str, Any]] = []
    for result in measure(scenes, plan, tell=lambda text: print(text, file=sys.stderr, flush=True)):
        results.append(result)
        print(line(result), flush=True)
    if target is not None:
        target.write_text(json.dumps({"scenes": results}, indent=1) + "\n")
    return 0


def line(result: dict[str, Any]) -> str:
    times = "  ".join(f"{name} {one['min']:.3f} / {one['median']:.3f} ms" for name, one in result["engines"].items())
    return f"{result['scene']:<15} {result['bodies']:>6} bodies {result['contacts']:>6} contacts   {times}"
