"""Levels with errors: each error is found, at its word, with the mending that was meant, and nothing else is said."""

from __future__ import annotations

import json
from argparse import ArgumentParser
from pathlib import Path

import pytest

from evilengine import script
from evilengine.cli import check
from evilengine.script.lexer import Source, tokens
from evilengine.script.words import EVENTS, KINDS, PROPERTY_WORDS, STATEMENTS
from evilengine.values.errors import AssetError, LevelError

GOLDEN = Path(__file__).parent / "golden" / "level_errors.txt"

# (level, where and what, what it suggests)
MISTAKES = [
    ("new rectangel 2 1 at 0 4;", "1:5 unknown-kind", "did you mean 'rectangle'?"),
    ("new box 2 1 at 0 4;", "1:5 unknown-kind", "did you mean 'rectangle'?"),
    ("nwe circle 1 at 0 4;", "1:1 unknown-statement", "did you mean 'new'?"),
    ("new circle ball 1; delete ball;", "1:20 unknown-statement", "did you mean 'destroy'?"),
    ("circle 1 at 0 4;", "1:1 missing-new", "did you mean 'new circle'?"),
    ("new circle 1 at 0 4 frction 0.5;", "1:21 unknown-property", "did you mean 'friction'?"),
    ("new circle 1 at 0 4 bounce 0.5;", "1:21 unknown-property", "did you mean 'restitution'?"),
    ("new circle 1 at 0 4 colour rde;", "1:28 unknown-colour", "did you mean 'red'?"),
    ("new circle 1 at 0 4 colour #ff0000;", "1:28 unquoted-colour", 'write "#ff0000"'),
    ("new circle 1 at 0 4 angle 30dge;", "1:29 unknown-unit", "did you mean 30deg?"),
    ("new circle 1 at 0 4 angle 30 deg;", "1:30 loose-unit", "write 30deg"),
    ("new circle 0,5 at 0 4;", "1:12 decimal-comma", "write 0.5"),
    ("new circle 1 at (0, 4);", "1:17 odd-parentheses", "as in: 1 2"),
    ("new circle -1 at 0 4;", "1:12 out-of-range", "the radius is from 0.001 to 10000"),
    ('on hit "ball" { }', "1:4 unknown-event", "did you mean 'on collide'?"),
    ('on key "spacebar" { }', "1:8 unknown-key", 'did you mean "space"?'),
    ("gravity 0-9.81;", "1:10 loose-arithmetic", "write 0 -9.81 for two numbers, or (0-9.81) for one"),
    ("gravity 0 -9.81", "1:16 missing-semicolon", "put a ; here"),
    ("after 2 { ", "1:9 missing-brace", "put a } where the block ends"),
    ("view 16;", "1:8 missing-number", "as in: view 16 9;"),
]


def cases() -> list[tuple[str, str]]:
    """(level, its full report) out of the golden file."""
    parts = GOLDEN.read_text(encoding="utf-8").split("=== level\n")[1:]
    pairs = [part.split("\n=== report\n") for part in parts]
    return [(level, report.removesuffix("\n")) for level, report in pairs]


@pytest.mark.parametrize(("level", "report"), cases())
def test_the_full_report_of_a_broken_level_is_as_it_was_judged(level: str, report: str) -> None:
    _, errors = script.check(level)
    assert "\n\n".join(map(str, errors)) == report


def test_every_golden_level_is_broken() -> None:
    assert len(cases()) > 100
    assert all(script.check(level)[1] for level, _ in cases())


@pytest.mark.parametrize(("level", "place", "suggestion"), MISTAKES)
def test_a_mistake_is_said_once_at_its_word_with_a_suggestion(level: str, place: str, suggestion: str) -> None:
    _, errors = script.check(level)
    said = [(f"{error.line}:{error.column} {error.code}", error.suggestion) for error in errors]
    assert said == [(place, suggestion)]


