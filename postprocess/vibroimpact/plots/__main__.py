"""python -m vibroimpact.plots is vibroimpact-plot."""

import sys

from .command_line import main

if __name__ == "__main__":
    sys.exit(main())
