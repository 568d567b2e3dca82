"""Save files: whole or not at all, with a backup, and believed only when every byte is as it was written."""

from __future__ import annotations

import errno
import os
import signal
import subprocess
import sys
import time
import tracemalloc

import pytest

import evilengine as evil
from evilengine.save import Container, Functions, Slots, write_whole
from evilengine.save.files import LARGEST, read_whole, saves_folder

LETTERS = Container(b"EVILTEST", "a letter", 3, {1: lambda old: {"text": old["words"]}, 2: lambda old: old})
SECTIONS = {"text": b"hello", "empty": b"", "more": bytes(range(256))}


def read(data, name="a.letter"):
    return LETTERS.read(data, name)


def test_what_is_written_is_read_again():
    assert read(LETTERS.write(SECTIONS)) == SECTIONS


def test_a_file_cut_at_any_place_is_refused():
    data = LETTERS.write(SECTIONS)
    for length in range(len(data)):
        with pytest.raises(evil.SaveError, match=r"a\.letter"):
            read(data[:length])


def test_a_file_with_any_byte_changed_is_refused():
    data = LETTERS.write(SECTIONS)
    for at in range(len(data)):
        for flip in (0x01, 0x80, 0xFF):
            changed = bytearray(data)
            changed[at] ^= flip
            with pytest.raises(evil.SaveError):
                read(bytes(changed))


def test_a_file_that_goes_on_after_its_end_is_refused():
    with pytest.raises(evil.SaveError, match="damaged"):
        read(LETTERS.write(SECTIONS) + b"x")


def test_something_else_is_not_taken_for_a_file_of_ours():
    with pytest.raises(evil.SaveError, match="is not a letter"):
        read(b"\x89PNG\r\n\x1a\n" + bytes(1000))


def test_a_newer_version_is_refused_clearly():
    newer = Container(b"EVILTEST", "a letter", 4, {}).write(SECTIONS)
    with pytest.raises(evil.SaveError, match=r"newer version of the engine .* update the engine"):
        read(newer)


def test_an_older_version_is_migrated_step_by_step():
    assert read(Container(b"EVILTEST", "a letter", 1, {}).write({"words": b"hi"})) == {"text": b"hi"}


def test_a_version_too_old_and_one_that_does_not_migrate_are_refused():
    with pytest.raises(evil.SaveError, match="too old"):
        read(Container(b"EVILTEST", "a letter", 0, {}).write({"words": b"hi"}))
    with pytest.raises(evil.SaveError, match="format 1"):
        read(Container(b"EVILTEST", "a letter", 1, {}).write({"wrong": b"hi"}))


@pytest.mark.parametrize("title", ["Tilt", "Space Cats!", "../../etc", "", "日本"])
def test_each_title_has_a_folder_inside_that_of_the_saves(title, monkeypatch, tmp_path):
    monkeypatch.setenv("EVILENGINE_SAVES", str(tmp_path))
    path = Slots(title).path("one", "test")
    assert path.parent.parent == tmp_path
    assert path.name == "one.evs"


def test_without_the_variable_saves_lie_in_the_users_data_folder(monkeypatch):
    import platformdirs

    monkeypatch.delenv("EVILENGINE_SAVES", raising=False)
    assert saves_folder().is_relative_to(platformdirs.user_data_path())


@pytest.mark.parametrize("slot", ["", "a b", "../x", "a/b", "a.b", "x" * 65, "ä", "one\n"])
def test_names_of_slots_are_checked(slot):
    with pytest.raises(evil.ArgumentError, match="letters"):
        Slots("Test").path(slot, "Game.save")
    with pytest.raises(evil.ArgumentTypeError):
        Slots("Test").path(3, "Game.save")


# Writing --------------------------------------------------------------------------------------------------------------


def store(folder, text):
    slots = Slots("Test", folder)
    path = slots.path("one", "test")
    slots.write(path, LETTERS.write({"text": text}), lambda data: LETTERS.read(data, "one"))
    return path


def load(folder):
    slots = Slots("Test", folder)
    return slots.read(slots.path("one", "test"), LETTERS.read)["text"]


def test_the_newest_is_read_and_the_one_before_it_is_the_backup(tmp_path):
    for text in (b"one", b"two", b"three"):
        path = store(tmp_path, text)
    assert load(tmp_path) == b"three"
    path.unlink()
    assert load(tmp_path) == b"two"
    assert sorted(file.name for file in tmp_path.iterdir()) == ["one.evs.before"]


