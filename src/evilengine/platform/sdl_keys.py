"""What SDL calls keys, buttons and axes, and what we call them."""

from __future__ import annotations

from evilengine.values.events import PAD_AXES, PAD_BUTTONS

_PUNCTUATION = {
    "-": "minus",
    "=": "equals",
    "[": "left_bracket",
    "]": "right_bracket",
    "\\": "backslash",
    ";": "semicolon",
    "'": "quote",
    "`": "backquote",
    ",": "comma",
    ".": "period",
    "/": "slash",
    "<": "less",
    " ": "space",
    "\r": "enter",
    "\x1b": "escape",
    "\b": "backspace",
    "\t": "tab",
    "\x7f": "delete",
}
BY_CHARACTER = {ord(character): character for character in "abcdefghijklmnopqrstuvwxyz0123456789"} | {
    ord(character): name for character, name in _PUNCTUATION.items()
}
"""SDL's key codes below 128 are the character on the key, without shift."""
NO_CHARACTER = 1 << 30
"""This bit in a key code says that the key has no character, and that the rest of the code is a scancode."""

# Places of keys (SDL's scancodes are the usage numbers of the USB keyboard page). A place decides where the key has no
# character, and on layouts whose letters are not Latin: there a key is called what it would be on an American keyboard.
_LETTERS_AND_DIGITS = dict(zip(range(4, 40), "abcdefghijklmnopqrstuvwxyz1234567890", strict=True))
_REST = (
    *("enter", "escape", "backspace", "tab", "space", "minus", "equals", "left_bracket", "right_bracket"),  # 40
    *("backslash", "backslash", "semicolon", "quote", "backquote", "comma", "period", "slash", "caps_lock"),  # 49
    *(f"f{number}" for number in range(1, 13)),  # 58
    *("print_screen", "scroll_lock", "pause", "insert", "home", "page_up", "delete", "end", "page_down"),  # 70
    *("right", "left", "down", "up"),  # 79
    *("num_lock", "keypad_divide", "keypad_times", "keypad_minus", "keypad_plus", "keypad_enter"),  # 83
    *(f"keypad_{number}" for number in (1, 2, 3, 4, 5, 6, 7, 8, 9, 0)),  # 89
    *("keypad_period", "less", "menu"),  # 99
)
BY_PLACE = (
    _LETTERS_AND_DIGITS
    | dict(enumerate(_REST, start=40))
    | {104 + number: f"f{13 + number}" for number in range(12)}
    | {
        224: "left_ctrl",
        225: "left_shift",
        226: "left_alt",
        227: "left_meta",
        228: "right_ctrl",
        229: "right_shift",
        230: "right_alt",
        231: "right_meta",
        270: "back",
    }
)

MOUSE_BUTTONS = {1: "left", 2: "middle", 3: "right", 4: "back", 5: "forward"}
# SDL numbers a game controller's buttons and axes in the order of our names.
CONTROLLER_BUTTONS = dict(enumerate(PAD_BUTTONS))
CONTROLLER_AXES = dict(enumerate(PAD_AXES))


def key_of(code: int, place: int) -> str | None:
    """Our name of the key with SDL's key code and scancode; None for keys that games do not need."""
    if code & NO_CHARACTER:
        return BY_PLACE.get(code & ~NO_CHARACTER) or BY_PLACE.get(place)
    return BY_CHARACTER.get(code) or BY_PLACE.get(place)