def test_every_error_of_a_file_is_reported_in_order() -> None:
    level = "\n".join(level for level, _, _ in MISTAKES if "{" not in level and not level.endswith("9.81"))
    lines = [error.line for error in script.check(level)[1]]
    assert lines == sorted(lines)
    assert set(lines) == set(range(1, level.count("\n") + 2))


def test_a_missing_semicolon_is_reported_at_the_end_of_the_line_that_lacks_it() -> None:
    level = "view 16 9;\nnew circle 1 at 0 4   # a ball\n\nnew circle 2 at 5 4;\n"
    (error,) = script.check(level)[1]
    assert (error.line, error.column, error.code) == (2, 20, "missing-semicolon")


def test_a_missing_semicolon_never_changes_what_the_next_statement_means() -> None:
    good = ["new circle a 1 at 0 4;", "new circle b 1 at 3 4 physicsOn;", "tilt on;", "on shake { destroy a; }"]
    whole, _ = script.check("\n".join(good))
    for line in range(3):
        lines = list(good)
        lines[line] = lines[line].rstrip(";")
        level, errors = script.check("\n".join(lines))
        assert [error.code for error in errors] == ["missing-semicolon"]
        assert level.commands == whole.commands


SHIPPED = sorted((Path(__file__).parent.parent / "src" / "evilengine" / "examples").glob("*.evil"))


@pytest.mark.parametrize("path", SHIPPED, ids=[path.stem for path in SHIPPED])
def test_each_semicolon_that_is_taken_out_of_a_level_is_one_error_at_its_place(path: Path) -> None:
    text = path.read_text(encoding="utf-8")
    for token in tokens(Source(text, "level.evil")):
        if token.kind == ";":
            (error,) = script.check(text[: token.start] + text[token.end :])[1]
            assert (error.code, error.line, error.column) == (
                "missing-semicolon",
                token.place.line,
                token.place.column,
            )


@pytest.mark.parametrize("path", SHIPPED, ids=[path.stem for path in SHIPPED])
def test_each_word_of_the_language_that_is_misspelt_is_one_error_that_suggests_it(path: Path) -> None:
    text = path.read_text(encoding="utf-8")
    known = {*STATEMENTS, *KINDS, *PROPERTY_WORDS, *EVENTS}
    for token in tokens(Source(text, "level.evil")):
        if token.kind == "name" and token.text in known and len(token.text) >= 4:
            misspelt = token.text[:2] + token.text[3] + token.text[2] + token.text[4:]
            if misspelt == token.text:
                misspelt = token.text[:2] + token.text[3:]
            (error,) = script.check(text[: token.start] + misspelt + text[token.end :])[1]
            assert (error.line, error.column) == (token.place.line, token.place.column)
            assert f"{token.text}'" in error.suggestion


@pytest.mark.parametrize("mark", "(){}")
def test_a_bracket_that_is_taken_out_is_seldom_more_than_one_error(mark: str) -> None:
    found = []
    for path in SHIPPED:
        text = path.read_text(encoding="utf-8")
        places = [token for token in tokens(Source(text, "level.evil")) if token.kind == mark]
        found += [len(script.check(text[: token.start] + text[token.end :])[1]) for token in places]
    assert min(found) >= 1
    assert sum(found) / len(found) < 1.2


def test_a_misspelt_kind_still_makes_its_name_known() -> None:
    _, errors = script.check("new rectangel crate 2 1 at 0 4;\non collide crate { destroy crate; }")
    assert [error.code for error in errors] == ["unknown-kind"]


def test_carets_stand_under_the_word_after_tabs_and_wide_letters() -> None:
    (error,) = script.check("\tnew circle 球 1 at 0 4 frction;")[1][:1]
    source, carets = str(error).splitlines()[1:3]
    before = source[: source.index("frction")]
    assert carets == before.replace("new circle 球 1 at 0 4 ", " " * 23) + "^^^^^^^"


def test_a_very_long_line_is_shown_in_part() -> None:
    (error,) = script.check("new circle 1 at 0 4; " * 2000 + "nwe circle 1 at 0 4;")[1]
    assert max(map(len, str(error).splitlines())) < 200
    assert "nwe" in str(error)


