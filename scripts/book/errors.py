"""What ends the making of the book, with the exit codes of all programs of Raysteps."""

DONE, FAILED, WRONG_INPUT, MACHINE_LACKS = 0, 1, 2, 3


class BookError(Exception):
    """One sentence that says what, where, and what to do next."""

    code = FAILED


class MachineError(BookError):
    code = MACHINE_LACKS