def test_a_damaged_file_gives_way_to_its_backup_with_one_line_of_notice(tmp_path, caplog):
    store(tmp_path, b"one")
    path = store(tmp_path, b"two")
    path.write_bytes(path.read_bytes()[:-5])
    assert load(tmp_path) == b"one"
    assert len(caplog.messages) == 1
    assert "one.evs is cut short" in caplog.messages[0]
    assert "the save before it" in caplog.messages[0]


def test_a_damaged_file_never_becomes_the_backup(tmp_path):
    store(tmp_path, b"one")
    path = store(tmp_path, b"two")
    path.write_bytes(b"EVILTEST, but not really")
    store(tmp_path, b"three")
    path.write_bytes(b"")
    assert load(tmp_path) == b"one"


def test_a_newer_version_is_not_replaced_by_its_backup(tmp_path):
    store(tmp_path, b"one")
    path = store(tmp_path, b"two")
    path.write_bytes(Container(b"EVILTEST", "a letter", 4, {}).write({"text": b"later"}))
    with pytest.raises(evil.SaveError, match="newer"):
        load(tmp_path)


def test_an_empty_slot_says_which_there_are(tmp_path):
    with pytest.raises(evil.SaveError, match="nothing is saved in slot 'one'"):
        load(tmp_path)
    store(tmp_path, b"one")
    slots = Slots("Test", tmp_path)
    with pytest.raises(evil.SaveError, match="there are 'one'"):
        slots.read(slots.path("two", "test"), LETTERS.read)
    assert slots.names() == ("one",)


def fail_with(error):
    def fail(*args, **kwargs):
        raise OSError(error, os.strerror(error))

    return fail


class FullDisk:
    """A file that takes some bytes and then no more."""

    def __init__(self, stream):
        self._stream = stream

    def __enter__(self):
        return self

    def __exit__(self, *args):
        self._stream.close()

    def write(self, data):
        self._stream.write(data[: len(data) // 2])
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))

    def __getattr__(self, name):
        return getattr(self._stream, name)


@pytest.mark.parametrize("failing", ["open", "write", "fsync", "replace", "both names"])
def test_whatever_fails_while_writing_nothing_is_lost(failing, tmp_path, monkeypatch):
    store(tmp_path, b"one")
    path = store(tmp_path, b"two")
    with monkeypatch.context() as patch:
        if failing == "open":  # as in a folder that may only be read
            patch.setattr(os, "open", fail_with(errno.EROFS))
            real = type(path).open
            patch.setattr(
                type(path), "open", lambda self, mode="r": (fail_with(errno.EROFS) if "w" in mode else real)(self, mode)
            )
        elif failing == "write":
            real = type(path).open
            patch.setattr(
                type(path),
                "open",
                lambda self, mode="r": FullDisk(real(self, mode)) if "w" in mode else real(self, mode),
            )
        elif failing == "fsync":
            patch.setattr(os, "fsync", fail_with(errno.ENOSPC))
        elif failing == "replace":
            patch.setattr(os, "replace", fail_with(errno.EIO))
        else:
            patch.setattr(os, "link", fail_with(errno.EPERM))
            patch.setattr(os, "replace", fail_with(errno.EIO))
        with pytest.raises(evil.SaveError, match=r"cannot be written: .*; what was there before stays"):
            store(tmp_path, b"three")
    assert load(tmp_path) == b"two"
    assert sorted(file.name for file in tmp_path.iterdir()) == ["one.evs", "one.evs.before"]
    store(tmp_path, b"four")
    assert load(tmp_path) == b"four"


def test_reading_takes_as_much_memory_as_the_file_is_large_and_no_more(tmp_path):
    file = tmp_path / "small"
    file.write_bytes(b"x" * 1000)
    tracemalloc.start()
    try:
        assert len(read_whole(file, LARGEST)) == 1000
        assert tracemalloc.get_traced_memory()[1] < 100_000
    finally:
        tracemalloc.stop()
    with pytest.raises(evil.SaveError, match="larger than 999 bytes"):
        read_whole(file, 999)


def test_a_file_system_without_links_keeps_a_backup_too(tmp_path, monkeypatch):
    monkeypatch.setattr(os, "link", fail_with(errno.EPERM))
    store(tmp_path, b"one")
    path = store(tmp_path, b"two")
    path.unlink()
    assert load(tmp_path) == b"one"


