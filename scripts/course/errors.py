"""What ends the program, with the exit codes of all programs of Raysteps."""

DONE, CHECK_FAILED, WRONG_INPUT, MACHINE_LACKS = 0, 1, 2, 3


class CourseError(Exception):
    """One sentence that says what, where, and what to do next."""

    code = WRONG_INPUT


class MachineError(CourseError):
    code = MACHINE_LACKS
