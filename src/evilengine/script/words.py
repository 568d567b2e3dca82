"""Every word of the level language, and which one somebody meant who wrote another.

The tables (statements.py, kinds.py, properties.py) drive the parser, the checker, the suggestions and the reference
page docs/level-language.md, so a new word is one entry there. A later subject has its kinds and properties in a file of
its own, as joints.py does, and those two take them in.
"""

from __future__ import annotations

import difflib
import functools
from collections.abc import Iterable, Mapping

from evilengine.script.kinds import KINDS
from evilengine.script.properties import PROPERTIES
from evilengine.script.statements import ARITY, CHARACTER_EVENTS, EVENT_MEANT, EVENTS, FUNCTIONS, MEETINGS, STATEMENTS
from evilengine.script.waters import FLOWS
from evilengine.script.word import Kind, Property, Word

DRAWN = ("rectangle", "circle", "triangle", "polygon", "capsule", "segment", "chain")
"""The kinds that `draw` knows."""
ONLY = {"slice": ("rectangle",), "colours": ("rectangle", "triangle", "polygon")}
"""Looks that only some kinds have."""
PROPERTY_WORDS = frozenset(word for each in PROPERTIES for word in (each.word, *each.spellings))
JOINING_WORDS = frozenset({"times", "as", "else", "and", "or", "not"})
EVENT_NAMES = frozenset({"this", "other"})
RESERVED = frozenset(STATEMENTS) | frozenset(KINDS) | PROPERTY_WORDS | JOINING_WORDS | EVENT_NAMES
"""Words that cannot be names. Functions can: `floor` is one only with a ( right after it."""


def kind_called(word: str) -> Kind:
    """The kind of what `new` makes, or a statement about water."""
    return KINDS.get(word) or FLOWS[word]


def property_of(word: str, family: str) -> Property | None:
    """The property that `word` means for something of this family."""
    for each in PROPERTIES:
        if (each.word == word or word in each.spellings) and family in each.families:
            return each
    return None


def properties_of(family: str) -> list[Property]:
    """Every property that something of this family may take; some of shapes are for some kinds only."""
    return [each for each in PROPERTIES if family in each.families]


def changes_of(family: str) -> str:
    """A hint: what `set` changes of something of this family.

    >>> changes_of("liquid")
    'of a liquid, set changes density, viscosity, surfaceTension, colour'
    """
    words = [each.word for each in properties_of(family) if each.settable]
    return f"of {some(family)}, set changes {', '.join(words)}" if words else ""


_MANY = frozenset({"particles", "walls"})
_MUCH = frozenset({"smoke", "water", "drag", "music"})
_OF_FAMILY = {"body": "thing"}


def some(word: str) -> str:
    """A kind or family as people speak of one: with its article, if it has one.

    >>> some("light"), some("particles"), some("smoke"), some("body")
    ('a light', 'particles', 'smoke', 'a thing')
    """
    word = _OF_FAMILY.get(word, word)
    return word if word in _MANY | _MUCH else f"{'an' if word[:1] in 'aeiou' else 'a'} {word}"


def has(word: str, verb: str = "has") -> str:
    """A kind or family with what it does.

    >>> has("light"), has("particles"), has("particles", "needs"), has("walls", "takes")
    ('a light has', 'particles have', 'particles need', 'walls take')
    """
    return f"{some(word)} {({'has': 'have'}.get(verb) or verb.removesuffix('s')) if word in _MANY else verb}"


def takes(kind: Kind, entry: Property) -> bool:
    """Whether a property of its family is one of this kind's."""
    return kind.word in ONLY[entry.word] if entry.word in ONLY else entry.part != "shape" or entry.word in kind.shaped


def placed(kind: Kind) -> bool:
    """Whether its place may follow its sizes, as in `new rectangle 2 1 0 4`."""
    return bool(kind.sizes) and property_of("at", kind.family) is not None


def near(wrong: str, words: Iterable[str], meant: Mapping[str, str] | None = None) -> str | None:
    """The one of `words` that somebody who wrote `wrong` most likely wanted, or None.

    >>> near("rectangel", KINDS), near("Circle", KINDS), near("xyzzy", KINDS)
    ('rectangle', 'circle', None)
    """
    candidates = list(words)
    folded = {each.lower(): each for each in reversed(candidates)}
    lower = wrong.lower()
    if lower in folded:
        return folded[lower]
    if meant and lower in meant:
        return meant[lower]
    if len(wrong) > 40 or len(wrong) < 2:
        return None
    close = difflib.get_close_matches(lower, folded, n=1, cutoff=0.6)
    return folded[close[0]] if close else None


def meant_for(words: Iterable[Word]) -> dict[str, str]:
    """What people write -> the word that they mean."""
    return {wrong.lower(): each.word for each in words for wrong in each.meant}


@functools.lru_cache(maxsize=1000)
def near_statement(wrong: str) -> str | None:
    meant, word = meant_for(STATEMENTS.values()), wrong.lower()
    if word not in meant and word in meant_for(KINDS.values()):
        return None  # another name of a kind is no statement that happens to look like it
    return near(wrong, STATEMENTS, meant)


@functools.lru_cache(maxsize=1000)
def near_kind(wrong: str) -> str | None:
    return near(wrong, KINDS, meant_for(KINDS.values()))


@functools.lru_cache(maxsize=1000)
def near_property(wrong: str, family: str) -> str | None:
    """The property word of this family, or failing that of any, that `wrong` is near to."""
    own = properties_of(family)
    return near(wrong, [each.word for each in own], meant_for(own))


@functools.lru_cache(maxsize=1000)
def near_change(wrong: str, family: str) -> str | None:
    """The property of this family that `set` changes and that `wrong` is near to."""
    own = [each for each in properties_of(family) if each.settable]
    return near(wrong, [each.word for each in own], meant_for(own))


__all__ = [
    "ARITY", "CHARACTER_EVENTS", "DRAWN", "EVENTS", "EVENT_MEANT", "EVENT_NAMES", "FUNCTIONS", "JOINING_WORDS", "KINDS",
    "MEETINGS", "ONLY", "PROPERTIES", "PROPERTY_WORDS", "RESERVED", "STATEMENTS", "changes_of", "has", "kind_called",
    "meant_for", "near", "near_change", "near_kind", "near_property", "near_statement", "placed", "properties_of",
    "property_of", "some", "takes",
]  # fmt: skip