def test_a_folder_that_is_a_file_is_an_error_of_ours(tmp_path):
    (tmp_path / "saves").write_text("I am a file")
    with pytest.raises(evil.SaveError, match="cannot be written"):
        write_whole(tmp_path / "saves" / "one.evs", b"data")


@pytest.mark.skipif(not hasattr(os, "geteuid") or os.geteuid() == 0, reason="root may write anywhere")
def test_a_folder_that_may_not_be_written_is_an_error_of_ours(tmp_path):
    store(tmp_path, b"one")
    tmp_path.chmod(0o555)
    try:
        with pytest.raises(evil.SaveError, match="cannot be written"):
            store(tmp_path, b"two")
        assert load(tmp_path) == b"one"
    finally:
        tmp_path.chmod(0o755)


def test_what_a_killed_process_left_is_swept_away_later(tmp_path):
    left = tmp_path / ".one.evs.1234.new"
    left.write_bytes(b"half of a sa")
    os.utime(left, (time.time() - 7200, time.time() - 7200))
    store(tmp_path, b"one")
    assert [file.name for file in tmp_path.iterdir()] == ["one.evs"]


WRITER = """
import sys
from pathlib import Path
from evilengine.save import Container, Slots
letters = Container(b"EVILTEST", "a letter", 3, {})
slots = Slots("Test", Path(sys.argv[1]))
path = slots.path("one", "test")
count = 0
while True:
    count += 1
    slots.write(path, letters.write({"text": b"%d " % count * 20_000}), lambda data: letters.read(data, "one"))
    print(count, flush=True)
"""


@pytest.mark.skipif(sys.platform == "win32", reason="kill -9 is a signal")
def test_killed_at_any_moment_the_last_save_is_whole(tmp_path):
    for part in range(8):
        process = subprocess.Popen([sys.executable, "-c", WRITER, str(tmp_path)], stdout=subprocess.PIPE, text=True)
        assert process.stdout is not None
        process.stdout.readline()  # it has saved once
        time.sleep(0.004 * part + 0.001)
        process.send_signal(signal.SIGKILL)
        said = [int(line) for line in process.stdout.read().split()]
        process.stdout.close()
        process.wait()
        data = (tmp_path / "one.evs").read_bytes()
        number = int(LETTERS.read(data, "one")["text"].split()[0])
        assert number >= max(said, default=1), "what was reported as saved is there"
        assert (tmp_path / "one.evs.before").exists() or number == 1


# Functions ------------------------------------------------------------------------------------------------------------


def at_the_top():
    pass


def test_functions_are_found_by_the_names_they_have():
    functions = Functions()
    name = functions.name_of(at_the_top, "here")
    assert name == f"{__name__}:at_the_top"
    assert functions.find(name) is at_the_top


def test_functions_that_no_name_leads_to_are_refused_and_named():
    functions = Functions()

    def inner():
        pass

    for function in (inner, lambda: None, functions.find):
        with pytest.raises(evil.SaveError, match=r"on a timer: the function .* cannot be saved.*game\.register"):
            functions.name_of(function, "on a timer")


def test_a_registered_function_is_saved_by_its_name_methods_too():
    functions = Functions()

    class Counter:
        def more(self):
            pass

    counter = Counter()
    functions.register("more", counter.more)
    assert functions.name_of(counter.more, "here") == "more"
    assert functions.find("more") == counter.more
    with pytest.raises(evil.SaveError):
        functions.name_of(Counter().more, "here")


@pytest.mark.parametrize(
    "name", ["os:system", "os:abort", "sys:exit", "nowhere:nothing", "builtins:print", ":x", "a:", "subprocess:run"]
)
def test_a_file_cannot_make_the_engine_call_what_the_game_does_not_know(name):
    with pytest.raises(evil.SaveError, match="not there"):
        Functions().find(name)


def test_finding_a_function_imports_nothing(tmp_path, monkeypatch):
    (tmp_path / "trap_for_imports.py").write_text("raise SystemExit('imported')\ndef f(): pass\n")
    monkeypatch.syspath_prepend(tmp_path)
    with pytest.raises(evil.SaveError):
        Functions().find("trap_for_imports:f")


@pytest.mark.parametrize("name", ["", "a:b", "x" * 201])
def test_names_for_functions_are_checked(name):
    with pytest.raises(evil.ArgumentError):
        Functions().register(name, at_the_top)
