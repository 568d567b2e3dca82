"""The version of the engine, the one in pyproject.toml."""

VERSION = "0.1.0"
