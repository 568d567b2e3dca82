"""Sound files before they are decoded: which format a file is in, and whether all of it is there.

Decoders play what they find and stop where it ends; a file that was cut short or damaged on its way would be heard as
if it were meant so. These checks read headers, lengths and checksums, and never decode.
"""

from __future__ import annotations

import struct
import zlib
from collections.abc import Callable, Iterator

ENDINGS = ("wav", "ogg", "mp3", "flac")
_LONGEST_TAGS = 2**24  # bytes: a picture of the cover may be among them
_REVERSED = bytes(int(f"{byte:08b}"[::-1], 2) for byte in range(256))


class DamagedError(Exception):
    """Why a file cannot be played."""


def format_of(data: bytes) -> str:
    """ "wav", "ogg", "mp3" or "flac", by what the file holds, whatever its name. Raises DamagedError if it is none."""
    if data[:4] == b"RIFF" and data[8:12] == b"WAVE":
        return "wav"
    if data[:4] == b"OggS":
        return "ogg"
    if data[:4] == b"fLaC":
        return "flac"
    if data[:3] == b"ID3" or _mp3_frame(data, 0) is not None:
        return "mp3"
    if any(magic.startswith(data[: len(magic)]) for magic in (b"RIFF", b"OggS", b"fLaC", b"ID3")) or len(data) < 12:
        raise DamagedError("it is cut short: not even its first bytes are whole" if data else "it is empty")
    raise DamagedError(
        f"this is no sound that can be read (it starts with {data[:12]!r}); known are {', '.join(ENDINGS)}"
    )


def check(data: bytes, kind: str) -> None:
    """Raise DamagedError, with the reason, unless `data` is a whole file of this format."""
    checks: dict[str, Callable[[bytes], None]] = {"wav": _check_wav, "ogg": _check_ogg, "mp3": _check_mp3}
    if kind in checks:  # FLAC says how long it is: who decodes it compares
        checks[kind](data)


# WAV: chunks of a name, a length and as many bytes, padded to even (RIFF, Microsoft and IBM 1991) ---------------------


def _check_wav(data: bytes) -> None:
    chunks = dict(_chunks(data))
    if b"fmt " not in chunks or b"data" not in chunks:
        raise DamagedError("it is cut short or damaged: no samples follow its header")
    if chunks[b"data"] == 0:
        raise DamagedError("it holds no samples")


def _chunks(data: bytes) -> Iterator[tuple[bytes, int]]:
    at = 12
    while at < len(data):
        if at + 8 > len(data):
            raise DamagedError("it is cut short: it ends within the header of a chunk")
        name, size = data[at : at + 4], int.from_bytes(data[at + 4 : at + 8], "little")
        if name == b"data" and size == 0xFFFFFFFF:  # written to a pipe, by somebody who did not know the length
            size = len(data) - at - 8
        if at + 8 + size > len(data):
            raise DamagedError(f"it is cut short: {at + 8 + size - len(data)} bytes are missing at the end")
        yield name, size
        at += 8 + size + size % 2


# Ogg: pages with a checksum each, the last one marked (RFC 3533) ------------------------------------------------------


def _check_ogg(data: bytes) -> None:
    unfinished: set[bytes] = set()
    at, first, head = 0, b"", b""
    while at < len(data):
        flags, serial, body, end = _ogg_page(data, at)
        if at == 0:
            first = serial
            _check_vorbis(data[body : body + 8])
        elif serial == first and len(head) < _LONGEST_TAGS:
            head += data[body:end]  # tags come in the packet after the first, which has a page of its own
        (unfinished.discard if flags & 4 else unfinished.add)(serial)
        at = end
    if unfinished:
        raise DamagedError("it is cut short: its last page is missing")
    _check_tags(head)


def _check_tags(packet: bytes) -> None:
    """Lengths in the tags that lead out of them: the decoder would follow them anywhere."""
    if packet[:7] != b"\x03vorbis":
        raise DamagedError("it is damaged: no tags follow its header")
    at = 7
    try:
        at += 4 + int(struct.unpack_from("<I", packet, at)[0])
        count = int(struct.unpack_from("<I", packet, at)[0])
        at += 4
        for _ in range(count):
            at += 4 + int(struct.unpack_from("<I", packet, at)[0])
    except struct.error:
        raise DamagedError("it is damaged: its tags do not fit in it") from None
    if at >= len(packet):
        raise DamagedError("it is damaged: its tags do not fit in it")


