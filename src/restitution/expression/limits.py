"""How large a text may be. Real questions stay far below; whatever exceeds these is refused early.

Each limit is checked before the work it bounds, so that any bytes are answered at once.
"""

MAX_TEXT_BYTES = 100_000
MAX_LINES = 1_000
MAX_LINE_LENGTH = 2_000
MAX_TOKENS_PER_LINE = 1_000
MAX_NESTING = 50
MAX_TREE_DEPTH = 100
MAX_DIGITS = 40
MAX_BODIES = 100
MAX_EVENTS = 60
MAX_ERRORS = 20
