"""The words that start a statement, the events, and the functions of arithmetic."""

from __future__ import annotations

from collections.abc import Mapping

from evilengine.script.air import AIR_STATEMENTS
from evilengine.script.filming import CAMERA_STATEMENTS
from evilengine.script.lighting import LIGHT_STATEMENTS
from evilengine.script.waters import WATER_STATEMENTS
from evilengine.script.word import Statement, Word

STATEMENTS: Mapping[str, Statement] = {
    each.word: each
    for each in (
        Statement(
            word="evil",
            form="evil 1;",
            doc="The version of the language, as the first statement of a level. It may be left out.",
            example="evil 1;",
            meant=("version",),
        ),
        Statement(
            word="view",
            form="view WIDTH HEIGHT;",
            doc="How much of the world the screen shows, in metres, with the origin in the middle.",
            example="view 16 9;",
            meant=("screen", "size", "window"),
        ),
        Statement(
            word="follow",
            form="follow NAME;",
            doc="Keeps a thing in the middle of the screen from now on, wherever it goes.",
            example="new circle ball 0.5 at 0 3 physicsOn velocity 4 0;\nfollow ball;",
            meant=("track", "chase", "lookAt"),
        ),
        Statement(
            word="split",
            form="split NAME [NAME [NAME [NAME]]];",
            doc="Shares the screen out: a part for each of these things, which follows it. Two are side by side, three "
            "and four in quarters; one has all of it again.",
            example="new circle one 0.5 at -3 3 physicsOn;\nnew circle two 0.5 at 3 3 physicsOn;\nsplit one two;",
            meant=("splitScreen", "views", "share", "players"),
        ),
        Statement(
            word="quake",
            form="quake NUMBER;",
            doc="Shakes the picture, at first by so many points; it dies away by itself.",
            example="new circle ball 0.5 at 0 3 physicsOn;\non collide ball { quake 12; }",
            meant=("cameraShake", "shakeScreen", "earthquake"),
        ),
        Statement(
            word="gravity",
            form="gravity X Y;",
            doc="The pull on everything that moves, in metres a second, each second. On Earth it is `0 -9.81`.",
            example="gravity 0 -9.81;",
        ),
        Statement(
            word="tilt",
            form="tilt on;  tilt off;",
            doc="Lets the tilt of the device turn gravity. Arrow keys or the mouse wheel stand in for it.",
            example="tilt on;",
        ),
        *CAMERA_STATEMENTS,
        *AIR_STATEMENTS,
        *LIGHT_STATEMENTS,
        Statement(
            word="seed",
            form="seed NUMBER;",
            doc="Where `random` starts from: a whole number. The same seed gives the same level every time.",
            example="seed 7;",
        ),
        Statement(
            word="new",
            form="new KIND [NAME] SIZES [PROPERTIES];",
            doc="Makes something. A name is needed only if you speak of it later, and no two things share one.",
            example="new circle ball 0.5 at 0 3 physicsOn;",
            meant=("create", "add", "make", "spawn", "object"),
        ),
        Statement(
            word="draw",
            form="draw KIND [NAME] SIZES [PROPERTIES];",
            doc="Draws a rectangle, circle, triangle or polygon that nothing can touch: a cloud, water, a far hill.",
            example='draw circle sun 1 at 6 3 colour "gold" layer -1;',
            meant=("paint", "picture", "decoration", "image"),
        ),
        Statement(
            word="text",
            form='text [NAME] "WORDS" at X Y [PROPERTIES];',
            doc="A line of words on the screen; `at` counts points from the top left corner. "
            "A number's name in { } shows the number, and `\\n` begins a new line.",
            example='let score 0;\ntext "Score {score}" at 20 20 size 24;',
            meant=("print", "write", "label", "say", "show"),
        ),
        Statement(
            word="play",
            form='play "FILE" [PROPERTIES];',
            doc="Plays a sound once: a wav, ogg, mp3 or flac file in the level's folder.",
            example='new circle ball 0.5 at 0 3 physicsOn;\non collide ball { play "thud.ogg" at ball; }',
            meant=("sound", "audio", "sfx", "noise"),
        ),
        Statement(
            word="music",
            form='music "FILE" [PROPERTIES];  music off;',
            doc="Plays music over and over; it fades into what follows. `music off` lets it fade away.",
            example='music "wind.ogg" volume 0.5;',
            meant=("song", "soundtrack"),
        ),
        Statement(
            word="go",
            form='go "LEVEL.evil";',
            doc="Begins another level in the same folder, when the step is over: in a block, such as that of an event. "
            "Everything of this one is gone then.",
            example='new circle ball 0.5 at 0 3 physicsOn;\non touch ball { go "level2.evil"; }',
            meant=("goto", "scene", "nextlevel", "load", "open"),
        ),
        Statement(
            word="restart",
            form="restart;",
            doc="Begins this level again, when the step is over: in a block, such as that of an event.",
            example='on key "r" { restart; }',
            meant=("again", "reset", "restartLevel"),
        ),
        Statement(
            word="pace",
            form="pace NUMBER;",
            doc="How fast time goes: `0.25` is slow motion, `1` as always, `2` twice as fast; 0.05 to 4.",
            example='on key "s" { pace 0.25; }\nafter 5 { pace 1; }',
            meant=("speed", "slow", "slowmotion", "timescale"),
        ),
        Statement(
            word="let",
            form="let NAME NUMBER;",
            doc="Makes a number that has a name, such as a score. `set` changes it.",
            example="let score 0;",
            meant=("var", "variable", "number", "int", "float", "const"),
        ),
        Statement(
            word="set",
            form="set NAME PROPERTY VALUE;  set NAME NUMBER;",
            doc="Changes a property of something, or a number made by `let`. What is gone stays gone.",
            example="let score 0;\nnew circle ball 0.5 at 0 3 physicsOn;\n"
            'on touch ball { set ball colour "red"; set score (score + 1); }',
            meant=("change", "assign"),
        ),
        Statement(
            word="impulse",
            form="impulse NAME X Y;",
            doc="A kick: changes speed at once. The same kick moves a heavy thing less.",
            example='new circle ball 0.5 at 0 3 physicsOn;\non key "space" { impulse ball 0 5; }',
            meant=("kick", "push", "hit", "throw"),
        ),
        Statement(
            word="drive",
            form='drive NAME [left "KEY"] [right "KEY"] [up "KEY"] [down "KEY"] [jump "KEY"];  drive off;',
            doc="Lets the player steer a character: arrows, w a s d or the stick of a pad, and the space bar to jump. "
            "Other keys are said by name, one or more for each. Whoever was steered before stands.",
            example='new character hero 0.6 1.5 at 0 1;\ndrive hero jump "space" "z";',
            meant=("control", "steer", "player"),
        ),
        Statement(
            word="tell",
            form="tell NAME walk NUMBER;  tell NAME climb NUMBER;  tell NAME jump;  tell NAME letGo;  tell NAME drop;",
            doc="Steers a character without the player: `walk -1` to the left and `1` to the right, `climb 1` up a "
            "ladder and `-1` down, until told otherwise; `letGo` ends a jump early, `drop` falls through a platform.",
            example="new character guard 0.6 1.5 at 0 1;\ntell guard walk -1;\nevery 2 { tell guard jump; }",
            meant=("order", "command", "walk"),
        ),
        *WATER_STATEMENTS,
        Statement(
            word="destroy",
            form="destroy NAME;",
            doc="Takes something out of the world. Destroying what is already gone does nothing.",
            example="new circle ball 0.5 at 0 3 physicsOn;\nafter 5 { destroy ball; }",
            meant=("delete", "remove", "kill", "erase"),
        ),
        Statement(
            word="on",
            form="on collide A [B] { ... }  on separate A [B] { ... }  on enter A [B] { ... }  on leave A [B] { ... }  "
            'on touch A { ... }  on land A { ... }  on jump A { ... }  on crush A { ... }  on key "KEY" { ... }  '
            "on shake { ... }",
            doc="Does what is in the block each time that something happens. A and B are names, or tags in quotes, "
            "which stand for everything with that tag. Without B it happens with anything. "
            "In the block `this` is the first of the two and `other` the second.",
            example="new circle ball 0.5 at 0 3 physicsOn;\nnew rectangle floor 9 1 at 0 -3;\n"
            'on collide ball floor { set ball colour "gold"; }\non key "up" { impulse ball 0 4; }',
            meant=("when", "event", "onCollide", "onTouch", "onKey"),
        ),
        Statement(
            word="after",
            form="after SECONDS { ... }",
            doc="Does what is in the block once, that many seconds from now.",
            example="after 3 { new circle 0.5 at 0 3 physicsOn; }",
            meant=("wait", "delay", "later", "sleep"),
        ),
        Statement(
            word="every",
            form="every SECONDS [times N] [as NAME] { ... }",
            doc="Does what is in the block again and again, with that many seconds between. `times` says how often; "
            "`as` gives the number of the round (1, 2, 3 ...) a name.",
            example="every 0.5s times 20 as i { new circle 0.2 at (i / 4 - 2) 4 physicsOn; }",
            meant=("interval", "always", "forever"),
        ),
        Statement(
            word="repeat",
            form="repeat N [as NAME] { ... }",
            doc="Does what is in the block N times at once. `as` gives the number of the round (1, 2, 3 ...) a name. "
            "Names made inside belong to one round.",
            example="repeat 5 as i { new rectangle 1 1 at 0 (i - 0.5) physicsOn; }",
            meant=("loop", "for", "while", "foreach"),
        ),
        Statement(
            word="if",
            form="if (CONDITION) { ... } [else { ... }]",
            doc="Does what is in the block only if the condition holds. Compare with `<`, `>`, `<=`, `>=`, `==`, `!=`; "
            "join with `and`, `or`, `not`.",
            example="let lives 3;\nnew circle ball 0.5 at 0 3 physicsOn;\n"
            "on touch ball { set lives (lives - 1); if (lives <= 0) { destroy ball; } }",
        ),
    )
}
EVENTS = {
    "collide": "two things begin to touch each other",
    "separate": "two things that touched each other part",
    "enter": "something comes into a thing that is a `sensor`; the sensor is the first",
    "leave": "it goes out of it again, or is gone",
    "land": "a character comes down on the ground",
    "jump": "a character jumps",
    "crush": "a character has no room left",
    "touch": "a finger or the mouse presses something",
    "key": "a key is pressed",
    "shake": "the device is shaken",
}
MEETINGS = ("collide", "separate", "enter", "leave")
"""The events of two things."""
CHARACTER_EVENTS = ("land", "jump", "crush")
EVENT_MEANT = {
    "collision": "collide", "hit": "collide", "contact": "collide", "collides": "collide", "click": "touch",
    "tap": "touch", "press": "key", "keypress": "key", "apart": "separate",
    "enters": "enter", "inside": "enter", "leaves": "leave", "exit": "leave", "outside": "leave", "lands": "land",
    "landing": "land", "jumps": "jump", "crushed": "crush", "squeeze": "crush",
}  # fmt: skip

