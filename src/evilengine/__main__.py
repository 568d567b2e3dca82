"""`python -m evilengine` is `evil`."""

import sys

from evilengine.cli import main

sys.exit(main())
