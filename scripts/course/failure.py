"""Why a program gave no answer, in words."""

import re
import signal
from dataclasses import dataclass

from . import sandbox

MEMORY = (" memory that is not its own ({}): is an index beyond the end of a list, or does a function call "
          "itself without end?")
SIGNALS = {
    signal.SIGSEGV: "It read or wrote" + MEMORY.format("SIGSEGV"),
    signal.SIGBUS: "It read or wrote" + MEMORY.format("SIGBUS"),
    signal.SIGFPE: "It divided a whole number by zero (SIGFPE).",
    signal.SIGILL: "It came where no code is (SIGILL): does a function end without `return`?",
    signal.SIGTRAP: "It came where no code is (SIGTRAP): does a function end without `return`?",
    signal.SIGABRT: "It gave up (SIGABRT).",
    signal.SIGXFSZ: "It printed too much (SIGXFSZ): does a loop that prints never end?",
    signal.SIGKILL: "It was killed (SIGKILL): there may have been no memory left.",
}


@dataclass
class Failure:
    """No answer: `kind` is compile, crash, time or machine."""

    kind: str
    message: str


def of_run(outcome, limits, is_cpp=False):
    if outcome.timed_out:
        return Failure("time", f"It was stopped after {outcome.seconds:.0f} s (it may take "
                               f"{limits.seconds:.0f} s, and {limits.cpu_seconds} s of processors): "
                               "does a loop never end?")
    number, errors = sandbox.signal_of(outcome.code), outcome.errors.strip()
    if number:
        return Failure("crash", _in_words(number, errors))
    if is_cpp:
        return Failure("crash", _exception(errors, limits) if errors else
                       f"It ended the program with exit code {outcome.code}.")
    return of_refusal(errors or f"It ended with exit code {outcome.code}.")


def _in_words(number, errors):
    words = SIGNALS.get(number, f"It was ended by signal {number}.")
    said = re.search(r"^(terminate called|.*[Aa]ssertion|  what\(\)).*", errors, re.MULTILINE)
    return f"{words} The program said: {said[0].strip()}" if number == signal.SIGABRT and said else words


def _exception(errors, limits):
    last = errors.splitlines()[-1]
    if last in ("std::bad_alloc", "std::bad_array_new_length"):
        most = f"the {limits.memory_bytes >> 20} MiB that it may have" if limits.memory_bytes else "there is"
        return (f"It asked for more memory than {most} ({last}): is a size negative, or does a list grow "
                "without end?")
    return f"It threw an exception that nobody caught: {last[:300]}"


def of_refusal(message):
    is_shader = "does not compile" in message or "do not link" in message
    return Failure("compile" if is_shader else "machine", message)