def test_control_characters_of_a_level_never_reach_the_terminal() -> None:
    report = "\n".join(map(str, script.check("new \x1b[31mcircle\x07 1 at \x00 0;")[1]))
    assert all(letter.isprintable() or letter == "\n" for letter in report)


def test_reading_a_broken_level_raises_one_error_that_holds_them_all() -> None:
    with pytest.raises(LevelError, match="did you mean 'circle'") as raised:
        script.read("new circel 1;\nnwe circle 1;")
    assert [error.line for error in raised.value.errors] == [1, 2]


def test_pictures_are_looked_for_in_the_folder_of_the_level(tmp_path: Path) -> None:
    (tmp_path / "crate.png").write_bytes(b"")
    level = tmp_path / "level.evil"
    level.write_text('new circle 1 texture "crate.png"; new circle 1 texture "crat.png"; background "/etc/x.png";')
    errors = script.check_file(level)[1]
    assert [error.code for error in errors] == ["missing-file", "bad-file"]
    assert errors[0].suggestion == "did you mean 'crate.png'?"


@pytest.mark.parametrize("name", ["../a.png", "/a.png", "C:\\a.png", "a/../../b.png", "", "a\\b.png"])
def test_no_file_name_leaves_the_folder_of_the_level(name: str) -> None:
    assert [error.code for error in script.check(f'new circle 1 texture "{name}";')[1]] == ["bad-file"]


def test_a_link_out_of_the_folder_is_no_file_of_the_level(tmp_path: Path) -> None:
    (tmp_path / "secret.png").write_bytes(b"")
    folder = tmp_path / "level"
    folder.mkdir()
    (folder / "link.png").symlink_to(tmp_path / "secret.png")
    assert script.check('new circle 1 texture "link.png";', folder=folder)[1][0].code == "missing-file"


def test_a_file_that_is_no_text_says_where(tmp_path: Path) -> None:
    level = tmp_path / "level.evil"
    level.write_bytes(b"view 16 9;\nnew \xff\xfe circle 1;")
    (error,) = script.check_file(level)[1]
    assert (error.line, error.column, error.code) == (2, 5, "not-text")


def test_a_missing_level_is_an_asset_error(tmp_path: Path) -> None:
    with pytest.raises(AssetError, match="no such file"):
        script.check_file(tmp_path / "nowhere.evil")


def run(*words: str) -> int:
    parser = ArgumentParser()
    check.add_arguments(parser)
    return check.run(parser.parse_args(words))


def test_evil_check_prints_each_error_and_fails(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    level = tmp_path / "level.evil"
    level.write_text("new circel 1;\nnew circle 1 at 0 4")
    assert run(str(level)) == 1
    out = capsys.readouterr().out
    assert f"{level}:1:5: error[unknown-kind]: " in out
    assert "    new circel 1;\n        ^^^^^^\n    did you mean 'circle'?" in out
    assert f"{level}:2:20: error[missing-semicolon]: " in out


def test_evil_check_passes_a_good_level(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    level = tmp_path / "level.evil"
    level.write_text("new circle 1;")
    assert run(str(level)) == 0
    assert capsys.readouterr().out == f"{level}: no errors\n"


def test_evil_check_json_is_a_list_of_every_error(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    level = tmp_path / "level.evil"
    level.write_text("new circel 1;")
    missing = tmp_path / "missing.evil"
    assert run(str(level), str(missing), "--json") == 1
    first, second = json.loads(capsys.readouterr().out)
    assert first == {
        "file": str(level),
        "line": 1,
        "column": 5,
        "length": 6,
        "severity": "error",
        "code": "unknown-kind",
        "message": "there is no kind of thing called 'circel'",
        "suggestion": "did you mean 'circle'?",
    }
    assert second["code"] == "unreadable"
    level.write_text("new circle 1;")
    assert run(str(level), "--json") == 0
    assert json.loads(capsys.readouterr().out) == []