def _ogg_page(data: bytes, at: int) -> tuple[int, bytes, int, int]:
    """Flags and serial of the page at `at`, where its body begins, and where it ends."""
    if data[at : at + 4] != b"OggS"[: len(data) - at]:
        raise DamagedError(f"it is damaged at byte {at}")
    body = at + 27 + data[at + 26] if at + 27 <= len(data) else len(data) + 1
    end = body + sum(data[at + 27 : body])
    if end > len(data):
        raise DamagedError("it is cut short: its last page is not whole")
    page = data[at : at + 22] + bytes(4) + data[at + 26 : end]
    if _ogg_checksum(page) != int.from_bytes(data[at + 22 : at + 26], "little"):
        raise DamagedError(f"it is damaged: the checksum of the page at byte {at} is wrong")
    return data[at + 5], data[at + 14 : at + 18], body, end


def _ogg_checksum(page: bytes) -> int:
    """CRC-32 with the highest bit first: zlib's, which takes the lowest first, of the mirrored bytes."""
    mirrored = zlib.crc32(page.translate(_REVERSED), 0xFFFFFFFF) ^ 0xFFFFFFFF
    return int(f"{mirrored:032b}"[::-1], 2)


def _check_vorbis(packet: bytes) -> None:
    if packet[:7] == b"\x01vorbis":
        return
    inside = "Opus" if packet[:8] == b"OpusHead" else "FLAC" if packet[1:5] == b"FLAC" else "something else"
    raise DamagedError(f"there is {inside} in this Ogg file, where Vorbis can be read; convert it")


# MP3: frames, each with a header that says its length (ISO 11172-3) ---------------------------------------------------

_RATES = {3: (44100, 48000, 32000), 2: (22050, 24000, 16000), 0: (11025, 12000, 8000)}
_KILOBITS_1 = (0, 32, 40, 48, 56, 64, 80, 96, 112, 128, 160, 192, 224, 256, 320)
_KILOBITS_2 = (0, 8, 16, 24, 32, 40, 48, 56, 64, 80, 96, 112, 128, 144, 160)
_TAGS = (b"TAG", b"APETAGEX", b"LYRICSBEGIN")


def _mp3_frame(data: bytes, at: int) -> int | None:
    """Bytes of the layer III frame at `at`, or None if there is none."""
    if at + 4 > len(data) or data[at] != 0xFF or data[at + 1] & 0xE6 != 0xE2:
        return None
    version, bits, rate = data[at + 1] >> 3 & 3, data[at + 2] >> 4, data[at + 2] >> 2 & 3
    if version == 1 or bits in (0, 15) or rate == 3:
        return None
    kilobits = (_KILOBITS_1 if version == 3 else _KILOBITS_2)[bits]
    return (144000 if version == 3 else 72000) * kilobits // _RATES[version][rate] + (data[at + 2] >> 1 & 1)


def _check_mp3(data: bytes) -> None:
    at = _after_id3(data)
    frames, promised = 0, None
    while at < len(data) and not data.startswith(_TAGS, at):
        size = _mp3_frame(data, at)
        if size is None:
            at = _next_mp3_frame(data, at + 1)
            continue
        if at + size > len(data):
            raise DamagedError("it is cut short: its last frame is not whole")
        if frames == 0:
            promised = _promised_frames(data[at : at + size])
        frames += 1
        at += size
    if frames == 0:
        raise DamagedError("it is cut short or damaged: there is no whole frame in it")
    if promised is not None and frames < promised:
        raise DamagedError(f"it is cut short: {frames} frames of {promised} are there")


def _next_mp3_frame(data: bytes, at: int) -> int:
    """Where the next frame begins after something else; only one that another follows is believed."""
    while (at := data.find(b"\xff", at)) >= 0:
        size = _mp3_frame(data, at)
        if size is not None and (at + size == len(data) or _mp3_frame(data, at + size) is not None):
            return at
        at += 1
    return len(data)


def _after_id3(data: bytes) -> int:
    if data[:3] != b"ID3":
        return 0
    if len(data) < 10:
        raise DamagedError("it is cut short within its tags")
    size = 10 + sum((byte & 127) << shift for byte, shift in zip(data[6:10], (21, 14, 7, 0), strict=True))
    if size >= len(data):
        raise DamagedError("it is cut short within its tags")
    return size


def _promised_frames(first: bytes) -> int | None:
    """How many frames an encoder's note in the first frame tells of, that frame among them."""
    for mark in (b"Xing", b"Info"):
        at = first.find(mark, 4, 48)
        if at >= 0 and len(first) >= at + 12 and first[at + 7] & 1:
            return int(struct.unpack_from(">I", first, at + 8)[0]) + 1
    return None
