"""Text to tokens: numbers with units, names, texts, marks, comments, and where each stands."""

from __future__ import annotations

import pytest

from evilengine.script.lexer import MAX_CHARACTERS, Source, Token, tokens
from evilengine.script.word import UNITS


def read(text: str) -> list[Token]:
    source = Source(text, "level.evil")
    found = tokens(source)
    assert source.diagnostics == []
    return found[:-1]


def codes(text: str) -> list[str]:
    source = Source(text, "level.evil")
    tokens(source)
    return [error.code for error in source.diagnostics]


def test_a_statement_becomes_words_numbers_and_marks() -> None:
    kinds = [token.kind for token in read('new circle ball 0.5 at 1 -2 colour "#fff";')]
    assert kinds == ["name", "name", "name", "number", "name", "number", "-", "number", "name", "string", ";"]


@pytest.mark.parametrize("text", ["12", "0.5", ".5", "3.", "1e3", "2.5e-2"])
def test_a_number_is_read_as_python_reads_it(text: str) -> None:
    (token,) = read(text)
    assert (token.kind, token.number, token.unit) == ("number", float(text), "")


@pytest.mark.parametrize("unit", UNITS)
def test_a_number_may_carry_any_unit(unit: str) -> None:
    (token,) = read(f"2.5{unit}")
    assert (token.number, token.unit) == (2.5, unit)


def test_comments_end_with_their_line() -> None:
    assert [token.text for token in read("tilt # on; off;\non;")] == ["tilt", "on", ";"]


def test_a_hash_inside_a_text_starts_no_comment() -> None:
    assert [token.text for token in read('"#cc9966" tilt')] == ["#cc9966", "tilt"]


def test_names_may_use_letters_of_any_language() -> None:
    assert [token.text for token in read("låda1 мяч _x")] == ["låda1", "мяч", "_x"]


@pytest.mark.parametrize("end", ["\n", "\r\n", "\r"])
def test_lines_and_columns_count_from_one_whatever_ends_a_line(end: str) -> None:
    places = [(token.place.line, token.place.column) for token in read(f"view 16{end}{end}  9;")]
    assert places == [(1, 1), (1, 6), (3, 3), (3, 4)]


def test_a_byte_order_mark_is_no_part_of_the_first_word() -> None:
    assert read("\ufeffview")[0].text == "view"


def test_tokens_know_which_is_the_first_on_its_line() -> None:
    assert [token.first for token in read("tilt on;\nview 1 2;")] == [True, False, False, True, False, False, False]


@pytest.mark.parametrize(
    ("text", "code"),
    [
        ('"red', "unclosed-text"),
        ("'red'", "wrong-quotes"),
        ("“red”", "wrong-quotes"),
        ("§", "odd-character"),
        ("1.2.3", "bad-number"),
        ("3parsec", "unknown-unit"),
        ("1e99", "number-too-large"),
        ("// no", "wrong-comment"),
        ("/* no */", "wrong-comment"),
        ("\uff1b", "odd-character"),
        ("colour #f00;", "unquoted-colour"),
    ],
)
def test_what_is_odd_is_said_once(text: str, code: str) -> None:
    assert codes(text) == [code]


def test_a_run_of_odd_characters_is_one_error() -> None:
    assert codes("§§§§ 1 $$$") == ["odd-character", "odd-character"]


def test_a_text_without_end_stops_before_the_semicolon() -> None:
    source = Source('colour "red;\ntilt on;', "level.evil")
    assert [token.text for token in tokens(source)][:3] == ["colour", "red", ";"]


def test_a_file_that_is_too_long_is_not_read() -> None:
    assert codes("a" * (MAX_CHARACTERS + 1)) == ["too-long"]
    assert len(tokens(Source(" " * MAX_CHARACTERS, "level.evil"))) == 1
