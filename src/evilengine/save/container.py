"""The container: named sections of bytes in one file, which are believed only when every byte is as it was written.

    magic (8 bytes)   version (u32)   length (u64)   sections ...   checksum (16 bytes)          little-endian
    each section: length of its name (u8), name, length (u64), bytes

This frame stays as it is in every version, so that a damaged file can be told from a newer one. What the sections hold
belongs to the version; an older one is brought up to date by the functions of `migrations`, one version at a time.
"""

from __future__ import annotations

import hashlib
import struct
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import TypeAlias

from evilengine.values.errors import DamagedSaveError, SaveError

Sections: TypeAlias = dict[str, bytes]
Migration: TypeAlias = Callable[[Sections], Sections]
"""Sections of one version to those of the next."""

_HEAD = struct.Struct("<8sIQ")
_CHECKSUM = 16
LARGEST = 1 << 31
"""Bytes of a whole file: more is a mistake, or an attack on the memory."""


@dataclass(frozen=True, slots=True)
class Container:
    """A kind of file: its magic word, its version, and how older versions become this one.

    >>> letters = Container(b"EVILTEST", "a letter", 1, {0: lambda old: {"text": old["words"]}})
    >>> letters.read(letters.write({"text": b"hello"}), "a.letter")
    {'text': b'hello'}
    >>> letters.read(Container(b"EVILTEST", "a letter", 0, {}).write({"words": b"hi"}), "old.letter")
    {'text': b'hi'}
    """

    magic: bytes
    what: str
    """What a file of this kind is called in errors: "a saved game"."""
    version: int
    migrations: Mapping[int, Migration]

    def write(self, sections: Mapping[str, bytes]) -> bytes:
        """The bytes of a file with these sections."""
        body = b"".join(
            bytes([len(name)]) + name.encode("ascii") + struct.pack("<Q", len(data)) + data
            for name, data in sections.items()
        )
        whole = _HEAD.pack(self.magic, self.version, len(body)) + body
        return whole + _sum(whole)

    def read(self, data: bytes, name: str) -> Sections:
        """The sections in `data`, as this version has them; `name` is what errors call the file. Raises SaveError."""
        if data[: len(self.magic)] != self.magic[: len(data)] or not data:
            raise DamagedSaveError(f"{name} is not {self.what}")
        if len(data) < _HEAD.size + _CHECKSUM:
            raise DamagedSaveError(f"{name} is cut short; it is not whole any more")
        _, version, length = _HEAD.unpack_from(data)
        if length != len(data) - _HEAD.size - _CHECKSUM:
            cut = length > len(data) - _HEAD.size - _CHECKSUM
            raise DamagedSaveError(f"{name} is {'cut short' if cut else 'damaged'}; it is not whole any more")
        if _sum(data[:-_CHECKSUM]) != data[-_CHECKSUM:]:
            raise DamagedSaveError(f"{name} is damaged: its checksum does not fit its bytes")
        if version > self.version:
            raise SaveError(
                f"{name} was written by a newer version of the engine (its format is {version}, this engine knows"
                f" up to {self.version}); update the engine to read it"
            )
        sections = _sections(data[_HEAD.size : -_CHECKSUM], name)
        for old in range(version, self.version):
            if old not in self.migrations:
                raise SaveError(
                    f"{name} was written by a version of the engine too old to be read (its format is {old})"
                )
            try:
                sections = self.migrations[old](sections)
            except (KeyError, ValueError, TypeError, AttributeError) as problem:
                raise SaveError(f"{name} is no sound file of format {old}: {problem!r}") from problem
        return sections


def _sum(data: bytes) -> bytes:
    return hashlib.blake2b(data, digest_size=_CHECKSUM).digest()


def _sections(body: bytes, name: str) -> Sections:
    sections: Sections = {}
    at = 0
    while at < len(body):
        letters = body[at]
        head = at + 1 + letters
        if head + 8 > len(body):
            break
        (length,) = struct.unpack_from("<Q", body, head)
        end = head + 8 + length
        title = body[at + 1 : head].decode("ascii", "replace")
        if end > len(body) or title in sections:
            break
        sections[title] = body[head + 8 : end]
        at = end
    if at != len(body):
        raise DamagedSaveError(f"{name} is damaged: its sections do not fit together")
    return sections