FUNCTIONS: Mapping[str, Word] = {
    each.word: each
    for each in (
        Word(
            word="random",
            doc="A number between the two, another one each time; the same in every run of the level.",
            example="new circle random(0.2, 0.6) at 0 3;",
            meant=("rand", "rnd"),
        ),
        Word(word="sin", doc="Sine of an angle in degrees.", example="new circle 1 at sin(30) 0;"),
        Word(word="cos", doc="Cosine of an angle in degrees.", example="new circle 1 at cos(60) 0;"),
        Word(word="sqrt", doc="Square root.", example="new circle sqrt(2) at 0 0;", meant=("root",)),
        Word(word="abs", doc="The number without its minus.", example="new circle abs(-1) at 0 0;"),
        Word(word="min", doc="The smaller of two.", example="new circle min(1, 2) at 0 0;"),
        Word(word="max", doc="The larger of two.", example="new circle max(1, 2) at 0 0;"),
        Word(word="floor", doc="The whole number at or below it.", example="new circle floor(1.7) at 0 0;"),
        Word(word="round", doc="The nearest whole number; halves go up.", example="new circle round(1.2) at 0 0;"),
    )
}
ARITY = {"random": 2, "sin": 1, "cos": 1, "sqrt": 1, "abs": 1, "min": 2, "max": 2, "floor": 1, "round": 1}
